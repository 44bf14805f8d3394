// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyWallDistance.H"
#include "wallDist.H"

const Foam::label Foam::bodyWallDistance::range;


Foam::volScalarField& Foam::bodyWallDistance::distance() const
{
    return const_cast<volScalarField&>(wallDist::New(mesh_).y());
}


bool Foam::bodyWallDistance::moved()
{
    const PtrList<bodyRegion>& regions = bodies_.region().regions();

    List<point> centres(regions.size());
    List<quaternion> orientations(regions.size());

    forAll(regions, i)
    {
        const immersedBody& body = bodies_[regions[i].body()];

        centres[i] =
            body.resolved() ? regions[i].centre(body.state()) : point::max;
        orientations[i] = body.state().orientation;
    }

    const bool changed =
        centres != centres_ || orientations != orientations_;

    centres_.transfer(centres);
    orientations_.transfer(orientations);

    return returnReduce(changed, orOp<bool>());
}


void Foam::bodyWallDistance::add(const bodyRegion& region, scalarField& y)
{
    const immersedBody& body = bodies_[region.body()];
    const cellSearch& search = bodies_.region().search();
    const scalar most = 2*range*body.shape().boundingRadius();
    const labelList near
    (
        search.cellsAround
        (
            region.centre(body.state()),
            body.shape().boundingRadius() + most
        )
    );

    pointField x(mesh_.cellCentres(), near);
    x -= region.shift();

    scalarField d(near.size());
    body.posed().distance(x, d);

    // Models divide by the distance; in cells
    const scalar least = 0.1;

    forAll(near, i)
    {
        const label celli = near[i];

        if (d[i] < most && d[i] < y[celli])
        {
            y[celli] = min(max(d[i], least*search.h()[celli]), y[celli]);
            changed_.append(celli);
        }
    }
}


Foam::bodyWallDistance::bodyWallDistance
(
    const fvMesh& mesh,
    const immersedBodies& bodies
)
:
    mesh_(mesh),
    bodies_(bodies),
    wanted_(mesh.thisDb().foundObject<wallDist>(wallDist::typeName))
{
    if (wanted_)
    {
        scalarField& y = distance().primitiveFieldRef();

        // It is negative where the mesh has no walls
        y = mag(y);
        toWalls_ = y;
    }
}


bool Foam::bodyWallDistance::update()
{
    if (!moved())
    {
        return false;
    }
    if (!wanted_)
    {
        return true;
    }

    volScalarField& y = distance();

    for (const label celli : changed_)
    {
        y[celli] = toWalls_[celli];
    }
    changed_.clear();

    for (const bodyRegion& region : bodies_.region().regions())
    {
        if (bodies_[region.body()].resolved())
        {
            add(region, y.primitiveFieldRef());
        }
    }
    y.correctBoundaryConditions();

    return true;
}
