// SPDX-License-Identifier: GPL-3.0-or-later

#include "ellipsoidShape.H"
#include "addToRunTimeSelectionTable.H"
#include "checkKeywords.H"
#include "mathematicalConstants.H"
#include "sphericity.H"

namespace Foam
{
namespace shapeModels
{
    defineTypeNameAndDebug(ellipsoidShape, 0);
    addToRunTimeSelectionTable(shapeModel, ellipsoidShape, dictionary);
}
}


namespace
{

using namespace Foam;

//- Semi-axes [m] of the ellipsoid with the ratios of the moments of inertia and
//  the volume of a shape
vector semiAxes(const bodyShape& shape)
{
    const symmTensor I(shape.inertia());
    const scalar mixed = mag(I.xy()) + mag(I.xz()) + mag(I.yz());

    if (mixed > 1e-3*tr(I))
    {
        FatalErrorInFunction
            << "'shapeModel' in 'coupling' of immersedBodyProperties, other"
            << " than 'type sphericity', needs shapes whose principal axes are"
            << " those of their frame, and the type '" << shape.type()
            << "' has the moments of inertia " << I << nl << exit(FatalError);
    }

    vector a
    (
        I.yy() + I.zz() - I.xx(),
        I.xx() + I.zz() - I.yy(),
        I.xx() + I.yy() - I.zz()
    );

    for (direction i = 0; i < 3; ++i)
    {
        a[i] = Foam::sqrt(max(a[i], VSMALL));
    }

    const scalar volume =
        4.0/3.0*constant::mathematical::pi*a.x()*a.y()*a.z();

    return Foam::cbrt(shape.volume()/volume)*a;
}


//- The next step of duplication: lambda, and x, y and z with it
scalar duplicate(scalar& x, scalar& y, scalar& z)
{
    const scalar l =
        Foam::sqrt(x*y) + Foam::sqrt(x*z) + Foam::sqrt(y*z);

    x = 0.25*(x + l);
    y = 0.25*(y + l);
    z = 0.25*(z + l);

    return l;
}

//- Where the series are exact to 1e-15
const scalar near = 2e-3;

} // End anonymous namespace


Foam::scalar Foam::shapeModels::ellipsoidShape::RF(scalar x, scalar y, scalar z)
{
    scalar A = (x + y + z)/3;

    while (max(mag(A - x), max(mag(A - y), mag(A - z))) > near*A)
    {
        duplicate(x, y, z);
        A = (x + y + z)/3;
    }

    const scalar X = 1 - x/A, Y = 1 - y/A, Z = -X - Y;
    const scalar E2 = X*Y - sqr(Z), E3 = X*Y*Z;

    return
        (1 - E2/10 + E3/14 + sqr(E2)/24 - 3*E2*E3/44)/Foam::sqrt(A);
}


Foam::scalar Foam::shapeModels::ellipsoidShape::RD(scalar x, scalar y, scalar z)
{
    scalar A = (x + y + 3*z)/5, sum = 0, part = 1;

    while (max(mag(A - x), max(mag(A - y), mag(A - z))) > near*A)
    {
        const scalar z0 = z, l = duplicate(x, y, z);

        sum += part/(Foam::sqrt(z0)*(z0 + l));
        part *= 0.25;
        A = (x + y + 3*z)/5;
    }

    const scalar X = 1 - x/A, Y = 1 - y/A, Z = 1 - z/A;
    const scalar a = X*Y, b = sqr(Z), c = a - b, d = a - 6*b;
    const scalar e = d + c + c;

    return
        3*sum
      + part
       *(
            1 + d*(-3.0/14 + 9.0/88*d - 9.0/52*Z*e)
          + Z*(e/6 + Z*(-9.0/22*c + Z*3.0/26*a))
        )/(A*Foam::sqrt(A));
}


void Foam::shapeModels::ellipsoidShape::setStokes(const scalar D)
{
    const vector s(cmptMultiply(axes_, axes_));
    const scalar chi = 2*RF(s.x(), s.y(), s.z());
    const vector alpha
    (
        2.0/3.0*RD(s.y(), s.z(), s.x()),
        2.0/3.0*RD(s.z(), s.x(), s.y()),
        2.0/3.0*RD(s.x(), s.y(), s.z())
    );
    const vector load(cmptMultiply(s, alpha));

    for (direction i = 0; i < 3; ++i)
    {
        const direction j = (i + 1) % 3, k = (i + 2) % 3;

        stokes_[i] = 16/(3*D*(chi + load[i]));
        turning_[i] = 16*(s[j] + s[k])/(3*pow3(D)*(load[j] + load[k]));
    }
}


Foam::shapeModels::ellipsoidShape::ellipsoidShape
(
    const dictionary& dict,
    const bodyShape& shape
)
:
    axes_(semiAxes(shape))
{
    keywords::check(dict, {"type"});

    const scalar D =
        cbrt(6*shape.volume()/constant::mathematical::pi);
    const scalar psi = sphericity(shape).value();
    const scalar form = 0.42/24*pow(10, 0.4*pow(max(-log10(psi), 0), 0.2));

    setStokes(D);
    boundaryLayer_ = 3.0/24/pow(psi, 0.75);

    for (direction i = 0; i < 3; ++i)
    {
        inertial_[i] = form*4*axes_[(i + 1) % 3]*axes_[(i + 2) % 3]/sqr(D);
    }
}


Foam::vector Foam::shapeModels::ellipsoidShape::force
(
    const scalar Re,
    const vector& e
) const
{
    const scalar layer = Foam::sqrt(Re);
    const scalar sphere = 1 + (3*layer + 0.42*Re)/24;
    const vector k
    (
        stokes_ + boundaryLayer_*layer*vector::one + Re*inertial_
    );

    return cmptMultiply(k, e)/sphere;
}


Foam::vector Foam::shapeModels::ellipsoidShape::straining
(
    const symmTensor& E
) const
{
    const vector s(cmptMultiply(axes_, axes_));
    const vector mixed(E.yz(), E.xz(), E.xy());
    vector torque;

    for (direction i = 0; i < 3; ++i)
    {
        const direction j = (i + 1) % 3, k = (i + 2) % 3;

        torque[i] = turning_[i]*(s[j] - s[k])/(s[j] + s[k])*mixed[i];
    }

    return torque;
}
