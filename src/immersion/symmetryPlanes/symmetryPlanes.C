// SPDX-License-Identifier: GPL-3.0-or-later

#include "symmetryPlanes.H"
#include "symmetryPlanePolyPatch.H"
#include "symmetryPolyPatch.H"

namespace
{

//- Largest difference [m] between the signed distances of points of the
//  display surface and of their images in a plane through the centre with the
//  normal n
Foam::scalar asymmetry
(
    const Foam::immersedBody& body,
    const Foam::vector& n
)
{
    using namespace Foam;

    const bodyState& state = body.state();
    const tensor R(state.orientation.R());
    pointField points;
    faceList faces;
    scalar largest = 0;

    body.shape().surface(points, faces);

    for (const point& X : points)
    {
        const vector r(R & X);
        const scalar d = body.posed().distance(state.position + r);
        const scalar image =
            body.posed().distance(state.position + r - 2*(n & r)*n);

        largest = max(largest, mag(d - image));
    }

    return largest;
}

} // End anonymous namespace


Foam::symmetryPlanes::symmetryPlanes(const fvMesh& mesh)
{
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if
        (
            !isA<symmetryPlanePolyPatch>(patch)
         && !isA<symmetryPolyPatch>(patch)
        )
        {
            continue;
        }

        const vectorField& Sf = patch.faceAreas();
        const scalar area = gSum(mag(Sf));
        const vector normal(gSum(Sf)/max(area, VSMALL));

        // Of a curved patch the normals do not add up
        if (mag(normal) > 1 - 1e-6)
        {
            normals_.append(normal/mag(normal));
            points_.append(gSum(mag(Sf)*patch.faceCentres())/area);
        }
    }
}


Foam::List<Foam::vector> Foam::symmetryPlanes::through
(
    const point& x,
    const scalar tolerance
) const
{
    DynamicList<vector> found;

    forAll(normals_, i)
    {
        if (mag((x - points_[i]) & normals_[i]) < tolerance)
        {
            found.append(normals_[i]);
        }
    }

    return List<vector>(std::move(found));
}


Foam::scalar Foam::symmetryPlanes::bind
(
    immersedBody& body,
    const dictionary& dict
) const
{
    const bodyState& state = body.state();
    const List<vector> normals
    (
        through(state.position, 1e-6*body.shape().width())
    );
    scalar nParts = 1;

    for (const vector& n : normals)
    {
        const scalar across =
            mag(n & state.U)
          + body.shape().boundingRadius()*mag(n ^ state.omega);

        if (cmptMax(cmptMag(n)) < 1 - 1e-6 || across > 0)
        {
            FatalIOErrorInFunction(dict)
                << "Body '" << body.name() << "' is cut by a plane of"
                << " symmetry with the normal " << n << ", which must be"
                << " a coordinate axis; its 'velocity' must be in that"
                << " plane and its 'angularVelocity' normal to it" << nl
                << exit(FatalIOError);
        }

        if (asymmetry(body, n) > 0.01*body.shape().width())
        {
            FatalIOErrorInFunction(dict)
                << "Body '" << body.name() << "' is cut by a plane of"
                << " symmetry with the normal " << n << " and is not"
                << " symmetric about it; see its 'orientation'" << nl
                << exit(FatalIOError);
        }

        body.status().keepOnPlane(n);
        nParts *= 2;
    }

    return nParts;
}
