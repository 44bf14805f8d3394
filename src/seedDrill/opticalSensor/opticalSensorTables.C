// SPDX-License-Identifier: GPL-3.0-or-later

#include "opticalSensor.H"
#include "OSspecific.H"

Foam::autoPtr<Foam::OFstream> Foam::functionObjects::opticalSensor::newTable
(
    const word& file,
    const string& title,
    const std::initializer_list<const char*>& columns
) const
{
    const fileName folder(baseFileDir()/prefix_/time_.timeName());

    mkDir(folder);
    autoPtr<OFstream> osPtr(new OFstream(folder/(file + ".dat")));
    OFstream& os = osPtr();

    initStream(os);
    writeHeader(os, title);
    writeCommented(os, "plane");

    for (const char* column : columns)
    {
        os  << tab << column;
    }
    os  << nl;

    return osPtr;
}


void Foam::functionObjects::opticalSensor::writeSummary() const
{
    autoPtr<OFstream> table
    (
        newTable
        (
            "summary",
            "Passages of grains, and signals that the sensor sees of them",
            {
                "duration[s]", "grains", "backward", "rate[1/s]",
                "meanSpeed[m/s]", "deviationOfSpeed[m/s]",
                "meanSpacing[m]", "variationOfSpacing",
                "signals", "doubles", "hidden", "doubleRate[1/s]",
                "meanInterval[s]", "deviationOfInterval[s]",
                "variationOfInterval", "multiples", "misses",
                "multipleRate[1/s]", "missRate[1/s]", "precision", "name"
            }
        )
    );

    forAll(planes_, planei)
    {
        const passageStatistics& one = record_[planei];
        const scalar T = record_.duration(planei, bodies_.clock());

        // Not known without a nominal rate, or before the start
        auto known = [&](const scalar x) { return one.rate() > 0 ? x : NAN; };
        auto rate = [&](const label n) { return T > 0 ? n/T : NAN; };

        table()
            << planei << tab << T << tab << one.nGrains() << tab
            << one.nBackward() << tab << rate(one.nGrains()) << tab
            << one.speed().mean() << tab << one.speed().deviation() << tab
            << one.spacing().mean() << tab << one.spacing().variation()
            << tab << one.nSignals() << tab << one.nDoubles() << tab
            << one.nHidden() << tab << rate(one.nDoubles()) << tab
            << one.interval().mean() << tab << one.interval().deviation()
            << tab << one.interval().variation() << tab
            << known(one.nMultiples()) << tab << known(one.nMisses()) << tab
            << known(rate(one.nMultiples())) << tab
            << known(rate(one.nMisses()))
            << tab << known(one.single().deviation()*one.rate()) << tab
            << planes_[planei].name() << nl;
    }
}


void Foam::functionObjects::opticalSensor::writeRadii() const
{
    autoPtr<OFstream> table
    (
        newTable
        (
            "radii",
            "Grains by their distance from the axis",
            {
                "inner[m]", "outer[m]", "grains", "meanSpeed[m/s]",
                "deviation[m/s]", "least[m/s]", "largest[m/s]",
                "density[1/m2]", "densityOverMean"
            }
        )
    );

    forAll(planes_, planei)
    {
        const sensorPlane& plane = planes_[planei];
        const passageStatistics& one = record_[planei];

        forAll(one.speedAtRadius(), i)
        {
            const runningMoments& speed = one.speedAtRadius()[i];
            const scalar inner = one.innerRadius(i);
            const scalar outer = one.innerRadius(i + 1);
            const scalar density = speed.n()/plane.area(inner, outer);
            const scalar mean =
                max(one.nGrains(), 1)/plane.area(0, plane.radius());

            table()
                << planei << tab << inner << tab << outer << tab << speed.n()
                << tab << speed.mean() << tab << speed.deviation() << tab
                << speed.min() << tab << speed.max() << tab << density << tab
                << density/mean << nl;
        }
    }
}


void Foam::functionObjects::opticalSensor::writeIntervals() const
{
    autoPtr<OFstream> table
    (
        newTable
        (
            "intervals",
            "Times between signals, over the nominal one: the last row of a"
            " plane has all that are longer",
            {"from", "to", "number"}
        )
    );
    const scalar width = passageStatistics::width;

    forAll(planes_, planei)
    {
        const labelUList& intervals = record_[planei].intervals();

        forAll(intervals, i)
        {
            table()
                << planei << tab << max((i - 0.5)*width, 0) << tab
                << (i == intervals.size() - 1 ? GREAT : (i + 0.5)*width)
                << tab << intervals[i] << nl;
        }
    }
}


void Foam::functionObjects::opticalSensor::writeOutlets() const
{
    runningMoments numbers;
    label nGrains = 0;

    for (const label planei : outlets_)
    {
        numbers.add(record_[planei].nGrains());
        nGrains += record_[planei].nGrains();
    }

    autoPtr<OFstream> table
    (
        newTable
        (
            "outlets",
            "Coefficient of variation of the grains per outlet: "
          + Foam::name(numbers.variation()),
            {"grains", "share", "name"}
        )
    );

    for (const label planei : outlets_)
    {
        const label n = record_[planei].nGrains();

        table()
            << planei << tab << n << tab << scalar(n)/max(nGrains, 1) << tab
            << planes_[planei].name() << nl;
    }
}


void Foam::functionObjects::opticalSensor::writeTables()
{
    if (!writeToFile() || tablesIndex_ == time_.timeIndex())
    {
        return;
    }

    tablesIndex_ = time_.timeIndex();
    writeSummary();
    writeRadii();
    writeIntervals();

    if (outlets_.size())
    {
        writeOutlets();
    }
}
