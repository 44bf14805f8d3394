// SPDX-License-Identifier: GPL-3.0-or-later

#include "Zastawny.H"
#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"

namespace Foam
{
namespace shapeModels
{
    defineTypeNameAndDebug(Zastawny, 0);
    addToRunTimeSelectionTable(shapeModel, Zastawny, dictionary);
}
}


namespace
{

using Foam::scalar;

//- Of the aspect ratios 5/4 and 5/2
const scalar drags[2][9] =
{
    {1.95, 18.12, 1.023, 4.26, 0.384, 21.52, 0.99, 2.86, 0.26},
    {2, 5.1, 0.48, 15.52, 1.05, 24.68, 0.98, 3.19, 0.21}
};

const scalar lifts[2][10] =
{
    {0.083, -0.21, 1.582, 0.851, 1.842, -0.802, -0.006, 0.874, 0.009, 0.57},
    {6.079, 0.898, 0.704, -0.028, 1.067, 0.0025, 0.818, 1.049, 0, 0}
};

const scalar torques[2][10] =
{
    {0.935, 0.146, -0.469, 0.145, 0.116, 0.748, 0.041, 0.221, 0.657, 0.044},
    {2.078, 0.279, 0.372, 0.018, 0.98, 0, 0, 1, 0, 0}
};

//- Reynolds number below which there is no computation
const scalar least = 0.1;

} // End anonymous namespace


Foam::shapeModels::Zastawny::Zastawny
(
    const dictionary& dict,
    const bodyShape& shape
)
:
    ellipsoidShape(dict, shape),
    standard_(dictionary())
{
    const vector& a = axes();

    axis_ = a.x() >= a.y() && a.x() >= a.z() ? 0 : a.y() >= a.z() ? 1 : 2;

    const scalar b = a[(axis_ + 1) % 3], c = a[(axis_ + 2) % 3];
    const scalar aspect = a[axis_]/(0.5*(b + c));

    if (aspect < 1.1 || aspect > 3.5 || max(b, c) > 4.0/3.0*min(b, c))
    {
        FatalErrorInFunction
            << "'shapeModel { type Zastawny; }' in 'coupling' of"
            << " immersedBodyProperties is for long grains: the longest"
            << " semi-axis 1.1 to 3.5 of the others, which differ by a third at"
            << " most; those of the shape '" << shape.type() << "' are " << a
            << ". Use 'type ellipsoid' or 'type sphericity'" << nl
            << exit(FatalError);
    }

    // At the geometric mean of the two
    const label set = sqr(aspect) < 1.25*2.5 ? 0 : 1;

    drag_ = drags[set];
    lift_ = lifts[set];
    torque_ = torques[set];
}


Foam::scalar Foam::shapeModels::Zastawny::across
(
    const scalar* k,
    const scalar Re,
    const scalar sine,
    const scalar cosine
)
{
    return
        (k[0]/pow(Re, k[1]) + k[2]/pow(Re, k[3]))
       *pow(sine, k[4] + k[5]*pow(Re, k[6]))
       *pow(cosine, k[7] + k[8]*pow(Re, k[9]));
}


Foam::vector Foam::shapeModels::Zastawny::alongAxis
(
    const vector& e,
    scalar& sine,
    scalar& cosine
) const
{
    vector along(Zero);

    along[axis_] = e[axis_] < 0 ? -1 : 1;
    cosine = min(mag(e[axis_]), scalar(1));
    sine = Foam::sqrt(1 - sqr(cosine));

    return along;
}


Foam::vector Foam::shapeModels::Zastawny::force
(
    const scalar Re,
    const vector& e
) const
{
    const scalar part = min(Re/least, scalar(1));
    const vector fit(fitted(max(Re, least), e));

    return part < 1 ? part*fit + (1 - part)*ellipsoidShape::force(Re, e) : fit;
}


Foam::vector Foam::shapeModels::Zastawny::fitted
(
    const scalar Re,
    const vector& e
) const
{
    scalar sine, cosine;
    const vector along(alongAxis(e, sine, cosine));
    const scalar* a = drag_;
    const scalar C0 = a[1]/pow(Re, a[2]) + a[3]/pow(Re, a[4]);
    const scalar C90 = a[5]/pow(Re, a[6]) + a[7]/pow(Re, a[8]);
    const scalar CD = C0 + (C90 - C0)*pow(sine, a[0]);
    const scalar sphere = 24*standard_.K(Re, 0)/Re;
    vector f(CD/sphere*e);

    if (sine > 1e-6 && cosine > 1e-6)
    {
        // Away from the end that points downstream
        f -=
            across(lift_, Re, sine, cosine)/sphere*(along - cosine*e)/sine;
    }

    return f;
}


Foam::vector Foam::shapeModels::Zastawny::pitching
(
    const vector& W,
    const scalar D,
    const scalar nu
) const
{
    const scalar Re = mag(W)*D/nu;

    if (Re < 1e-100)
    {
        return Zero;
    }

    const vector e(W/mag(W));
    scalar sine, cosine;
    const vector along(alongAxis(e, sine, cosine));

    if (sine < 1e-6 || cosine < 1e-6)
    {
        return Zero;
    }

    const scalar CT = across(torque_, max(Re, least), sine, cosine);

    return
        CT*constant::mathematical::pi/16*pow3(D)*magSqr(W)*(e^along)/sine;
}
