// SPDX-License-Identifier: GPL-3.0-or-later

#include "pairGradient.H"
#include "faceSums.H"
#include "fusedKernels.H"
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


//- What the internal faces add to the sums of value times area of their cells
class faceLoop
{
    const labelUList& owner_;
    const labelUList& neighbour_;
    const scalarField& weights_;
    const vectorField& Sf_;
    const scalarField& p_;
    const scalarField& q_;

public:

    faceLoop(const volScalarField& p, const volScalarField& q)
    :
        owner_(p.mesh().owner()),
        neighbour_(p.mesh().neighbour()),
        weights_(p.mesh().weights()),
        Sf_(p.mesh().Sf()),
        p_(p),
        q_(q)
    {}

    //- One face
    void add
    (
        const label facei,
        vectorField& sumP,
        vectorField& sumQ
    ) const
    {
        add(owner_[facei], facei, facei + 1, sumP, sumQ);
    }

    //- The faces from begin to end, all of the same owner
    void add
    (
        const label owner,
        const label begin,
        const label end,
        vectorField& sumP,
        vectorField& sumQ
    ) const
    {
        const scalar p = p_[owner];
        const scalar q = q_[owner];
        vector ownP(sumP[owner]);
        vector ownQ(sumQ[owner]);

        for (label facei = begin; facei < end; ++facei)
        {
            const label n = neighbour_[facei];
            const scalar w = weights_[facei];
            const vector fluxP(Sf_[facei]*(w*(p - p_[n]) + p_[n]));
            const vector fluxQ(Sf_[facei]*(w*(q - q_[n]) + q_[n]));

            ownP += fluxP;
            sumP[n] -= fluxP;
            ownQ += fluxQ;
            sumQ[n] -= fluxQ;
        }

        sumP[owner] = ownP;
        sumQ[owner] = ownQ;
    }
};


//- Add the faces of a patch to the sums of value times area of its cells
void addPatch(const fvPatchScalarField& p, vectorField& sums)
{
    const label patchi = p.patch().index();
    const fvMesh& mesh = p.patch().boundaryMesh().mesh();
    const vectorField& Sf = mesh.Sf().boundaryField()[patchi];
    const labelUList& faceCells = p.patch().faceCells();
    const tmp<scalarField> tp
    (
        faceValues(p, mesh.weights().boundaryField()[patchi])
    );

    forAll(Sf, i)
    {
        sums[faceCells[i]] += Sf[i]*tp()[i];
    }
}


//- Bring the values of a gradient on patches up to date
void correctPatches(const volScalarField& p, volVectorField& gradP)
{
    gradP.correctBoundaryConditions();
    fv::gaussGrad<scalar>::correctBoundaryConditions(p, gradP);
}

} // End anonymous namespace


bool Foam::pairGradient::serves(const fvMesh& mesh, const word& name)
{
    ITstream& scheme = mesh.gradScheme(name);

    return fusedKernels::active
     && scheme.size() == 2
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
    const scalarField& V = mesh.V();
    const labelUList& start = mesh.lduAddr().ownerStartAddr();
    vectorField& sumP = gradP.primitiveFieldRef();

    gradQ.resize(V.size());

    const bitSet beside(besidePatches(mesh));
    const faceLoop loop(p, q);
    zeroedAhead<vector> zeroedP(mesh, sumP);
    zeroedAhead<vector> zeroedQ(mesh, gradQ);

    // Faces are in the order of their owners: those of a cell's lower
    // neighbours are done before its own
    forAll(V, celli)
    {
        zeroedP.reach(celli);
        zeroedQ.reach(celli);
        loop.add(celli, start[celli], start[celli + 1], sumP, gradQ);

        if (!beside.test(celli))
        {
            sumP[celli] /= V[celli];
            gradQ[celli] *= factor/V[celli];
        }
    }

    // Last, for the very sums of gaussGrad, which a restart has
    forAll(p.boundaryField(), patchi)
    {
        addPatch(p.boundaryField()[patchi], sumP);
        addPatch(q.boundaryField()[patchi], gradQ);
    }

    for (const label celli : beside)
    {
        sumP[celli] /= V[celli];
        gradQ[celli] *= factor/V[celli];
    }

    correctPatches(p, gradP);
}


void Foam::pairGradient::set(const volScalarField& p, volVectorField& gradP)
{
    const fvMesh& mesh = p.mesh();
    const scalarField& V = mesh.V();
    const scalarField& weights = mesh.weights();
    const vectorField& Sf = mesh.Sf();
    const labelUList& neighbour = mesh.neighbour();
    const labelUList& start = mesh.lduAddr().ownerStartAddr();
    const bitSet beside(besidePatches(mesh));
    vectorField& sums = gradP.primitiveFieldRef();
    zeroedAhead<vector> zeroed(mesh, sums);

    forAll(V, celli)
    {
        zeroed.reach(celli);

        const scalar own = p[celli];
        vector sum(sums[celli]);

        for (label facei = start[celli]; facei < start[celli + 1]; ++facei)
        {
            const scalar other = p[neighbour[facei]];
            const vector flux(Sf[facei]*(weights[facei]*(own - other) + other));

            sum += flux;
            sums[neighbour[facei]] -= flux;
        }

        sums[celli] = beside.test(celli) ? sum : sum/V[celli];
    }

    for (const fvPatchScalarField& patch : p.boundaryField())
    {
        addPatch(patch, sums);
    }

    for (const label celli : beside)
    {
        sums[celli] /= V[celli];
    }

    correctPatches(p, gradP);
}


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

    const faceLoop loop(p, q);

    for (const label facei : some.between)
    {
        loop.add(facei, sumP, gradQ);
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

        pOnPatches[patchi] = faceValues(p.boundaryField()[patchi], w);
        qOnPatches[patchi] = faceValues(q.boundaryField()[patchi], w);
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
