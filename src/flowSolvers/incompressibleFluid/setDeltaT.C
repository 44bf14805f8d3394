// SPDX-License-Identifier: GPL-3.0-or-later

#include "incompressibleFluid.H"
#include "surfaceFields.H"

namespace
{
    //- Sum of |phi| over the faces of each cell, without a field on faces
    Foam::scalarField sumMag(const Foam::surfaceScalarField& phi)
    {
        using namespace Foam;

        const fvMesh& mesh = phi.mesh();
        const labelUList& owner = mesh.owner();
        const labelUList& neighbour = mesh.neighbour();
        scalarField sum(mesh.nCells(), Zero);

        forAll(owner, facei)
        {
            sum[owner[facei]] += mag(phi[facei]);
            sum[neighbour[facei]] += mag(phi[facei]);
        }

        for (const fvsPatchScalarField& patch : phi.boundaryField())
        {
            const labelUList& faceCells = patch.patch().faceCells();

            forAll(patch, i)
            {
                sum[faceCells[i]] += mag(patch[i]);
            }
        }

        return sum;
    }


    //- Largest Courant number of a flux; prints it after the mean
    Foam::scalar courantNo
    (
        const Foam::surfaceScalarField& phi,
        const char* prefix
    )
    {
        using namespace Foam;

        const fvMesh& mesh = phi.mesh();
        const scalar deltaT = mesh.time().deltaTValue();

        const scalarField& V = mesh.V();
        const scalarField sumPhi(sumMag(phi));

        scalar largest = 0;

        forAll(V, celli)
        {
            largest = max(largest, sumPhi[celli]/V[celli]);
        }

        const scalar CoNum =
            0.5*returnReduce(largest, maxOp<scalar>())*deltaT;
        const scalar meanCoNum = 0.5*(gSum(sumPhi)/gSum(V))*deltaT;

        Info<< prefix << "Courant Number mean: " << meanCoNum
            << " max: " << CoNum << endl;

        return CoNum;
    }
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
