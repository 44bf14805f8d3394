// SPDX-License-Identifier: GPL-3.0-or-later

#include "Clift.H"
#include "ellipsoidShape.H"
#include "mathematicalConstants.H"
#include "shapeModelTools.H"
#include "sphericity.H"

using namespace Foam;
using namespace shapeModelTools;
using Catch::Contains;
using constant::mathematical::pi;
using testTools::difference;
using testTools::messageOf;


TEST_CASE("Integrals of Carlson", "[shapes]")
{
    typedef shapeModels::ellipsoidShape E;

    // Carlson (1979), and elementary cases
    CHECK(E::RF(1, 2, 0) == Approx(1.3110287771461).epsilon(1e-13));
    CHECK(E::RF(2, 3, 4) == Approx(0.58408284167715).epsilon(1e-13));
    CHECK(E::RF(4, 4, 4) == Approx(0.5).epsilon(1e-14));
    CHECK(E::RD(0, 2, 1) == Approx(1.7972103521034).epsilon(1e-13));
    CHECK(E::RD(2, 3, 4) == Approx(0.16510527294261).epsilon(1e-13));
    CHECK(E::RD(4, 4, 4) == Approx(0.125).epsilon(1e-14));
}


TEST_CASE("Ellipsoids in Stokes flow: spheroids", "[shapes]")
{
    // Oberbeck (1876), closed forms: along and across the axis, over
    // 6 pi mu a U of the sphere of the same volume; about it and across it
    const scalar table[][5] =
    {
        {0.25, 1.376828, 1.083146, 2.249528, 1.843112},
        {0.5, 1.140613, 0.998749, 1.410040, 1.131632},
        {1.25, 0.975237, 1.019738, 0.920800, 1.076806},
        {2, 0.955569, 1.094433, 0.806677, 1.504926},
        {2.5, 0.961568, 1.146631, 0.770843, 1.892321},
        {10, 1.228692, 1.769155, 0.680471, 13.368037}
    };

    for (const auto& row : table)
    {
        INFO("aspect ratio " << row[0]);
        const auto m = model("ellipsoid", ellipsoid(3, 3*row[0], 3));
        const scalar e = 6e-7;

        CHECK(m->force(0, {0, 1, 0}).y() == Approx(row[1]).epsilon(e));
        CHECK(m->force(0, {1, 0, 0}).x() == Approx(row[2]).epsilon(e));
        CHECK(m->force(0, {0, 0, 1}).z() == Approx(row[2]).epsilon(e));
        CHECK(m->turning().y() == Approx(row[3]).epsilon(e));
        CHECK(m->turning().x() == Approx(row[4]).epsilon(e));

        // Any direction
        const vector d(0.36, 0.48, 0.8);
        CHECK
        (
            difference
            (
                m->force(0, d),
                vector(0.36*row[2], 0.48*row[1], 0.8*row[2])
            ) < 1e-6
        );
    }
}


TEST_CASE("Spheres have the drag of spheres", "[shapes]")
{
    const std::string sphere("type sphere; radius 0.02;");
    const vector d(0.36, 0.48, 0.8);

    for (const char* type : {"sphericity", "ellipsoid"})
    {
        const auto m = model(type, sphere);

        for (const scalar Re : {0., 0.1, 10., 2000.})
        {
            CHECK(difference(m->force(Re, d), d) < 1e-12);
        }
        CHECK(difference(m->turning(), vector::one) < 1e-12);
        CHECK(mag(m->straining(symmTensor(1, 2, 3, 4, 5, 6))) < 1e-12);
        CHECK(m->pitching({1, 2, 3}, 1, 1) == vector::zero);
    }
}


TEST_CASE("Drag of Hoelzer and Sommerfeld", "[shapes]")
{
    const scalar Re = 500;
    const std::string form(ellipsoid(1, 1, 2));
    const auto m = model("ellipsoid", form);
    const scalar psi = sphericity(*shape(form, space)).value();
    const scalar D2 = sqr(2*Foam::cbrt(2.0));

    // Along and across, with their Stokes part replaced by the exact one
    auto Cd = [&](const scalar stokes, const scalar section)
    {
        return
            24*stokes/Re + 3/Foam::sqrt(Re)/Foam::pow(psi, 0.75)
          + 0.42*Foam::pow(10, 0.4*Foam::pow(-Foam::log10(psi), 0.2))
           /(D2/4/section);
    };
    const scalar sphere = 24/Re + 3/Foam::sqrt(Re) + 0.42;

    CHECK(m->force(Re, {0, 0, 1}).z()
        == Approx(Cd(0.955569, 1)/sphere).epsilon(1e-6));
    CHECK(m->force(Re, {0, 1, 0}).y()
        == Approx(Cd(1.094433, 2)/sphere).epsilon(1e-6));
}


TEST_CASE("Coefficients of Zastawny et al.", "[shapes]")
{
    const dragModels::Clift clift(dict(""));
    const scalar nu = 0.01, D = 0.2;
    const scalar r = 0.1/Foam::cbrt(2.5);
    const auto m = model("Zastawny", ellipsoid(r, 2.5*r, r));

    for (const scalar Re : {0.5, 30., 200.})
    {
        for (const scalar angle : {0.2, 0.7, 1.3, 2.2, 4.})
        {
            INFO("Re " << Re << ", angle " << angle);
            const scalar S = mag(Foam::sin(angle)), C = mag(Foam::cos(angle));
            const vector e(Foam::sin(angle), Foam::cos(angle), 0);
            const scalar C0 =
                5.1/Foam::pow(Re, 0.48) + 15.52/Foam::pow(Re, 1.05);
            const scalar C90 =
                24.68/Foam::pow(Re, 0.98) + 3.19/Foam::pow(Re, 0.21);
            const scalar CL =
                (6.079/Foam::pow(Re, 0.898) + 0.704*Foam::pow(Re, 0.028))
               *Foam::pow(S, 1.067 + 0.0025*Foam::pow(Re, 0.818))
               *Foam::pow(C, 1.049);
            const scalar CT =
                (2.078/Foam::pow(Re, 0.279) + 0.372/Foam::pow(Re, 0.018))
               *Foam::pow(S, 0.98)*C;

            // Over C_D of the sphere by Clift
            const vector f(24*clift.K(Re, 0)/Re*m->force(Re, e));
            CHECK((f & e) == Approx(C0 + (C90 - C0)*S*S).epsilon(1e-6));

            const vector lift(f - (f & e)*e);
            CHECK(mag(lift) == Approx(CL).epsilon(1e-6));

            // As in Stokes flow: more of the force across the axis than of
            // the slip
            CHECK(mag(lift.x() + f.x()) > mag(f.x()));
            CHECK(lift.x()*e.x() > 0);
            CHECK(lift.y()*e.y() < 0);

            const scalar W = Re*nu/D;
            const vector T(m->pitching(W*e, D, nu));
            CHECK
            (
                mag(T)
             == Approx(CT*pi/16*pow3(D)*sqr(W)).epsilon(1e-6)
            );

            // About z it turns the axis, y, away from e
            const vector axis(0, C*Foam::cos(angle) > 0 ? 1 : -1, 0);
            CHECK(((T^axis) & e) < 0);
        }
    }
}


TEST_CASE("Zastawny et al. go over to Stokes flow without a jump", "[shapes]")
{
    const auto m = model("Zastawny", ellipsoid(1, 2.5, 1));
    const auto stokes = model("ellipsoid", ellipsoid(1, 2.5, 1));
    const vector e(0.6, 0.8, 0);

    CHECK(difference(m->force(0, e), stokes->force(0, e)) < 1e-12);
    CHECK(difference(m->force(0.1 - 1e-9, e), m->force(0.1, e)) < 1e-6);
    CHECK(m->pitching(vector::zero, 1, 1) == vector::zero);
}


TEST_CASE("Wrong entries of shape models", "[shapes]")
{
    auto refused = [](const std::string& entries, const std::string& form)
    {
        return messageOf
        (
            [&]{ shapeModel::New(dict(entries), *shape(form, space)); }
        );
    };
    const std::string sphere("type sphere; radius 1;");

    CHECK_THAT
    (
        refused("type elipsoid;", sphere),
        Contains("nearest valid one is 'ellipsoid'")
    );
    CHECK_THAT(refused("type ellipsoid; a 1;", sphere), Contains("'a'"));
    CHECK_THAT(refused("type Zastawny;", sphere), Contains("long grains"));
    CHECK_THAT
    (
        refused("type Zastawny;", ellipsoid(2, 2, 1)), Contains("1.1 to 3.5")
    );
    CHECK(refused("type Zastawny;", ellipsoid(3.54, 1.33, 1.21)).empty());
    CHECK(refused("type ellipsoid;", ellipsoid(4.7, 4.1, 2.32)).empty());
}
