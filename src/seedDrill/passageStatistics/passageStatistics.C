// SPDX-License-Identifier: GPL-3.0-or-later

#include "passageStatistics.H"
#include <cmath>

constexpr Foam::scalar Foam::passageStatistics::width;
constexpr Foam::label Foam::passageStatistics::nIntervals;


Foam::passageStatistics::passageStatistics
(
    const scalar rate,
    const scalar start,
    const scalar radius,
    const label nRadii,
    const sensorLight& light
)
:
    rate_(rate),
    start_(start),
    radius_(radius),
    light_(light),
    nGrains_(0),
    nBackward_(0),
    nSignals_(0),
    nDoubles_(0),
    nHidden_(0),
    nMultiples_(0),
    nMisses_(0),
    lastGrain_(-GREAT),
    lastSignal_(-GREAT),
    speedAtRadius_(radius < GREAT ? nRadii : 0),
    intervals_(rate > 0 ? nIntervals + 1 : 0, Zero)
{}


void Foam::passageStatistics::addInterval(const scalar interval)
{
    interval_.add(interval);

    if (rate_ == 0)
    {
        return;
    }

    const scalar x = interval*rate_;

    // Those of the nominal length are in the middle of their part
    ++intervals_[min(label(std::floor(x/width + 0.5)), nIntervals)];

    if (x <= 0.5)
    {
        ++nMultiples_;
    }
    else if (x > 1.5)
    {
        ++nMisses_;
    }
    else
    {
        single_.add(interval);
    }
}


Foam::passageStatistics::passage Foam::passageStatistics::add
(
    const scalar time,
    const scalar u,
    const scalar r,
    const point& x,
    const scalar R,
    const vector& axis
)
{
    const sensorLight::shadow& shadow = light_.add(time, mag(u), x, R, axis);
    const passage result
    {
        lastGrain_ > -GREAT ? time - lastGrain_ : NAN,
        shadow.signal
    };

    if (time >= start_)
    {
        ++nGrains_;
        nBackward_ += u < 0;
        speed_.add(u);

        if (lastGrain_ >= start_)
        {
            spacing_.add(mag(u)*result.interval);
        }
        if (speedAtRadius_.size())
        {
            const label i = label(r/radius_*speedAtRadius_.size());
            speedAtRadius_[min(i, speedAtRadius_.size() - 1)].add(u);
        }

        if (shadow.nGrains > 1)
        {
            ++nHidden_;
            nDoubles_ += shadow.nGrains == 2;
        }
        else
        {
            ++nSignals_;
            if (lastSignal_ >= start_)
            {
                addInterval(time - lastSignal_);
            }
        }
    }

    lastGrain_ = time;
    lastSignal_ = shadow.nGrains > 1 ? lastSignal_ : time;

    return result;
}


void Foam::passageStatistics::readState(const dictionary& dict)
{
    light_.readState(dict);
    nGrains_ = dict.get<label>("grains");
    nBackward_ = dict.get<label>("backward");
    nSignals_ = dict.get<label>("countedSignals");
    nDoubles_ = dict.get<label>("doubles");
    nHidden_ = dict.get<label>("hidden");
    nMultiples_ = dict.get<label>("multiples");
    nMisses_ = dict.get<label>("misses");
    lastGrain_ = dict.get<scalar>("lastGrain");
    lastSignal_ = dict.get<scalar>("lastSignal");
    speed_.readState(dict, "speed");
    spacing_.readState(dict, "spacing");
    interval_.readState(dict, "interval");
    single_.readState(dict, "single");

    // With another number of parts, or another rate, they begin anew
    const labelList intervals(dict.get<labelList>("intervals"));

    if (intervals.size() == intervals_.size())
    {
        intervals_ = intervals;
    }
    if (dict.get<label>("radii") == speedAtRadius_.size())
    {
        forAll(speedAtRadius_, i)
        {
            speedAtRadius_[i].readState(dict, "radius" + Foam::name(i));
        }
    }
}


void Foam::passageStatistics::writeState(Ostream& os) const
{
    light_.writeState(os);
    os.writeEntry("grains", nGrains_);
    os.writeEntry("backward", nBackward_);
    os.writeEntry("countedSignals", nSignals_);
    os.writeEntry("doubles", nDoubles_);
    os.writeEntry("hidden", nHidden_);
    os.writeEntry("multiples", nMultiples_);
    os.writeEntry("misses", nMisses_);
    os.writeEntry("lastGrain", lastGrain_);
    os.writeEntry("lastSignal", lastSignal_);
    speed_.writeState(os, "speed");
    spacing_.writeState(os, "spacing");
    interval_.writeState(os, "interval");
    single_.writeState(os, "single");

    // As text, whatever the format
    os.writeKeyword("intervals") << token::BEGIN_LIST;

    for (const label n : intervals_)
    {
        os  << token::SPACE << n;
    }
    os  << token::END_LIST << token::END_STATEMENT << nl;

    os.writeEntry("radii", speedAtRadius_.size());

    forAll(speedAtRadius_, i)
    {
        speedAtRadius_[i].writeState(os, "radius" + Foam::name(i));
    }
}
