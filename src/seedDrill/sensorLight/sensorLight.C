// SPDX-License-Identifier: GPL-3.0-or-later

#include "sensorLight.H"
#include "checkKeywords.H"
#include "scalarList.H"

Foam::sensorLight::sensorLight()
:
    active_(false),
    thickness_(0),
    resolution_(0),
    view_(Zero),
    nSignals_(0)
{}


Foam::sensorLight::sensorLight(const dictionary& dict)
:
    active_(true),
    thickness_(dict.lookupOrDefault<scalar>("thickness", 0)),
    resolution_(dict.lookupOrDefault<scalar>("resolution", 0)),
    view_(dict.lookupOrDefault<vector>("view", Zero)),
    nSignals_(0)
{
    keywords::check(dict, {"thickness", "resolution", "view"});

    if (!(thickness_ >= 0 && resolution_ >= 0))
    {
        FatalIOErrorInFunction(dict)
            << "'thickness " << thickness_ << "' and 'resolution "
            << resolution_ << "' in '" << dict.dictName()
            << "' must not be less than 0" << nl << exit(FatalIOError);
    }

    if (mag(view_) > 0)
    {
        view_ /= mag(view_);
    }
}


bool Foam::sensorLight::overlap
(
    const shadow& a,
    const shadow& b,
    const scalar speed
) const
{
    const scalar gap = max(a.begin, b.begin) - min(a.end, b.end);
    const scalar apart = mag(a.across - b.across) - a.radius - b.radius;

    return
        gap*speed < resolution_
     && (view_ == vector::zero || apart < resolution_);
}


const Foam::sensorLight::shadow& Foam::sensorLight::add
(
    const scalar time,
    const scalar speed,
    const point& x,
    const scalar R,
    const vector& axis
)
{
    const scalar half = (0.5*thickness_ + R)/max(speed, VSMALL);
    const vector across(axis ^ view_);

    shadow one
    {
        time - half,
        time + half,
        (x & across)/max(mag(across), VSMALL),
        R,
        nSignals_,
        1
    };

    for (label i = shadows_.size() - 1; active_ && i >= 0; --i)
    {
        if (overlap(one, shadows_[i], speed))
        {
            one.signal = shadows_[i].signal;
            break;
        }
    }

    for (const shadow& other : shadows_)
    {
        one.nGrains += other.signal == one.signal;
    }
    nSignals_ += one.nGrains == 1;

    if (shadows_.size() == nCompared_)
    {
        shadows_.remove(0);
    }
    shadows_.append(one);

    return shadows_.last();
}


void Foam::sensorLight::readState(const dictionary& dict)
{
    nSignals_ = dict.get<label>("signals");
    shadows_.clear();

    const scalarList values(dict.get<scalarList>("shadows"));

    for (label i = 0; i + 6 <= values.size(); i += 6)
    {
        shadows_.append
        (
            shadow
            {
                values[i],
                values[i + 1],
                values[i + 2],
                values[i + 3],
                label(values[i + 4]),
                label(values[i + 5])
            }
        );
    }
}


void Foam::sensorLight::writeState(Ostream& os) const
{
    os.writeEntry("signals", nSignals_);
    os.writeKeyword("shadows") << token::BEGIN_LIST;

    for (const shadow& one : shadows_)
    {
        os  << nl << one.begin << token::SPACE << one.end << token::SPACE
            << one.across << token::SPACE << one.radius << token::SPACE
            << one.signal << token::SPACE << one.nGrains;
    }
    os  << token::END_LIST << token::END_STATEMENT << nl;
}
