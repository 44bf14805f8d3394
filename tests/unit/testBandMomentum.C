// SPDX-License-Identifier: GPL-3.0-or-later

#include "testTools.H"
#include "bandMomentum.H"
#include "boxMesh.H"
#include "ddtCoefficients.H"
#include "fixedValueFvPatchFields.H"
#include "fvmLaplacian.H"
#include "immersedBodies.H"
#include "randomFlow.H"
#include "vectorSmoothSolver.H"

using namespace Foam;
using testTools::dict;

namespace
{

//- A box of 24 x 16 x 16 cells, on one or two processors
std::unique_ptr<fvMesh> makeMesh(const Time& time)
{
    testTools::boxMesh box;

    box.x = {{
        testTools::graded(24, 3, 1),
        testTools::graded(16, 2, 1),
        testTools::graded(16, 2, 1)
    }};
    box.sides = {{"zz", "zz", "zz"}};
    box.processor = [](const labelVector& cell)
    {
        return Pstream::parRun() && cell.x() > 11 ? 1 : 0;
    };

    return box.make(time);
}


//- A field that varies from cell to cell
vectorField varying(const fvMesh& mesh)
{
    const vectorField& x = mesh.cellCentres();
    vectorField values(x.size());

    forAll(values, i)
    {
        values[i] = vector
        (
            Foam::sin(7*x[i].y()),
            Foam::cos(5*x[i].z()),
            Foam::sin(3*x[i].x())
        );
    }

    return values;
}


void set(volVectorField& U, const vectorField& values)
{
    U.primitiveFieldRef() = values;
    U.correctBoundaryConditions();
}


//- Coefficients of an equation in one list
scalarField coefficients(const fvVectorMatrix& eqn)
{
    scalarField all(eqn.diag());

    all.append(eqn.upper());
    all.append(eqn.lower());
    forAll(eqn.internalCoeffs(), patchi)
    {
        all.append(mag(eqn.internalCoeffs()[patchi]));
        all.append(mag(eqn.boundaryCoeffs()[patchi]));
    }

    return all;
}

} // End anonymous namespace


TEST_CASE("Weighted residuals are those of scaled rows", "[bandMomentum]")
{
    const testTools::schemesCase files("orthogonal");
    const Time time
    (
        dict("deltaT 0.1; writeFrequency 1;"),
        files.folder.path(),
        files.folder.name()
    );
    const std::unique_ptr<fvMesh> mesh(makeMesh(time));
    testTools::readSchemes(*mesh);
    immersedBodies bodies
    (
        *mesh,
        dict
        (
            "bodies { grain { shape { type sphere; radius 0.5; }"
            " densityRatio 2; position (1.4 1 1); } }"
        )
    );
    volVectorField U
    (
        IOobject("U", "0", *mesh),
        *mesh,
        dimensionedVector(dimVelocity, Zero),
        fixedValueFvPatchVectorField::typeName
    );
    const dimensionedScalar nu("nu", dimViscosity, 0.05);
    fvVectorMatrix eqn(-fvm::laplacian(nu, U));

    eqn.diag() += 10*mesh->V();

    const volScalarField A0(eqn.A());
    const vectorField gradP(varying(*mesh));
    const vectorField start(0.01*gradP);

    bodies.beginStep();
    bodies.predict(false);
    bodies.resolved().updateResistance
    (
        ddtCoefficients("Euler", 0.1, 0.1),
        A0,
        scalarField(mesh->nCells(), nu.value())
    );

    const dictionary controls
    (
        dict
        (
            "solver smoothSolver; smoother symGaussSeidel; tolerance 0;"
            " relTol 0; maxIter 2; minIter 2;"
        )
    );
    const labelUList& cells = bodies.region().cells();
    const scalarField plain(coefficients(eqn));
    bandMomentum bands(bodies.region());

    eqn.source() = 10*mesh->V()*(start + 0.01*gradP.component(0)*gradP);
    bands.penalise(gradP, eqn);

    const scalarField weights(bands.weights(A0));
    CHECK(gMin(weights) < 0.5);
    CHECK(gMax(weights) < 1);

    set(U, start);
    vectorSmoothSolver solver(eqn, U);
    solver.weigh(cells, weights);
    const SolverPerformance<vector> weighted(solver.solve(controls));
    const vectorField found(U.primitiveField());

    set(U, start);
    const vector unweighted
    (
        vectorSmoothSolver(eqn, U).solve(controls).initialResidual()
    );

    set(U, start);
    bands.scaleRows(A0, eqn);
    const SolverPerformance<vector> scaled(eqn.solve(controls));

    CHECK(gMax(mag(found - start)()) > 1e-4);
    CHECK(gMax(mag(found - U.primitiveField())()) < 1e-15);
    for (direction k = 0; k < 3; ++k)
    {
        const scalar first = scaled.initialResidual()[k];
        const scalar last = scaled.finalResidual()[k];

        CHECK(weighted.initialResidual()[k] == Approx(first).epsilon(1e-10));
        CHECK(weighted.finalResidual()[k] == Approx(last).epsilon(1e-6));
    }
    CHECK(mag(unweighted - scaled.initialResidual()) > 0.01);

    // The matrix is as it was, with and without scaled rows
    bands.restore(eqn);
    CHECK(coefficients(eqn) == plain);
    bands.penalise(gradP, eqn);
    bands.restore(eqn);
    CHECK(coefficients(eqn) == plain);
}
