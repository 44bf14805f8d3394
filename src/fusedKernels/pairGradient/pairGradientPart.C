// SPDX-License-Identifier: GPL-3.0-or-later

#include "pairGradient.H"
#include "pairSums.H"

void Foam::pairGradient::part::find
(
    const cellNeighbours& neighbours,
    const bitSet& in
)
{
    between.clear();
    edges.clear();
    patchFaces.clear();

    for (const label celli : cells)
    {
        for (const auto& n : neighbours.of(celli))
        {
            if (!in.test(n.cell()))
            {
                edges.append(edge{celli, n});
            }
            else if (n.owner())
            {
                between.append(n.face());
            }
        }

        for (const auto& face : neighbours.onPatches(celli))
        {
            patchFaces.append(patchFace{celli, face});
        }
    }
}


void Foam::pairGradient::set
(
    const part& some,
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
    vectorField& sumP = gradP.primitiveFieldRef();

    for (const label celli : some.cells)
    {
        sumP[celli] = gradQ[celli] = Zero;
    }

    const pairSums sums(p, q);

    for (const label facei : some.between)
    {
        sums.add(facei, sumP, gradQ);
    }

    for (const auto& edge : some.edges)
    {
        const label o = edge.cell;
        const label n = edge.beyond.cell();
        const label facei = edge.beyond.face();
        const bool owner = edge.beyond.owner();
        const scalar w = owner ? weights[facei] : 1 - weights[facei];
        const vector S(owner ? Sf[facei] : -Sf[facei]);

        sumP[o] += (w*(p[o] - p[n]) + p[n])*S;
        gradQ[o] += (w*(q[o] - q[n]) + q[n])*S;
    }

    List<scalarField> pOnPatches(mesh.boundary().size());
    List<scalarField> qOnPatches(mesh.boundary().size());

    forAll(pOnPatches, patchi)
    {
        const scalarField& w = weights.boundaryField()[patchi];

        pOnPatches[patchi] = pairSums::onPatch(p.boundaryField()[patchi], w);
        qOnPatches[patchi] = pairSums::onPatch(q.boundaryField()[patchi], w);
    }

    for (const auto& patchFace : some.patchFaces)
    {
        const label patchi = patchFace.face.patch;
        const label i = patchFace.face.face;
        const vector& S = Sf.boundaryField()[patchi][i];

        sumP[patchFace.cell] += pOnPatches[patchi][i]*S;
        gradQ[patchFace.cell] += qOnPatches[patchi][i]*S;
    }

    for (const label celli : some.cells)
    {
        sumP[celli] /= V[celli];
        gradQ[celli] *= factor/V[celli];
    }

    gradP.correctBoundaryConditions();
}
