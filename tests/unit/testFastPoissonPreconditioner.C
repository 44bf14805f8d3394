// SPDX-License-Identifier: GPL-3.0-or-later

#include "poissonProblem.H"

using namespace Foam;
using testTools::boxMesh;
using testTools::makeBox;
using testTools::processors;
using problem = testTools::poissonProblem;


TEST_CASE("Preconditioner where the coefficient varies", "[fastPoisson]")
{
    // Iterations depend on the range of the coefficient, here 10, and not on
    // the number of cells
    const label n = GENERATE(8, 32);
    boxMesh box(makeBox({n, n, 1}, {"zf", "cc", "zz"}, 1));
    box.processor = processors(0, box);
    problem made(box);
    const std::string controls =
        "solver PCG; tolerance 1e-12; preconditioner"
        "{ preconditioner fastPoisson; field p; }";
    scalarField tau(made.mesh().nInternalFaces() + 1, 1);
    testTools::RandomNumbers random(3);

    for (scalar& t : tau)
    {
        t = 0.1 + 0.9*(0.5 + 0.5*random.number());
    }

    // On patches, the same seen from both processors
    tau[tau.size() - 1] = 0.5;

    CHECK(testTools::messageOf([&]()
    {
        made.solve(made.equation(tau).ref(), false, controls);
    }).find("has not been solved for") != std::string::npos);

    // Once with a uniform one
    made.solve(made.equation(1).ref(), false);
    CHECK(made.solve(made.equation(tau).ref(), false, controls) < 1e-10);
    CHECK(made.performance.solverName() == "fastPoissonPCG");
    CHECK(made.performance.nIterations() < 40);
}


TEST_CASE("Preconditioner where the level is open", "[fastPoisson]")
{
    boxMesh box(makeBox({16, 12, 1}, {"zz", "cc", "zz"}, 0));
    box.processor = processors(0, box);
    problem made(box);
    const std::string controls =
        "solver PCG; tolerance 1e-12; preconditioner"
        "{ preconditioner fastPoisson; field p; }";

    // The direct solution with a reference and without; the other has none
    tmp<fvScalarMatrix> direct(made.equation(1));

    if (GENERATE(true, false))
    {
        direct.ref().setReference(Pstream::master() ? 0 : -1, 0);
    }
    made.solve(direct.ref(), true);

    CHECK(made.solve(made.equation(1).ref(), true, controls) < 1e-10);
    CHECK(made.performance.nIterations() <= 2);

    scalarField tau(made.mesh().nInternalFaces() + 1, 1);
    tau[0] = 0.5;
    CHECK(made.solve(made.equation(tau).ref(), true, controls) < 1e-10);
    CHECK(made.performance.nIterations() < 10);
}


TEST_CASE("Preconditioner after a solution from rest", "[fastPoisson]")
{
    // As in a first step, where nothing drives the pressure yet
    boxMesh box(makeBox({16, 12, 1}, {"zf", "cc", "zz"}, 0));
    box.processor = processors(0, box);
    problem made(box);
    made.setBoundary(0);
    made.exact = 0;
    CHECK(made.solve(made.equation(1).ref(), false) == 0);
    CHECK(made.performance.nIterations() == 0);
    CHECK(made.description() != "");
}
