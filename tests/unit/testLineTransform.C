// SPDX-License-Identifier: GPL-3.0-or-later

#include "testTools.H"
#include "denseTransform.H"
#include "fastestTransform.H"
#include "fourierTransform.H"

using namespace Foam;
using testTools::RandomNumbers;

namespace
{

//- Sides: z(ero gradient), f(ixed value), c(yclic)
lineOperator makeLine(const std::string& sides, const label n, const bool equal)
{
    RandomNumbers random(n);
    const bool cyclic = sides == "cc";
    scalarField widths(n, 0.3), links(n, 2);

    for (label i = 0; !equal && i < n; ++i)
    {
        widths[i] *= 2 + random.number();
        links[i] *= 2 + random.number();
    }

    links[n - 1] *= cyclic ? 1 : 0;

    return lineOperator
    (
        widths, links, sides[0] == 'f' ? 4 : 0, sides[1] == 'f' ? 4 : 0, cyclic
    );
}


//- S v of v[outer][n][inner]
scalarField multiply
(
    const lineOperator& line,
    const scalarField& v,
    const label inner
)
{
    const label n = line.size();
    scalarField result(v.size(), Zero);

    forAll(v, j)
    {
        const label i = (j/inner) % n;
        const label next = j + ((i + 1) % n - i)*inner;
        result[j] += line.diag(i)*v[j] - line.off(i)*v[next];
        result[next] -= line.off(i)*v[j];
    }

    return result;
}


//- Largest difference between S v and what the transform makes of it
scalar deviation(const lineOperator& line, const lineTransform& transform)
{
    const label n = line.size(), inner = 3, size = 2*n*inner;
    scalar* v = fftw_alloc_real(size);
    scalar* other = fftw_alloc_real(size);
    RandomNumbers random;
    scalarField original(size);

    forAll(original, i)
    {
        original[i] = v[i] = random.number();
    }

    transform.forward(v, other);
    forAll(original, i)
    {
        v[i] *= transform.eigenvalues()[(i/inner) % n]/transform.norm();
    }
    transform.backward(v, other);

    const scalarField expected(multiply(line, original, inner));
    const scalar difference =
        max(mag(expected - UList<scalar>(v, size))());
    fftw_free(v);
    fftw_free(other);

    return difference/max(mag(expected));
}

} // End anonymous namespace


TEST_CASE("Trigonometric transforms diagonalise", "[fastPoisson]")
{
    const std::string sides = GENERATE("zz", "ff", "zf", "fz", "cc");
    const label n = GENERATE(2, 3, 8, 31, 96);
    const lineOperator line(makeLine(sides, n, true));
    CAPTURE(sides, n);

    REQUIRE(line.trigonometric() != lineOperator::basis::none);
    CHECK(deviation(line, fourierTransform(line, 3, 2)) < 1e-13);
}


TEST_CASE("Matrices of eigenvectors diagonalise", "[fastPoisson]")
{
    const std::string sides = GENERATE("zz", "ff", "zf", "fz", "cc");
    const label n = GENERATE(2, 3, 8, 31, 96);
    const bool equal = GENERATE(false, true);
    const lineOperator line(makeLine(sides, n, equal));
    CAPTURE(sides, n, equal);

    CHECK((line.trigonometric() == lineOperator::basis::none) == !equal);
    CHECK(deviation(line, denseTransform(line, 3, 2)) < 1e-13);
}


TEST_CASE("The cheaper transform is taken", "[fastPoisson]")
{
    auto kind = [](const label n, const bool equal)
    {
        const lineOperator line(makeLine("zz", n, equal));
        return fastestTransform::New(line, 1, 1)().description();
    };

    CHECK(kind(100, true) == "cosine transform");
    CHECK(kind(100, false) == "dense diagonalisation");
    CHECK(kind(10, true) == "dense diagonalisation");
}
