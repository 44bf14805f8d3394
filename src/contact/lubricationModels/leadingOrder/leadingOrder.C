// SPDX-License-Identifier: GPL-3.0-or-later

#include "leadingOrder.H"
#include "addToRunTimeSelectionTable.H"
#include "checkKeywords.H"
#include "mathematicalConstants.H"

using Foam::constant::mathematical::pi;

namespace Foam
{
namespace lubricationModels
{
    defineTypeNameAndDebug(leadingOrder, 0);
    addToRunTimeSelectionTable(lubricationModel, leadingOrder, dictionary);
}
}


namespace
{

Foam::scalar readNu(const Foam::dictionary& dict, const Foam::scalar nu)
{
    if (dict.found("nu"))
    {
        return Foam::keywords::positive(dict, "nu");
    }

    if (nu <= 0)
    {
        FatalIOErrorInFunction(dict)
            << "'" << dict.dictName() << "' needs 'nu' [m2/s], the viscosity of"
            << " the fluid in narrow gaps: transportProperties has none that"
            << " is constant" << Foam::nl << Foam::exit(Foam::FatalIOError);
    }

    return nu;
}

} // End anonymous namespace


Foam::lubricationModels::leadingOrder::leadingOrder
(
    const dictionary& dict,
    const geometricSpace& space,
    const scalar nu
)
:
    twoD_(space.twoD()),
    roughness_(keywords::positiveOr(dict, "roughness", 1e-4)),
    nu_(readNu(dict, nu)*(twoD_ ? space.depth() : 1)),
    c_(twoD_ ? 0.65 : 0.5),
    b_(twoD_ ? 0.68 : 0.72)
{
    keywords::check(dict, {"type", "roughness", "nu"});
}


Foam::scalar Foam::lubricationModels::leadingOrder::normal
(
    const film& f,
    const scalar gap
) const
{
    if (gap <= 0 || gap >= range(f.cell))
    {
        return 0;
    }

    const scalar e = max(gap/f.radius, roughness_);
    const scalar eMesh = max(meshGap(f, gap)/f.radius, e);

    return twoD_
      ? nu_*3*Foam::sqrt(2.0)*pi*(pow(e, -1.5) - pow(eMesh, -1.5))
      : nu_*6*pi*f.radius*(1/e - 1/eMesh);
}


Foam::scalar Foam::lubricationModels::leadingOrder::normalSum
(
    const film& f,
    const scalar gap
) const
{
    if (gap <= 0)
    {
        return 0;
    }

    // Of the terms at the gap itself, no less than the roughness, and of those
    // at the gap of the mesh; where roughness exceeds that they cancel
    const scalar most = range(f.cell);
    const scalar rough = roughness_*f.radius;
    const scalar first = max((rough - c_*f.cell)/b_, scalar(0));

    if (min(gap, most) <= first)
    {
        return 0;
    }

    const scalar e0 = first/f.radius, e = min(gap, most)/f.radius;
    const scalar flat = min(e, roughness_);
    const scalar m0 = meshGap(f, first)/f.radius;
    const scalar m = meshGap(f, e*f.radius)/f.radius;

    if (twoD_)
    {
        auto primitive = [](const scalar x)
        {
            return -2/Foam::sqrt(x);
        };

        return nu_*3*Foam::sqrt(2.0)*pi*f.radius
           *(
                max(flat - e0, scalar(0))*pow(roughness_, -1.5)
              + primitive(max(e, roughness_))
              - primitive(max(e0, roughness_))
              - (primitive(m) - primitive(m0))/b_
            );
    }

    return nu_*6*pi*sqr(f.radius)
       *(
            max(flat - e0, scalar(0))/roughness_
          + log(max(e, roughness_)/max(e0, roughness_))
          - log(m/m0)/b_
        );
}


Foam::scalar Foam::lubricationModels::leadingOrder::tangential
(
    const film& f,
    const scalar gap
) const
{
    if (gap <= 0 || gap >= range(f.cell))
    {
        return 0;
    }

    const scalar e = max(gap/f.radius, roughness_);
    const scalar eMesh = max(meshGap(f, gap)/f.radius, e);

    return twoD_
      ? nu_*Foam::sqrt(2.0)*pi*(1/Foam::sqrt(e) - 1/Foam::sqrt(eMesh))
      : nu_*2*pi*f.radius*log(eMesh/e);
}


Foam::scalar Foam::lubricationModels::leadingOrder::sliding
(
    const film& f,
    const scalar gap
) const
{
    return tangential(f, gap);
}


Foam::scalar Foam::lubricationModels::leadingOrder::rolling
(
    const film& f,
    const scalar gap
) const
{
    return (twoD_ ? 1 : 0.6)*tangential(f, gap);
}


void Foam::lubricationModels::leadingOrder::report(Ostream& os) const
{
    os  << "leadingOrder, roughness " << roughness_;
}
