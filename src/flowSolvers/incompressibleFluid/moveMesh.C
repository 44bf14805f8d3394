// SPDX-License-Identifier: GPL-3.0-or-later

#include "incompressibleFluid.H"
#include "CorrectPhi.H"
#include "fvcMeshPhi.H"
#include "geometricZeroField.H"


void Foam::flowSolvers::incompressibleFluid::moveMesh()
{
    if (pimple_.firstIter() || moveMeshOuterCorrectors)
    {
        mesh_.controlledUpdate();
    }
}


void Foam::flowSolvers::incompressibleFluid::motionCorrector()
{
    const bool moved = pimple_.firstIter() || moveMeshOuterCorrectors;

    if (!moved || !mesh_.changing())
    {
        return;
    }

    MRF.update();

    if (correctPhi)
    {
        // The absolute flux on the new mesh
        phi_ = mesh_.Sf() & Uf();

        CorrectPhi
        (
            U_,
            phi_,
            p_,
            dimensionedScalar("rAUf", dimTime, 1),
            geometricZeroField(),
            pimple_
        );

        continuityErrors();

        fvc::makeRelative(phi_, U_);
    }

    if (checkMeshCourantNo)
    {
        meshCourantNo();
    }
}
