// SPDX-License-Identifier: GPL-3.0-or-later

#include "impactCoefficients.H"
#include "checkKeywords.H"
#include "mathematicalConstants.H"

namespace
{

const Foam::scalar degree = Foam::constant::mathematical::pi/180;


//- Speeds [m/s] at which functions are looked at
Foam::scalarList speeds()
{
    Foam::scalarList s(51);

    forAll(s, i)
    {
        s[i] = Foam::pow(Foam::scalar(10), -3 + 0.1*i);
    }

    return s;
}

} // End anonymous namespace


const Foam::wordList Foam::impactCoefficients::keywords
({
    "restitution", "restitutionCoeffs", "friction", "frictionCoeffs",
    "rollingFriction", "wallRoughness"
});


Foam::impactCoefficients::function Foam::impactCoefficients::read
(
    const dictionary& dict,
    const word& key,
    const function& deflt,
    scalar& value
)
{
    const entry* e = dict.findEntry(key, keyType::LITERAL);

    if (!e)
    {
        return deflt;
    }

    if (e->isStream() && token(e->stream()).isNumber())
    {
        value = dict.get<scalar>(key);
        return function();
    }

    const function f(Function1<scalar>::New(key, dict).ptr());
    value = f->value(speeds().first());

    return f;
}


Foam::impactCoefficients::impactCoefficients
(
    const dictionary& dict,
    const impactCoefficients& deflt
)
:
    contactCoefficients(deflt),
    restitution_(read(dict, "restitution", deflt.restitution_, restitution)),
    friction_(read(dict, "friction", deflt.friction_, friction))
{
    rollingFriction =
        dict.lookupOrDefault<scalar>("rollingFriction", rollingFriction);
    wallRoughness =
        degree
       *dict.lookupOrDefault<scalar>("wallRoughness", wallRoughness/degree);

    check(dict);
}


void Foam::impactCoefficients::check(const dictionary& dict) const
{
    const bool steep = !(wallRoughness >= 0 && wallRoughness < 45*degree);

    if (steep || !(rollingFriction >= 0))
    {
        FatalIOErrorInFunction(dict)
            << "In '" << dict.dictName() << "' 'rollingFriction "
            << rollingFriction << "' must be at least 0 and 'wallRoughness "
            << wallRoughness/degree << "' at least 0 and below 45 degrees"
            << nl << exit(FatalIOError);
    }

    for (const scalar speed : speeds())
    {
        const scalar e =
            restitution_ ? restitution_->value(speed) : restitution;
        const scalar mu = friction_ ? friction_->value(speed) : friction;

        if (!(e > 0 && (restitution_ || e <= 1) && mu >= 0))
        {
            FatalIOErrorInFunction(dict)
                << "In '" << dict.dictName() << "' 'restitution " << e
                << "' must be above 0 and at most 1 and 'friction " << mu
                << "' at least 0";

            if (restitution_ || friction_)
            {
                FatalIOError
                    << "; functions are asked for speeds from "
                    << speeds().first() << " to " << speeds().last()
                    << " m/s, and this is at " << speed << " m/s";
            }
            FatalIOError<< nl << exit(FatalIOError);
        }
    }
}


Foam::contactCoefficients Foam::impactCoefficients::at
(
    const scalar speed
) const
{
    contactCoefficients c(*this);

    // The limits from below are for speeds that have not been checked
    if (restitution_)
    {
        c.restitution = min(max(restitution_->value(speed), 1e-3), scalar(1));
    }
    if (friction_)
    {
        c.friction = max(friction_->value(speed), scalar(0));
    }

    return c;
}


Foam::contactCoefficients Foam::impactCoefficients::largest() const
{
    contactCoefficients c(*this);

    c.restitution = restitution_ ? 1 : restitution;

    for (const scalar speed : speeds())
    {
        c.friction = max(c.friction, at(speed).friction);
    }

    return c;
}


void Foam::impactCoefficients::report(Ostream& os) const
{
    auto one = [&](const char* key, const function& f, const scalar value)
    {
        os  << ", " << key << ' ';
        f ? os << "by speed" : os << value;
    };

    one("restitution", restitution_, restitution);
    one("friction", friction_, friction);

    if (rollingFriction > 0)
    {
        os  << ", rolling friction " << rollingFriction;
    }
    if (wallRoughness > 0)
    {
        os  << ", wall roughness " << wallRoughness/degree << " degrees";
    }
}
