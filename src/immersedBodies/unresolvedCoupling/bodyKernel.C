// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyKernel.H"

Foam::bodyKernel::bodyKernel()
:
    searchCentre_(Zero),
    searchRadius_(0),
    searchMargin_(-1),
    centreCell(-1)
{}


void Foam::bodyKernel::clear()
{
    near_.clearStorage();
    nearShift_.clearStorage();
    cells.clearStorage();
    r.clearStorage();
    weight.clearStorage();
    searchMargin_ = -1;
    centreCell = -1;
}


void Foam::bodyKernel::search
(
    const point& x,
    const scalar R,
    const boundBox& centres,
    const cellSearch& search,
    const periodicity& periods
)
{
    searchCentre_ = x;
    searchRadius_ = R;
    searchMargin_ = 0.25*R;

    const scalar reach = R + searchMargin_;

    near_.clear();
    nearShift_.clear();

    for (const vector& shift : periods.localShifts(x, reach))
    {
        const point image(x + shift);

        if (!centres.overlaps(image, sqr(reach)))
        {
            continue;
        }

        for (const label celli : search.cellsAround(image, reach))
        {
            const vector d(search.mesh().cellCentres()[celli] - image);

            if (magSqr(d) < sqr(reach))
            {
                near_.append(celli);
                nearShift_.append(shift);
            }
        }
    }
}


void Foam::bodyKernel::update
(
    const point& x,
    const scalar R,
    const boundBox& centres,
    const cellSearch& search,
    const periodicity& periods
)
{
    if
    (
        searchMargin_ < 0
     || R != searchRadius_
     || mag(x - searchCentre_) > searchMargin_
    )
    {
        this->search(x, R, centres, search, periods);
    }

    const fvMesh& mesh = search.mesh();
    scalar nearest = GREAT;
    label nearesti = -1;

    cells.clear();
    r.clear();
    weight.clear();
    centreCell = -1;

    forAll(near_, i)
    {
        const vector ri(mesh.cellCentres()[near_[i]] - x - nearShift_[i]);
        const scalar s = magSqr(ri)/sqr(R);

        if (s >= 1)
        {
            continue;
        }

        if (s < nearest)
        {
            nearest = s;
            nearesti = cells.size();
        }
        cells.append(near_[i]);
        r.append(ri);
        weight.append(sqr(1 - s));
    }

    auto holds = [&](const label i)
    {
        return search.contains
        (
            cells[i],
            mesh.cellCentres()[cells[i]] - r[i]
        );
    };

    // Next to smaller cells the nearest centre may be that of another
    if (nearesti >= 0 && holds(nearesti))
    {
        centreCell = cells[nearesti];
        return;
    }

    forAll(cells, i)
    {
        if (mag(r[i]) < search.hMax(cells[i]) && holds(i))
        {
            centreCell = cells[i];
            return;
        }
    }
}


Foam::scalar Foam::bodyKernel::sum(const UList<scalar>& V) const
{
    scalar total = 0;

    forAll(cells, i)
    {
        total += weight[i]*V[cells[i]];
    }

    return total;
}


void Foam::bodyKernel::normalise(const scalar sum)
{
    for (scalar& w : weight)
    {
        w /= sum;
    }
}
