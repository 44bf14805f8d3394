// SPDX-License-Identifier: GPL-3.0-or-later

#include "stokesTable.H"
#include "IFstream.H"

namespace
{
    //- Difference of positions that their digits can have
    const Foam::scalar rounding = 1e-10;

    //- The numbers that are left of a row; streams do not read nan
    Foam::scalarList rest(std::istream& row)
    {
        Foam::DynamicList<Foam::scalar> values;
        std::string word;

        while (row >> word)
        {
            values.append(std::strtod(word.c_str(), nullptr));
        }

        return Foam::scalarList(std::move(values));
    }
}


Foam::DynamicList<Foam::string> Foam::stokesTable::read()
{
    DynamicList<string> lines;
    IFstream is(file_);
    string line;

    while (is.good() && is.getLine(line).good())
    {
        if (lines.empty())
        {
            if (line != header())
            {
                FatalErrorInFunction
                    << file_ << " has other columns than the states of"
                    << " system/stokesModesDict: move it away" << nl
                    << exit(FatalError);
            }
            lines.append(line);
            continue;
        }

        std::istringstream row(line);
        label state = -1;
        row >> state;
        bool same = state >= 0 && state < states_.size();

        if (same)
        {
            for (const scalar expected : poses(state))
            {
                scalar value = GREAT;
                row >> value;
                same = same
                 && mag(value - expected) <= rounding*max(mag(expected), 1);
            }
        }
        if (!same)
        {
            FatalErrorInFunction
                << "Row '" << state << "' of " << file_
                << " is of another state than that in system/stokesModesDict:"
                << " move the table away" << nl << exit(FatalError);
        }
        rows_[state] = rest(row);
        lines.append(line);
    }

    return lines;
}
