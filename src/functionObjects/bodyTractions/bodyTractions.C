// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyTractions.H"
#include "bodyShare.H"

Foam::bodyTractions::bodyTractions
(
    const immersedBodies& bodies,
    const bodyFractions& fractions,
    const scalarField& p,
    const ddtCoefficients& ddt
)
:
    surface_(bodies.size(), Zero),
    inertia_(bodies.size(), Zero),
    known_(true)
{
    const immersedRegion& region = bodies.region();
    const scalarField& V = region.search().mesh().cellVolumes();

    forAll(region.regions(), regioni)
    {
        const bodyRegion& one = region.regions()[regioni];
        const immersedBody& body = bodies[one.body()];
        const rigidAcceleration acceleration(body.motion().acceleration(ddt));
        tensor& surface = surface_[one.body()];
        tensor& inertia = inertia_[one.body()];

        if (one.force.size() != one.cells.size())
        {
            known_ = false;
            continue;
        }

        forAll(one.cells, i)
        {
            const label celli = one.cells[i];
            const vector r(one.x(i) - one.position());
            const scalar inside = V[celli]*fractions[regioni][i];
            const tensor rate(inside*(acceleration(r)*r));

            surface += rate - inside*p[celli]*I - V[celli]*(one.force[i]*r);
            inertia -= body.densityRatio()*rate;
        }
    }

    reduce(known_, andOp<bool>());

    for (tensorField* moments : {&surface_, &inertia_})
    {
        bodies.list().share().combine(*moments, plusEqOp<tensor>());
    }
}
