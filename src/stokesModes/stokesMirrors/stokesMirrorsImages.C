// SPDX-License-Identifier: GPL-3.0-or-later

#include "stokesMirrors.H"
#include <algorithm>

namespace
{
    //- Digits of positions, over the size of the mesh, by which states are told
    //  apart
    const Foam::scalar digits = 1e8;
}


Foam::stokesMirrors::image Foam::stokesMirrors::reflect
(
    const label state,
    const label reflections
) const
{
    const label nBodies = bodies_.size();
    pointField x(states_.positions(state));
    std::vector<std::vector<label>> keys(nBodies);
    const scalar size = bodies_.mesh().bounds().mag();

    for (label bodyi = 0; bodyi < nBodies; ++bodyi)
    {
        forAll(axes_, i)
        {
            scalar& c = x[bodyi][axes_[i]];
            c = reflections & (1 << i) ? 2*middle_[axes_[i]] - c : c;
        }

        // Those of one radius can be interchanged
        const auto add = [&](const scalar c)
        {
            keys[bodyi].push_back(label(std::floor(digits*c/size + 0.5)));
        };

        add(bodies_[bodyi].shape().boundingRadius());
        add(x[bodyi].x());
        add(x[bodyi].y());
        add(x[bodyi].z());
    }

    image im{{}, reflections, identity(nBodies)};

    std::sort
    (
        im.order.begin(),
        im.order.end(),
        [&](const label a, const label b) { return keys[a] < keys[b]; }
    );
    for (const label bodyi : im.order)
    {
        im.key.insert(im.key.end(), keys[bodyi].begin(), keys[bodyi].end());
    }

    return im;
}


Foam::stokesMirrors::image Foam::stokesMirrors::first(const label state) const
{
    image im(reflect(state, 0));

    for (label i = 1; i < (1 << axes_.size()); ++i)
    {
        image other(reflect(state, i));

        if (other.key < im.key)
        {
            im = other;
        }
    }

    return im;
}


void Foam::stokesMirrors::note(const label state)
{
    if (axes_.size())
    {
        known_.insert({first(state).key, state});
    }
}


Foam::label Foam::stokesMirrors::find(const label state) const
{
    if (axes_.empty())
    {
        return -1;
    }

    const auto found = known_.find(first(state).key);

    return found == known_.end() ? -1 : found->second;
}


Foam::scalar Foam::stokesMirrors::sign
(
    const label mode,
    const label reflections
) const
{
    const rigidMotion motion(bodies_.motion(mode));
    scalar sign = 1;

    forAll(axes_, i)
    {
        if (reflections & (1 << i))
        {
            // Velocities across the plane turn, spins about axes along it
            sign *= motion.U[axes_[i]] != 0 ? -1 : 1;
            sign *= mag(motion.omega) > 0 && motion.omega[axes_[i]] == 0
              ? -1 : 1;
        }
    }

    return sign;
}


Foam::scalarList Foam::stokesMirrors::reflected
(
    const label state,
    const label other,
    const scalarList& row
) const
{
    const image here(first(state)), there(first(other));
    const label reflections = here.reflections ^ there.reflections;
    const label n = bodies_.nModes(), nPerBody = bodies_.nPerBody();
    labelList from(n);
    scalarList result(row);
    scalar flowSign = 1;

    forAll(axes_, i)
    {
        flowSign *= reflections & (1 << i) ? flowSigns_[i] : 1;
    }

    forAll(here.order, k)
    {
        for (label l = 0; l < nPerBody; ++l)
        {
            from[nPerBody*here.order[k] + l] = nPerBody*there.order[k] + l;
        }
    }

    for (label i = 0; i < n; ++i)
    {
        const scalar si = sign(i, reflections);

        // V, V1, B, C
        for (label q = 0; q < 4; ++q)
        {
            const scalar flow = q % 2 == 0 ? flowSign : 1;

            result[q*n + i] = flow*si*row[q*n + from[i]];
        }
        for (label j = 0; j < n; ++j)
        {
            result[4*n + i*n + j] =
                si*sign(j, reflections)*row[4*n + from[i]*n + from[j]];
        }
    }

    return result;
}
