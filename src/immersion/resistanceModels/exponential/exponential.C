// SPDX-License-Identifier: GPL-3.0-or-later

#include "exponential.H"
#include "addToRunTimeSelectionTable.H"
#include "checkKeywords.H"

namespace Foam
{
namespace resistanceModels
{
    defineTypeNameAndDebug(exponential, 0);
    addToRunTimeSelectionTable(resistanceModel, exponential, dictionary);
}
}


namespace
{

using Foam::scalar;

//- Cap of the resistance as a multiple of the momentum coefficient
const scalar cap = 1e6;


//- The parabola through (1, y0), (1.1, y1), (1.2, y2) at x
scalar interpolate
(
    const scalar x,
    const scalar y0,
    const scalar y1,
    const scalar y2
)
{
    const scalar t = 10*(x - 1);

    return y0 + t*(y1 - y0) + 0.5*t*(t - 1)*(y2 - 2*y1 + y0);
}


//- 1 up to start, 0 from end on
scalar fade(const scalar x, const scalar start, const scalar end)
{
    return x > start ? Foam::max((end - x)/(end - start), 0) : 1;
}

//- Value i of a list, zero if it is empty
scalar valueOf(const Foam::scalarField& values, const Foam::label i)
{
    return values.empty() ? 0 : values[i];
}

//- Sharper curvatures, times the cell size, are taken for this one
const scalar sharpest = 1.0/3.0;

} // End anonymous namespace


Foam::resistanceModels::exponential::exponential
(
    const dictionary& dict,
    const fvMesh&,
    const bool bodiesMove
)
:
    resistanceModel(),
    steepness_(bodiesMove ? 1.0 : 1.2)
{
    keywords::check(dict, {"type", "steepness", "shieldShift", "shieldWidth"});

    if (dict.found("steepness"))
    {
        const token t(dict.lookup("steepness"));

        if (t.isNumber() && t.number() >= 1 && t.number() <= 1.2)
        {
            steepness_ = t.number();
        }
        else if (!t.isWord() || t.wordToken() != "auto")
        {
            FatalIOErrorInFunction(dict)
                << "'steepness' in '" << dict.dictName()
                << "' must be 'auto' or a number from 1 to 1.2" << nl
                << exit(FatalIOError);
        }
    }

    // Calibrated pairs for a = 1, 1.1 and 1.2
    shieldShift_ = dict.lookupOrDefault<scalar>
    (
        "shieldShift",
        interpolate(steepness_, -0.05, -0.033, 0)
    );
    shieldWidth_ = keywords::positiveOr
    (
        dict,
        "shieldWidth",
        interpolate(steepness_, 1.115, 1.0, 0.9)
    );

    fadeStart_ = interpolate(steepness_, 2.2, 3.1, 4);
    fadeEnd_ = interpolate(steepness_, 3.2, 4.35, 5.5);
    factor_ = interpolate(steepness_, 1.0704, 1.0156, 1);
    shieldFade_ = interpolate(steepness_, 2, 3.5, 5);
    shieldEnd_ = interpolate(steepness_, 2.8, 3.9, 5);
    bend_ = interpolate(steepness_, 0, 0.5, 1);
}


Foam::scalar Foam::resistanceModels::exponential::bandWidth() const
{
    return max(fadeEnd_/steepness_, shieldShift_ + shieldEnd_*shieldWidth_);
}


Foam::scalar Foam::resistanceModels::exponential::shieldAt
(
    const scalar d,
    const scalar bend
) const
{
    const scalar x = (d - shieldShift_)/(shieldWidth_ + 0.9*bend);

    // (1 - tanh(x))/2
    return x < shieldEnd_
      ? fade(x, shieldFade_, shieldEnd_)/(1 + Foam::exp(2*x))
      : 0;
}


Foam::tmp<Foam::scalarField> Foam::resistanceModels::exponential::bends
(
    const immersedBody& body,
    const UList<vector>& n,
    const UList<scalar>& h
) const
{
    tmp<scalarField> tbends(new scalarField);

    if (bend_ > 0)
    {
        scalarField& bends = tbends.ref();
        bends.setSize(h.size());

        const tensor R(body.state().orientation.R());

        body.shape().curvature(vectorField(R.T() & vectorField(n)), bends);

        forAll(bends, i)
        {
            bends[i] = bend_*sqr(min(bends[i]*h[i], sharpest));
        }
    }

    return tbends;
}


void Foam::resistanceModels::exponential::setShield
(
    const immersedBody& body,
    bodyRegion& region
) const
{
    const scalarField bend(bends(body, region.normal, region.h));

    forAll(region.cells, i)
    {
        region.shield[i] =
            shieldAt(region.distance[i]/region.h[i], valueOf(bend, i));
    }

    const scalarField faceBend(bends(body, region.faceNormal, region.faceH));

    forAll(region.faces, i)
    {
        region.faceShield[i] =
            shieldAt
            (
                region.faceDistance[i]/region.faceH[i], valueOf(faceBend, i)
            );
    }
}


void Foam::resistanceModels::exponential::setResistance
(
    const immersedBody& body,
    const scalarField& A0,
    const scalarField& nu,
    bodyRegion& region
) const
{
    const scalar gamma = 0.5772156649015329;
    const scalar a = steepness_;
    const scalar factor = factor_*sqr(2*a*Foam::exp(-gamma));
    const scalarField bend(bends(body, region.normal, region.h));

    forAll(region.cells, i)
    {
        const label celli = region.cells[i];
        const scalar h = region.h[i];
        const scalar ad = a*(region.distance[i]/h + 0.1*valueOf(bend, i));

        if (ad >= fadeEnd_)
        {
            region.resistance[i] = 0;
            continue;
        }

        // Beyond exp(60) the cap applies whatever the other factors
        const scalar K =
            nu[celli]/sqr(h)*factor
           *Foam::exp(sqr(a)*region.c4[i]/18 - 2*max(ad, scalar(-30)));

        region.resistance[i] =
            min(fade(ad, fadeStart_, fadeEnd_)*K, cap*A0[celli]);
    }
}


void Foam::resistanceModels::exponential::report(Ostream& os) const
{
    os  << "exponential, steepness " << steepness_ << ", shield shift "
        << shieldShift_ << " width " << shieldWidth_;
}
