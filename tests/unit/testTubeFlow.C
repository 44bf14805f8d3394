// SPDX-License-Identifier: GPL-3.0-or-later

#include "testTools.H"
#include "tubeFlow.H"

using namespace Foam;
using testTools::dict;
using testTools::messageOf;

namespace
{

//- Between plates in the plane z, or in a round tube, about (0.5 0.2 0.1)
tubeFlow tube(const std::string& text, const scalar halfWidth)
{
    const dictionary entries(dict(text));
    tubeFlow flow(entries, vector(1, 2, 0), true, vector(0, 0, 1));

    flow.place(entries, point(0.5, 0.2, 0.1), halfWidth);

    return flow;
}


//- A point at the distance s from the middle
point at(const scalar s)
{
    return point(0.5, 0.2, 0.1) + s*normalised(vector(-2, 1, 0));
}

} // End anonymous namespace


TEST_CASE("The rough profile between plates is that of the closed form")
{
    const scalar a = 2, K = 0.7, Q = 1.8;
    const tubeFlow flow(tube("a 2; K 0.7;", 1));

    for (const scalar y : {-1.0, -0.3, 0.0, 0.8})
    {
        const scalar u =
            (6*K - 3*a*Q)/(4*(3 + a))*(sqr(y) - 1) + (2*K + 3*Q)/(2*(3 + a));

        CHECK(flow.speed(at(y), Q/2) == Approx(u));
    }
}


TEST_CASE("Profiles have the mean speed and obey the condition at the walls")
{
    for (const char* shape : {"plates", "round"})
    {
        for
        (
            const char* wall : {"a 3", "slipLength 0.4", "a 0", "slipLength 0"}
        )
        {
            const scalar R = 0.3, mean = 1.7, K = 5, uw = 0.6;
            const tubeFlow flow
            (
                tube
                (
                    std::string("shape ") + shape + "; " + wall
                  + "; K 5; wallVelocity 0.6;",
                    R
                )
            );
            const bool round = flow.round();
            const label n = 2000;
            scalar sum = 0, area = 0;

            for (label i = 0; i < n; ++i)
            {
                const scalar s = R*(i + 0.5)/n;
                const scalar weight = round ? s : 1;

                sum += weight*flow.speed(at(s), mean);
                area += weight;
            }
            CHECK(sum/area == Approx(mean).epsilon(1e-6));

            const scalar h = 1e-6;
            const scalar u = flow.speed(at(R), mean);
            const scalar slope =
                (flow.speed(at(R + h), mean) - flow.speed(at(R - h), mean))
               /(2*h);
            const std::string name(wall);
            const scalar friction = name == "a 3" ? 3 : name == "a 0" ? 0 : 1;
            const scalar slip =
                name[0] == 'a' ? 1 : name == "slipLength 0" ? 0 : 0.4;

            CHECK(mag(friction*(u - uw) + slip*(slope - K)) < 1e-6);
        }
    }
}


TEST_CASE("The vorticity is the curl of the velocity")
{
    for (const char* shape : {"plates", "round"})
    {
        const tubeFlow flow(tube(std::string("a 3; shape ") + shape + ";", 2));
        const point x(0.9, -0.4, 0.5);
        const scalar h = 1e-6;
        tensor grad;

        for (direction i = 0; i < 3; ++i)
        {
            vector step(Zero);
            step[i] = h;
            const vector slope
            (
                (flow.velocity(x + step, 1) - flow.velocity(x - step, 1))/(2*h)
            );
            for (direction j = 0; j < 3; ++j)
            {
                grad[3*i + j] = slope[j];
            }
        }
        const vector curl
        (
            grad.yz() - grad.zy(), grad.zx() - grad.xz(), grad.xy() - grad.yx()
        );

        CHECK(mag(flow.vorticity(x, 1) - curl) < 1e-7);
    }
}


TEST_CASE("Plates in 3D need to know where they are")
{
    const std::string message
    (
        messageOf([]
        {
            tubeFlow
            (
                dict("shape plates;"), vector(1, 0, 0), false, vector(Zero)
            );
        })
    );

    CHECK(message.find("across") != std::string::npos);
}
