// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedFluid.H"
#include "fvcFlux.H"
#include "meshProperties.H"

Foam::fv::flowRateForce* Foam::flowSolvers::immersedFluid::findFlowRate()
{
    for (fv::option& force : static_cast<fv::optionList&>(fvOptions))
    {
        if (isA<fv::flowRateForce>(force))
        {
            return &refCast<fv::flowRateForce>(force);
        }
    }

    return nullptr;
}


void Foam::flowSolvers::immersedFluid::checkSettings() const
{
    if (mesh_.dynamic())
    {
        FatalErrorInFunction
            << "Immersed bodies need a mesh at rest; remove"
            << " constant/dynamicMeshDict or choose"
            << " 'dynamicFvMesh staticFvMesh' there" << nl
            << exit(FatalError);
    }

    if
    (
        bodies_->disperse()
     && momentumTransport->get<word>("simulationType") == "laminar"
    )
    {
        FatalIOErrorInFunction(*momentumTransport)
            << "'dispersion' of unresolved bodies needs a turbulence model, and"
            << " 'simulationType' is laminar" << nl << exit(FatalIOError);
    }

    if (bodies_->frozen() && bodies_->window().comoving())
    {
        FatalErrorInFunction
            << "A fluid that is frozen does not go with a comoving window"
            << nl << exit(FatalError);
    }

    // Refuses schemes that the bodies' equations do not follow
    meshProperties::ddt(mesh_, U_.name());
}


void Foam::flowSolvers::immersedFluid::initialise()
{
    if (!bodies_->restarted())
    {
        bodies_->setAmbient(U_);
        if (bodies_->frozen())
        {
            return;
        }

        bodies_->setRigidMotion(U_);
        phi_ = fvc::flux(U_);
        makeRelative(bodies_->window().velocity());

        // That of another solver's run does not know the bodies
        if (phi_.nOldTimes())
        {
            phi_.oldTime() == phi_;
        }
    }
}


void Foam::flowSolvers::immersedFluid::makeRelative(const vector& V)
{
    if (V != vector::zero)
    {
        phi_ -= dimensionedVector("V", dimVelocity, V) & mesh_.Sf();
    }
}
