// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedBodies.H"
#include "bodyPassage.H"
#include "compat.H"
#include "symmetryPlanes.H"

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
        const scalar d = body.distance(state.position + r);
        const scalar image =
            body.distance(state.position + r - 2*(n & r)*n);

        largest = max(largest, mag(d - image));
    }

    return largest;
}

} // End anonymous namespace


Foam::Pair<Foam::scalar> Foam::immersedBodies::largestCells
(
    const bodyRegion& region
) const
{
    Pair<scalar> largest(0, 0);

    forAll(region.cells, i)
    {
        const scalar h = region_.search().h(region.cells[i], region.normal[i]);

        if (mag(region.distance[i]) < h)
        {
            largest.first() = max(largest.first(), h);
        }
        largest.second() = max(largest.second(), h);
    }

    return largest;
}


Foam::scalar Foam::immersedBodies::cellSize
(
    const immersedBody& body,
    const Pair<scalar>& largest
)
{
    // No cell is near the surface if the body is outside the mesh but for its
    // band, or smaller than a cell
    return
        largest.first() > 0 ? largest.first()
      : largest.second() > 0 ? largest.second()
      : body.shape().width();
}


void Foam::immersedBodies::measureCells()
{
    scalarField atSurface(size(), Zero), inBand(size(), Zero);

    for (const bodyRegion& region : region_.regions())
    {
        const Pair<scalar> largest(largestCells(region));
        const label bodyi = region.body();

        atSurface[bodyi] = max(atSurface[bodyi], largest.first());
        inBand[bodyi] = max(inBand[bodyi], largest.second());
    }

    compat::allReduce(atSurface, maxEqOp<scalar>());
    compat::allReduce(inBand, maxEqOp<scalar>());

    forAll(h_, bodyi)
    {
        if (bodies_[bodyi].resolved())
        {
            h_[bodyi] =
                cellSize(bodies_[bodyi], {atSurface[bodyi], inBand[bodyi]});
        }
    }
}


void Foam::immersedBodies::checkInside() const
{
    labelList found(bodies_.size(), 0);

    // A fixed one may be there in part, such as one that a plane of symmetry
    // cuts
    for (const bodyRegion& region : region_.regions())
    {
        const label bodyi = region.body();
        const immersedBody& body = bodies_[bodyi];

        if
        (
            region_.search().findCell(region.centre(body.state())) >= 0
         || (
                (body.isFixed() || body.passing().size())
             && !region.cells.empty()
            )
        )
        {
            found[bodyi] = 1;
        }
    }

    compat::allReduce(found, maxEqOp<label>());

    forAll(bodies_, bodyi)
    {
        if (!found[bodyi])
        {
            FatalIOErrorInFunction(dict_.subDict("bodies"))
                << "'position " << bodies_[bodyi].state().position
                << "' of body '" << bodies_[bodyi].name()
                << "' is outside the mesh, whose bounds are "
                << mesh_.bounds() << nl << exit(FatalIOError);
        }
    }
}


void Foam::immersedBodies::findSymmetry()
{
    const symmetryPlanes planes(mesh_);

    forAll(bodies_, bodyi)
    {
        immersedBody& body = bodies_[bodyi];
        const bodyState& state = body.state();
        const List<vector> normals
        (
            planes.through(state.position, 1e-6*body.shape().width())
        );

        for (const vector& n : normals)
        {
            const scalar across =
                mag(n & state.U)
              + body.shape().boundingRadius()*mag(n ^ state.omega);

            if (cmptMax(cmptMag(n)) < 1 - 1e-6 || across > 0)
            {
                FatalIOErrorInFunction(dict_.subDict("bodies"))
                    << "Body '" << body.name() << "' is cut by a plane of"
                    << " symmetry with the normal " << n << ", which must be"
                    << " a coordinate axis; its 'velocity' must be in that"
                    << " plane and its 'angularVelocity' normal to it" << nl
                    << exit(FatalIOError);
            }

            if (asymmetry(body, n) > 0.01*body.shape().width())
            {
                FatalIOErrorInFunction(dict_.subDict("bodies"))
                    << "Body '" << body.name() << "' is cut by a plane of"
                    << " symmetry with the normal " << n << " and is not"
                    << " symmetric about it; see its 'orientation'" << nl
                    << exit(FatalIOError);
            }

            body.keepOnPlane(n);
            nParts_[bodyi] *= 2;
        }
    }
}


void Foam::immersedBodies::checkResolution() const
{
    forAll(bodies_, bodyi)
    {
        if (bodies_[bodyi].resolved() && cellsPerWidth(bodyi) < 4)
        {
            IOWarningInFunction(dict_.subDict("bodies"))
                << "Body '" << bodies_[bodyi].name() << "' has only "
                << cellsPerWidth(bodyi) << " cells across its width; at least"
                << " 4 are needed, 8 for errors of a percent" << nl << endl;
        }
    }
}


void Foam::immersedBodies::checkSteady() const
{
    if (passage_->injects())
    {
        FatalIOErrorInFunction(dict_.subDict("steady"))
            << "'steady' is not for bodies that enter: remove 'injection'"
            << nl << exit(FatalIOError);
    }

    if (!moving_ || window_.comoving())
    {
        return;
    }

    for (const immersedBody& body : bodies_)
    {
        if (!body.isFixed())
        {
            FatalIOErrorInFunction(dict_.subDict("steady"))
                << "'steady' is for bodies that do not cross the mesh, and"
                << " body '" << body.name() << "' may: allowed are"
                << " 'motion { type fixed; }' for all bodies, or"
                << " 'window { type comoving; ... }'" << nl
                << exit(FatalIOError);
        }
    }
}
