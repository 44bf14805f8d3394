// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactTools.H"
#include "mathematicalConstants.H"

using namespace Foam;
using contactTools::Scene;

namespace
{

const scalar e = 0.8, mu = 0.3, R = 0.5, T = 0.001;
const geometricSpace xyPlane(2, 0.1);


//- Tangential speed of the surface after an impact with the normal speed 1: two
//  oscillators of the effective masses 1 and mt, with Coulomb's limit, in a
//  million steps
scalar reference(const scalar Ut, const scalar mt)
{
    const scalar logE = std::log(e);
    const scalar square = sqr(constant::mathematical::pi) + sqr(logE);
    const scalar k = square/sqr(T), gamma = -2*logE/T;
    const scalar kt = mt*k;
    const scalar gammat = -2*logE/std::sqrt(square)*std::sqrt(kt*mt);
    const scalar dt = 1e-6*T;

    scalar overlap = 0, spring = 0, un = 1, ut = Ut;

    do
    {
        const scalar normal = k*overlap + gamma*un;
        const scalar limit = mu*max(normal, scalar(0));
        scalar friction = kt*spring + gammat*ut;

        if (mag(friction) > limit)
        {
            friction *= limit/mag(friction);
            spring = (friction - gammat*ut)/kt;
        }

        un -= dt*normal;
        ut -= dt*friction/mt;
        overlap += dt*un;
        spring += dt*ut;
    }
    while (overlap > 0);

    return ut;
}

} // End anonymous namespace


TEST_CASE("Impact on a wall at every angle", "[contact]")
{
    // Tangential over normal speed, from sticking to sliding all the time:
    // Maw, Barber & Fawcett (1976, Wear 38, 101) have the same for spheres of
    // Hertz and Mindlin
    const bool twoD = GENERATE(true, false);
    const scalar Ut = GENERATE(0.1, 0.5, 0.8, 1.2, 1.6, 2., 3., 6.);
    const scalar inertia = twoD ? 0.5 : 0.4;
    const scalar mt = inertia/(1 + inertia);

    Scene scene
    (
        "restitution 0.8; friction 0.3; collisionTime 0.001;",
        twoD ? xyPlane : geometricSpace(-1)
    );
    scene.addPlane({0, 0, 0}, {0, 1, 0});
    scene.add
    (
        twoD ? "type disc; radius 0.5;" : "type sphere; radius 0.5;",
        {0, 0.5003, 0}, {Ut, -1, 0}
    );
    scene.run(0.0002, 15);

    const bodyState& end = scene.bodies[0].state();
    const scalar surface = end.U.x() + R*end.omega.z();

    CHECK(end.U.y() == Approx(e).epsilon(0.01));
    CHECK(surface == Approx(reference(Ut, mt)).margin(0.02));

    // Angular momentum about the point of contact
    CHECK(end.U.x() - inertia*R*end.omega.z() == Approx(Ut).epsilon(1e-3));

    const scalar slides = Ut - mu*(1 + e)/mt;
    if (slides > 3)
    {
        CHECK(surface == Approx(slides).epsilon(0.01));
    }
    else if (Ut < 0.2)
    {
        // Never at the limit but for the end: as the normal motion
        CHECK(surface < 0);
        CHECK(surface > -1.02*e*Ut);
    }
}
