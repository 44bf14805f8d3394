// SPDX-License-Identifier: GPL-3.0-or-later

#include "testTools.H"
#include "dragModel.H"
#include "sphericity.H"

using namespace Foam;
using testTools::dict;
using testTools::messageOf;
using testTools::shape;


namespace
{

autoPtr<dragModel> model(const std::string& type)
{
    return dragModel::New(dict("type " + type + ";"));
}


//- Drag coefficient
scalar Cd(const dragModel& drag, const scalar Re, const scalar phi = 0)
{
    return 24*drag.K(Re, phi)/Re;
}

} // End anonymous namespace


TEST_CASE("Drag of Clift: the standard curve", "[drag]")
{
    const autoPtr<dragModel> drag(dragModel::New(dict("")));

    // Clift, Grace & Weber (1978): their fits, to the digits given
    const scalar table[][2] =
    {
        {0.1, 244.26}, {0.5, 51.538}, {1, 27.156}, {2, 14.757}, {5, 7.033},
        {10, 4.2584}, {20, 2.7147}, {50, 1.5743}, {100, 1.087},
        {150, 0.88917}, {200, 0.77563}, {250, 0.69974}, {300, 0.65272},
        {500, 0.55492}, {1000, 0.47109}, {1e4, 0.405}, {1e5, 0.502}
    };

    CHECK(drag->type() == "Clift");

    for (const auto& row : table)
    {
        INFO("Re " << row[0]);
        CHECK(Cd(drag(), row[0]) == Approx(row[1]).epsilon(1e-3));
    }

    CHECK(drag->K(0, 0) == 1);
}


TEST_CASE("Drag of Ergun: the pressure drop of a bed", "[drag]")
{
    const autoPtr<dragModel> drag(model("Ergun"));
    const scalar D = 0.003, nu = 1.5e-5, phi = 0.6, e = 0.4, W = 0.7;

    // Ergun (1952): over the density, for 6 phi/(pi D^3) spheres per volume
    const scalar drop =
        150*nu*sqr(phi)*W/(pow3(e)*sqr(D)) + 1.75*phi*sqr(W)/(pow3(e)*D);

    CHECK(18*nu*phi/sqr(D)*W*drag->K(W*D/nu, phi) == Approx(drop));
}


TEST_CASE("Drag of Gidaspow: Ergun, and Wen & Yu", "[drag]")
{
    const autoPtr<dragModel> drag(model("Gidaspow"));

    for (const scalar Re : {0., 10., 300., 2000.})
    {
        CHECK(drag->K(Re, 0.21) == model("Ergun")->K(Re, 0.21));
        CHECK
        (
            drag->K(Re, 0.1)
         == Approx
            (
                model("SchillerNaumann")->K(Re, 0)*Foam::pow(0.9, -4.65)
            )
        );
        CHECK(drag->K(Re, 0) == Approx(model("SchillerNaumann")->K(Re, 0)));
    }
}


TEST_CASE("Drag of Clift hardly jumps between its fits", "[drag]")
{
    const autoPtr<dragModel> drag(model("Clift"));

    for (const scalar Re : {0.01, 20., 260., 1500., 1.2e4, 4.4e4})
    {
        INFO("Re " << Re);
        CHECK(drag->K(1.0001*Re, 0)/drag->K(0.9999*Re, 0)
            == Approx(1).epsilon(0.01));
    }

    // The drag crisis
    CHECK(Cd(drag(), 5e5) < 0.3*Cd(drag(), 3e5));
}


TEST_CASE("Drag of Schiller & Naumann", "[drag]")
{
    const autoPtr<dragModel> drag(model("SchillerNaumann"));

    CHECK(Cd(drag(), 0.1) == Approx(247.4).epsilon(1e-4));
    CHECK(Cd(drag(), 10) == Approx(4.1511).epsilon(1e-4));
    CHECK(Cd(drag(), 500) == Approx(0.56267).epsilon(1e-4));
    CHECK(Cd(drag(), 5000) == Approx(0.44));
    CHECK(drag->K(0, 0) == 1);
}


TEST_CASE("Drag of Tenneti, Garg & Subramaniam", "[drag]")
{
    const autoPtr<dragModel> drag(model("Tenneti"));

    // phi, Re, K: the correlation, worked out separately
    const scalar table[][3] =
    {
        {0.1, 0.01, 2.517}, {0.1, 100, 7.4715}, {0.2, 10, 6.4096},
        {0.3, 300, 39.311}, {0.4, 0.01, 18.148}, {0.5, 50, 62.814}
    };

    for (const auto& row : table)
    {
        CHECK(drag->K(row[1], row[0]) == Approx(row[2]).epsilon(1e-4));
    }

    // A sphere alone
    CHECK(drag->K(50, 0) == Approx(model("SchillerNaumann")->K(50, 0)));
}


TEST_CASE("Drag of Di Felice", "[drag]")
{
    const autoPtr<dragModel> drag(model("DiFelice"));

    // A sphere alone: Dalla Valle
    CHECK(Cd(drag(), 100) == Approx(sqr(0.63 + 0.48)));
    CHECK(drag->K(0, 0) == Approx(0.96));

    // Exponents of Wen & Yu (1966) in both limits, and the least between
    auto exponent = [&](const scalar Re)
    {
        return -Foam::log(drag->K(Re, 0.4)/drag->K(Re, 0))/Foam::log(0.6);
    };

    CHECK(exponent(0) == Approx(4.7).epsilon(1e-3));
    CHECK(exponent(1e6) == Approx(4.7).epsilon(1e-3));
    CHECK(exponent(Foam::pow(10., 1.5)) == Approx(4.05));
}


TEST_CASE("Sphericity of shapes, and what it does to the drag", "[drag]")
{
    const geometricSpace space(-1);
    const sphericity cube(*shape("type box; size (2 2 2);", space));
    const sphericity sphere(*shape("type sphere; radius 2;", space));

    CHECK(sphere.value() == 1);
    CHECK(sphere.factor(100) == 1);
    CHECK(cube.value() == Approx(0.805996).epsilon(1e-5));

    // The fit for psi = 0.806, with its coefficients worked out separately:
    // A = 0.27645, B = 0.54494, C = 1.3521, D = 491.64
    CHECK(sphericity::K(100, 0.806)
        == Approx(1 + 0.27645*Foam::pow(100., 0.54494) + 1.3521e4/24/591.64)
           .epsilon(1e-3));

    // Their curve of a sphere is the standard one to 6 % at Re up to 1000
    const autoPtr<dragModel> drag(model("Clift"));

    for (const scalar Re : {0.1, 1., 10., 100., 1000.})
    {
        INFO("Re " << Re);
        CHECK(sphericity::K(Re, 1) == Approx(drag->K(Re, 0)).epsilon(0.06));
        CHECK(cube.factor(Re) > 1);
    }
}


TEST_CASE("Wrong drag models are refused", "[drag]")
{
    const std::string type = messageOf([]{ model("Clif"); });

    CHECK_THAT(type, Catch::Contains("'type Clif'"));
    CHECK_THAT(type, Catch::Contains("nearest valid one is 'Clift'"));
    CHECK_THAT(type, Catch::Contains("SchillerNaumann"));

    CHECK_THAT
    (
        messageOf([]{ dragModel::New(dict("typ Clift;")); }),
        Catch::Contains("'typ'")
    );
}
