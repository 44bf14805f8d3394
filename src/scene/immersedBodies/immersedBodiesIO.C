// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedBodies.H"
#include "bodiesInOrder.H"
#include "bodyContacts.H"
#include "bodyPassage.H"
#include "unresolvedBodies.H"

void Foam::immersedBodies::report(Ostream& os) const
{
    os  << "Immersed bodies: " << nBodies() << ' ' << space_.nDims() << "D";

    if (space_.twoD())
    {
        os  << " (depth " << space_.depth() << " m)";
    }

    if (periodicity_.active())
    {
        os  << nl << "    ";
        periodicity_.report(os);
    }

    os  << nl << "    resistance: ";
    region().resistance().report(os);

    const bodyShare& share = bodies_.share();
    scalar fewest = GREAT, most = 0;

    forAll(bodies_, bodyi)
    {
        fewest = min(fewest, cellsPerWidth(bodyi));
        most = max(most, cellsPerWidth(bodyi));
    }
    fewest = -share.largest(-fewest);
    most = share.largest(most);

    const label nFree = share.sum<label>
    (
        [&](const label i) { return bodies_[i].isFree(); }
    );
    const label nFixed = share.sum<label>
    (
        [&](const label i) { return bodies_[i].isFixed(); }
    );

    os  << nl << "    motion: " << nFree << " free, " << nFixed << " fixed, "
        << nBodies() - nFree - nFixed << " prescribed";

    if (window_.comoving())
    {
        os  << nl << "    window: comoving, at "
            << window_.displacement() << " m with " << window_.velocity()
            << " m/s";
    }

    if (nBodies())
    {
        os  << nl << "    cells per width: " << fewest << " to " << most;
    }

    if (share.any(bodies_.nUnresolved()))
    {
        os  << nl << "    ";
        unresolved_->coupling().report(os);
    }
    os  << nl;

    contacts_->report(bodies_, os);

    if (steady_.active())
    {
        os  << "    steady: ends at a residual of " << steady_.tolerance()
            << nl;
    }
}


bool Foam::immersedBodies::writeData(Ostream& os) const
{
    // As many digits as it takes to go on exactly
    const auto precision = os.precision(17);

    os.writeEntry("time", clock_);
    window_.writeState(os);
    passage_->writeState(os);
    contacts_->writeState(os);
    crowd_.writeState(os);
    bodies_.share().writeState(os);

    os.beginBlock("bodies");

    bodiesInOrder::write
    (
        bodies_, os,
        [&](Ostream& os, const label bodyi)
        {
            os.beginBlock(bodies_[bodyi].name());
            bodies_[bodyi].writeState(os);
            os.writeEntry("cellSize", h_[bodyi]);
            contacts_->writeState(os, bodies_, bodyi);
            os.endBlock();
        }
    );

    os.endBlock();
    os.precision(precision);

    return os.good();
}
