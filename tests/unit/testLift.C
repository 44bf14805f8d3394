// SPDX-License-Identifier: GPL-3.0-or-later

#include "testTools.H"
#include "liftModel.H"
#include "mathematicalConstants.H"
#include "unresolvedMotion.H"

using namespace Foam;
using constant::mathematical::pi;
using testTools::dict;
using testTools::difference;
using testTools::messageOf;
using testTools::shape;


namespace
{

PtrList<liftModel> models(const std::string& type)
{
    return liftModel::New(dict("lift { type " + type + "; }"));
}


//- Lift on a sphere, D 0.01 m, nu 1e-3 m2/s, with the slip W along x in a flow
//  along x that grows with y
vector shearLift(const scalar W, const scalar shear)
{
    const vector vorticity(0, 0, -shear);

    return models("SaffmanMei")[0].force
    (
        vector(W, 0, 0), vorticity, vector::zero, 0.01, 1e-3
    );
}

} // End anonymous namespace


TEST_CASE("Lift of Saffman where inertia is small", "[lift]")
{
    // Re 1e-6, Re_w 1e-2: towards the faster flow if it lags
    const scalar W = 1e-7, shear = 0.1;
    const vector F(shearLift(W, shear));
    const scalar saffman = 1.615*sqr(0.01)*Foam::sqrt(1e-3*shear)*W;

    CHECK(F.y()/saffman == Approx(1).epsilon(1e-5));
    CHECK(F.x() == 0);
    CHECK(F.z() == 0);
    CHECK(shearLift(-W, shear).y() == Approx(-F.y()));
    CHECK(shearLift(W, -shear).y() == Approx(-F.y()));
    CHECK(shearLift(0, shear) == vector::zero);
    CHECK(shearLift(W, 0) == vector::zero);
}


TEST_CASE("Lift of Mei at finite Reynolds number", "[lift]")
{
    for (const scalar Re : {0.5, 5., 39., 41., 100.})
    {
        for (const scalar b : {0.01, 0.1, 0.4})
        {
            INFO("Re " << Re << " b " << b);

            const scalar W = Re*0.1, shear = 2*b*W/0.01;
            const scalar saffman =
                1.615*0.01*0.01*Foam::sqrt(1e-3*shear)*W;
            const scalar mei = Re <= 40
              ? (1 - 0.3314*Foam::sqrt(b))*Foam::exp(-Re/10)
              + 0.3314*Foam::sqrt(b)
              : 0.0524*Foam::sqrt(b*Re);

            CHECK(shearLift(W, shear).y()
                == Approx(saffman*mei).epsilon(1e-12));
        }
    }
}


TEST_CASE("Magnus force: with the spin, less the fluid's", "[lift]")
{
    const PtrList<liftModel> both(models("(RubinowKeller OesterleBuiDinh)"));
    const vector W(-2, 0, 0), omega(0, 0, 30);
    const scalar D = 0.01;

    REQUIRE(both.size() == 2);

    // A ball that flies to x with backspin goes up
    const vector F(both[0].force(W, vector::zero, omega, D, 1e-3));
    CHECK(difference(F, vector(0, pi/8*1e-6*30*2, 0)) < 1e-18);

    // That turns as the fluid does
    for (const liftModel& lift : both)
    {
        CHECK(mag(lift.force(W, 2*omega, omega, D, 1e-3)) < 1e-18);
        CHECK(mag(lift.force(vector::zero, W, omega, D, 1e-3)) == 0);
    }

    // The same at low Re; coefficient 0.45 at high Re
    CHECK(difference
    (
        both[1].force(W, vector::zero, omega, D, 1e8),
        both[0].force(W, vector::zero, omega, D, 1e8)
    ) < 1e-3*mag(F));
    CHECK(both[1].force(W, vector::zero, 100*omega, D, 1e-9).y()
        == Approx(pi/8*1e-4*0.45*4).epsilon(1e-6));

    // Never more than at low Re
    CHECK(both[1].force(W, vector::zero, 0.1*omega, D, 1e-5).y()
        == Approx(0.1*F.y()));

    // Crowe's form of it: s the spin parameter
    const scalar Re = 20, s = 0.5*D*3000/2;
    CHECK(both[1].force(W, vector::zero, 100*omega, D, 1e-3).y()
        == Approx
        (
            pi/8*1e-4*4
           *(
                0.45
              + (2*s - 0.45)
               *Foam::exp(-0.075*Foam::pow(s, 0.4)*Foam::pow(Re, 0.7))
            )
        ).epsilon(1e-4));
}


TEST_CASE("Lift acts on an unresolved grain, and back", "[lift]")
{
    // In a shear flow, held: nothing but drag and lift
    immersedBody body
    (
        "grain",
        std::make_shared<const bodyKind>
        (
            dict("motion { type fixed; }"),
            shape("type sphere; radius 0.05;", geometricSpace(-1)),
            geometricSpace(-1),
            -1
        ),
        point::zero
    );
    body.status().setResolved(false);

    const tensor grad(0, 0, 0, 2, 0, 0, 0, 0, 0);
    const scalar nu = 0.1;
    fluidSample fluid;

    // A kernel so wide that the grain does not disturb its mean
    for (label i = 0; i < 27; ++i)
    {
        const vector r(i % 3 - 1, (i/3) % 3 - 1, i/9 - 1);

        fluid.add(1.0/27, r, vector(3, 0, 0) + (r & grad), vector::zero);
        fluid.addScalars(1.0/27, nu, nu, 1e-30, 0, 0);
    }

    const ddtCoefficients ddt("Euler", 1, 1);
    const autoPtr<dragModel> drag(dragModel::New(dict("")));
    const autoPtr<shapeModel> form(shapeModel::New(dict(""), body.shape()));
    const PtrList<liftModel> lifts(models("SaffmanMei"));

    auto load = [&](const PtrList<liftModel>& with)
    {
        return unresolvedMotion
        (
            drag(), fluid, body, form(), ddt, vector::zero, vector::zero,
            vector::zero, with
        ).load(body, ddt).force;
    };

    const vector expected
    (
        lifts[0].force
        (
            vector(3, 0, 0), vector(0, 0, -2), vector::zero, 0.1, nu
        )
    );
    const vector change(load(lifts) - load(PtrList<liftModel>()));

    CHECK(expected.y() > 0);
    CHECK(difference(change, -expected) < 1e-8*mag(expected));
}


TEST_CASE("Wrong lift is refused", "[lift]")
{
    CHECK(liftModel::New(dict("")).empty());
    CHECK(models("none").empty());
    CHECK(messageOf([]{ models("SaffmanMay"); }).find("SaffmanMei")
        != std::string::npos);
    CHECK(messageOf([]{ models("(SaffmanMei SaffmanMei)"); }).find("twice")
        != std::string::npos);
    CHECK(messageOf
    (
        []{ liftModel::New(dict("lift { typ none; }")); }
    ).find("type") != std::string::npos);
}
