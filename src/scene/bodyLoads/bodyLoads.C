// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyLoads.H"
#include "bodyShare.H"
#include "symmetryPlanes.H"
#include "unresolvedCoupling.H"

Foam::bodyLoads::bodyLoads
(
    const fvMesh& mesh,
    const dictionary& dict,
    bodyList& bodies
)
:
    bodies_(bodies),
    nParts_(bodies, 1),
    loads_(bodies)
{
    const symmetryPlanes planes(mesh);

    forAll(bodies, bodyi)
    {
        nParts_[bodyi] = planes.bind(bodies[bodyi], dict);
    }
}


void Foam::bodyLoads::reduce
(
    const immersedRegion& region,
    const bool response
)
{
    if (!Pstream::parRun())
    {
        return;
    }

    const label n = response ? bodyLoad::nPacked : bodyLoad::nPackedLoad;
    DynamicList<label> measured(bodies_.size());

    forAll(bodies_, bodyi)
    {
        if (bodies_[bodyi].resolved() && region.selected(bodyi))
        {
            measured.append(bodyi);
        }
    }

    scalarField packed(n*measured.size());

    forAll(measured, i)
    {
        loads_[measured[i]].pack(packed, n*i, n);
    }
    bodies_.share().combine(measured, n, packed, plusEqOp<scalar>());
    forAll(measured, i)
    {
        loads_[measured[i]].unpack(packed, n*i, n);
    }
}


void Foam::bodyLoads::measure
(
    const solvedMomentum& solved,
    const bool response,
    immersedRegion& region
)
{
    region.load(bodies_, solved, response, loads_);

    forAll(loads_, bodyi)
    {
        if (region.selected(bodyi))
        {
            loads_[bodyi].scale(nParts_[bodyi], response);
        }
    }

    reduce(region, response);
}


void Foam::bodyLoads::noteUnresolved(const unresolvedCoupling& coupling)
{
    forAll(bodies_, bodyi)
    {
        if (!bodies_[bodyi].resolved())
        {
            loads_[bodyi].volume =
                coupling.kernels().inside(bodyi) ? bodies_[bodyi].volume() : 0;
        }
    }
}


Foam::scalar Foam::bodyLoads::slip() const
{
    // Of squares, and volume
    const vector2D sums = bodies_.share().sum<vector2D>
    (
        [&](const label bodyi)
        {
            return bodies_[bodyi].resolved()
              ? vector2D(loads_[bodyi].slip, loads_[bodyi].volume)
              : vector2D(Zero);
        }
    );

    return Foam::sqrt(sums.x()/max(sums.y(), VSMALL));
}
