// SPDX-License-Identifier: GPL-3.0-or-later

#include "pairGradient.H"
#include "boxGradient.H"
#include "faceSums.H"
#include "fusedKernels.H"
#include "gaussGrad.H"
#include "pairSums.H"
#include "surfaceFields.H"

namespace
{

using namespace Foam;

//- Add the faces of a patch to the sums of value times area of its cells
void addPatch(const fvPatchScalarField& p, vectorField& sums)
{
    const label patchi = p.patch().index();
    const fvMesh& mesh = p.patch().boundaryMesh().mesh();
    const vectorField& Sf = mesh.Sf().boundaryField()[patchi];
    const labelUList& faceCells = p.patch().faceCells();
    const tmp<scalarField> tp
    (
        pairSums::onPatch(p, mesh.weights().boundaryField()[patchi])
    );

    forAll(Sf, i)
    {
        sums[faceCells[i]] += Sf[i]*tp()[i];
    }
}


//- Set grad to factor times the gradient of p on a box
void setOnBox
(
    const boxCells& box,
    const volScalarField& p,
    const scalar factor,
    vectorField& grad
)
{
    const scalarField& V = p.mesh().V();

    boxGradient(box, p, factor, grad);

    for (const fvPatchScalarField& patch : p.boundaryField())
    {
        const labelUList& faceCells = patch.patch().faceCells();
        const vectorField& Sf = patch.patch().Sf();
        const tmp<scalarField> tp
        (
            pairSums::onPatch(patch, patch.patch().weights())
        );
        const scalarField& values = tp();

        forAll(values, i)
        {
            const label celli = faceCells[i];

            grad[celli] += factor/V[celli]*values[i]*Sf[i];
        }
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

    const boxCells& box = boxCells::New(mesh);

    if (box.valid())
    {
        setOnBox(box, p, 1, sumP);
        setOnBox(box, q, factor, gradQ);
        correctPatches(p, gradP);
        return;
    }

    const bitSet beside(besidePatches(mesh));
    const pairSums sums(p, q);
    zeroedAhead<vector> zeroedP(mesh, sumP);
    zeroedAhead<vector> zeroedQ(mesh, gradQ);

    // Faces are in the order of their owners: those of a cell's lower
    // neighbours are done before its own
    forAll(V, celli)
    {
        zeroedP.reach(celli);
        zeroedQ.reach(celli);
        sums.add(celli, start[celli], start[celli + 1], sumP, gradQ);

        if (!beside.test(celli))
        {
            sumP[celli] /= V[celli];
            gradQ[celli] *= factor/V[celli];
        }
    }

    // Last, for the very sums of gaussGrad
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
    const boxCells& box = boxCells::New(mesh);
    vectorField& sums = gradP.primitiveFieldRef();

    if (box.valid())
    {
        setOnBox(box, p, 1, sums);
        correctPatches(p, gradP);
        return;
    }

    const bitSet beside(besidePatches(mesh));
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
