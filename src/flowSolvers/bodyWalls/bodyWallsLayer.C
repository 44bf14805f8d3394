// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyWalls.H"
#include "lawOfTheWall.H"

void Foam::fv::bodyWalls::findCells()
{
    const PtrList<bodyRegion>& regions = bodies_.region().regions();
    scalarField nearest(mesh_.nCells(), GREAT);

    for (const bodyRegion& r : regions)
    {
        forAll(r.cells, i)
        {
            scalar& d = nearest[r.cells[i]];

            d = min(d, r.distance[i]/r.h[i]);
        }
    }

    zone_.clear();
    outside_.clear();

    forAll(regions, regioni)
    {
        const bodyRegion& r = regions[regioni];

        forAll(r.cells, i)
        {
            const bodyCell c{r.cells[i], regioni, i};
            scalar& d = nearest[c.cell];

            if (cellsAway(c) == d && d < width_ + 1)
            {
                (d < width_ ? zone_ : outside_).append(c);

                // Of two bodies at the same distance it is the first
                d = -GREAT;
            }
        }
    }

    inward_.reset(new normalExtrapolation(mesh_, regions, width_));
    within_.reset(new normalExtrapolation(mesh_, regions, width_ - 1));
}


void Foam::fv::bodyWalls::setLayer()
{
    const volScalarField* k =
        usesK() ? &mesh_.lookupObject<volScalarField>("k") : nullptr;

    uTau_ = 0;
    kLog_ = 0;

    for (const bodyCell& c : outside_)
    {
        const scalar nu = nu_[c.cell];
        const scalar u = lawOfTheWall::frictionVelocity(speed(c), y(c), nu);

        uTau_[c.cell] = u;
        kLog_[c.cell] =
        (
            k
          ? lawOfTheWall::through((*k)[c.cell], y(c), nu, u)
          : lawOfTheWall(nu, u)
        ).kLog();
    }

    inward_->apply(uTau_, false);
    inward_->apply(kLog_, false);
}


void Foam::fv::bodyWalls::setViscosity()
{
    const bool byK = usesK();

    nut_ = 0;

    for (const bodyCell& c : zone_)
    {
        if (cellsAway(c) >= width_ - 1)
        {
            nut_[c.cell] = byK
              ? law(c).nut(y(c))
              : lawOfTheWall::nutByVelocity(speed(c), y(c), nu_[c.cell]);
        }
    }

    within_->apply(nut_, false);
}
