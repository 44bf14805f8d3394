// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluidConstants.H"
#include "checkKeywords.H"
#include "dimensionedVector.H"
#include "IOdictionary.H"
#include "meshProperties.H"
#include "uniformDimensionedFields.H"

namespace
{

//- transportProperties; empty if there is no such file
Foam::dictionary readTransport(const Foam::fvMesh& mesh)
{
    const Foam::IOdictionary transport
    (
        Foam::IOobject
        (
            "transportProperties",
            mesh.time().constant(),
            mesh,
            Foam::IOobject::READ_IF_PRESENT,
            Foam::IOobject::NO_WRITE,
            false
        )
    );

    return Foam::dictionary(transport);
}

} // End anonymous namespace


Foam::fluidConstants::fluidConstants
(
    const dictionary& dict,
    const fvMesh& mesh
)
:
    rho_(readRho(dict, mesh)),
    nu_(readNu(mesh)),
    g_(readGravity(mesh))
{}


Foam::scalar Foam::fluidConstants::readRho
(
    const dictionary& dict,
    const fvMesh& mesh
)
{
    if (dict.found("rho"))
    {
        return keywords::positive(dict, "rho");
    }

    const dictionary transport(readTransport(mesh));

    return transport.found("rho")
      ? dimensionedScalar("rho", dimDensity, transport).value()
      : -1;
}


Foam::scalar Foam::fluidConstants::readNu(const fvMesh& mesh)
{
    const dictionary transport(readTransport(mesh));
    const word model
    (
        transport.lookupOrDefault<word>("transportModel", word::null)
    );

    return model == "Newtonian" && transport.found("nu")
      ? dimensionedScalar("nu", dimViscosity, transport).value()
      : -1;
}


Foam::vector Foam::fluidConstants::readGravity(const fvMesh& mesh)
{
    const uniformDimensionedVectorField g
    (
        IOobject
        (
            "g",
            mesh.time().constant(),
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE,
            false
        ),
        dimensionedVector(dimAcceleration, Zero)
    );

    const vector out
    (
        g.value()
      - cmptMultiply(g.value(), meshProperties::space(mesh).translation())
    );

    if (g.dimensions() != dimAcceleration || magSqr(out) > 0)
    {
        FatalErrorInFunction
            << "'value " << g.value() << "', 'dimensions " << g.dimensions()
            << "' in " << g.objectPath() << ": allowed are dimensions "
            << dimAcceleration << " and vectors in the plane of the mesh" << nl
            << exit(FatalError);
    }

    return g.value();
}
