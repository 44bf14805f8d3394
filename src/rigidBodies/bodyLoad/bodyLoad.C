// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyLoad.H"

namespace
{

//- Matrix of the cross product: crossMatrix(r) & e = r ^ e
Foam::tensor crossMatrix(const Foam::vector& r)
{
    return Foam::tensor
    (
        0, -r.z(), r.y(),
        r.z(), 0, -r.x(),
        -r.y(), r.x(), 0
    );
}


//- Call f with each scalar of the load in turn, the response last
template<class Load, class Function>
void forEach(Load& load, Function f)
{
    for (Foam::direction i = 0; i < 3; ++i)
    {
        f(load.force[i]);
        f(load.torque[i]);
    }
    f(load.volume);
    f(load.slip);

    f(load.a);
    for (Foam::direction i = 0; i < 3; ++i)
    {
        f(load.aRow[i]);
        f(load.aCol[i]);
    }
    for (Foam::direction i = 0; i < 9; ++i)
    {
        f(load.aRowCol[i]);
    }
}

} // End anonymous namespace


Foam::bodyLoad::bodyLoad()
{
    clear(true);
}


void Foam::bodyLoad::clear(const bool response)
{
    force = torque = Zero;
    volume = slip = 0;

    if (response)
    {
        a = 0;
        aRow = aCol = Zero;
        aRowCol = Zero;
    }
}


void Foam::bodyLoad::symmetrise(const direction k)
{
    force[k] = aRow[k] = aCol[k] = 0;

    for (direction j = 0; j < 3; ++j)
    {
        if (j != k)
        {
            torque[j] = 0;
            aRowCol(j, k) = aRowCol(k, j) = 0;
        }
    }
}


void Foam::bodyLoad::scale(const scalar factor, const bool response)
{
    label i = 0;
    forEach
    (
        *this,
        [&](scalar& value)
        {
            if (response || i < nPackedLoad) value *= factor;
            ++i;
        }
    );
}


Foam::scalarSquareMatrix Foam::bodyLoad::block() const
{
    // Mode k translates with e_k, mode 3 + k turns with e_k ^ r. With the
    // rows at r_i and columns at r_j:
    //     e_k . (e_l ^ r_j) = -crossMatrix(r_j)_kl
    //     (e_k ^ r_i) . e_l = crossMatrix(r_i)_kl
    //     (e_k ^ r_i) . (e_l ^ r_j) = delta_kl r_i.r_j - (r_j)_k (r_i)_l
    const tensor ur(-crossMatrix(aCol));
    const tensor ru(crossMatrix(aRow));
    const tensor rr(tr(aRowCol)*tensor::I - aRowCol.T());

    scalarSquareMatrix G(6, Zero);

    for (direction k = 0; k < 3; ++k)
    {
        G(k, k) = a;

        for (direction l = 0; l < 3; ++l)
        {
            G(k, 3 + l) = ur(k, l);
            G(3 + k, l) = ru(k, l);
            G(3 + k, 3 + l) = rr(k, l);
        }
    }

    return G;
}


void Foam::bodyLoad::pack
(
    UList<scalar>& data,
    const label start,
    const label n
) const
{
    label i = 0;
    forEach
    (
        *this,
        [&](const scalar value)
        {
            if (i < n) data[start + i] = value;
            ++i;
        }
    );
}


void Foam::bodyLoad::unpack
(
    const UList<scalar>& data,
    const label start,
    const label n
)
{
    label i = 0;
    forEach
    (
        *this,
        [&](scalar& value)
        {
            if (i < n) value = data[start + i];
            ++i;
        }
    );
}
