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
    const std::string& entries,
    const vectorField& trend = vectorField()
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

    autoPtr<vectorSmoothSolver> solver
    (
        vectorSmoothSolver::New(eqn, U, controls)
    );
    const vectorField none(trend.size(), Zero);

    if (trend.size())
    {
        solver->follow(none, trend, 1);
    }

    return cmptMax(solver->solve(controls).nIterations());
}

//- Equation of a viscous flow (nu 2), of one in which convection dominates
//  (0.003), and of one without a time derivative (20); a stiff body fills a few
//  cells
tmp<fvVectorMatrix> equation(randomFlow& flow, const scalar nu)
{
    const scalar rDeltaT = nu > 10 ? 0 : nu < 1 ? 30 : 3;
    tmp<fvVectorMatrix> teqn
    (
        fvm::div(flow.phi, flow.U)
      - fvm::laplacian(dimensionedScalar("nu", dimViscosity, nu), flow.U)
    );
    fvVectorMatrix& eqn = teqn.ref();

    // Each row has a dominant diagonal, as with small time steps
    scalarField least(eqn.diag().size(), Zero);
    eqn.sumMagOffDiag(least);
    eqn.diag() = max(eqn.diag(), least) + rDeltaT*flow.mesh->V().field();
    eqn.source() = flow.gradP.primitiveField();

    const label last = min(40, eqn.diag().size());

    for (label celli = min(30, last); celli < last; ++celli)
    {
        eqn.diag()[celli] *= 1e4;
        eqn.source()[celli] *= 1e4;
    }

    return teqn;
}

} // End anonymous namespace


TEST_CASE("Over-relaxation leads to the same solution", "[fusedKernels]")
{
    const scalar nu = GENERATE(2., 0.003, 20.);
    randomFlow flow("orthogonal");
    const tmp<fvVectorMatrix> teqn(equation(flow, nu));
    const fvVectorMatrix& eqn = teqn();

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


TEST_CASE("Over-relaxation of many rows converges as well", "[fusedKernels]")
{
    randomFlow flow("orthogonal", 0.4, {50, 40, 20*Pstream::nProcs()});
    tmp<fvVectorMatrix> teqn(equation(flow, 2));
    const volVectorField start("start", flow.U);

    // Without, symmetric sweeps would take thousands
    teqn.ref().diag() *= 1.3;

    const std::string close("tolerance 1e-13; relTol 0;");

    sweeps(teqn(), flow.U, close);

    const vectorField exact(flow.U.primitiveField());

    flow.U = start;
    sweeps(teqn(), flow.U, close + "overRelaxation yes;");

    CHECK(gMax(mag(exact - start.primitiveField())()) > 0.1);
    CHECK
    (
        gMax(mag(flow.U.primitiveField() - exact)())
      < 1e-6*gMax(mag(exact)())
    );
}


TEST_CASE("A trend is followed if it leads to the solution", "[fusedKernels]")
{
    const std::string entries
    (
        std::string("tolerance 1e-12; relTol 1e-6; overRelaxation ")
      + GENERATE("yes", "no") + ';'
    );
    randomFlow flow("orthogonal");
    const tmp<fvVectorMatrix> teqn(equation(flow, 20));
    const volVectorField start("start", flow.U);

    const label nPlain = sweeps(teqn(), flow.U, entries);
    const vectorField plain(flow.U.primitiveField());

    sweeps(teqn(), flow.U, "tolerance 1e-13; relTol 0;");
    const vectorField way(flow.U.primitiveField() - start.primitiveField());

    flow.U = start;
    CHECK(sweeps(teqn(), flow.U, entries, way) == 0);
    CHECK
    (
        gMax(mag(flow.U.primitiveField() - start.primitiveField() - way)())
      < 1e-12*gMax(mag(way)())
    );

    // The error that is left is the same, not the part of that at the start
    flow.U = start;
    const label nMost = sweeps(teqn(), flow.U, entries, 0.999*way);
    CHECK(nMost > 0);
    CHECK(nMost < nPlain);

    flow.U = start;
    CHECK(sweeps(teqn(), flow.U, entries, -0.5*way) == nPlain);
    CHECK
    (
        gMax(mag(flow.U.primitiveField() - plain)()) < 1e-12*gMax(mag(way)())
    );
}
