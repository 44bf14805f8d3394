// SPDX-License-Identifier: GPL-3.0-or-later

#include "slabTridiagonal.H"
#include "SubField.H"


Foam::slabTridiagonal::slabTridiagonal
(
    const lineOperator& line,
    const slabs& parts,
    const scalarField& lambda,
    const bool singular,
    const slidingModes* sliding
)
:
    nModes_(lambda.size()),
    separated_(parts.size() > 1 || line.cyclic()),
    separator_(line.cyclic() || parts.mine() < parts.size() - 1),
    nInner_(parts.nLayers() - (separator_ ? 1 : 0)),
    toHigh_(0),
    toLow_(0),
    sliding_(sliding),
    first_(parts.mine() == 0)
{
    const label start = parts.start(parts.mine());
    const label n = line.size();
    scalarField diag(nInner_), off(nInner_ - 1);

    forAll(diag, i)
    {
        diag[i] = line.diag(start + i);
    }

    forAll(off, i)
    {
        off[i] = line.off(start + i);
    }

    inner_.reset(new tridiagonal(diag, off, lambda, singular && !separated_));

    if (separated_)
    {
        const label last = start + nInner_;
        toHigh_ = separator_ ? line.off(last - 1) : 0;
        toLow_ = line.off((start + n - 1) % n);

        if (sliding_)
        {
            slidingSeparators_.reset(new slidingSeparators(parts, *sliding_));
        }
        else
        {
            separators_.reset
            (
                new separatorSystem(parts, line.cyclic(), nModes_)
            );
        }
        assemble(line, last, lambda, singular);
        saved_.setSize(nInner_*nModes_);
    }
}


void Foam::slabTridiagonal::assemble
(
    const lineOperator& line,
    const label last,
    const scalarField& lambda,
    const bool singular
)
{
    scalarField response(nInner_*nModes_, Zero);
    SubField<scalar> first(response, nModes_);
    SubField<scalar> final(response, nModes_, (nInner_ - 1)*nModes_);

    // To a unit at the low, then at the high end
    first = 1;
    inner_->solve(response.begin());
    atLow_ = -sqr(toLow_)*first;
    const scalarField between(-toLow_*toHigh_*final);

    response = 0;
    final = 1;
    inner_->solve(response.begin());
    atHigh_ = -sqr(toHigh_)*final;

    if (separator_)
    {
        atHigh_ += line.diag(last) + lambda;
    }

    if (sliding_)
    {
        slidingSeparators_->assemble(atHigh_, atLow_, between, singular);
    }
    else
    {
        separators_->assemble(atHigh_, atLow_, between, singular);
    }
}


void Foam::slabTridiagonal::solveSeparators() const
{
    if (!sliding_)
    {
        separators_->solve(atHigh_, atLow_);
        return;
    }

    sliding_->update();

    if (first_)
    {
        sliding_->multiply(atLow_, false);
    }
    slidingSeparators_->solve(atHigh_, atLow_);

    if (first_)
    {
        sliding_->multiply(atLow_, true);
    }
}


void Foam::slabTridiagonal::solve(scalar* v) const
{
    if (!separated_)
    {
        inner_->solve(v);
        return;
    }

    scalar* const high = v + nInner_*nModes_;
    scalar* const last = high - nModes_;
    std::copy_n(v, nInner_*nModes_, saved_.begin());
    inner_->solve(v);

    for (label m = 0; m < nModes_; ++m)
    {
        atHigh_[m] = toHigh_*last[m] + (separator_ ? high[m] : 0);
        atLow_[m] = toLow_*v[m];
    }

    solveSeparators();
    std::copy_n(saved_.begin(), nInner_*nModes_, v);

    for (label m = 0; m < nModes_; ++m)
    {
        v[m] += toLow_*atLow_[m];
        last[m] += toHigh_*atHigh_[m];

        if (separator_)
        {
            high[m] = atHigh_[m];
        }
    }

    inner_->solve(v);
}
