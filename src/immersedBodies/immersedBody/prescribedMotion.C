// SPDX-License-Identifier: GPL-3.0-or-later

#include "prescribedMotion.H"
#include "checkKeywords.H"

Foam::prescribedMotion::prescribedMotion
(
    const dictionary& dict,
    const geometricSpace& space
)
:
    dict_(dict),
    space_(space),
    velocity_(read("velocity")),
    angularVelocity_(read("angularVelocity"))
{
    keywords::check
    (
        dict,
        {
            "type", "velocity", "angularVelocity",
            "velocityCoeffs", "angularVelocityCoeffs"
        }
    );

    if (!velocity_.valid() && !angularVelocity_.valid())
    {
        FatalIOErrorInFunction(dict)
            << "'type prescribed' in '" << dict.dictName() << "' needs"
            << " 'velocity' [m/s], 'angularVelocity' [rad/s] or both, as"
            << " functions of time; for a body at rest use 'type fixed'" << nl
            << exit(FatalIOError);
    }
}


Foam::autoPtr<Foam::Function1<Foam::vector>>
Foam::prescribedMotion::read(const word& key) const
{
    return dict_.found(key)
      ? Function1<vector>::New(key, dict_)
      : autoPtr<Function1<vector>>();
}


Foam::vector Foam::prescribedMotion::value
(
    const autoPtr<Function1<vector>>& f,
    const word& key,
    const vector& allowed,
    const scalar t
) const
{
    if (!f.valid())
    {
        return Zero;
    }

    const vector v(f->value(t));

    if (magSqr(v - cmptMultiply(v, allowed)) > 0)
    {
        std::string components;

        for (direction i = 0; i < 3; ++i)
        {
            components += std::string(i ? " " : "")
              + (allowed[i] > 0 ? vector::componentNames[i] : "0");
        }

        FatalIOErrorInFunction(dict_)
            << "'" << key << "' in '" << dict_.dictName() << "' is " << v
            << " at time " << t << " and leads out of the plane of the mesh;"
            << " allowed is (" << components.c_str() << ')' << nl
            << exit(FatalIOError);
    }

    return v;
}
