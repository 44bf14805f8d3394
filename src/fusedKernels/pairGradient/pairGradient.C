// SPDX-License-Identifier: GPL-3.0-or-later

#include "pairGradient.H"
#include "faceSums.H"
#include "fusedKernels.H"
#include "gaussGrad.H"
#include "gaussSums.H"

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

    sumP = Zero;
    gradQ.resize(V.size());
    gradQ = Zero;

    const bitSet beside(besidePatches(mesh));
    gaussSums ofP(p, sumP);
    gaussSums ofQ(q, gradQ);

    // Faces are in the order of their owners: those of a cell's lower
    // neighbours are done before its own
    forAll(V, celli)
    {
        ofP.add(celli, start[celli], start[celli + 1]);
        ofQ.add(celli, start[celli], start[celli + 1]);

        if (!beside.test(celli))
        {
            sumP[celli] /= V[celli];
            gradQ[celli] *= factor/V[celli];
        }
    }

    ofP.addPatches();
    ofQ.addPatches();

    for (const label celli : beside)
    {
        sumP[celli] /= V[celli];
        gradQ[celli] *= factor/V[celli];
    }

    gradP.correctBoundaryConditions();
    fv::gaussGrad<scalar>::correctBoundaryConditions(p, gradP);
}


Foam::tmp<Foam::volVectorField> Foam::pairGradient::ofOne
(
    const volScalarField& p
)
{
    const fvMesh& mesh = p.mesh();
    const scalarField& V = mesh.V();
    const labelUList& start = mesh.lduAddr().ownerStartAddr();
    tmp<volVectorField> tgradP
    (
        new volVectorField
        (
            IOobject("grad(" + p.name() + ')', mesh.time().timeName(), mesh),
            mesh,
            dimensionedVector(p.dimensions()/dimLength, Zero),
            "calculated"
        )
    );
    vectorField& sums = tgradP.ref().primitiveFieldRef();
    gaussSums ofP(p, sums);

    forAll(V, celli)
    {
        ofP.add(celli, start[celli], start[celli + 1]);
    }
    ofP.addPatches();
    sums /= V;

    tgradP.ref().correctBoundaryConditions();
    fv::gaussGrad<scalar>::correctBoundaryConditions(p, tgradP.ref());

    return tgradP;
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
    const surfaceVectorField& Sf = p.mesh().Sf();
    const scalarField& V = p.mesh().V();
    vectorField& sumP = gradP.primitiveFieldRef();
    gaussSums ofP(p, sumP);
    gaussSums ofQ(q, gradQ);

    for (const label celli : some.cells)
    {
        sumP[celli] = gradQ[celli] = Zero;
    }

    for (const label facei : some.between)
    {
        ofP.add(facei);
        ofQ.add(facei);
    }

    for (const auto& edge : some.edges)
    {
        ofP.addTo(edge.cell, edge.beyond);
        ofQ.addTo(edge.cell, edge.beyond);
    }

    const List<scalarField> pOnPatches(ofP.onPatches());
    const List<scalarField> qOnPatches(ofQ.onPatches());

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
