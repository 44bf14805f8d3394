// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyLoads.H"
#include "compat.H"
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
    const auto measured = [&](const label bodyi)
    {
        return bodies_[bodyi].resolved() && region.selected(bodyi);
    };
    scalarField packed(n*bodies_.nResolved());
    label at = 0;

    forAll(loads_, bodyi)
    {
        if (measured(bodyi))
        {
            loads_[bodyi].pack(packed, at, n);
            at += n;
        }
    }

    packed.resize(at);
    compat::allReduce(packed, plusEqOp<scalar>());
    at = 0;

    forAll(loads_, bodyi)
    {
        if (measured(bodyi))
        {
            loads_[bodyi].unpack(packed, at, n);
            at += n;
        }
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
    scalar sum = 0, volume = 0;

    forAll(loads_, bodyi)
    {
        if (bodies_[bodyi].resolved())
        {
            sum += loads_[bodyi].slip;
            volume += loads_[bodyi].volume;
        }
    }

    return Foam::sqrt(sum/max(volume, VSMALL));
}
