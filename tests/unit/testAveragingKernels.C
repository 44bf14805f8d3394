// SPDX-License-Identifier: GPL-3.0-or-later

#include "averagingKernel.H"
#include "boxMesh.H"
#include "kernelSums.H"
#include "mathematicalConstants.H"
#include "meshProperties.H"
#include "Pstream.H"
#include "testTools.H"

using namespace Foam;
using testTools::dict;
using testTools::near;

namespace
{

//- Half integrals of a kernel over the space by the midpoint rule: of g, and of
//  g x^2, in n points along each coordinate
Pair<scalar> moments(const averagingKernel& kernel, const bool twoD)
{
    // Cells that end where the kernels do
    const label n = twoD ? 800 : 160;
    const scalar h = 2*kernel.reach()/n;
    vectorList r(n);
    scalarList g(n);
    Pair<scalar> sums(0, 0);

    for (label k = 0; k < (twoD ? 1 : n); ++k)
    {
        for (label j = 0; j < n; ++j)
        {
            for (label i = 0; i < n; ++i)
            {
                r[i] = h*vector(i - 0.5*(n - 1), j - 0.5*(n - 1), 0);
                r[i].z() = twoD ? 0 : h*(k - 0.5*(n - 1));
            }
            kernel.values(r, g);

            for (label i = 0; i < n; ++i)
            {
                const scalar w = g[i]*(twoD ? sqr(h) : pow3(h));

                sums.first() += w;
                sums.second() += w*sqr(r[i].x());
            }
        }
    }

    return sums;
}


//- Box of cells of size 0.1 on one or all processors, 2 long
testTools::boxMesh boxOf(const std::string& sides, const label n)
{
    testTools::boxMesh box;
    box.x = {{
        testTools::graded(n, 2, 1), testTools::graded(n, 2, 1),
        testTools::graded(4, 0.4, 1)
    }};
    box.sides = {{sides, sides, "cc"}};

    const label nProcs = Pstream::nProcs();
    box.processor = [nProcs, n](const labelVector& ijk)
    {
        return ijk.x()*nProcs/n;
    };

    return box;
}


scalar f(const point& x)
{
    return 3 + 2*x.x() - x.y();
}

} // End anonymous namespace


TEST_CASE("Kernels: integral and second moment", "[averages]")
{
    const std::string type = GENERATE("Gaussian", "topHat", "sphere");
    const bool twoD = GENERATE(true, false);
    const auto kernel =
        averagingKernel::New(dict("radius 1.5; type " + type + ";"), 0.2, twoD);
    const Pair<scalar> sums(moments(kernel(), twoD));

    CHECK(kernel->reach() == Approx(type == "Gaussian" ? 1.2 : 0.3));
    CHECK(sums.first() == Approx(1).epsilon(1e-3));
    CHECK(sums.second() == Approx(kernel->secondMoment()).epsilon(2e-3));
}


TEST_CASE("Kernels: wrong entries", "[averages]")
{
    CHECK_THROWS(averagingKernel::New(dict("type Gauss;"), 1, true));
    CHECK_THROWS(averagingKernel::New(dict("radius 0;"), 1, true));
    CHECK_THROWS(averagingKernel::New(dict("width 1;"), 1, true));
}


TEST_CASE("Averages of a linear field", "[averages][parallel]")
{
    const std::string type = GENERATE("Gaussian", "topHat", "sphere");
    const Time time(dict("deltaT 1; writeFrequency 1;"), "/tmp", "none");
    const auto mesh(boxOf("zz", 20).make(time));
    const auto kernel = averagingKernel::New
    (
        dict("type " + type + ";"), type == "Gaussian" ? 0.12 : 0.35, false
    );
    const kernelSums sums(*mesh, meshProperties::periods(*mesh), kernel());
    scalarField values(2*mesh->nCells());

    forAll(mesh->cellCentres(), celli)
    {
        values[2*celli] = f(mesh->cellCentres()[celli]);
        values[2*celli + 1] = 7;
    }

    const scalarField means(sums.average(2, values));

    forAll(mesh->cellCentres(), celli)
    {
        const point& x = mesh->cellCentres()[celli];
        const scalar fromWall = min(min(x.x(), x.y()), 2 - max(x.x(), x.y()));

        // Constants stay everywhere, linear fields away from walls
        CHECK(means[2*celli + 1] == near(7));
        if (fromWall > kernel->reach())
        {
            CHECK(means[2*celli] == Approx(f(x)).epsilon(1e-12));
        }
        else if (type == "topHat" && x.x() < 0.1 && fromWall == x.x())
        {
            // Of three cells beyond the first, one-sided
            if (x.y() > 0.4 && x.y() < 1.6)
            {
                CHECK(means[2*celli] == Approx(f(x) + 2*0.15));
            }
        }
    }
}


TEST_CASE("Averages across cyclic patches keep the integral",
    "[averages][parallel]")
{
    const std::string type = GENERATE("Gaussian", "topHat", "sphere");
    const Time time(dict("deltaT 1; writeFrequency 1;"), "/tmp", "none");
    const auto mesh(boxOf("cc", 20).make(time));
    const auto kernel =
        averagingKernel::New(dict("type " + type + ";"), 0.27, false);
    const kernelSums sums(*mesh, meshProperties::periods(*mesh), kernel());
    testTools::RandomNumbers random(2);
    scalarField values(mesh->nCells());
    scalar wave = 0;

    forAll(values, celli)
    {
        values[celli] = random.number();
    }

    const scalarField means(sums.average(1, values));
    const scalar before = gSum(mesh->cellVolumes()*values);

    CHECK(gSum(mesh->cellVolumes()*means) == Approx(before).epsilon(1e-12));

    // A wave has its amplitude changed, the same everywhere
    const scalar k = constant::mathematical::twoPi/2;
    forAll(values, celli)
    {
        values[celli] = std::cos(k*mesh->cellCentres()[celli].x());
    }
    const scalarField damped(sums.average(1, values));
    wave = gSum(values*damped)/gSum(values*values);

    CHECK(gMax(mag(damped - wave*values)()) < 1e-12);
    CHECK
    (
        wave == Approx(1 - 0.5*sqr(k)*kernel->secondMoment()).margin(0.08)
    );
}


TEST_CASE("Averages on graded and on sheared meshes", "[averages]")
{
    // Direction by direction, and pair by pair
    const std::string type = GENERATE("Gaussian", "topHat", "sphere");
    const scalar shear = GENERATE(0., 0.3);
    const bool last = type == "sphere";
    const Time time(dict("deltaT 1; writeFrequency 1;"), "/tmp", "none");
    testTools::boxMesh box;
    box.x = {{
        testTools::graded(9, 2, 1.2), testTools::graded(7, 1, 0.8),
        testTools::graded(5, 1, 1.1)
    }};
    box.sides = {{"zz", "zz", "zz"}};
    box.shear = shear;

    if (Pstream::parRun())
    {
        return;
    }

    const auto mesh(box.make(time));
    const auto kernel = averagingKernel::New
    (
        dict("type " + type + ";"), type == "Gaussian" ? 0.15 : 0.6, false
    );
    const kernelSums sums(*mesh, meshProperties::periods(*mesh), kernel());
    const vectorField& x = mesh->cellCentres();
    const scalarField& V = mesh->cellVolumes();
    const gridSums grid(kernel(), x, x);
    testTools::RandomNumbers random(4);
    scalarField values(x.size()), g(x.size());

    CHECK(grid.valid() == (!last && shear == 0));
    forAll(values, celli)
    {
        values[celli] = random.number();
    }

    const scalarField means(sums.average(1, values));

    forAll(means, celli)
    {
        kernel->values(vectorField(x - x[celli]), g);
        const scalar mean = sum(scalarField(V*g*values))/sum(scalarField(V*g));

        CHECK(means[celli] == Approx(mean).margin(1e-12));
    }
}
