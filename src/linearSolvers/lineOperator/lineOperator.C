// SPDX-License-Identifier: GPL-3.0-or-later

#include "lineOperator.H"

namespace
{

using namespace Foam;

//- Equal up to what mesh files round off; refinement makes up for it
bool alike(const scalar a, const scalar b)
{
    return mag(a - b) <= 1e-6*max(mag(a), mag(b));
}

} // End anonymous namespace


Foam::lineOperator::lineOperator()
:
    low_(0),
    high_(0),
    cyclic_(false)
{}


Foam::lineOperator::lineOperator
(
    const scalarField& widths,
    const scalarField& links,
    const scalar low,
    const scalar high,
    const bool cyclic
)
:
    widths_(widths),
    links_(links),
    low_(low),
    high_(high),
    cyclic_(cyclic)
{}


Foam::scalar Foam::lineOperator::sumLinks(const label i) const
{
    const label n = size();

    return links_[i] + links_[(i + n - 1) % n]
      + (i == 0 ? low_ : 0) + (i == n - 1 ? high_ : 0);
}


Foam::scalar Foam::lineOperator::diag(const label i) const
{
    return sumLinks(i)/widths_[i];
}


Foam::scalar Foam::lineOperator::off(const label i) const
{
    return links_[i]/sqrt(widths_[i]*widths_[(i + 1) % size()]);
}


Foam::lineOperator::basis Foam::lineOperator::trigonometric() const
{
    const scalar a = links_[0];

    for (label i = 0; i < size(); ++i)
    {
        const bool linked = cyclic_ || i < size() - 1;

        if (!alike(widths_[i], widths_[0]) || (linked && !alike(links_[i], a)))
        {
            return basis::none;
        }
    }

    if (cyclic_)
    {
        return basis::periodic;
    }

    const bool fixedLow = alike(low_, 2*a);
    const bool fixedHigh = alike(high_, 2*a);

    if ((low_ != 0 && !fixedLow) || (high_ != 0 && !fixedHigh))
    {
        return basis::none;
    }

    return
        fixedLow
      ? (fixedHigh ? basis::ss : basis::sc)
      : (fixedHigh ? basis::cs : basis::cc);
}


Foam::scalar Foam::lineOperator::scale() const
{
    const label n = cyclic_ ? size() : size() - 1;

    return n > 0 ? (sum(links_)/n)/average(widths_) : 0;
}
