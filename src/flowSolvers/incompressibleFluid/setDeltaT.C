// SPDX-License-Identifier: GPL-3.0-or-later

#include "incompressibleFluid.H"
#include "faceSums.H"

Foam::scalar Foam::flowSolvers::incompressibleFluid::courantNo
(
    const surfaceScalarField& phi,
    const char* prefix
)
{
    const fvMesh& mesh = phi.mesh();
    const scalar deltaT = mesh.time().deltaTValue();

    const scalarField& V = mesh.V();

    scalar largest = 0;
    vector2D sums(Zero);

    faceSums
    (
        phi,
        [](const scalar flux) { return mag(flux); },
        [&](const label celli, const scalar sumPhi)
        {
            largest = max(largest, sumPhi/V[celli]);
            sums[0] += sumPhi;
            sums[1] += V[celli];

            return sumPhi;
        }
    );
    reduce(sums, sumOp<vector2D>());

    const scalar CoNum =
        0.5*returnReduce(largest, maxOp<scalar>())*deltaT;
    const scalar meanCoNum = 0.5*(sums[0]/sums[1])*deltaT;

    Info<< prefix << "Courant Number mean: " << meanCoNum
        << " max: " << CoNum << endl;

    return CoNum;
}


void Foam::flowSolvers::incompressibleFluid::readControls()
{
    const dictionary& timeDict = runTime_.controlDict();
    adjustTimeStep = timeDict.lookupOrDefault("adjustTimeStep", false);
    maxCo = timeDict.lookupOrDefault<scalar>("maxCo", 1);
    maxDeltaT = timeDict.lookupOrDefault<scalar>("maxDeltaT", GREAT);

    // An entry that is removed during the run keeps its value
    const dictionary& dict = pimple_.dict();
    dict.readIfPresent("correctPhi", correctPhi);
    dict.readIfPresent("checkMeshCourantNo", checkMeshCourantNo);
    dict.readIfPresent("moveMeshOuterCorrectors", moveMeshOuterCorrectors);
}


void Foam::flowSolvers::incompressibleFluid::correctCoNum()
{
    CoNum = courantNo(phi_, "");
}


void Foam::flowSolvers::incompressibleFluid::meshCourantNo() const
{
    courantNo(mesh_.phi(), "Mesh ");
}


void Foam::flowSolvers::incompressibleFluid::setInitialDeltaT()
{
    if (adjustTimeStep && runTime_.timeIndex() == 0 && CoNum > SMALL)
    {
        const scalar deltaT = runTime_.deltaTValue();

        runTime_.setDeltaT(min(maxCo*deltaT/CoNum, min(deltaT, maxDeltaT)));
    }
}


void Foam::flowSolvers::incompressibleFluid::adjustDeltaT()
{
    if (!adjustTimeStep)
    {
        return;
    }

    // Grow slowly, shrink at once
    const scalar limit = maxCo/(CoNum + SMALL);
    const scalar factor = min(min(limit, 1 + 0.1*limit), 1.2);

    runTime_.setDeltaT(min(factor*runTime_.deltaTValue(), maxDeltaT));

    Info<< "deltaT = " << runTime_.deltaTValue() << endl;
}
