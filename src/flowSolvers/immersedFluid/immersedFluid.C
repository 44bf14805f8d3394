// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedFluid.H"
#include "addToRunTimeSelectionTable.H"
#include "compatMesh.H"
#include "functionObject.H"
#include "pairGradient.H"

namespace Foam
{
namespace flowSolvers
{
    defineTypeNameAndDebug(immersedFluid, 0);
    addToRunTimeSelectionTable(flowSolver, immersedFluid, dynamicFvMesh);
}
}


Foam::flowSolvers::immersedFluid::immersedFluid(dynamicFvMesh& mesh)
:
    incompressibleFluid(mesh),
    bodies_(immersedBodies::New(mesh)),
    uniformViscosity_
    (
        momentumTransport->type() == "Stokes"
     && laminarTransport.get<word>("transportModel") == "Newtonian"
    ),
    stokes_
    (
        immersed()
     && word(mesh.divScheme("div(phi,U)")) == "none"
    ),
    pairOfGradients_(pairGradient::serves(mesh, "grad(p)")),
    flowRate_(findFlowRate()),
    bodyWalls_(nullptr),
    viscousReach_(0),
    outer_(0),
    bandOnly_(false),
    converged_(false),
    firstChange_(0),
    change_(0),
    speedScale_(0),
    lost_(false),
    acceleration_(mesh),
    startTime_(mesh.time().value())
{
    if (!immersed())
    {
        Info<< "No immersed bodies: solving as incompressibleFluid" << nl
            << endl;
        return;
    }

    checkSettings();
    projection_.reset(new projection(p_, pRefCell));
    if (bodies_->moving())
    {
        pending_.reset
        (
            new pendingCorrection(bodies_->region(), projection_->dp())
        );
    }
    compat::setFinalIteration(mesh_, true);

    if (bodies_->moving())
    {
        // Two previous levels, to extrapolate from
        p_.oldTime().oldTime();
    }
    if (bodies_->moving() && !stokes_)
    {
        convecting_.reset
        (
            new surfaceScalarField
            (
                IOobject("convecting", runTime_.timeName(), mesh_),
                mesh_,
                phi_.dimensions()
            )
        );
    }

    if (!functionObject::postProcess)
    {
        initialise();
    }
    if (!stokes_)
    {
        phi_.oldTime().oldTime();
    }

    correctViscosity();
    addBodyWalls();
    retry_.reset(new timeStepRetry(mesh_, runTime_));

    bodies_->report(Info);
    // Each with a comma and a space before
    string skipped;
    skipped += bodies_->moving() ? "" : ", motion of bodies";
    skipped += bodies_->frozen() ? ", the fluid" : "";
    skipped += stokes_ ? ", convection" : "";
    skipped += uniformViscosity_ ? ", turbulence, transposed stress" : "";
    skipped += bodies_->contact() ? "" : ", contact";
    skipped += bodies_->lubrication() ? "" : ", lubrication";

    Info<< "    skipped: "
        << (skipped.empty() ? "nothing" : skipped.substr(2).c_str()) << nl
        << endl;
}


void Foam::flowSolvers::immersedFluid::preSolve()
{
    if (!immersed())
    {
        incompressibleFluid::preSolve();
        return;
    }

    readControls();
    correctCoNum();
    CoNum = max(CoNum, bodies_->courantNo());
    adjustDeltaT();
    retry_->begin(adjustTimeStep);
    if (flowRate_)
    {
        flowRate_->beginStep();
    }
    acceleration_.begin();

    outer_ = 0;
    converged_ = false;
    change_ = 0;
    lost_ = false;
}


bool Foam::flowSolvers::immersedFluid::outerLoop()
{
    if (!immersed())
    {
        return incompressibleFluid::outerLoop();
    }

    if (!converged_ && !lost_ && outer_ < bodies_->nOuterCorrectors())
    {
        ++outer_;
        return true;
    }

    if (!farOff())
    {
        return false;
    }

    repeatStep();
    return true;
}


void Foam::flowSolvers::immersedFluid::momentumTransportCorrector()
{
    if (!immersed())
    {
        incompressibleFluid::momentumTransportCorrector();
    }
    else if (!uniformViscosity_ && !bodies_->frozen())
    {
        correctViscosity();
        if (bodyWalls_)
        {
            bodyWalls_->update(momentumTransport->nu()());
        }
        momentumTransport->correct();
    }
}


void Foam::flowSolvers::immersedFluid::correctViscosity()
{
    laminarTransport.correct();

    if (laminarTransport.get<word>("transportModel") != "Newtonian")
    {
        const tmp<volScalarField> tnu(laminarTransport.nu());

        bodies_->region().extrapolate(tnu.constCast());
    }
}
