// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshProperties.H"
#include "checkKeywords.H"

Foam::geometricSpace Foam::meshProperties::space(const polyMesh& mesh)
{
    if (mesh.nSolutionD() == 3 && mesh.nGeometricD() == 3)
    {
        return geometricSpace(-1);
    }

    if (mesh.nSolutionD() != 2 || mesh.nGeometricD() != 2)
    {
        FatalErrorInFunction
            << "Immersed bodies need a mesh in three dimensions or, between"
            << " two empty patches, in two; this one has "
            << mesh.nGeometricD() << " geometric and " << mesh.nSolutionD()
            << " solution directions" << nl << exit(FatalError);
    }

    direction empty = 0;

    while (mesh.solutionD()[empty] > 0)
    {
        ++empty;
    }

    return geometricSpace
    (
        empty,
        mesh.bounds().span()[empty],
        mesh.bounds().midpoint()[empty]
    );
}


Foam::ddtCoefficients Foam::meshProperties::ddt
(
    const fvMesh& mesh,
    const word& fieldName
)
{
    const word scheme(mesh.ddtScheme("ddt(" + fieldName + ')'));

    if (!ddtCoefficients::schemes().found(scheme))
    {
        keywords::refuse
        (
            mesh.schemesDict().subDict("ddtSchemes"),
            "ddt(" + fieldName + ')',
            scheme,
            ddtCoefficients::schemes()
        );
    }

    // The first step of a run knows one previous level only: as the fluid's
    // scheme does, take the one before as infinitely old
    const Time& time = mesh.time();

    return ddtCoefficients
    (
        scheme,
        time.deltaTValue(),
        time.timeIndex() < 2 ? GREAT : time.deltaT0Value()
    );
}
