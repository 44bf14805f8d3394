// SPDX-License-Identifier: GPL-3.0-or-later

#include "randomFlow.H"
#include "vectorSmoothSolver.H"
#include "fvmDiv.H"
#include "fvmLaplacian.H"

using namespace Foam;
using testTools::dict;
using testTools::randomFlow;


namespace
{

//- Solve for U from its present values; the number of sweeps
label sweeps
(
    const fvVectorMatrix& eqn,
    volVectorField& U,
    const std::string& entries
)
{
    const dictionary controls
    (
        dict
        (
            "solver smoothSolver; smoother symGaussSeidel; maxIter 5000;"
          + entries
        )
    );

    return cmptMax
    (
        vectorSmoothSolver::New(eqn, U, controls)->solve(controls)
       .nIterations()
    );
}

} // End anonymous namespace


TEST_CASE("Over-relaxation leads to the same solution", "[fusedKernels]")
{
    // Of a viscous flow, of one in which convection dominates, and of one
    // without a time derivative
    const scalar nu = GENERATE(2., 0.003, 20.);
    const scalar rDeltaT = nu > 10 ? 0 : nu < 1 ? 30 : 3;
    randomFlow flow("orthogonal");
    fvVectorMatrix eqn
    (
        fvm::div(flow.phi, flow.U)
      - fvm::laplacian(dimensionedScalar("nu", dimViscosity, nu), flow.U)
    );

    // Each row has a dominant diagonal, as with small time steps
    scalarField least(eqn.diag().size(), Zero);
    eqn.sumMagOffDiag(least);
    eqn.diag() = max(eqn.diag(), least) + rDeltaT*flow.mesh->V().field();
    eqn.source() = flow.gradP.primitiveField();

    // A stiff body fills a few cells
    for (label celli = 30; celli < 40; ++celli)
    {
        eqn.diag()[celli] *= 1e4;
        eqn.source()[celli] *= 1e4;
    }

    const volVectorField start("start", flow.U);
    const label symmetric = sweeps(eqn, flow.U, "tolerance 1e-13; relTol 0;");
    const vectorField exact(flow.U.primitiveField());

    flow.U = start;
    const label over = sweeps
    (
        eqn, flow.U, "tolerance 1e-13; relTol 0; overRelaxation yes;"
    );

    CHECK(gMax(mag(exact - start.primitiveField())()) > 0.1);
    CHECK
    (
        gMax(mag(flow.U.primitiveField() - exact)())
      < 1e-7*gMax(mag(exact)())
    );

    // A sweep is half of a symmetric one
    CHECK(over < (nu > 1 ? 1.4 : 3)*symmetric);
}
