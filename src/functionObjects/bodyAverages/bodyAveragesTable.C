// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyAverages.H"
#include "meshLayers.H"
#include <cmath>

void Foam::functionObjects::bodyAverages::writeTableHeader(Ostream& os)
{
    writeHeader(os, "Averages in layers, over the density of the fluid");
    writeCommented(os, "time[s]");
    os  << tab << "position[m]" << tab << "fluidFraction" << tab
        << "bodyFraction" << tab << "pressure[m2/s2]";

    for
    (
        const char* name
      : {"UFluid_@[m/s]", "UBodies_@[m/s]", "spin_@[rad/s]", "force_@[m/s2]"}
    )
    {
        for (const char* i : {"x", "y", "z"})
        {
            os  << tab << string(name).replace("@", i).c_str();
        }
    }
    for (const char* name : {"stress", "traction", "contact"})
    {
        for (const char* i : {"xx", "xy", "xz", "yy", "yz", "zz"})
        {
            os  << tab << name << '_' << i << "[m2/s2]";
        }
    }
    os  << nl;
}


void Foam::functionObjects::bodyAverages::writeTable(const scalarField& means)
{
    typedef phaseSources source;

    const meshLayers layers(mesh_, direction_, nLayers_);
    const List<scalarField> sums(layers.sums(means, source::nColumns));

    if (!writeToFile())
    {
        return;
    }

    OFstream& os = file();

    if (writesHeader())
    {
        writeTableHeader(os);
    }

    forAll(sums, layeri)
    {
        const scalar volume = sums[layeri][0];
        const scalar* of = &sums[layeri][1];

        // n columns from k on, over w
        auto write = [&](const source::column k, const label n, const scalar w)
        {
            for (label i = 0; i < n; ++i)
            {
                os  << tab << (w > 0 ? of[k + i]/w : NAN);
            }
        };

        writeCurrentTime(os);
        os  << tab << layers.position(layeri);
        write(source::fluid, 1, volume);
        write(source::bodies, 1, volume);
        write(source::p, 1, of[source::fluid]);
        write(source::U, 3, of[source::fluid]);
        write(source::Ub, 3, of[source::bodies]);
        write(source::omega, 3, of[source::bodies]);
        write(source::force, 3, volume);
        write(source::stress, 6, volume);
        write(source::traction, 6, volume);
        write(source::contact, 6, volume);
        os  << nl;
    }
    os.flush();
}
