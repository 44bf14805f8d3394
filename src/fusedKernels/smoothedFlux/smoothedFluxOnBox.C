// SPDX-License-Identifier: GPL-3.0-or-later

#include "smoothedFlux.H"

Foam::scalar Foam::smoothedFlux::onBox
(
    const label o,
    const label n,
    const direction cmpt,
    const scalar sign,
    const scalar w,
    const scalar deltaCoeff
) const
{
    const scalar own = U_[o][cmpt] + tau_[o]*gradP_[o][cmpt];
    const scalar other = U_[n][cmpt] + tau_[n]*gradP_[n][cmpt];
    const scalar tau = w*tau_[o] + (1 - w)*tau_[n];

    return sign*(w*own + (1 - w)*other) - tau*deltaCoeff*(p_[n] - p_[o]);
}


void Foam::smoothedFlux::setAlong
(
    const boxCells& box,
    const boxCells::row& r,
    scalarField& phi
) const
{
    const boxCells::line& along = box.along(0);
    const direction cmpt = along.cmpt;
    const scalar sign = along.sign;
    const scalar area = box.along(1).width[r.j]*box.along(2).width[r.k];
    const label begin = box.face(r, 0, 0);
    const label step = along.n > 2 ? box.face(r, 1, 0) - begin : 0;

    for (label i = 0; i < along.n - 1; ++i)
    {
        const label o = r.cell + i;

        phi[begin + step*i] = area*onBox
        (
            o, o + 1, cmpt, sign, along.weight[i], along.deltaCoeff[i]
        );
    }
}


void Foam::smoothedFlux::setAcross
(
    const boxCells& box,
    const boxCells::row& r,
    const direction d,
    scalarField& phi
) const
{
    const boxCells::line& along = box.along(d);
    const label at = d == 1 ? r.j : r.k;
    const direction cmpt = along.cmpt;
    const label stride = along.stride;
    const scalar sign = along.sign;
    const scalar w = along.weight[at];
    const scalar deltaCoeff = along.deltaCoeff[at];

    // Of all faces of the row, but for the widths along it
    const scalarField& width = box.along(0).width;
    const scalar other =
        d == 1 ? box.along(2).width[r.k] : box.along(1).width[r.j];

    // The last cell of the row has fewer faces than the others
    const label last = width.size() - 1;
    const label begin = box.face(r, 0, d);
    const label step = last > 1 ? box.face(r, 1, d) - begin : 0;

    const auto flux = [&](const label i)
    {
        const label o = r.cell + i;

        return other*width[i]
           *onBox(o, o + stride, cmpt, sign, w, deltaCoeff);
    };

    for (label i = 0; i < last; ++i)
    {
        phi[begin + step*i] = flux(i);
    }
    phi[box.face(r, last, d)] = flux(last);
}


void Foam::smoothedFlux::setOnBox
(
    const boxCells& box,
    scalarField& phi
) const
{
    box.forRows
    (
        [&](const boxCells::row& r)
        {
            setAlong(box, r, phi);
            if (r.j < box.along(1).n - 1)
            {
                setAcross(box, r, 1, phi);
            }
            if (r.k < box.along(2).n - 1)
            {
                setAcross(box, r, 2, phi);
            }
        }
    );
}
