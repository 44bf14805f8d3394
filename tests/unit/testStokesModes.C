// SPDX-License-Identifier: GPL-3.0-or-later

#include "denseMatrix.H"
#include "recycledKrylov.H"
#include "stokesDrive.H"
#include "testTools.H"

using namespace Foam;

namespace
{

//- Not symmetric, with eigenvalues from 1 to n
tmp<scalarField> product(const scalarField& x)
{
    tmp<scalarField> ty(new scalarField(x.size()));

    forAll(x, i)
    {
        ty.ref()[i] = (i + 1)*x[i] + (i > 0 ? 0.5*x[i - 1] : 0);
    }

    return ty;
}


tmp<scalarField> copy(const scalarField& x)
{
    return tmp<scalarField>(new scalarField(x));
}

} // End anonymous namespace


TEST_CASE("Conjugate residuals solve what they are given", "[stokesModes]")
{
    recycledKrylov krylov(product, copy);
    const scalarField solution({1, -2, 3, 0.5, 0.25, -1});
    const scalarField b(product(solution));
    scalarField x;

    CHECK(krylov.solve(b, 1e-10, 100, x) <= 1e-10);
    CHECK(max(mag(x - solution)) < 1e-8);

    // As many as there are unknowns, on each rank the same ones
    const label first = krylov.nIterations();
    CHECK(first <= 6);

    // All that there is to know is known
    scalarField y;
    CHECK(krylov.solve(2*b, 1e-10, 100, y) <= 1e-10);
    CHECK(krylov.nIterations() == first);
    CHECK(max(mag(y - 2*solution)) < 1e-8);
}


TEST_CASE("Conjugate residuals say how far they came", "[stokesModes]")
{
    recycledKrylov krylov(product, copy, 8);
    const scalarField b(20, 1);
    scalarField x;

    const scalar ratio = krylov.solve(b, 1e-12, 3, x);
    const scalarField r(b - product(x)());

    CHECK(krylov.nIterations() == 3);
    CHECK(ratio > 1e-12);
    CHECK(Foam::sqrt(gSumSqr(r)/gSumSqr(b)) == Approx(ratio));

    // With eight directions at a time
    CHECK(krylov.solve(b, 1e-8, 500, x) <= 1e-8);
    CHECK(krylov.solve(0*b, 1e-8, 500, x) == 0);
}


TEST_CASE("Inverse and eigenvalues of a small matrix", "[stokesModes]")
{
    scalarSquareMatrix A(2, Zero);
    A(0, 0) = 2;
    A(0, 1) = 1.5;
    A(1, 0) = 0.5;
    A(1, 1) = 2;

    // Symmetric part: 2 on the diagonal, 1 beside
    const scalarField values(denseMatrix::eigenvalues(A));
    CHECK(values[0] == Approx(1));
    CHECK(values[1] == Approx(3));

    const scalarSquareMatrix inverse(denseMatrix::inverse(A));
    const scalarField x
    (
        denseMatrix::multiply
        (
            inverse,
            denseMatrix::multiply(A, scalarField(List<scalar>({3, -1})))
        )
    );
    CHECK(x[0] == Approx(3));
    CHECK(x[1] == Approx(-1));
    CHECK(inverse(0, 1) == Approx(-1.5/3.25));
}


TEST_CASE("What drives the flow besides patches", "[stokesModes]")
{
    const auto drive = [](const string& text)
    {
        return stokesDrive(dictionary(IStringStream(text)()));
    };

    CHECK(!drive("").active);
    CHECK(drive("").direction == vector(1, 0, 0));

    const stokesDrive held(drive("direction (0 0 2); meanVelocity 3;"));
    CHECK((held.active && held.holdsFlowRate));
    CHECK(held.value == 3);
    CHECK(held.direction == vector(0, 0, 1));

    CHECK(!drive("acceleration 2;").holdsFlowRate);
    CHECK_THROWS(drive("direction (0 0 0);"));
    CHECK_THROWS(drive("acceleration 2; meanVelocity 1;"));
    CHECK_THROWS(drive("meanSpeed 1;"));
}
