// SPDX-License-Identifier: GPL-3.0-or-later

#include "poissonProblem.H"

using namespace Foam;
using testTools::boxMesh;
using testTools::makeBox;
using testTools::processors;
using problem = testTools::poissonProblem;

namespace
{

const std::vector<std::string> allSides = {"zz", "ff", "zf", "fz", "cc"};


//- Solve on the box; with and without the reference if singular
void checkBox(const boxMesh& box)
{
    // Too few cells for all processors
    if (max(box.n(0), max(box.n(1), box.n(2))) < 2*Pstream::nProcs())
    {
        return;
    }

    CAPTURE(box.sides, box.seed, box.n(0), box.n(1), box.n(2));
    problem made(box);
    tmp<fvScalarMatrix> eqn(made.equation(2.5));

    CHECK(made.solve(eqn.ref(), made.singular) < 1e-10);
    CHECK(made.performance.nIterations() == 1);
    CHECK(made.performance.finalResidual() < 1e-11);
    CHECK(made.description() != "");

    if (made.singular)
    {
        // Not one with neighbours on other processors only
        const label celli = findMax(mag(eqn().diag())());
        eqn.ref().setReference
        (
            Pstream::master() ? celli : -1,
            Pstream::master() ? made.exact[celli] : 0
        );
        // Once to find it
        made.solve(eqn.ref(), false);
        CHECK(made.solve(eqn.ref(), false) < 1e-9);
        CHECK(made.performance.nIterations() == 1);
        CHECK(made.performance.finalResidual() < 1e-11);
    }
}

} // End anonymous namespace


TEST_CASE("All sides and spacings in 2D are solved directly", "[fastPoisson]")
{
    const std::string x = GENERATE(from_range(allSides));
    const std::string y = GENERATE(from_range(allSides));
    const label way = GENERATE(0, 1, 3);

    for (label stretch = 0; stretch < 4; ++stretch)
    {
        boxMesh box(makeBox({9, 7, 1}, {x, y, "zz"}, stretch));
        box.seed = stretch;
        box.processor = processors(way, box);
        checkBox(box);
    }
}


TEST_CASE("All sides in 3D are solved directly", "[fastPoisson]")
{
    const std::string x = GENERATE(from_range(allSides));
    const std::string y = GENERATE(from_range(allSides));
    const std::string z = GENERATE(from_range(allSides));

    static label n = 0;
    ++n;
    boxMesh box(makeBox({4, 5, 6}, {x, y, z}, n % 8));
    box.seed = n;
    box.processor = processors(n % 4, box);
    checkBox(box);
}


TEST_CASE("A coefficient that scales needs nothing new", "[fastPoisson]")
{
    boxMesh box(makeBox({9, 7, 1}, {"zf", "cc", "zz"}, 2));
    box.processor = processors(0, box);
    problem made(box);
    made.solve(made.equation(1).ref(), false);
    const boxSolver* solver = boxSolverCache::New(made.mesh()).find("p");

    for (const scalar tau : {1e-6, 0.3, -2.0, 1e6})
    {
        CHECK(made.solve(made.equation(tau).ref(), false) < 1e-10);
        CHECK(made.performance.nIterations() == 1);
    }

    CHECK(boxSolverCache::New(made.mesh()).find("p") == solver);
}


TEST_CASE("Rounded points need a second solution at most", "[fastPoisson]")
{
    boxMesh box(makeBox({70, 66, 1}, {"zz", "zf", "zz"}, 0));
    box.processor = processors(1, box);

    for (scalar& x : box.x[0])
    {
        x = std::round(1e10*x)/1e10;
    }

    problem made(box);
    CHECK(made.solve(made.equation(1).ref(), false) < 1e-8);
    CHECK(made.performance.finalResidual() < 1e-10);
    CHECK(made.performance.nIterations() <= 2);
}


TEST_CASE("No more than rounding allows is asked for", "[fastPoisson]")
{
    boxMesh box(makeBox({9, 7, 1}, {"zf", "zz", "zz"}, 3));
    box.processor = processors(0, box);
    problem made(box);
    const std::string controls = "solver fastPoisson; tolerance 0; relTol 0;";

    CHECK(made.solve(made.equation(1).ref(), false, controls) < 1e-12);
    CHECK(made.performance.solverName() == "fastPoisson");
}


TEST_CASE("What is no Laplacian on a box is solved otherwise", "[fastPoisson]")
{
    boxMesh box(makeBox({9, 7, 1}, {"zf", "zz", "zz"}, 0));
    box.processor = processors(0, box);
    const std::string controls =
        "solver fastPoisson; tolerance 1e-12;"
        "fallback { solver PCG; preconditioner DIC; }";

    SECTION("coefficient that varies")
    {
        problem made(box);
        scalarField tau(made.mesh().nInternalFaces() + 1, 1);
        tau[0] = 1.01;
        tmp<fvScalarMatrix> eqn(made.equation(tau));

        CHECK(made.solve(eqn.ref(), false, controls) < 1e-10);
        CHECK(made.performance.solverName() == "DICPCG");
    }

    SECTION("time derivative")
    {
        problem made(box);
        tmp<fvScalarMatrix> eqn(made.equation(1));
        const scalarField add(-made.mesh().V()*3);
        eqn.ref().diag() += add;
        eqn.ref().source() += add*made.exact;

        CHECK(made.solve(eqn.ref(), false, controls) < 1e-10);
        CHECK(made.performance.solverName() == "DICPCG");
    }

    SECTION("cells that are no boxes")
    {
        box.shear = 0.3;
        problem made(box);
        tmp<fvScalarMatrix> eqn(made.equation(1));

        CHECK(made.solve(eqn.ref(), false, controls) < 1e-10);
        CHECK(made.performance.solverName() == "DICPCG");
    }

    SECTION("by multigrid unless another solver is given")
    {
        problem made(box);
        tmp<fvScalarMatrix> eqn(made.equation(1));
        eqn.ref().diag()[0] *= 1.5;
        made.solve(eqn.ref(), false);

        CHECK(made.performance.solverName() == "GAMG");
    }
}


TEST_CASE("New conditions are noticed", "[fastPoisson]")
{
    // Few rows, all of which are looked at, and many
    const label n = GENERATE(9, 220);
    boxMesh box(makeBox({n, n - 2, 1}, {"zf", "zz", "zz"}, 0));
    box.processor = processors(0, box);
    problem made(box);
    made.solve(made.equation(1).ref(), false);

    // Half a cell more to the fixed value, on all of the side
    tmp<fvScalarMatrix> eqn(made.equation(1));
    forAll(made.p.boundaryField(), patchi)
    {
        if (made.p.boundaryField()[patchi].fixesValue())
        {
            eqn.ref().internalCoeffs()[patchi] *= 0.5;
            eqn.ref().boundaryCoeffs()[patchi] *= 0.5;
        }
    }
    made.p.primitiveFieldRef() = made.exact;
    eqn.ref().source() -= made.residual(eqn());

    CHECK(made.solve(eqn.ref(), false) < 1e-8);
    CHECK(made.performance.solverName() == "fastPoisson");
}


TEST_CASE("The residual of many rows is estimated", "[fastPoisson]")
{
    const label n = 170*Pstream::nProcs();
    boxMesh box(makeBox({230, n, 1}, {"zf", "cc", "zz"}, 0));
    box.processor = processors(0, box);
    problem made(box);
    scalar residual[2];

    for (scalar& of : residual)
    {
        CHECK(made.solve(made.equation(1).ref(), false) < 1e-10);
        of = made.performance.finalResidual();
    }

    // The first one is of all rows
    CHECK(residual[1] != residual[0]);
    CHECK(residual[1] > 0.5*residual[0]);
    CHECK(residual[1] < 2*residual[0]);
}


TEST_CASE("The fallback is another solver", "[fastPoisson]")
{
    boxMesh box(makeBox({9, 7, 1}, {"zf", "zz", "zz"}, 0));
    box.processor = processors(0, box);
    problem made(box);
    tmp<fvScalarMatrix> eqn(made.equation(1));
    eqn.ref().diag()[0] *= 1.5;

    CHECK(testTools::messageOf([&]()
    {
        made.solve
        (
            eqn.ref(), false,
            "solver fastPoisson; fallback { solver fastPoisson; }"
        );
    }).find("must be another solver") != std::string::npos);
}


TEST_CASE("Long directions with equal cells are transformed", "[fastPoisson]")
{
    const std::string x = GENERATE(from_range(allSides));
    const std::string y = GENERATE(from_range(allSides));

    boxMesh box(makeBox({70, 66, 1}, {x, y, "zz"}, 1));
    box.processor = processors(0, box);
    checkBox(box);

    problem made(box);
    made.solve(made.equation(1).ref(), made.singular);
    CHECK(made.description().find("transform in y") != std::string::npos);
}
