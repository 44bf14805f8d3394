// SPDX-License-Identifier: GPL-3.0-or-later

#include "twoTermFit.H"
#include "scalarList.H"
#include <cmath>

namespace
{
    //- Determinant over the product of the diagonal below which two terms are
    //  taken as the same: some digits more than rounding leaves
    const Foam::scalar singular = 1e-10;
}


Foam::twoTermFit::twoTermFit()
:
    blockLength_(1),
    nLast_(1)
{}


Foam::twoTermFit::block Foam::twoTermFit::total() const
{
    block all(scalar(0));

    for (const block& b : blocks_)
    {
        for (label i = 0; i < nSums; ++i)
        {
            all[i] += b[i];
        }
    }

    return all;
}


Foam::twoTermFit::pair Foam::twoTermFit::solve
(
    const block& S,
    const scalar v1,
    const scalar v2
)
{
    const scalar diagonal = S[x1x1]*S[x2x2];
    const scalar det = diagonal - sqr(S[x1x2]);

    if (!(det > singular*diagonal))
    {
        return pair(scalar(NAN));
    }

    pair c;
    c[0] = (S[x2x2]*v1 - S[x1x2]*v2)/det;
    c[1] = (S[x1x1]*v2 - S[x1x2]*v1)/det;

    return c;
}


void Foam::twoTermFit::mergeBlocks()
{
    const label n = blocks_.size()/2;

    for (label i = 0; i < n; ++i)
    {
        for (label k = 0; k < nSums; ++k)
        {
            blocks_[i][k] = blocks_[2*i][k] + blocks_[2*i + 1][k];
        }
    }

    blocks_.setSize(n);
    blockLength_ *= 2;
    nLast_ = blockLength_;
}


void Foam::twoTermFit::add(const vector& y, const vector& x1, const vector& x2)
{
    if (nLast_ == blockLength_)
    {
        if (blocks_.size() == 2*minBlocks)
        {
            mergeBlocks();
        }
        blocks_.append(block(scalar(0)));
        nLast_ = 0;
    }

    block& last = blocks_.last();

    last[x1x1] += x1 & x1;
    last[x1x2] += x1 & x2;
    last[x2x2] += x2 & x2;
    last[x1y] += x1 & y;
    last[x2y] += x2 & y;
    last[yy] += y & y;
    ++nLast_;
}


Foam::label Foam::twoTermFit::n() const
{
    return blocks_.empty() ? 0 : (blocks_.size() - 1)*blockLength_ + nLast_;
}


Foam::twoTermFit::pair Foam::twoTermFit::coefficients() const
{
    const block all(total());

    return solve(all, all[x1y], all[x2y]);
}


Foam::twoTermFit::pair Foam::twoTermFit::errors() const
{
    const label n = blocks_.size();

    if (n < minBlocks)
    {
        return pair(scalar(NAN));
    }

    const block all(total());
    const pair c(coefficients());
    pair variance(scalar(0));

    for (const block& b : blocks_)
    {
        const pair d
        (
            solve
            (
                all,
                b[x1y] - c[0]*b[x1x1] - c[1]*b[x1x2],
                b[x2y] - c[0]*b[x1x2] - c[1]*b[x2x2]
            )
        );

        variance[0] += sqr(d[0]);
        variance[1] += sqr(d[1]);
    }

    pair error;
    error[0] = Foam::sqrt(variance[0]*n/(n - 2));
    error[1] = Foam::sqrt(variance[1]*n/(n - 2));

    return error;
}


Foam::scalar Foam::twoTermFit::unexplained() const
{
    const block all(total());
    const pair c(coefficients());
    const scalar rest = all[yy] - c[0]*all[x1y] - c[1]*all[x2y];

    // Numbers that are none must not be compared: that is trapped
    if (std::isnan(rest) || all[yy] <= 0)
    {
        return NAN;
    }

    // Less than zero by rounding only
    return max(rest/all[yy], scalar(0));
}


void Foam::twoTermFit::readState(const dictionary& dict)
{
    const scalarList sums(dict.get<scalarList>("sums"));

    if (sums.size() % nSums)
    {
        FatalIOErrorInFunction(dict)
            << "'sums' must have " << label(nSums) << " numbers for each block"
            << " and has " << sums.size() << nl << exit(FatalIOError);
    }

    blockLength_ = dict.get<label>("blockLength");
    nLast_ = dict.get<label>("lastBlock");
    blocks_.setSize(sums.size()/nSums);

    forAll(sums, i)
    {
        blocks_[i/nSums][i % nSums] = sums[i];
    }
}


void Foam::twoTermFit::writeState(Ostream& os) const
{
    os.writeEntry("blockLength", blockLength_);
    os.writeEntry("lastBlock", nLast_);

    // As text, whatever the format
    os.writeKeyword("sums") << token::BEGIN_LIST;
    for (const block& b : blocks_)
    {
        for (const scalar x : b)
        {
            os  << token::SPACE << x;
        }
    }
    os  << token::SPACE << token::END_LIST << token::END_STATEMENT << nl;
}
