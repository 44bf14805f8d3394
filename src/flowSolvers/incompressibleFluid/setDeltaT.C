// SPDX-License-Identifier: GPL-3.0-or-later

#include "incompressibleFluid.H"

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
    CoNum = fluxSums_.courantNo(runTime_.deltaTValue(), "");
}


void Foam::flowSolvers::incompressibleFluid::meshCourantNo() const
{
    fluxSums(mesh_.phi()).courantNo(runTime_.deltaTValue(), "Mesh ");
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
