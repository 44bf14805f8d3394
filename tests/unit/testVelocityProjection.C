// SPDX-License-Identifier: GPL-3.0-or-later

#include "projectionProblem.H"
#include "mathematicalConstants.H"

using namespace Foam;
using namespace projectionProblem;
using testTools::near;
using testTools::RandomNumbers;


TEST_CASE("Two bodies leave with the common velocity", "[contact]")
{
    velocityProjection solver(tolerance, 100);
    problem two;
    two.bodies.append(body(vector(3, 1, 0), 2));
    two.bodies.append(body(vector(-1, 0, 0), 6));
    two.contacts.append(contact(0, 1, vector(1, 0, 0)));

    SECTION("They touch")
    {
        two.load(solver);
        CHECK(solver.solve());
        CHECK(difference(solver[0].U, vector(0, 1, 0)) < 1e-14);
        CHECK(difference(solver[1].U, vector(0, 0, 0)) < 1e-14);
        CHECK(solver.impulse(0) == near(6));
    }

    SECTION("They may still come nearer")
    {
        two.contacts[0].offset = 1;
        two.load(solver);
        CHECK(solver.solve());
        CHECK(solver[0].U.x() - solver[1].U.x() == near(1));
    }

    SECTION("They do not meet in this step")
    {
        two.contacts[0].offset = 5;
        two.contacts[0].impulse = 3;
        two.load(solver);
        CHECK(solver.solve());
        CHECK(solver[0].U == vector(3, 1, 0));
        CHECK(solver.impulse(0) == 0);
    }

    SECTION("One does not give way")
    {
        two.bodies[1] = body(vector(-1, 0, 0), -1);
        two.load(solver);
        CHECK(solver.solve());
        CHECK(solver[1].U == vector(-1, 0, 0));
        CHECK(difference(solver[0].U, vector(-1, 1, 0)) < 1e-14);
    }

    SECTION("Neither gives way")
    {
        solver.clear();
        solver.append(body(vector(1, 0, 0), -1));
        CHECK_FALSE(solver.append(contact(0, -1, vector(1, 0, 0))));
    }
}


TEST_CASE("A contact that holds pulls as much as it may", "[contact]")
{
    const scalar speed = GENERATE(1., 2., 5.);
    velocityProjection solver(tolerance, 100);
    problem one;
    one.bodies.append(body(vector(-speed, 0, 0), 2));
    one.contacts.append(contact(0, -1, vector(1, 0, 0), 0, -4));
    one.load(solver);

    CHECK(solver.solve());
    one.check(solver, speed);
    CHECK(solver[0].U.x() == near(-max(speed - 2, scalar(0))));
}


TEST_CASE("A rod that is hit at its end turns", "[contact]")
{
    const scalar arm = 0.3, inertia = 0.05, mass = 2;
    velocityProjection solver(tolerance, 100);
    problem rod;
    rod.bodies.append(body(vector(0, -1, 0), mass));
    rod.bodies[0].inverseInertia = tensor::I/inertia;
    rod.contacts.append(contact(0, -1, vector(0, -1, 0)));
    rod.contacts[0].arma = vector(arm, 0, 0);
    rod.load(solver);

    CHECK(solver.solve());
    rod.check(solver, 1);

    const scalar p = 1/(1/mass + sqr(arm)/inertia);
    CHECK(solver.impulse(0) == near(p));
    CHECK(solver[0].omega.z() == near(p*arm/inertia));
}


TEST_CASE("A chain of ten", "[contact]")
{
    velocityProjection solver(tolerance, 100);
    problem row(chain(10));

    row.load(solver);
    CHECK(solver.solve());
    row.check(solver, 1);

    vector sum(Zero);
    for (label i = 0; i < 10; ++i)
    {
        CHECK(solver[i].U.x() == Approx(0.1).margin(1e-7));
        sum += solver[i].U;
    }
    CHECK(mag(sum - vector(1, 0, 0)) < 1e-13);

    CHECK(solver.nIterations() < 15);
}


TEST_CASE("Long chains take sweeps in proportion", "[contact]")
{
    auto sweeps = [](const label n)
    {
        velocityProjection solver(tolerance, 10000);
        problem row(chain(n));
        row.load(solver);
        CHECK(solver.solve());
        return solver.nIterations();
    };

    // Without conjugate directions fourfold
    CHECK(sweeps(80) < 2.5*sweeps(40));
}


TEST_CASE("A packed triangle, and two at once on one", "[contact]")
{
    velocityProjection solver(tolerance, 200);
    problem packed;
    const scalar s = std::sqrt(0.75);

    SECTION("Triangle")
    {
        const std::array<vector, 3> x
        {{
            vector(0, 0, 0), vector(1, 0, 0), vector(0.5, s, 0)
        }};
        for (label i = 0; i < 3; ++i)
        {
            packed.bodies.append
            (
                body(vector(0.5, s/3, 0) - x[i] + vector(0.1, 0, 0), 1 + i)
            );
            packed.contacts.append
            (
                contact(i, (i + 1) % 3, x[(i + 1) % 3] - x[i])
            );
        }
    }

    SECTION("Two on one")
    {
        packed.bodies.append(body(vector(0, 0, 0)));
        packed.bodies.append(body(vector(0.5, -1, 0)));
        packed.bodies.append(body(vector(-0.5, -1, 0)));
        packed.contacts.append(contact(0, 1, vector(-0.5, s, 0)));
        packed.contacts.append(contact(0, 2, vector(0.5, s, 0)));
    }

    packed.load(solver);
    CHECK(solver.solve());
    packed.check(solver, 1);

    vector before(Zero), after(Zero);
    forAll(packed.bodies, i)
    {
        const scalar mass = 1/packed.bodies[i].inverseMass.x();
        before += mass*packed.bodies[i].U;
        after += mass*solver[i].U;
    }
    CHECK(mag(after - before) < 1e-13);
}


TEST_CASE("Unequal masses and many contacts", "[contact]")
{
    // A heap of balls at random places, with masses over four decades, that
    // push, that hold, and that turn
    RandomNumbers random(GENERATE(1, 2, 3));
    velocityProjection solver(tolerance, 20000);
    problem heap;

    for (label i = 0; i < 60; ++i)
    {
        auto b = body(random.vector(), Foam::pow(10., 2*random.number()));
        b.inverseInertia = 3*b.inverseMass.x()*tensor::I;
        b.omega = random.vector();
        heap.bodies.append(b);
    }
    for (label k = 0; k < 150; ++k)
    {
        const label a = k % 60;
        const label b = (a + 1 + (7*k + k/60) % 58) % 60;
        auto c = contact(a, k % 10 ? b : -1, normalised(random.vector()));

        c.arma = 0.5*random.vector();
        c.armb = 0.5*random.vector();
        c.offset = 0.1*(1 + random.number());
        c.least = k % 3 ? 0 : -0.1;
        heap.contacts.append(c);
    }

    heap.load(solver);
    CHECK(solver.solve());
    heap.check(solver, 3);
    const label cold = solver.nIterations();

    // Begun with the impulses of a problem that is nearly the same
    forAll(heap.contacts, k)
    {
        heap.contacts[k].impulse = solver.impulse(k);
    }
    for (auto& b : heap.bodies)
    {
        b.U += 1e-3*random.vector();
    }
    heap.load(solver);
    CHECK(solver.solve());
    heap.check(solver, 3);
    INFO(cold << " " << solver.nIterations());
    CHECK(solver.nIterations() < 0.8*cold);
}


TEST_CASE("Too few sweeps are told", "[contact]")
{
    velocityProjection solver(tolerance, 3);
    problem row(chain(10));
    row.load(solver);

    CHECK_FALSE(solver.solve());
    CHECK(solver.nIterations() == 3);
    CHECK(solver.residual() > tolerance);
}
