// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactClearance.H"
#include "bitSet.H"

void Foam::contactClearance::reset(const label nMovers)
{
    pairs_.clear();
    normals_.clear();
    ways_ = List<growing>(nMovers, growing{0, 0, 0});
    slid_ = growing{0, 0, 0};
    step_ = 0;
    nSteps_ = 0;
    fastest_ = 0;
    dueValid_ = false;
}


void Foam::contactClearance::setWay
(
    const label mover,
    const scalar now,
    const scalar perStep
)
{
    growing& way = ways_[mover];

    // Pairs are scheduled right after paths are set; one that is set in each
    // sub-step may have grown as the fastest
    const scalar more = step_ == way.set + 1 ? fastest_ - way.perStep : 0;

    if (perStep > fastest_ || now > way.at(step_) + more + 1e-9*perStep)
    {
        // Somewhat more, as it may be accelerated
        fastest_ = max(fastest_, 1.1*perStep);
        dueValid_ = false;
    }
    way = from(now, perStep);
}


Foam::labelList Foam::contactClearance::due()
{
    if (dueValid_)
    {
        // Many of them in no order: faster than to sort them
        return bitSet(pairs_.size(), due_[step_]).sortedToc();
    }

    due_.resize(nSteps_);
    for (DynamicList<label>& pairs : due_)
    {
        pairs.clear();
    }
    dueValid_ = true;

    return identity(pairs_.size());
}


void Foam::contactClearance::schedule(const label pairi)
{
    const label nLeft = nSteps_ - step_ - 1;

    if (nLeft <= 0)
    {
        return;
    }

    // By two at the speed of the fastest, which may rest
    const scalar perStep = 2*fastest_ + slid_.perStep;
    const entry& e = pairs_[pairi];
    const scalar gap = e.until - sum(e, step_ + 0.5);

    if (gap <= 0)
    {
        due_[step_ + 1].append(pairi);
    }
    else if (gap < nLeft*perStep)
    {
        // Somewhat earlier, for rounding
        due_[step_ + 1 + label(0.999*gap/perStep)].append(pairi);
    }
}
