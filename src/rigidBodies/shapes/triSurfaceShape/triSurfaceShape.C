// SPDX-License-Identifier: GPL-3.0-or-later

#include "triSurfaceShape.H"
#include "addToRunTimeSelectionTable.H"
#include "checkKeywords.H"
#include "momentOfInertia.H"
#include "OSspecific.H"
#include "triSurfaceTools.H"

namespace Foam
{
namespace bodyShapes
{
    defineTypeNameAndDebug(triSurfaceShape, 0);
    addToRunTimeSelectionTable(bodyShape, triSurfaceShape, dictionary);
}
}


Foam::fileName Foam::bodyShapes::triSurfaceShape::findFile
(
    const dictionary& dict
)
{
    const fileName file(dict.get<fileName>("file"));
    const fileName folder(dict.topDict().name().path());

    // <case>/constant, or <case>/processor<i>/constant of a decomposed case
    const fileName path
    (
        file.isAbsolute() ? file : folder/"triSurface"/file
    );
    const fileName undecomposed
    (
        folder.path().path()/folder.name()/"triSurface"/file
    );

    if (isFile(path))
    {
        return path;
    }

    if (file.isAbsolute() || !isFile(undecomposed))
    {
        FatalIOErrorInFunction(dict)
            << "There is no file " << path << ", the 'file' in '"
            << dict.dictName() << "'" << nl << exit(FatalIOError);
    }

    return undecomposed;
}


void Foam::bodyShapes::triSurfaceShape::checkClosed
(
    const dictionary& dict,
    const triSurface& surface
)
{
    const labelListList& edgeFaces = surface.edgeFaces();
    label nOpen = 0, nTurned = 0;

    forAll(edgeFaces, edgei)
    {
        const labelList& joined = edgeFaces[edgei];

        if (joined.size() != 2)
        {
            ++nOpen;
            continue;
        }

        // Neighbours of the same orientation follow an edge in opposite
        // directions
        const edge& e = surface.edges()[edgei];
        const auto& faces = surface.localFaces();

        if (faces[joined[0]].edgeDirection(e)
            == faces[joined[1]].edgeDirection(e))
        {
            ++nTurned;
        }
    }

    if (surface.empty() || nOpen || nTurned)
    {
        FatalIOErrorInFunction(dict)
            << "The surface " << dict.get<fileName>("file")
            << " with " << surface.size()
            << " triangles is not closed: of its " << edgeFaces.size()
            << " edges " << nOpen << " do not join two triangles, " << nTurned
            << " join triangles of different orientation" << nl
            << exit(FatalIOError);
    }
}


Foam::triSurface Foam::bodyShapes::triSurfaceShape::read
(
    const dictionary& dict,
    const geometricSpace& space
)
{
    keywords::check(dict, {"type", "file", "scale"});
    checkSpace(dict, space, 3);

    const triSurface raw(findFile(dict));
    checkClosed(dict, raw);

    // The points that are in use, and the triangles with their labels
    pointField points
    (
        keywords::positiveOr(dict, "scale", 1)*raw.localPoints()
    );
    List<labelledTri> triangles(raw.localFaces());

    scalar volume;
    vector centre;
    tensor inertia;
    momentOfInertia::massPropertiesSolid
    (
        triSurface(triangles, points), 1, volume, centre, inertia
    );

    if (volume < 0)
    {
        for (labelledTri& triangle : triangles)
        {
            triangle.flip();
        }
    }

    points -= centre;

    return triSurface(triangles, points);
}


Foam::bodyShapes::triSurfaceShape::triSurfaceShape
(
    const dictionary& dict,
    const geometricSpace& space
)
:
    triSurfaceShape(read(dict, space))
{}


Foam::bodyShapes::triSurfaceShape::triSurfaceShape(const triSurface& surface)
:
    bodyShape(),
    surface_(surface),
    search_(surface_),
    volume_(0),
    inertia_(Zero),
    boundingRadius_(Foam::sqrt(max(magSqr(surface_.points())))),
    width_(smallestExtent())
{
    vector centre;
    tensor inertia;
    momentOfInertia::massPropertiesSolid
    (
        surface_, 1, volume_, centre, inertia
    );
    inertia_ = symm(inertia);
}


Foam::scalar Foam::bodyShapes::triSurfaceShape::smallestExtent() const
{
    const label step = surface_.size()/200 + 1;
    scalar smallest = 2*boundingRadius_;

    for (label facei = 0; facei < surface_.size(); facei += step)
    {
        const scalarField along
        (
            surface_.points() & surface_.faceNormals()[facei]
        );
        const scalar extent = max(along) - min(along);

        // None along the normal of a triangle without area
        if (extent > SMALL*boundingRadius_)
        {
            smallest = min(smallest, extent);
        }
    }

    return smallest;
}


Foam::scalar Foam::bodyShapes::triSurfaceShape::nearest
(
    const point& X,
    point& onSurface,
    label& facei
) const
{
    const pointIndexHit hit(search_.tree().findNearest(X, sqr(GREAT)));
    onSurface = hit.hitPoint();
    facei = hit.index();

    const bool inside =
        triSurfaceTools::surfaceSide(surface_, X, facei)
     == triSurfaceTools::INSIDE;

    return (inside ? -1 : 1)*mag(X - onSurface);
}


void Foam::bodyShapes::triSurfaceShape::distance
(
    const UList<point>& X,
    UList<scalar>& d
) const
{
    point onSurface;
    label facei;

    forAll(X, i)
    {
        d[i] = nearest(X[i], onSurface, facei);
    }
}


void Foam::bodyShapes::triSurfaceShape::normal
(
    const UList<point>& X,
    UList<vector>& n
) const
{
    point onSurface;
    label facei;

    forAll(X, i)
    {
        const scalar d = nearest(X[i], onSurface, facei);

        // On the surface the direction to it is lost in round-off
        if (mag(d) > 1e-8*boundingRadius_)
        {
            n[i] = (X[i] - onSurface)/d;
        }
        else
        {
            n[i] = surface_.faceNormals()[facei];
        }
    }
}


Foam::autoPtr<Foam::bodyShape> Foam::bodyShapes::triSurfaceShape::makeScaled
(
    const dictionary&,
    const geometricSpace&,
    const scalar factor
) const
{
    return autoPtr<bodyShape>
    (
        new triSurfaceShape
        (
            triSurface
            (
                surface_.localFaces(),
                pointField(factor*surface_.localPoints())
            )
        )
    );
}


Foam::point Foam::bodyShapes::triSurfaceShape::support(const vector& n) const
{
    const pointField& points = surface_.localPoints();

    return points[findMax(scalarField(points & n))];
}


void Foam::bodyShapes::triSurfaceShape::surface
(
    pointField& points,
    faceList& faces
) const
{
    points = surface_.points();
    faces.setSize(surface_.size());

    forAll(faces, facei)
    {
        faces[facei] = face(surface_[facei]);
    }
}
