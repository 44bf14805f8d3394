// SPDX-License-Identifier: GPL-3.0-or-later

#include "sphericity.H"
#include "mathematicalConstants.H"

namespace
{

//- Sphericity of a shape
Foam::scalar measure(const Foam::bodyShape& shape)
{
    using namespace Foam;
    using constant::mathematical::pi;

    if (shape.round())
    {
        return 1;
    }

    pointField points;
    faceList faces;
    shape.surface(points, faces);

    scalar area = 0;

    for (const face& f : faces)
    {
        area += f.mag(points);
    }

    return min(Foam::cbrt(pi*sqr(6*shape.volume()))/area, scalar(1));
}

} // End anonymous namespace


Foam::sphericity::sphericity(const scalar psi)
:
    psi_(psi)
{}


Foam::sphericity::sphericity(const bodyShape& shape)
:
    psi_(measure(shape))
{}


Foam::scalar Foam::sphericity::K(const scalar Re, const scalar psi)
{
    const scalar A = exp(2.3288 - 6.4581*psi + 2.4486*sqr(psi));
    const scalar B = 0.0964 + 0.5565*psi;
    const scalar C =
        exp(4.9050 + psi*(-13.8944 + psi*(18.4222 - 10.2599*psi)));
    const scalar D =
        exp(1.4681 + psi*(12.2584 + psi*(-20.7322 + 15.8855*psi)));

    return 1 + A*pow(Re, B) + C*sqr(Re)/(24*(Re + D));
}


Foam::scalar Foam::sphericity::factor(const scalar Re) const
{
    return psi_ < 1 ? K(Re, psi_)/K(Re, 1) : 1;
}
