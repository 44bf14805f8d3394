// SPDX-License-Identifier: GPL-3.0-or-later

#include "incompressibleFluid.H"
#include "addToRunTimeSelectionTable.H"
#include "findRefCell.H"
#include "functionObject.H"
#include "fvcFlux.H"
#include "surfaceInterpolate.H"

namespace Foam
{
namespace flowSolvers
{
    defineTypeNameAndDebug(incompressibleFluid, 0);
    addToRunTimeSelectionTable(flowSolver, incompressibleFluid, dynamicFvMesh);
}
}

namespace
{
    //- A field's file in the start time
    Foam::IOobject fieldIO
    (
        const Foam::word& name,
        const Foam::fvMesh& mesh,
        const Foam::IOobject::readOption read
    )
    {
        return Foam::IOobject
        (
            name,
            mesh.time().timeName(),
            mesh,
            read,
            Foam::IOobject::AUTO_WRITE
        );
    }
}


Foam::flowSolvers::incompressibleFluid::incompressibleFluid
(
    dynamicFvMesh& mesh
)
:
    incompressibleFluid(mesh, false)
{}


Foam::flowSolvers::incompressibleFluid::incompressibleFluid
(
    dynamicFvMesh& mesh,
    const bool more
)
:
    flowSolver(mesh),
    p_(fieldIO("p", mesh, IOobject::MUST_READ), mesh),
    pRefCell(0),
    pRefValue(0),
    U_(fieldIO("U", mesh, IOobject::MUST_READ), mesh),
    phi_(fieldIO("phi", mesh, IOobject::READ_IF_PRESENT), fvc::flux(U_)),
    laminarTransport(U_, phi_),
    momentumTransport
    (
        incompressible::turbulenceModel::New(U_, phi_, laminarTransport)
    ),
    MRF(mesh),
    fvOptions(fv::options::New(mesh)),
    adjustTimeStep(false),
    maxCo(1),
    maxDeltaT(GREAT),
    correctPhi(mesh.dynamic()),
    checkMeshCourantNo(false),
    moveMeshOuterCorrectors(false),
    fluxSums_(phi_),
    CoNum(0),
    cumulativeContErr
    (
        IOobject
        (
            "cumulativeContErr",
            runTime_.timeName(),
            "uniform",
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        ),
        dimensionedScalar(dimless, Zero)
    ),
    p(p_),
    U(U_),
    phi(phi_)
{
    setRefCell(p_, pimple_.dict(), pRefCell, pRefValue);
    mesh_.setFluxRequired(p_.name());
    readControls();

    // What follows prepares a time step and would change what the
    // post-processing of a stored time sees
    if (functionObject::postProcess)
    {
        return;
    }

    if (mesh_.dynamic())
    {
        Uf.reset
        (
            new surfaceVectorField
            (
                fieldIO("Uf", mesh_, IOobject::READ_IF_PRESENT),
                fvc::interpolate(U_)
            )
        );
    }

    correctCoNum();
    if (!more)
    {
        setInitialDeltaT();
    }
    momentumTransport->validate();
}


void Foam::flowSolvers::incompressibleFluid::preSolve()
{
    readControls();
    correctCoNum();
    adjustDeltaT();
}


void Foam::flowSolvers::incompressibleFluid::momentumTransportCorrector()
{
    if (pimple_.turbCorr())
    {
        laminarTransport.correct();
        momentumTransport->correct();
    }
}


void Foam::flowSolvers::incompressibleFluid::check()
{
    flowSolver::check();
    Info<< "    turbulence       " << momentumTransport->type() << nl
        << "    MRF zones        " << MRF.MRFZoneList::size() << nl
        << "    fvOptions        " << fvOptions.optionList::size() << nl
        << "    outer, pressure, non-orthogonal correctors  "
        << pimple_.nCorrPIMPLE() << ' ' << pimple_.nCorrPISO() << ' '
        << pimple_.nNonOrthCorr() << nl
        << "    Courant number   " << CoNum << endl;

    // Schemes, linear solvers and function objects are looked up when first
    // used: use them now, so that a missing one stops the check
    assembleMomentum();

    for (const bool final : {false, true})
    {
        if (final || pimple_.nCorrPISO() > 1 || pimple_.nNonOrthCorr() > 0)
        {
            mesh_.solverDict(p_.select(final));
        }

        const bool used = final || pimple_.nCorrPIMPLE() > 1;

        if (pimple_.momentumPredictor() && used)
        {
            mesh_.solverDict(U_.select(final));
        }
    }

    // They are not to write
    functionObject::postProcess = true;
    runTime_.functionObjects().read();
    functionObject::postProcess = false;
}
