// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyCellSizes.H"
#include "bodyShare.H"
#include "immersedBody.H"
#include "immersedRegion.H"

namespace
{
    //- Cells across a body below which its layer leaves too little of it
    const Foam::scalar least = 1;
}


Foam::Pair<Foam::scalar> Foam::bodyCellSizes::largest
(
    const bodyRegion& region,
    const cellSearch& search
)
{
    Pair<scalar> largest(0, 0);

    forAll(region.cells, i)
    {
        const scalar h = search.h(region.cells[i], region.normal[i]);

        if (mag(region.distance[i]) < h)
        {
            largest.first() = max(largest.first(), h);
        }
        largest.second() = max(largest.second(), h);
    }

    return largest;
}


Foam::scalar Foam::bodyCellSizes::at
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


void Foam::bodyCellSizes::measure
(
    const bodyList& bodies,
    const immersedRegion& region
)
{
    scalarField atSurface(size(), Zero), inBand(size(), Zero);

    for (const bodyRegion& r : region.regions())
    {
        const Pair<scalar> local(largest(r, region.search()));
        const label bodyi = r.body();

        atSurface[bodyi] = max(atSurface[bodyi], local.first());
        inBand[bodyi] = max(inBand[bodyi], local.second());
    }

    bodies.share().combine(atSurface, maxEqOp<scalar>());
    bodies.share().combine(inBand, maxEqOp<scalar>());

    scalarList& h = *this;

    forAll(h, bodyi)
    {
        if (bodies[bodyi].resolved())
        {
            h[bodyi] = at(bodies[bodyi], {atSurface[bodyi], inBand[bodyi]});
        }
    }
}


Foam::scalar Foam::bodyCellSizes::perWidth
(
    const immersedBody& body,
    const label bodyi
) const
{
    return body.shape().width()/operator[](bodyi);
}


void Foam::bodyCellSizes::checkResolution
(
    const PtrList<immersedBody>& bodies,
    const dictionary& dict
) const
{
    forAll(bodies, bodyi)
    {
        const immersedBody& body = bodies[bodyi];
        const scalar n = perWidth(body, bodyi);

        // One that is leaving may have no cells any more
        if
        (
            body.resolved() && n <= least
         && !body.isFixed() && body.status().passing().empty()
        )
        {
            FatalIOErrorInFunction(dict)
                << "Body '" << body.name() << "' has only " << n
                << " cells across its width, which is too few for the mesh to"
                << " see it: at least 4 are needed, 8 for errors of a percent;"
                << " or, in 3D, 'coupling { type auto; }'" << nl
                << exit(FatalIOError);
        }

        if (body.resolved() && n < 4)
        {
            IOWarningInFunction(dict)
                << "Body '" << body.name() << "' has only " << n
                << " cells across its width; at least 4 are needed, 8 for"
                << " errors of a percent" << nl << endl;
        }
    }
}
