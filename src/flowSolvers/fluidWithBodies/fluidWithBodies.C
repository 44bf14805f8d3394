// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluidWithBodies.H"
#include "bodyContacts.H"
#include "bodyProperties.H"
#include "carrierFlow.H"
#include "compatMesh.H"
#include "functionObject.H"
#include "meshProperties.H"
#include "unresolvedBodies.H"

Foam::flowSolvers::fluidWithBodies::fluidWithBodies(dynamicFvMesh& mesh)
:
    incompressibleFluid(mesh, true),
    ownBodies_
    (
        new immersedBodies(mesh, bodyProperties::read(mesh))
    ),
    startTime_(mesh.time().value()),
    warned_(false),
    warnedOfSlip_(false),
    bodies_(ownBodies_())
{
    checkSettings();
    compat::setFinalIteration(mesh_, true);

    if (!functionObject::postProcess)
    {
        setInitialDeltaT();
    }
}


void Foam::flowSolvers::fluidWithBodies::checkSettings()
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
        bodies_.unresolved().coupling().disperses()
     && momentumTransport->get<word>("simulationType") == "laminar"
    )
    {
        FatalIOErrorInFunction(*momentumTransport)
            << "'dispersion' of unresolved bodies needs a turbulence model, and"
            << " 'simulationType' is laminar" << nl << exit(FatalIOError);
    }

    // Refuses schemes that the bodies' equations do not follow
    meshProperties::ddt(mesh_, U_.name());

    checkFluid();
}


void Foam::flowSolvers::fluidWithBodies::checkFluid()
{
    const scalar nu = gMin(laminarTransport.nu()().primitiveField());

    if (!(nu > 0))
    {
        FatalIOErrorInFunction(laminarTransport)
            << "The viscosity 'nu' [m2/s] is " << nu << " and must be greater"
            << " than 0: bodies move the fluid by it" << nl
            << exit(FatalIOError);
    }

    for (const fv::option& one : static_cast<const fv::optionList&>(fvOptions))
    {
        if (one.type() == "meanVelocityForce")
        {
            FatalIOErrorInFunction(fvOptions)
                << "'type meanVelocityForce' in '" << one.name()
                << "' corrects the velocity and not the flux, which the bodies"
                << " are held by: use 'type flowRateForce' with 'direction' and"
                << " 'meanVelocity'" << nl << exit(FatalIOError);
        }
    }

    const word equation(U_.select(true));

    if
    (
        mesh_.relaxEquation(equation)
     && mesh_.equationRelaxationFactor(equation) < 1
    )
    {
        FatalIOErrorInFunction
        (
            mesh_.solutionDict().subDict("relaxationFactors")
        )   << "The momentum equation with bodies is that of the last"
            << " iteration, and must not be relaxed: in 'equations' the factor"
            << " of '" << equation << "' is "
            << mesh_.equationRelaxationFactor(equation) << " and must be 1"
            << nl << exit(FatalIOError);
    }

    // What is missing is found before the first time step
    mesh_.solver(U_.select(true));
    mesh_.solver(p_.select(true));
}


void Foam::flowSolvers::fluidWithBodies::reportIgnored() const
{
    const dictionary& dict = pimple_.dict();
    string ignored;

    for (const word key : {"nOuterCorrectors", "nCorrectors"})
    {
        if (dict.lookupOrDefault<label>(key, 1) != 1)
        {
            ignored += " '" + key + "'";
        }
    }
    if (dict.lookupOrDefault("consistent", false))
    {
        ignored += " 'consistent'";
    }
    if (!dict.lookupOrDefault("momentumPredictor", true))
    {
        ignored += " 'momentumPredictor'";
    }

    if (!ignored.empty())
    {
        Info<< "    not used, of 'PIMPLE' in " << dict.topDict().name()
            << ":" << ignored.c_str() << "; iterations are those of 'coupling'"
            << nl;
    }

    const dictionary& p = mesh_.solver(p_.select(true));
    const scalar tolerance = p.lookupOrDefault<scalar>("tolerance", 1e-6);
    const scalar relTol = p.lookupOrDefault<scalar>("relTol", 0);

    if (max(relTol, tolerance) < 1e-4 && p.get<word>("solver") != "fastPoisson")
    {
        Info<< "    pressure: solved for its increment, from zero, so that"
            << " 'relTol " << relTol << "' and 'tolerance " << tolerance
            << "' ask for " << max(relTol, tolerance)
            << " of what it begins with; 'relTol 0.01' does" << nl;
    }
}


void Foam::flowSolvers::fluidWithBodies::reportSetUp
(
    const string& coupling,
    const string& ofFluid
) const
{
    bodies_.report(Info);

    if (!coupling.empty())
    {
        Info<< "    coupling: " << coupling.c_str() << nl;
    }

    // Each with a comma and a space before
    string skipped;
    skipped += bodies_.moving() ? "" : ", motion of bodies";
    skipped += ofFluid;
    skipped += bodies_.contacts().active() ? "" : ", contact";
    skipped += bodies_.contacts().lubrication() ? "" : ", lubrication";

    reportIgnored();
    Info<< "    skipped: "
        << (skipped.empty() ? "nothing" : skipped.substr(2).c_str()) << nl
        << endl;
}


void Foam::flowSolvers::fluidWithBodies::correctViscosity()
{
    laminarTransport.correct();

    if (laminarTransport.get<word>("transportModel") != "Newtonian")
    {
        const tmp<volScalarField> tnu(laminarTransport.nu());

        bodies_.region().extrapolate(tnu.constCast());
    }
}


void Foam::flowSolvers::fluidWithBodies::setTimeStep()
{
    readControls();
    correctCoNum();
    CoNum = max(CoNum, bodies_.courantNo());
    adjustDeltaT();
}


Foam::tmp<Foam::vectorField>
Foam::flowSolvers::fluidWithBodies::moveUnresolved(const ddtCoefficients& ddt)
{
    tmp<volScalarField> tk, tepsilon;

    if (bodies_.unresolved().coupling().disperses())
    {
        tk = momentumTransport->k();
        tepsilon = momentumTransport->epsilon();
    }

    const tmp<volScalarField> tnu(momentumTransport->nu());
    const tmp<volScalarField> tnuEff(momentumTransport->nuEff());
    const carrierFlow flow
    {
        U_,
        tnu().primitiveField(),
        tnuEff().primitiveField(),
        tk.valid() ? &tk().primitiveField() : nullptr,
        tepsilon.valid() ? &tepsilon().primitiveField() : nullptr,
        nullptr
    };

    return bodies_.unresolved().correct(ddt, flow);
}
