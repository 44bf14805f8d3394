// SPDX-License-Identifier: GPL-3.0-or-later

template<class Type>
Foam::tmp<Foam::Field<Foam::sweptRemap::gradientOf<Type>>>
Foam::sweptRemap::gradients
(
    const GeometricField<Type, fvPatchField, volMesh>& y,
    const label n
) const
{
    const surfaceScalarField& weights = mesh_.weights();
    const vectorField& Sf = mesh_.faceAreas();
    const scalarField& V = mesh_.V();
    const List<Type> others(beyond(y.primitiveField()));
    tmp<Field<gradientOf<Type>>> tgrad(new Field<gradientOf<Type>>(n));
    Field<gradientOf<Type>>& grad = tgrad.ref();

    forAll(grad, i)
    {
        const label celli = cells_[i];
        gradientOf<Type> sum(Zero);

        for (label j = begin_[i]; j < begin_[i + 1]; ++j)
        {
            sum += links_[j].first*(y[links_[j].cell] - y[celli]);
        }

        for (const auto& face : neighbours_.onPatches(celli))
        {
            const fvPatch& patch = mesh_.boundary()[face.patch];
            const label facei = patch.start() + face.face;

            sum += patch.coupled()
              ? ((1 - weights.boundaryField()[face.patch][face.face])
               /V[celli]*Sf[facei])
               *(others[facei - mesh_.nInternalFaces()] - y[celli])
              : (Sf[facei]/V[celli])
               *(y.boundaryField()[face.patch][face.face] - y[celli]);
        }

        grad[i] = sum;
    }

    return tgrad;
}


namespace
{
    //- The row k of a gradient
    inline Foam::scalar row(const Foam::vector& grad, const Foam::direction k)
    {
        return grad[k];
    }

    inline Foam::vector row(const Foam::tensor& grad, const Foam::direction k)
    {
        return Foam::vector(grad[3*k], grad[3*k + 1], grad[3*k + 2]);
    }


    //- Value of what a face has swept over, see the header
    template<class Type, class Grad>
    Type sweptValue
    (
        const Foam::vector& s,
        const Foam::vector& d,
        const Foam::direction axis,
        const Foam::scalar m,
        const Foam::scalar w,
        const Type& yP,
        const Type& yN,
        const Grad& gP,
        const Grad& gN,
        const Type& bP,
        const Type& bN
    )
    {
        const Type dy(yN - yP);
        const Grad bend(gN - gP);
        const Grad grad(w*gP + (1 - w)*gN);
        const Type dMeanB(d[axis]*(w*bP + (1 - w)*bN));
        const Type excess((d & grad) - dy);
        const Foam::vector t(s - m*d);
        const Foam::scalar k = 1 - m*m, l = 4 - m*m;

        return w*yP + (1 - w)*yN
          - k/6*((d & bend) - (l/20*d[axis])*(bN - bP))
          - 0.5*m*(dy - k/3*excess + (k*l/90)*(dMeanB - 4*excess))
          - 0.5*(t & grad) + 0.5*m*(t & bend);
    }
}


template<class Type>
Foam::Field<Type> Foam::sweptRemap::secondDifferences
(
    const direction k,
    const UList<gradientOf<Type>>& grad,
    const UList<gradientOf<Type>>& others
) const
{
    const vectorField& Sf = mesh_.faceAreas();
    const scalarField& V = mesh_.V();
    Field<Type> b(nCells_, Zero);

    forAll(b, i)
    {
        const label celli = cells_[i];
        const Type here(row(grad[i], k));
        bool atPatch = false;

        for (label j = begin_[i]; j < begin_[i + 1]; ++j)
        {
            const scalar part = links_[j].second[k];

            // None of most faces of meshes along the axes
            if (part != 0)
            {
                b[i] += part*(row(grad[links_[j].place], k) - here);
            }
        }

        for (const auto& face : neighbours_.onPatches(celli))
        {
            const fvPatch& patch = mesh_.boundary()[face.patch];
            const label facei = patch.start() + face.face;

            if (patch.coupled())
            {
                b[i] += Sf[facei][k]*delta_[face.patch][face.face][k]/V[celli]
                   *(row(others[facei - mesh_.nInternalFaces()], k) - here);
            }
            else
            {
                atPatch = atPatch || mag(Sf[facei][k]) > 0.1*mag(Sf[facei]);
            }
        }

        if (atPatch)
        {
            b[i] = Zero;
        }
    }

    return b;
}


template<class Type>
void Foam::sweptRemap::sweep
(
    const UList<vector>& s,
    const direction k,
    const GeometricField<Type, fvPatchField, volMesh>& y,
    const UList<gradientOf<Type>>& grad,
    const bool smooth,
    scalarField& volume,
    Field<Type>& swept
) const
{
    const vectorField& C = mesh_.cellCentres();
    const vectorField& Sf = mesh_.faceAreas();
    const label nInternal = mesh_.nInternalFaces();

    const List<Type> otherY(beyond(y.primitiveField()));
    const List<gradientOf<Type>> otherGrad(beyondCells(grad));
    const Field<Type> b
    (
        smooth
      ? secondDifferences<Type>(k, grad, otherGrad)
      : Field<Type>(nCells_, Zero)
    );
    const List<Type> otherB(beyondCells(b));

    volume = 0;
    swept = Zero;

    forAll(faces_, i)
    {
        const label facei = faces_[i];
        const scalar V = s[i][k]*Sf[facei][k];

        if (V == 0)
        {
            continue;
        }

        const label own = mesh_.faceOwner()[facei];
        const label o = cellAt_[own];
        vector sk(Zero);
        sk[k] = s[i][k];

        volume[o] += V;

        if (facei < nInternal)
        {
            const label nei = mesh_.faceNeighbour()[facei];
            const label n = cellAt_[nei];
            const vector d(C[nei] - C[own]);
            const Type flux
            (
                V*sweptValue
                (
                    sk, d, k, V/(d & Sf[facei]), mesh_.weights()[facei],
                    y[own], y[nei], grad[o], grad[n], b[o], b[n]
                )
            );

            swept[o] += flux;
            swept[n] -= flux;
            volume[n] -= V;
            continue;
        }

        const label at = facei - nInternal;
        const label patchi = mesh_.boundaryMesh().patchID()[at];
        const fvPatch& patch = mesh_.boundary()[patchi];
        const label j = facei - patch.start();
        const vector d(delta_[patchi][j]);

        swept[o] += V*sweptValue
        (
            sk, d, k, V/(d & Sf[facei]), patch.weights()[j],
            y[own], otherY[at], grad[o], otherGrad[at], b[o], otherB[at]
        );
    }
}
