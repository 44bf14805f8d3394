// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyAverages.H"
#include <cmath>

Foam::List<Foam::scalarField> Foam::functionObjects::bodyAverages::layers
(
    const scalarField& means
) const
{
    const label n = phaseSources::nColumns;
    const scalarField height(mesh_.cellCentres() & direction_);
    const scalarField corners(mesh_.points() & direction_);
    const scalar low = gMin(corners);
    const scalar thickness = (gMax(corners) - low)/nLayers_;
    List<scalarField> sums(nLayers_, scalarField(n + 1, Zero));

    forAll(height, celli)
    {
        const label layeri = label((height[celli] - low)/thickness);
        scalarField& sum = sums[min(max(layeri, label(0)), nLayers_ - 1)];
        const scalar V = mesh_.V()[celli];

        sum[0] += V;
        for (label k = 0; k < n; ++k)
        {
            sum[k + 1] += V*means[n*celli + k];
        }
    }

    for (scalarField& sum : sums)
    {
        Pstream::listCombineGather(sum, plusEqOp<scalar>());
    }

    return sums;
}


void Foam::functionObjects::bodyAverages::writeTable(const scalarField& means)
{
    typedef phaseSources source;

    const scalar low = gMin(scalarField(mesh_.points() & direction_));
    const scalar high = gMax(scalarField(mesh_.points() & direction_));
    const List<scalarField> sums(layers(means));

    if (!writeToFile())
    {
        return;
    }

    OFstream& os = file();

    if (!writtenHeader_)
    {
        writeHeader(os, "Averages in layers, over the density of the fluid");
        writeCommented(os, "time[s]");
        os  << tab << "position[m]" << tab << "fluidFraction" << tab
            << "bodyFraction" << tab << "pressure[m2/s2]";

        for (const char* name : {"UFluid", "UBodies"})
        {
            for (const char* i : {"x", "y", "z"})
            {
                os  << tab << name << '_' << i << "[m/s]";
            }
        }
        for (const char* i : {"x", "y", "z"})
        {
            os  << tab << "spin_" << i << "[rad/s]";
        }
        for (const char* i : {"x", "y", "z"})
        {
            os  << tab << "force_" << i << "[m/s2]";
        }
        for (const char* name : {"stress", "traction", "contact"})
        {
            for (const char* i : {"xx", "xy", "xz", "yy", "yz", "zz"})
            {
                os  << tab << name << '_' << i << "[m2/s2]";
            }
        }
        os  << nl;
        writtenHeader_ = true;
    }

    forAll(sums, layeri)
    {
        const scalarField& sum = sums[layeri];
        const scalar* of = &sum[1];

        auto write = [&](const source::column k, const label n, const scalar w)
        {
            for (label i = 0; i < n; ++i)
            {
                os  << tab << (w > 0 ? of[k + i]/w : NAN);
            }
        };

        writeCurrentTime(os);
        os  << tab << low + (layeri + 0.5)*(high - low)/nLayers_;
        write(source::fluid, 1, sum[0]);
        write(source::bodies, 1, sum[0]);
        write(source::p, 1, of[source::fluid]);
        write(source::U, 3, of[source::fluid]);
        write(source::Ub, 3, of[source::bodies]);
        write(source::omega, 3, of[source::bodies]);
        write(source::force, 3, sum[0]);
        write(source::stress, 6, sum[0]);
        write(source::traction, 6, sum[0]);
        write(source::contact, 6, sum[0]);
        os  << nl;
    }
    os.flush();
}
