// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluidWithBodies.H"
#include "carrierFlow.H"
#include "compatMesh.H"
#include "meshProperties.H"

Foam::flowSolvers::fluidWithBodies::fluidWithBodies(dynamicFvMesh& mesh)
:
    incompressibleFluid(mesh),
    ownBodies_
    (
        new immersedBodies(mesh, immersedBodies::readProperties(mesh))
    ),
    startTime_(mesh.time().value()),
    bodies_(ownBodies_())
{
    checkSettings();
    compat::setFinalIteration(mesh_, true);
}


void Foam::flowSolvers::fluidWithBodies::checkSettings() const
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
        bodies_.disperse()
     && momentumTransport->get<word>("simulationType") == "laminar"
    )
    {
        FatalIOErrorInFunction(*momentumTransport)
            << "'dispersion' of unresolved bodies needs a turbulence model, and"
            << " 'simulationType' is laminar" << nl << exit(FatalIOError);
    }

    // Refuses schemes that the bodies' equations do not follow
    meshProperties::ddt(mesh_, U_.name());
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
    skipped += bodies_.contact() ? "" : ", contact";
    skipped += bodies_.lubrication() ? "" : ", lubrication";

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

    if (bodies_.disperse())
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
        tepsilon.valid() ? &tepsilon().primitiveField() : nullptr
    };

    return bodies_.correctUnresolved(ddt, flow);
}
