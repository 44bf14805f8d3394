// SPDX-License-Identifier: GPL-3.0-or-later

template<class Type>
Foam::tmp<Foam::Field<Type>> Foam::slidingPair::beyond
(
    const label patchi,
    const Field<Type>& others,
    const bool shifted
) const
{
    const bool first = patchi == patchi_;
    const rowsBeyond& rows = rows_[first ? 0 : 1];
    const scalar s = shifted ? (first ? -1 : 1)*shiftInCells() : 0;
    List<Type> exchanged(others);

    if (rows.exchange.valid())
    {
        rows.exchange().distribute(exchanged);
    }

    tmp<Field<Type>> tresult(new Field<Type>(rows.places.size()));
    Field<Type>& result = tresult.ref();
    scalarField values(rows.from.size());

    for (Foam::direction k = 0; k < pTraits<Type>::nComponents; ++k)
    {
        forAll(values, i)
        {
            values[i] = component(exchanged[rows.from[i]], k);
        }

        rows.shift().move(s, values);

        forAll(result, i)
        {
            setComponent(result[i], k) = values[rows.places[i]];
        }
    }

    return tresult;
}
