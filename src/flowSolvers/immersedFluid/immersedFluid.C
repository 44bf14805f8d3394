// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedFluid.H"
#include "addToRunTimeSelectionTable.H"
#include "bodyProperties.H"
#include "bodyWalls.H"
#include "denseFluid.H"
#include "fluidChoice.H"
#include "frozenFluid.H"
#include "functionObject.H"
#include "fvcFlux.H"
#include "meshProperties.H"

namespace Foam
{

// Which class solves a case depends on its bodies
template<>
autoPtr<flowSolver>
flowSolver::adddynamicFvMeshConstructorToTable<flowSolvers::immersedFluid>::New
(
    dynamicFvMesh& mesh
)
{
    return flowSolvers::immersedFluid::New(mesh);
}

namespace flowSolvers
{
    defineTypeNameAndDebug(immersedFluid, 0);
    addToRunTimeSelectionTable(flowSolver, immersedFluid, dynamicFvMesh);
}
}


Foam::autoPtr<Foam::flowSolver> Foam::flowSolvers::immersedFluid::New
(
    dynamicFvMesh& mesh
)
{
    const IOdictionary dict(bodyProperties::read(mesh));

    const fluidChoice fluid(dict.subOrEmptyDict("coupling"));

    if (!bodyProperties::any(dict) && !fluid.projected())
    {
        Info<< "No immersed bodies: solving as incompressibleFluid" << nl
            << endl;

        return autoPtr<flowSolver>(new incompressibleFluid(mesh));
    }

    if (fluid.dense())
    {
        return autoPtr<flowSolver>(new denseFluid(mesh));
    }

    return fluid.frozen()
      ? autoPtr<flowSolver>(new frozenFluid(mesh))
      : autoPtr<flowSolver>(new immersedFluid(mesh));
}


Foam::flowSolvers::immersedFluid::immersedFluid(dynamicFvMesh& mesh)
:
    fluidWithBodies(mesh),
    iteration_(bodies_.coupling(), bodies_.steady().active()),
    acceleration_(mesh),
    momentum_
    (
        U_, phi_, *momentumTransport, MRF, fvOptions, bodies_,
        momentumTransport->type() == "Stokes"
     && laminarTransport.get<word>("transportModel") == "Newtonian"
    ),
    projection_(p_, pRefCell),
    layers_(projection_.dp(), pRefCell, bodies_.region()),
    correction_
    (
        projection_, p_, phi_, U_, bodies_.region(), bodies_.moving()
    ),
    plan_
    (
        iteration_, bodies_, momentum_, layers_, acceleration_, runTime_
    ),
    flowRate_(findFlowRate()),
    bodyWalls_(nullptr)
{
    if (!functionObject::postProcess && !bodies_.restarted())
    {
        initialise();
    }
    keepOldTimes();
    correctViscosity();
    addBodyWalls();
    if (bodies_.moving())
    {
        retry_.reset(new timeStepRetry(mesh_, runTime_));
    }

    OStringStream coupling;
    iteration_.describe(coupling);

    string skipped;
    skipped += momentum_.stokes() ? ", convection" : "";
    skipped += momentum_.uniformViscosity()
      ? ", turbulence, transposed stress"
      : "";
    reportSetUp(coupling.str(), skipped);
}


void Foam::flowSolvers::immersedFluid::keepOldTimes()
{
    // Two previous levels, to extrapolate from
    if (bodies_.moving())
    {
        p_.oldTime().oldTime();
    }
    if (!momentum_.stokes())
    {
        phi_.oldTime().oldTime();
    }
}


void Foam::flowSolvers::immersedFluid::initialise()
{
    bodies_.setAmbient(U_);
    bodies_.resolved().setRigidMotion(U_);
    phi_ = fvc::flux(U_);
    makeRelative(bodies_.window().velocity());

    // That of another solver's run does not know the bodies
    if (phi_.nOldTimes())
    {
        phi_.oldTime() == phi_;
    }
}


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


void Foam::flowSolvers::immersedFluid::addBodyWalls()
{
    if (!fv::bodyWalls::wanted(mesh_))
    {
        return;
    }

    bodies_.holdWithin(bodyWallDistance::range);
    bodyWalls_ = new fv::bodyWalls
    (
        bodies_,
        U_,
        momentumTransport->get<word>("simulationType") == "LES"
    );
    static_cast<fv::optionList&>(fvOptions).append(bodyWalls_);

    // A file that has changed would be read again, for an entry of each option
    fvOptions.watchIndices().clear();

    bodyWalls_->update(momentumTransport->nu()());
    momentumTransport->validate();
}


void Foam::flowSolvers::immersedFluid::momentumTransportCorrector()
{
    if (!momentum_.uniformViscosity() && !momentum_.diverged())
    {
        correctViscosity();
        if (bodyWalls_)
        {
            bodyWalls_->update(momentumTransport->nu()());
        }
        momentumTransport->correct();
    }
}


void Foam::flowSolvers::immersedFluid::postSolve()
{
    momentum_.clear();
    fluidWithBodies::postSolve();
}


void Foam::flowSolvers::immersedFluid::check()
{
    fluidWithBodies::check();

    // Matrices once, as in a time step of no length
    bodies_.beginStep();
    momentum_.assemble(meshProperties::ddt(mesh_, U_.name()));
    mesh_.solver(U_.select(true));
    mesh_.solver(p_.select(true));
}
