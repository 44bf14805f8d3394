// SPDX-License-Identifier: GPL-3.0-or-later

#include "boxMesh.H"
#include "alignedFaces.H"
#include "fusedKernels.H"
#include "linearTransport.H"
#include "randomFlow.H"
#include "smoothedFlux.H"
#include "vectorSmoothSolver.H"
#include "fvmDiv.H"
#include "fvmLaplacian.H"

using namespace Foam;
using testTools::dict;
using testTools::plainForms;
using testTools::randomFlow;

namespace
{

//- Largest difference of two fields on the faces of a mesh, on this processor
scalar difference(const surfaceScalarField& a, const surfaceScalarField& b)
{
    scalar largest = max(mag(a.primitiveField() - b.primitiveField()));

    forAll(a.boundaryField(), patchi)
    {
        forAll(a.boundaryField()[patchi], i)
        {
            largest = max
            (
                largest,
                mag
                (
                    a.boundaryField()[patchi][i] - b.boundaryField()[patchi][i]
                )
            );
        }
    }

    return largest;
}


//- Largest difference of the coefficients of two matrices
scalar difference(const fvVectorMatrix& a, const fvVectorMatrix& b)
{
    scalar largest = max
    (
        max(mag(a.diag() - b.diag())),
        max(max(mag(a.upper() - b.upper())), max(mag(a.lower() - b.lower())))
    );

    forAll(a.internalCoeffs(), patchi)
    {
        forAll(a.internalCoeffs()[patchi], i)
        {
            largest = max
            (
                largest,
                mag
                (
                    a.internalCoeffs()[patchi][i]
                  - b.internalCoeffs()[patchi][i]
                )
              + mag
                (
                    a.boundaryCoeffs()[patchi][i]
                  - b.boundaryCoeffs()[patchi][i]
                )
            );
        }
    }

    return largest;
}

} // End anonymous namespace


TEST_CASE("Faces across axes have the shapes of the mesh", "[fusedKernels]")
{
    const scalar shear = GENERATE(0., 0.4);
    const randomFlow box("orthogonal", shear);
    const fvMesh& mesh = *box.mesh;
    const alignedFaces& aligned = alignedFaces::New(mesh);

    CHECK(aligned.valid() == (shear == 0));

    for
    (
        label facei = 0;
        aligned.valid() && facei < mesh.nInternalFaces();
        ++facei
    )
    {
        const auto& shape = aligned.of(facei);
        vector S(Zero);

        S[shape.axis] = aligned.area(facei, shape);
        CHECK(mag(S - mesh.Sf()[facei]) < 1e-13*mesh.magSf()[facei]);
        CHECK(mag(shape.weight - mesh.weights()[facei]) < 1e-13);
        CHECK
        (
            mag(shape.deltaCoeff/mesh.deltaCoeffs()[facei] - 1) < 1e-13
        );
    }
}


TEST_CASE("The smoothed flux is that of fields", "[fusedKernels]")
{
    const std::string snGrad(GENERATE("corrected", "uncorrected"));
    const scalar shear = GENERATE(0.4, 0.);
    randomFlow flow(snGrad, shear);
    const smoothedFlux flux(flow.U, flow.p, flow.gradP, flow.tau);
    surfaceScalarField fused(0*flow.phi), plain(0*flow.phi);

    flux.set(fused);
    {
        const plainForms off;
        flux.set(plain);
    }
    CHECK(gMax(mag(plain.primitiveField())()) > 0.1);
    CHECK(difference(fused, plain) < 1e-13);

    // Some of the faces, and the others stay
    const label n = flow.mesh->nFaces()/2;
    surfaceScalarField some(0*flow.phi), somePlain(0*flow.phi);
    labelList faces(n);

    forAll(faces, i)
    {
        faces[i] = 2*i;
    }
    flux.set(faces, some);
    {
        const plainForms off;
        flux.set(faces, somePlain);
    }
    CHECK(difference(some, somePlain) < 1e-13);
    CHECK(some[1] == 0);
    CHECK(some[2] == fused[2]);
}


TEST_CASE("Linear transport is that of OpenFOAM", "[fusedKernels]")
{
    randomFlow flow("orthogonal");
    const scalar nu = 0.3;
    const volScalarField nuField
    (
        IOobject("nu", "0", *flow.mesh),
        *flow.mesh,
        dimensionedScalar("nu", dimViscosity, nu)
    );
    const fvVectorMatrix plain
    (
        fvm::div(flow.phi, flow.U) - fvm::laplacian(nuField, flow.U)
    );
    const linearTransport kernel(flow.U, "div(phi,U)", "laplacian(nu,U)");
    fvVectorMatrix fused(flow.U, plain.dimensions());

    fused.diag() = 0;
    REQUIRE(kernel.serves());
    kernel.add(&flow.phi, nu, fused);
    CHECK(difference(fused, plain) < 1e-13);
    CHECK_THROWS(kernel.add(&flow.phi, nu, fused));

    const plainForms off;
    CHECK(!linearTransport(flow.U, "div(phi,U)", "laplacian(nu,U)").serves());
}


TEST_CASE("Sweeps over components at once are those of each", "[fusedKernels]")
{
    randomFlow flow("orthogonal");
    const dimensionedScalar nu("nu", dimViscosity, 0.3);
    fvVectorMatrix eqn
    (
        fvm::div(flow.phi, flow.U) - fvm::laplacian(nu, flow.U)
    );
    const dictionary controls
    (
        dict
        (
            "solver smoothSolver; smoother symGaussSeidel; tolerance 0;"
            " relTol 0; maxIter 3; minIter 3;"
        )
    );

    eqn.diag() += 3;
    eqn.source() = flow.gradP.primitiveField();

    volVectorField start("start", flow.U);
    REQUIRE(vectorSmoothSolver::serves(controls));
    vectorSmoothSolver(eqn, flow.U).solve(controls);

    const vectorField fused(flow.U.primitiveField());
    const plainForms off;
    REQUIRE(!vectorSmoothSolver::serves(controls));
    flow.U = start;
    eqn.solve(controls);

    const vectorField change(fused - start.primitiveField());
    CHECK(gMax(mag(change)()) > 0.1);
    CHECK(gMax(mag(fused - flow.U.primitiveField())()) < 1e-13);
}


TEST_CASE("Residuals of many rows are estimated", "[fusedKernels]")
{
    const Vector<label> n(50, 40, 20*Pstream::nProcs());
    randomFlow flow("orthogonal", 0.4, n);
    const dictionary controls
    (
        dict
        (
            "solver smoothSolver; smoother symGaussSeidel; tolerance 0;"
            "relTol 0; maxIter 2;"
        )
    );
    fvVectorMatrix eqn
    (
        fvm::div(flow.phi, flow.U)
      - fvm::laplacian(dimensionedScalar("nu", dimViscosity, 2), flow.U)
    );
    eqn.diag() += 30*flow.mesh->V().field();
    eqn.source() = flow.gradP.primitiveField();

    volVectorField start("start", flow.U);
    const SolverPerformance<vector> some
    (
        vectorSmoothSolver(eqn, flow.U).solve(controls)
    );
    const plainForms off;

    flow.U = start;
    const SolverPerformance<vector> all(eqn.solve(controls));

    for (direction cmpt = 0; cmpt < vector::nComponents; ++cmpt)
    {
        CHECK
        (
            some.initialResidual()[cmpt]
         == Approx(all.initialResidual()[cmpt]).epsilon(0.15)
        );
        CHECK
        (
            some.finalResidual()[cmpt]
         == Approx(all.finalResidual()[cmpt]).epsilon(0.15)
        );
    }
}


TEST_CASE("Hardly a sweep too many without a look", "[fusedKernels]")
{
    const scalar nu = GENERATE(0.3, 2., 10.);
    randomFlow flow("orthogonal");
    const dictionary controls
    (
        dict
        (
            "solver smoothSolver; smoother symGaussSeidel; tolerance 1e-11;"
            "relTol 0; maxIter 1000;"
        )
    );
    fvVectorMatrix eqn
    (
        fvm::div(flow.phi, flow.U)
      - fvm::laplacian(dimensionedScalar("nu", dimViscosity, nu), flow.U)
    );
    scalarField least(eqn.diag().size(), Zero);

    eqn.sumMagOffDiag(least);
    eqn.diag() = max(eqn.diag(), least) + flow.mesh->V().field();
    eqn.source() = flow.gradP.primitiveField();

    volVectorField start("start", flow.U);
    const label some = cmptMax
    (
        vectorSmoothSolver(eqn, flow.U).solve(controls).nIterations()
    );
    const plainForms off;

    flow.U = start;
    const label all = cmptMax(eqn.solve(controls).nIterations());

    CHECK(some >= all);
    CHECK(some <= 1.1*all + 1);
}
