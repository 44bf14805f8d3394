// SPDX-License-Identifier: GPL-3.0-or-later

#include "pairGradient.H"
#include "gaussGrad.H"
#include "surfaceFields.H"

namespace
{

using namespace Foam;

//- Values on the faces of a patch
tmp<scalarField> faceValues
(
    const fvPatchScalarField& patch,
    const scalarField& weights
)
{
    if (!patch.coupled())
    {
        return tmp<scalarField>(static_cast<const scalarField&>(patch));
    }

    return weights*patch.patchInternalField()
      + (1 - weights)*patch.patchNeighbourField();
}


//- Add the faces of a patch to the sums of value times area of its cells
void addPatch
(
    const fvPatchScalarField& p,
    const fvPatchScalarField& q,
    vectorField& gradP,
    vectorField& gradQ
)
{
    const label patchi = p.patch().index();
    const fvMesh& mesh = p.patch().boundaryMesh().mesh();
    const scalarField& weights = mesh.weights().boundaryField()[patchi];
    const vectorField& Sf = mesh.Sf().boundaryField()[patchi];
    const labelUList& faceCells = p.patch().faceCells();

    const tmp<scalarField> tp(faceValues(p, weights));
    const tmp<scalarField> tq(faceValues(q, weights));

    forAll(Sf, i)
    {
        gradP[faceCells[i]] += Sf[i]*tp()[i];
        gradQ[faceCells[i]] += Sf[i]*tq()[i];
    }
}

} // End anonymous namespace


bool Foam::pairGradient::serves(const fvMesh& mesh, const word& name)
{
    ITstream& scheme = mesh.gradScheme(name);

    return scheme.size() == 2
     && scheme[0] == word("Gauss")
     && scheme[1] == word("linear");
}


void Foam::pairGradient::set
(
    const volScalarField& p,
    const volScalarField& q,
    const scalar factor,
    volVectorField& gradP,
    vectorField& gradQ
)
{
    const fvMesh& mesh = p.mesh();
    const labelUList& owner = mesh.owner();
    const labelUList& neighbour = mesh.neighbour();
    const surfaceScalarField& weights = mesh.weights();
    const surfaceVectorField& Sf = mesh.Sf();
    const scalarField& V = mesh.V();
    vectorField& sumP = gradP.primitiveFieldRef();

    sumP = Zero;
    gradQ.resize(V.size());
    gradQ = Zero;

    forAll(owner, facei)
    {
        const label o = owner[facei];
        const label n = neighbour[facei];
        const scalar w = weights[facei];
        const vector fluxP(Sf[facei]*(w*(p[o] - p[n]) + p[n]));
        const vector fluxQ(Sf[facei]*(w*(q[o] - q[n]) + q[n]));

        sumP[o] += fluxP;
        sumP[n] -= fluxP;
        gradQ[o] += fluxQ;
        gradQ[n] -= fluxQ;
    }

    forAll(p.boundaryField(), patchi)
    {
        addPatch
        (
            p.boundaryField()[patchi],
            q.boundaryField()[patchi],
            sumP,
            gradQ
        );
    }

    forAll(V, celli)
    {
        sumP[celli] /= V[celli];
        gradQ[celli] *= factor/V[celli];
    }

    gradP.correctBoundaryConditions();
    fv::gaussGrad<scalar>::correctBoundaryConditions(p, gradP);
}


void Foam::pairGradient::set
(
    const labelUList& cells,
    const cellNeighbours& neighbours,
    const volScalarField& p,
    const volScalarField& q,
    const scalar factor,
    volVectorField& gradP,
    vectorField& gradQ
)
{
    const fvMesh& mesh = p.mesh();
    const surfaceScalarField& weights = mesh.weights();
    const surfaceVectorField& Sf = mesh.Sf();
    const scalarField& V = mesh.V();
    vectorField& inside = gradP.primitiveFieldRef();

    List<scalarField> pOnPatches(mesh.boundary().size());
    List<scalarField> qOnPatches(mesh.boundary().size());

    forAll(pOnPatches, patchi)
    {
        const scalarField& w = weights.boundaryField()[patchi];

        pOnPatches[patchi] = faceValues(p.boundaryField()[patchi], w);
        qOnPatches[patchi] = faceValues(q.boundaryField()[patchi], w);
    }

    for (const label celli : cells)
    {
        vector sumP(Zero), sumQ(Zero);

        for (const auto& n : neighbours.of(celli))
        {
            const label facei = n.face();
            const scalar w = n.owner() ? weights[facei] : 1 - weights[facei];
            const vector S(n.owner() ? Sf[facei] : -Sf[facei]);

            sumP += (w*(p[celli] - p[n.cell()]) + p[n.cell()])*S;
            sumQ += (w*(q[celli] - q[n.cell()]) + q[n.cell()])*S;
        }

        for (const auto& face : neighbours.onPatches(celli))
        {
            const vector& S = Sf.boundaryField()[face.patch][face.face];

            sumP += pOnPatches[face.patch][face.face]*S;
            sumQ += qOnPatches[face.patch][face.face]*S;
        }

        inside[celli] = sumP/V[celli];
        gradQ[celli] = factor*sumQ/V[celli];
    }

    gradP.correctBoundaryConditions();
}
