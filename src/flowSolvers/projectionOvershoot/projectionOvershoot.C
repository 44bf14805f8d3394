// SPDX-License-Identifier: GPL-3.0-or-later

#include "projectionOvershoot.H"
#include "fvcAverage.H"
#include "mathematicalConstants.H"
#include "surfaceFields.H"
#include "volFields.H"

namespace
{

using namespace Foam;

//- Below the limit of backward, 0.23
const scalar largestStable = 0.2;

//- Overshoot below which a mesh is orthogonal
const scalar none = 1e-6;


//- Smallest eigenvalue of a tensor, which may have equal ones (Smith 1961)
scalar smallestEigenvalue(const symmTensor& t)
{
    const scalar mean = tr(t)/3;
    const symmTensor rest(dev(t));
    const scalar spread = Foam::sqrt(magSqr(rest)/6);

    if (spread < SMALL*mean)
    {
        return mean;
    }

    const scalar r = 0.5*det(rest/spread);
    const scalar angle = Foam::acos(max(min(r, 1), -1))/3;

    return mean
      + 2*spread*Foam::cos(angle + 2*constant::mathematical::pi/3);
}


//- Energy in L of a gradient g, in a cell and per volume: g.T.g
tmp<volSymmTensorField> energy(const fvScalarMatrix& equation)
{
    const fvMesh& mesh = equation.psi().mesh();
    const surfaceVectorField delta(mesh.delta());
    const labelUList& owner = mesh.owner();
    const labelUList& neighbour = mesh.neighbour();
    const scalarField& c = equation.upper();

    tmp<volSymmTensorField> tT
    (
        new volSymmTensorField
        (
            IOobject("energy", mesh.time().timeName(), mesh),
            mesh,
            dimensionedSymmTensor(dimless, Zero),
            "zeroGradient"
        )
    );
    volSymmTensorField& T = tT.ref();

    forAll(c, facei)
    {
        const symmTensor half(0.5*mag(c[facei])*sqr(delta[facei]));

        T[owner[facei]] += half;
        T[neighbour[facei]] += half;
    }

    // Beyond a patch the mesh goes on as before it
    forAll(mesh.boundary(), patchi)
    {
        const fvPatch& patch = mesh.boundary()[patchi];
        const scalarField& onPatch = equation.internalCoeffs()[patchi];

        forAll(patch, i)
        {
            const vector& Sf = mesh.Sf().boundaryField()[patchi][i];
            const vector& d = delta.boundaryField()[patchi][i];

            T[patch.faceCells()[i]] += patch.coupled()
              ? 0.5*mag(onPatch[i])*sqr(d)
              : (d & Sf)*sqr(Sf/mag(Sf));
        }
    }

    T.primitiveFieldRef() /= mesh.V();

    // Nothing changes across the plane of a mesh in 2D
    const Vector<label> solved(mesh.geometricD());
    const symmTensor across
    (
        solved.x() < 0, 0, 0, solved.y() < 0, 0, solved.z() < 0
    );

    for (symmTensor& t : T.primitiveFieldRef())
    {
        t += across;
    }
    T.correctBoundaryConditions();

    return tT;
}

//- Largest overshoot in any cell, none if it is small
scalar overshootOf(const volSymmTensorField& T)
{
    scalar least = 1;

    for (const symmTensor& t : T.primitiveField())
    {
        least = min(least, smallestEigenvalue(t));
    }
    reduce(least, minOp<scalar>());

    const scalar overshoot = 1/max(least, SMALL) - 1;

    return overshoot > none ? overshoot : 0;
}

} // End anonymous namespace


Foam::scalar Foam::projectionOvershoot::largest(const fvScalarMatrix& equation)
{
    volSymmTensorField T(energy(equation));

    if (!overshootOf(T))
    {
        return 0;
    }

    // What grows is some cells long: G does not see shorter waves
    T = fvc::average(T);
    T = fvc::average(T);

    return overshootOf(T);
}


Foam::label Foam::projectionOvershoot::nCorrections
(
    const scalar overshoot,
    const label n
)
{
    return n % 2 || stable(pow(overshoot, n + 1)) ? n : n + 1;
}


bool Foam::projectionOvershoot::stable(const scalar overshoot)
{
    return overshoot < largestStable;
}
