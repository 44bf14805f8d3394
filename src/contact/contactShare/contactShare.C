// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactShare.H"
#include "boundBox.H"
#include "ListOps.H"
#include "Pstream.H"
#include <algorithm>

const Foam::label Foam::contactShare::fewest;


bool Foam::contactShare::mine(const label bodyi) const
{
    return !active_ || owners_[bodyi] == Pstream::myProcNo();
}


void Foam::contactShare::divide(const labelUList& owners)
{
    active_ = true;
    slabs_ = false;
    owners_ = owners;
}


void Foam::contactShare::divide(const UList<point>& centres)
{
    clear();

    const label n = centres.size(), nRanks = Pstream::nProcs();

    if (!Pstream::parRun() || n < fewest*nRanks)
    {
        return;
    }

    active_ = slabs_ = true;

    const vector span(boundBox(centres, false).span());

    along_ =
        span.x() >= max(span.y(), span.z()) ? 0 : span.y() >= span.z() ? 1 : 2;

    auto before = [&](const label i, const label j)
    {
        const scalar xi = centres[i][along_], xj = centres[j][along_];

        return xi != xj ? xi < xj : i < j;
    };

    labelList order(identity(n));
    label first = 0;

    owners_.setSize(n);
    for (label rank = 0; rank < nRanks; ++rank)
    {
        const label end = label((scalar(rank) + 1)/nRanks*n + 0.5);

        if (end < n)
        {
            std::nth_element
            (
                order.begin() + first, order.begin() + end, order.end(), before
            );
        }
        for (; first < end; ++first)
        {
            owners_[order[first]] = rank;
        }
    }

    low_ = GREAT;
    high_ = -GREAT;
    forAll(centres, i)
    {
        if (mine(i))
        {
            low_ = min(low_, centres[i][along_]);
            high_ = max(high_, centres[i][along_]);
        }
    }
}


Foam::boolList Foam::contactShare::distant
(
    const UList<point>& centres,
    const UList<scalar>& radii,
    const periodicity& periods
) const
{
    if (!slabs_)
    {
        return boolList();
    }

    boolList result;
    scalar largest = 0, ofMine = 0;

    forAll(radii, i)
    {
        largest = max(largest, radii[i]);
        ofMine = mine(i) ? max(ofMine, radii[i]) : ofMine;
    }

    result.setSize(centres.size());
    forAll(centres, i)
    {
        // Rounding of the shifts
        const scalar reach = 1.001*(radii[i] + ofMine);

        auto isDistant = [&](const scalar x)
        {
            return x < low_ - reach || x > high_ + reach;
        };

        result[i] = !mine(i) && isDistant(centres[i][along_]);

        if (!result[i] || !periods.active())
        {
            continue;
        }

        // With those of the body where mine have been shifted
        for
        (
            const periodicity::image& im
          : periods.globalImages(centres[i], 2*(radii[i] + largest))
        )
        {
            result[i] =
                result[i] && isDistant(centres[i][along_] + im.shift[along_]);
        }
    }

    return result;
}
