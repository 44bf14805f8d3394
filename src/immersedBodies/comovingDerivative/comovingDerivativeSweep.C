// SPDX-License-Identifier: GPL-3.0-or-later

#include "comovingDerivative.H"
#include "syncTools.H"

template<class Type>
Foam::List<Type> Foam::comovingDerivative::beyond
(
    const UList<Type>& values
) const
{
    List<Type> others;

    if (coupled_)
    {
        syncTools::swapBoundaryCellList(mesh_, values, others);
    }

    return others;
}


template<class Type>
Foam::Field<typename Foam::outerProduct<Foam::vector, Type>::type>
Foam::comovingDerivative::gradients
(
    const GeometricField<Type, fvPatchField, volMesh>& y,
    const labelUList& cells
) const
{
    typedef typename outerProduct<vector, Type>::type gradType;

    const surfaceScalarField& weights = mesh_.weights();
    const vectorField& Sf = mesh_.faceAreas();
    const List<Type> others(beyond(y.primitiveField()));
    Field<gradType> grad(cells.size());

    forAll(cells, i)
    {
        const label celli = cells[i];
        gradType sum(Zero);

        for (const auto& n : neighbours_.of(celli))
        {
            const label facei = n.face();
            const scalar w =
                n.owner() ? 1 - weights[facei] : -weights[facei];

            sum += (w*Sf[facei])*(y[n.cell()] - y[celli]);
        }

        for (const auto& face : neighbours_.onPatches(celli))
        {
            const fvPatch& patch = mesh_.boundary()[face.patch];
            const label facei = patch.start() + face.face;

            sum += patch.coupled()
              ? ((1 - weights.boundaryField()[face.patch][face.face])
               *Sf[facei])
               *(others[facei - mesh_.nInternalFaces()] - y[celli])
              : Sf[facei]
               *(y.boundaryField()[face.patch][face.face] - y[celli]);
        }

        grad[i] = sum/mesh_.V()[celli];
    }

    return grad;
}


namespace
{
    //- Value of what a face has swept over, see the header
    template<class Type, class Grad>
    Type sweptValue
    (
        const Foam::vector& s,
        const Foam::vector& d,
        const Foam::scalar m,
        const Foam::scalar w,
        const Type& yP,
        const Type& yN,
        const Grad& gradP,
        const Grad& gradN
    )
    {
        const Type dy(yN - yP);
        const Grad bend(gradN - gradP);
        const Grad grad(w*gradP + (1 - w)*gradN);
        const Foam::vector t(s - m*d);
        const Foam::scalar k = 1 - m*m;

        return w*yP + (1 - w)*yN - k/6*(d & bend)
          - 0.5*(m*(dy - k/3*((d & grad) - dy)) + (t & grad))
          + 0.5*m*(t & bend);
    }
}


template<class Type>
Foam::Field<Type> Foam::comovingDerivative::swept
(
    const UList<vector>& s,
    const GeometricField<Type, fvPatchField, volMesh>& y
) const
{
    typedef typename outerProduct<vector, Type>::type gradType;

    const vectorField& C = mesh_.cellCentres();
    const vectorField& Sf = mesh_.faceAreas();
    const label nInternal = mesh_.nInternalFaces();
    const Field<gradType> grad(gradients(y, cells_));
    Field<Type> sum(cells_.size(), Zero);

    // Beyond coupled patches
    const List<Type> others(beyond(y.primitiveField()));
    List<gradType> otherGrads;

    if (coupled_)
    {
        Field<gradType> all(mesh_.nCells(), Zero);
        UIndirectList<gradType>(all, cells_) = grad;
        otherGrads = beyond(all);
    }

    forAll(faces_, i)
    {
        const label facei = faces_[i];
        const label own = mesh_.faceOwner()[facei];
        const label o = cellAt_[own];
        const scalar volume = s[i] & Sf[facei];

        if (facei < nInternal)
        {
            const label nei = mesh_.faceNeighbour()[facei];
            const label n = cellAt_[nei];
            const vector d(C[nei] - C[own]);
            const Type flux
            (
                volume*sweptValue
                (
                    s[i], d, volume/(d & Sf[facei]), mesh_.weights()[facei],
                    y[own], y[nei], grad[o], grad[n]
                )
            );

            sum[o] += flux;
            sum[n] -= flux;
            continue;
        }

        const label b = facei - nInternal;
        const label patchi = mesh_.boundaryMesh().patchID()[b];
        const fvPatch& patch = mesh_.boundary()[patchi];
        const label j = facei - patch.start();
        const vector d(delta_[patchi][j]);

        sum[o] += volume*sweptValue
        (
            s[i], d, volume/(d & Sf[facei]), patch.weights()[j],
            y[own], others[b], grad[o], otherGrads[b]
        );
    }

    return sum;
}


Foam::scalarField Foam::comovingDerivative::sweptVolume
(
    const UList<vector>& s
) const
{
    scalarField sum(cells_.size(), Zero);

    forAll(faces_, i)
    {
        const label facei = faces_[i];
        const scalar volume = s[i] & mesh_.faceAreas()[facei];

        sum[cellAt_[mesh_.faceOwner()[facei]]] += volume;

        if (mesh_.isInternalFace(facei))
        {
            sum[cellAt_[mesh_.faceNeighbour()[facei]]] -= volume;
        }
    }

    return sum;
}


// For what is done with them elsewhere

template Foam::List<Foam::label> Foam::comovingDerivative::beyond
(
    const UList<label>&
) const;

template Foam::vectorField Foam::comovingDerivative::gradients
(
    const volScalarField&,
    const labelUList&
) const;

template Foam::scalarField Foam::comovingDerivative::swept
(
    const UList<vector>&,
    const volScalarField&
) const;

template Foam::vectorField Foam::comovingDerivative::swept
(
    const UList<vector>&,
    const volVectorField&
) const;
