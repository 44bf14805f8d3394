// SPDX-License-Identifier: GPL-3.0-or-later

#include "sensorPlane.H"
#include "checkKeywords.H"
#include "mathematicalConstants.H"
#include "unitConversion.H"

Foam::vector Foam::sensorPlane::direction
(
    const dictionary& dict,
    const word& key
)
{
    const vector given(dict.get<vector>(key));

    if (!(mag(given) > 0))
    {
        FatalIOErrorInFunction(dict)
            << "'" << key << ' ' << given << "' in '" << dict.dictName()
            << "' must not be zero" << nl << exit(FatalIOError);
    }

    return given/mag(given);
}


Foam::sensorPlane::sensorPlane
(
    const word& name,
    const dictionary& dict,
    const dictionary& deflt,
    const geometricSpace& space
)
:
    name_(name),
    space_(space),
    point_(dict.get<point>("point")),
    normal_(direction(dict, "normal")),
    axis_(direction(dict, dict.found("axis") ? "axis" : "normal")),
    centre_(dict.lookupOrDefault<point>("centre", point_)),
    radius_(keywords::positiveOr(dict, "radius", GREAT)),
    rate_
    (
        dict.found("rate") || deflt.found("rate")
      ? keywords::positive(dict.found("rate") ? dict : deflt, "rate")
      : 0
    )
{
    keywords::check
    (
        dict,
        {"point", "normal", "radius", "axis", "centre", "zeroAngle", "rate"}
    );

    if (mag(axis_ & normal_) < SMALL)
    {
        FatalIOErrorInFunction(dict)
            << "'axis' in '" << dict.dictName() << "' lies in the plane with"
            << " the normal " << normal_ << ": no grain along it would cross"
            << nl << exit(FatalIOError);
    }

    for (const vector& direction : {normal_, axis_})
    {
        if (mag(direction - cmptMultiply(direction, space.translation())) > 0)
        {
            FatalIOErrorInFunction(dict)
                << "'normal' or 'axis' in '" << dict.dictName()
                << "' leads out of the plane of the mesh" << nl
                << exit(FatalIOError);
        }
    }

    setAngles(dict);
}


void Foam::sensorPlane::setAngles(const dictionary& dict)
{
    vector zero(Zero);

    if (dict.found("zeroAngle"))
    {
        zero = direction(dict, "zeroAngle");
    }
    else
    {
        Foam::direction least = 0;

        for (Foam::direction k = 1; k < 3; ++k)
        {
            least = mag(axis_[k]) < mag(axis_[least]) - SMALL ? k : least;
        }
        zero[least] = 1;
    }

    zero_ = zero - (zero & axis_)*axis_;

    if (mag(zero_) < SMALL)
    {
        FatalIOErrorInFunction(dict)
            << "'zeroAngle' in '" << dict.dictName() << "' must not be along"
            << " the axis " << axis_ << nl << exit(FatalIOError);
    }

    zero_ /= mag(zero_);
    quarter_ = axis_ ^ zero_;
}


Foam::scalar Foam::sensorPlane::distance(const periodicity& periods) const
{
    scalar distance = 0;

    for (const vector& period : periods.periods())
    {
        const scalar along = mag(period & normal_);

        if (along > 1e-6*mag(period))
        {
            if (distance > 0)
            {
                FatalErrorInFunction
                    << "The plane '" << name_ << "' with the normal "
                    << normal_ << " is across several periods of the mesh, "
                    << periods.periods() << ": it can be across one" << nl
                    << exit(FatalError);
            }
            distance = along;
        }
    }

    return distance;
}


void Foam::sensorPlane::polar
(
    const point& x,
    scalar& radius,
    scalar& angle
) const
{
    vector r(x - centre_);

    r -= (r & axis_)*axis_ + (r & space_.emptyDir())*space_.emptyDir();
    radius = mag(r);
    angle = radToDeg(Foam::atan2(r & quarter_, r & zero_));

    // Of -0
    if (angle <= -180)
    {
        angle += 360;
    }
}


Foam::scalar Foam::sensorPlane::area
(
    const scalar inner,
    const scalar outer
) const
{
    return
        space_.twoD()
      ? 2*(outer - inner)*space_.depth()
      : constant::mathematical::pi*(sqr(outer) - sqr(inner));
}
