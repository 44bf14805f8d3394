// SPDX-License-Identifier: GPL-3.0-or-later

#include "rowSample.H"

namespace
{
    // Long enough for the processor to fetch rows ahead
    const Foam::label run = 256;

    // From here on some rows are left out
    const Foam::label many = 8192;

    // Rows from one run to the next. Rows of cells are rarely that long, so
    // that runs do not lie side by side in the mesh.
    const Foam::label period = 16*run + 8;
}


Foam::rowSample::rowSample
(
    const label nRows,
    const label which,
    const bitSet& asked
)
:
    rows_(asked.toc()),
    nAsked_(rows_.size()),
    factor_(1)
{
    const label step = nRows < many ? run : period;
    const label first = (which % step)*run % step;
    label n = nAsked_;

    rows_.resize(nAsked_ + (nRows/step + 2)*run);

    // The first run may have begun before the first row
    for (label from = first - step; from < nRows; from += step)
    {
        const label end = min(from + run, nRows);

        for (label row = max(from, label(0)); row < end; ++row)
        {
            if (!asked.test(row))
            {
                rows_[n++] = row;
            }
        }
    }

    rows_.resize(n);

    if (n > nAsked_)
    {
        factor_ = scalar(nRows - nAsked_)/(n - nAsked_);
    }
}
