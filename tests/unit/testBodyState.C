// SPDX-License-Identifier: GPL-3.0-or-later

#include "testTools.H"
#include "bodyState.H"
#include "mathematicalConstants.H"
#include "OStringStream.H"

using namespace Foam;
using constant::mathematical::twoPi;
using testTools::difference;
using testTools::near;

namespace
{

tensor rotationX(const scalar a)
{
    return tensor
    (
        1, 0, 0,
        0, Foam::cos(a), -Foam::sin(a),
        0, Foam::sin(a), Foam::cos(a)
    );
}


tensor rotationZ(const scalar a)
{
    return tensor
    (
        Foam::cos(a), -Foam::sin(a), 0,
        Foam::sin(a), Foam::cos(a), 0,
        0, 0, 1
    );
}


//- A body that turns about its x axis at the rate b, an axis that itself turns
//  about the global z axis at the rate a: R = Rz(a t) Rx(b t)
const scalar a = 0.7, b = 1.9;

vector precessionOmega(const scalar t)
{
    return vector(b*Foam::cos(a*t), b*Foam::sin(a*t), a);
}


//- Error at t = 2 with n steps, each with the mean of the velocities at its
//  ends: in orientation and in position (whose velocity is omega)
std::pair<scalar, scalar> precessionErrors(const label n)
{
    bodyState state;
    const scalar end = 2, dt = end/n;

    for (label i = 0; i < n; ++i)
    {
        const vector mean
        (
            0.5*(precessionOmega(i*dt) + precessionOmega((i + 1)*dt))
        );
        state.move(dt, mean, mean);
    }

    const vector position
    (
        b/a*Foam::sin(a*end), b/a*(1 - Foam::cos(a*end)), a*end
    );

    return
    {
        difference
        (
            state.orientation.R(),
            rotationZ(a*end) & rotationX(b*end)
        ),
        difference(state.position, position)
    };
}

} // End anonymous namespace


TEST_CASE("A full turn leads back, through half a turn", "[bodyState]")
{
    const vector axis(normalised(vector(1, -2, 0.5)));
    const vector X(0.3, 0.4, -0.2);
    const label n = 100;
    bodyState state;

    for (label i = 0; i < n; ++i)
    {
        state.move(0.01, vector::zero, twoPi/(n*0.01)*axis);

        const scalar norm =
            sqr(state.orientation.w()) + magSqr(state.orientation.v());
        REQUIRE(norm == near(1));

        if (i == n/2 - 1)
        {
            // Half a turn mirrors what is normal to the axis
            const vector half(2*(X & axis)*axis - X);
            CHECK(difference(state.orientation.R() & X, half) < 1e-12);
        }
    }

    CHECK(difference(state.orientation.R(), tensor(tensor::I)) < 1e-12);
    CHECK(state.position == vector::zero);
}


TEST_CASE("A quarter turn about z takes x to y", "[bodyState]")
{
    bodyState state;
    state.move(0.5, vector::zero, vector(0, 0, 0.5*twoPi/2/0.5));

    CHECK(difference(state.orientation.R() & vector(1, 0, 0), {0, 1, 0})
        < 1e-12);
}


TEST_CASE("Turns about several axes are put together globally", "[bodyState]")
{
    bodyState state;
    state.move(1, vector::zero, vector(0.8, 0, 0));
    state.move(1, vector::zero, vector(0, 0, 0.6));

    CHECK(difference(state.orientation.R(), rotationZ(0.6) & rotationX(0.8))
        < 1e-12);
}


TEST_CASE("Orientation and position are second order", "[bodyState]")
{
    const auto coarse = precessionErrors(40), fine = precessionErrors(80);

    CHECK(coarse.first < 1e-2);
    CHECK(coarse.first/fine.first == Approx(4).epsilon(0.05));
    CHECK(coarse.second/fine.second == Approx(4).epsilon(0.05));
}


TEST_CASE("The orientation stays a unit quaternion for ever", "[bodyState]")
{
    testTools::RandomNumbers random;
    bodyState state;

    for (int i = 0; i < 100000; ++i)
    {
        state.move(0.1, vector::zero, random.vector());
    }

    const scalar norm =
        sqr(state.orientation.w()) + magSqr(state.orientation.v());
    CHECK(norm == near(1));
}


TEST_CASE("Velocity of the rigid motion", "[bodyState]")
{
    bodyState state;
    state.position = vector(1, 2, 3);
    state.U = vector(0.1, 0.2, 0.3);
    state.omega = vector(0, 0, 2);

    CHECK(difference(state.velocity({1, 2, 3}), state.U) < 1e-15);
    CHECK(difference(state.velocity({2, 4, 9}), {0.1 - 4, 0.2 + 2, 0.3})
        < 1e-15);
}


TEST_CASE("A written state is read back to the last bit", "[bodyState]")
{
    testTools::RandomNumbers random;
    bodyState state;
    state.position = random.vector();
    state.U = random.vector();
    state.omega = random.vector();
    state.move(1, state.U, state.omega);

    OStringStream os;
    os.precision(17);
    state.write(os);
    const bodyState copy(testTools::dict(os.str()));

    CHECK(copy.position == state.position);
    CHECK(copy.orientation == state.orientation);
    CHECK(copy.U == state.U);
    CHECK(copy.omega == state.omega);
}


TEST_CASE("Small and large rotations in one step", "[bodyState]")
{
    // The series of small angles ends between the second and the third
    for (const scalar angle : {1e-9, 0.19, 0.21, 3.})
    {
        for (const scalar sign : {-1, 1})
        {
            bodyState state;

            state.move(0.5, Zero, vector(2*sign*angle, 0, 0));
            CHECK
            (
                difference(state.orientation.R(), rotationX(sign*angle)) < 1e-15
            );
        }
    }
}
