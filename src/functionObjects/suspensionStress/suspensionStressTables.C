// SPDX-License-Identifier: GPL-3.0-or-later

#include "suspensionStress.H"

namespace
{
    const char* const components[9] =
        {"xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz"};
}


Foam::wordList Foam::functionObjects::suspensionStress::columns() const
{
    wordList all
    ({
        word("volumeFraction[-]", false), word("shearRate[1/s]", false),
        word("shearStress[m2/s2]", false), word("viscosity[m2/s]", false),
        word("N1[m2/s2]", false)
    });

    if (!bodies_.space().twoD())
    {
        all.append(word("N2[m2/s2]", false));
    }
    for
    (
        const char* column
      : {
            "particlePressure[m2/s2]", "contacts", "leastGap[m]",
            "nearestGap[m]", "clusters", "largestCluster", "meanCluster"
        }
    )
    {
        all.append(word(column, false));
    }

    return all;
}


Foam::wordList Foam::functionObjects::suspensionStress::names() const
{
    wordList bare(columns());

    for (word& name : bare)
    {
        name = name.substr(0, name.find('['));
    }

    return bare;
}


void Foam::functionObjects::suspensionStress::writeRow()
{
    OFstream& os = file();

    if (!writtenHeader_)
    {
        writeHeader(os, "Mean stress over the density of the fluid, and gaps");
        writeCommented(os, "time[s]");

        for (const word& column : columns())
        {
            os  << tab << column;
        }
        for (const char* part : partNames)
        {
            for (const char* component : components)
            {
                os  << tab << part << '_' << component << "[m2/s2]";
            }
        }
        os  << nl;
        writtenHeader_ = true;
    }

    writeCurrentTime(os);
    for (const scalar value : values_)
    {
        os  << tab << value;
    }
    for (const tensor& part : parts_)
    {
        for (const scalar value : part)
        {
            os  << tab << value;
        }
    }
    os  << endl;
}


void Foam::functionObjects::suspensionStress::writeMeans()
{
    if (!(*record_)[0].n())
    {
        return;
    }

    OFstream& os = means_.file();

    if (means_.writesHeader())
    {
        writeHeader(os, "Means since `start`, and their standard errors");
        writeCommented(os, "time[s]");
        os  << tab << "samples";

        for (const word& column : columns())
        {
            os  << tab << column << tab << "errorOf_" << column;
        }
        os  << nl;
    }

    writeCurrentTime(os);
    os  << tab << (*record_)[0].n();
    for (label i = 0; i < record_->size(); ++i)
    {
        os  << tab << (*record_)[i].mean() << tab << (*record_)[i].error();
    }
    os  << endl;
}
