// SPDX-License-Identifier: GPL-3.0-or-later

#include "posedShape.H"

Foam::pointField Foam::posedShape::inBody(const UList<point>& x) const
{
    pointField X(x.size());

    if (shape_.round())
    {
        // However it has turned
        forAll(x, i)
        {
            X[i] = x[i] - state_.position;
        }
        return X;
    }

    const tensor toBody(state_.orientation.R().T());

    forAll(x, i)
    {
        X[i] = toBody & (x[i] - state_.position);
    }

    return X;
}


void Foam::posedShape::distance
(
    const UList<point>& x,
    UList<scalar>& d
) const
{
    shape_.distance(inBody(x), d);
}


void Foam::posedShape::normal(const UList<point>& x, UList<vector>& n) const
{
    shape_.normal(inBody(x), n);

    if (shape_.round())
    {
        return;
    }

    const tensor R(state_.orientation.R());

    forAll(n, i)
    {
        n[i] = R & n[i];
    }
}
