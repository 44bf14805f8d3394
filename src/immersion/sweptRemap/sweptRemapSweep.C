// SPDX-License-Identifier: GPL-3.0-or-later

template<class Type>
Foam::Field<Type> Foam::sweptRemap::gradientRow
(
    const direction row,
    const packedField<Type>& y,
    const UList<Type>& others
) const
{
    const remapStencil::axisLinks& along = stencil_.links(row);
    Field<Type> g(stencil_.nWide(), Zero);

    forAll(g, i)
    {
        for (label j = along.begin[i]; j < along.begin[i + 1]; ++j)
        {
            const remapStencil::link& link = along.links[j];

            g[i] += link.first*(y.values[link.place] - y.values[i]);
        }
    }
    for (const remapStencil::patchLink& link : along.onPatches)
    {
        const Type& value = link.beyond >= 0
          ? others[link.beyond]
          : y.onPatches[link.patch][link.face];

        g[link.place] += link.first*(value - y.values[link.place]);
    }

    return g;
}


template<class Type>
Foam::Field<Type> Foam::sweptRemap::secondDifferences
(
    const direction k,
    const UList<Type>& row,
    const UList<Type>& others
) const
{
    // A patch whose normal has no more of the axis is beside a cell, not at
    // the end of its line
    const scalar atEnd = 0.1;
    const remapStencil::axisLinks& along = stencil_.links(k);
    Field<Type> b(stencil_.nCells(), Zero);

    forAll(b, i)
    {
        for (label j = along.begin[i]; j < along.begin[i + 1]; ++j)
        {
            const remapStencil::link& link = along.links[j];

            b[i] += link.second*(row[link.place] - row[i]);
        }
    }
    for (const remapStencil::patchLink& link : along.onPatches)
    {
        if (link.beyond >= 0 && link.place < b.size())
        {
            b[link.place] +=
                link.second*(others[link.beyond] - row[link.place]);
        }
    }
    for (const remapStencil::patchLink& link : along.onPatches)
    {
        if (link.beyond < 0 && link.place < b.size() && link.second > atEnd)
        {
            b[link.place] = Zero;
        }
    }

    return b;
}


namespace
{
    //- Means and differences over the cells of a face, named as in the header
    template<class Type>
    class faceTerms
    {
        Type mean_, dy_;
        Type dMeanG_, dDiffG_, tMeanG_, tDiffG_;
        Type dMeanB_, dDiffB_;

    public:

        //- Construct for the weight of the owner and values there and beyond
        faceTerms(const Foam::scalar w, const Type& yO, const Type& yN)
        :
            mean_(w*yO + (1 - w)*yN),
            dy_(yN - yO),
            dMeanG_(Foam::Zero),
            dDiffG_(Foam::Zero),
            tMeanG_(Foam::Zero),
            tDiffG_(Foam::Zero)
        {}

        //- Add a row of the gradient; d, t: components along it
        void addGradient
        (
            const Foam::scalar w,
            const Foam::scalar d,
            const Foam::scalar t,
            const Type& gO,
            const Type& gN
        )
        {
            const Type mean(w*gO + (1 - w)*gN);
            const Type diff(gN - gO);

            dMeanG_ += d*mean;
            dDiffG_ += d*diff;
            tMeanG_ += t*mean;
            tDiffG_ += t*diff;
        }

        //- Set the second difference; d: component along s
        void setBend
        (
            const Foam::scalar w,
            const Foam::scalar d,
            const Type& bO,
            const Type& bN
        )
        {
            dMeanB_ = d*(w*bO + (1 - w)*bN);
            dDiffB_ = d*(bN - bO);
        }

        //- Value of what the face has swept over
        Type swept(const Foam::scalar m) const
        {
            const Foam::scalar k = 1 - m*m, l = 4 - m*m;
            const Type excess(dMeanG_ - dy_);

            return mean_
              - k/6*(dDiffG_ - l/20*dDiffB_)
              - 0.5*m*(dy_ - k/3*excess + k*l/90*(dMeanB_ - 4*excess))
              - 0.5*tMeanG_
              + 0.5*m*tDiffG_;
        }
    };
}


template<class Type>
void Foam::sweptRemap::sweep
(
    const UList<vector>& s,
    const direction k,
    const packedField<Type>& y,
    const bool smooth,
    scalarField& volume,
    Field<Type>& swept
) const
{
    const DynamicList<direction>& rows = stencil_.rows(k);
    const List<Type> otherY(stencil_.beyond(y.values));
    FixedList<Field<Type>, 3> g;
    FixedList<List<Type>, 3> otherG;

    for (const direction row : rows)
    {
        g[row] = gradientRow<Type>(row, y, otherY);
        otherG[row] = stencil_.beyond(g[row]);
    }

    const Field<Type> b
    (
        smooth
      ? secondDifferences<Type>(k, g[k], otherG[k])
      : Field<Type>(stencil_.nCells(), Zero)
    );
    const List<Type> otherB(stencil_.beyond(b));

    for (const remapStencil::face& face : stencil_.displaced(k))
    {
        const scalar sk = s[face.index][k];

        if (sk == 0)
        {
            continue;
        }

        const bool coupled = face.nei < 0;
        const label o = face.own, n = face.nei, at = face.beyond;
        const scalar m = sk*face.inverse;
        const scalar w = face.weight;
        faceTerms<Type> terms
        (
            w, y.values[o], coupled ? otherY[at] : y.values[n]
        );

        for (const direction row : rows)
        {
            terms.addGradient
            (
                w, face.d[row], (row == k ? sk : 0) - m*face.d[row],
                g[row][o], coupled ? otherG[row][at] : g[row][n]
            );
        }
        terms.setBend(w, face.d[k], b[o], coupled ? otherB[at] : b[n]);

        const scalar V = sk*face.area;
        const Type flux(V*terms.swept(m));

        volume[o] += V;
        swept[o] += flux;

        if (!coupled)
        {
            volume[n] -= V;
            swept[n] -= flux;
        }
    }
}
