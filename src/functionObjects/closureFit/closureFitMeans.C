// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyTractions.H"
#include "closureFit.H"
#include "meshLayers.H"
#include "meshProperties.H"
#include "phaseSources.H"
#include <cmath>

namespace
{
    //- Fraction below which a phase is not there
    const Foam::scalar none = 1e-6;
}


Foam::scalarField Foam::functionObjects::closureFit::rows() const
{
    const label n = phaseSources::nColumns;
    const bodyFractions fractions(bodies_);
    const bodyTractions tractions
    (
        bodies_,
        fractions,
        lookupObject<volScalarField>("p"),
        meshProperties::ddt(mesh_, "U")
    );

    if (!tractions.known())
    {
        return scalarField();
    }

    scalarField all
    (
        phaseSources(mesh_, bodies_, fractions, tractions).values()
    );
    const vectorField& U = lookupObject<volVectorField>("U");

    forAll(U, celli)
    {
        scalar* row = &all[n*celli];

        for (direction i = 0; i < 3; ++i)
        {
            row[phaseSources::U + i] = U[celli][i] - row[phaseSources::Ub + i];
        }
    }

    return all;
}


void Foam::functionObjects::closureFit::set
(
    place& one,
    const scalarField& sums
)
{
    typedef phaseSources source;

    const scalar volume = max(sums[0], VSMALL);
    const scalar* of = &sums[1];
    const auto mean = [&](const source::column k, const scalar over)
    {
        return one.both
          ? vector(of[k], of[k + 1], of[k + 2])/over
          : vector(Zero);
    };

    one.eps = of[source::fluid]/volume;
    one.phi = of[source::bodies]/volume;
    one.both = one.eps > none && one.phi > none;
    one.force = mean(source::force, volume);
    one.fluid = mean(source::U, of[source::fluid]);
    one.bodies = mean(source::Ub, of[source::bodies]);
}


bool Foam::functionObjects::closureFit::update()
{
    for (place& one : places_)
    {
        one.M = one.W = one.A = vector::uniform(NAN);
    }

    const scalarField rows(this->rows());

    if (rows.empty() && mesh_.nCells())
    {
        return false;
    }

    const meshLayers layers(mesh_, direction_, max(nLayers_, label(1)));
    const List<scalarField> sums(layers.sums(rows, phaseSources::nColumns));
    scalarField all(phaseSources::nColumns + 1, Zero);

    for (const scalarField& sum : sums)
    {
        all += sum;
    }

    set(places_[0], all);

    for (label i = 0; i < nLayers_; ++i)
    {
        places_[i + 1].position = layers.position(i);
        set(places_[i + 1], sums[i]);
    }

    return true;
}
