// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyTools.H"
#include "boxMesh.H"
#include "comovingDerivative.H"

using namespace Foam;
using testTools::dict;

namespace
{

const scalar h = 0.08, bandWidth = 3.2;

//- Distance in cells from the surface up to which all that a cell depends on
//  moves with the body: cells four away, where its frame has not faded yet
const scalar inside = -1;


//- A sphere in a box, after two time steps with one velocity, on all ranks
class towedSphere
{
    const Time time_;
    const std::unique_ptr<fvMesh> mesh_;
    const cellSearch search_;
    const cellNeighbours neighbours_;
    bodyList bodies_;
    PtrList<bodyRegion> regions_;

    static std::unique_ptr<fvMesh> makeMesh(const Time& time)
    {
        testTools::boxMesh box;
        box.x = {{
            testTools::graded(27, 27*h, 1),
            testTools::graded(24, 24*h, 1),
            testTools::graded(24, 24*h, 1)
        }};
        box.sides = {{"zz", "zz", "zz"}};
        box.processor = [](const labelVector& i)
        {
            return Pstream::parRun() && i.x() > 13 ? 1 : 0;
        };

        return box.make(time);
    }

public:

    comovingDerivative frame;
    volVectorField U;

    //- nu: viscosity [m2/s]; by default so low that the frame moves along
    towedSphere
    (
        const vector& move,
        const word& scheme,
        const scalar nu = 1e-6
    )
    :
        time_(dict("deltaT 1; writeFrequency 1;"), "/tmp", "none"),
        mesh_(makeMesh(time_)),
        search_(*mesh_, bodyTools::space),
        neighbours_(*mesh_),
        bodies_(PtrList<immersedBody>()),
        regions_(1),
        frame(*mesh_, neighbours_),
        U
        (
            IOobject("U", "0", *mesh_),
            *mesh_,
            dimensionedVector(dimVelocity, Zero)
        )
    {
        const immersedBody sphere
        (
            bodyTools::makeBody
            (
                "densityRatio 1; velocity (" + name(move.x()) + ' '
              + name(move.y()) + ' ' + name(move.z()) + ");",
                bodyTools::space, 1, point(1.1, 0.97, 1.03)
            )
        );

        bodies_.append(autoPtr<immersedBody>(new immersedBody(sphere)));
        regions_.set(0, new bodyRegion(0));

        // Time steps of one second
        for (int step = 0; step < 2; ++step)
        {
            bodies_[0].beginStep();
            bodies_[0].predictPose(1);
        }
        regions_[0].update(bodies_[0], search_, bandWidth);
        frame.update
        (
            regions_, bodies_, search_, scalarList(1, h), bandWidth,
            periodicity(), nu, ddtCoefficients(scheme, 1, 1)
        );
    }

    const fvMesh& mesh() const
    {
        return *mesh_;
    }

    //- Set the velocities at the last two times to functions of place
    template<class F0, class F00>
    void setOld(const F0& f0, const F00& f00)
    {
        volVectorField& U0 = U.oldTime();
        volVectorField& U00 = U0.oldTime();

        forAll(mesh().C(), celli)
        {
            U0.primitiveFieldRef()[celli] = f0(mesh().C()[celli]);
            U00.primitiveFieldRef()[celli] = f00(mesh().C()[celli]);
        }
    }

    //- What old times add [m/s2]
    vectorField added() const
    {
        vectorField source(mesh().nCells(), Zero);
        frame.addOldTimes(U, source);

        return source/mesh().V();
    }

    //- Does all of a cell move with the sphere
    bool moves(const label celli) const
    {
        return bodies_[0].posed().distance(mesh().C()[celli]) < inside*h;
    }
};


//- Something that no difference scheme is exact for
vector rough(const point& x)
{
    return vector
    (
        Foam::sin(17*x.x() + 5*x.y()), Foam::cos(23*x.y() - x.z()), x.x()*x.z()
    );
}

} // End anonymous namespace


TEST_CASE("A linear profile that moves with a body is steady to it", "[frame]")
{
    const vector V(0.3*h, -0.2*h, 0.1*h);
    const tensor G(1, 2, -3, 0.5, -1, 4, 2, 1, 0.3);
    const vector far(7, -3, 2);
    const auto profile = [&](const point& x) { return (x & G) + far; };
    towedSphere sphere(V, "backward");

    sphere.setOld
    (
        [&](const point& x) { return profile(x + V); },
        [&](const point& x) { return profile(x + 2*V); }
    );

    const ddtCoefficients ddt("backward", 1, 1);
    const vectorField added(sphere.added());
    const vectorField& U0 = sphere.U.oldTime();
    const vectorField& U00 = sphere.U.oldTime().oldTime();
    label n = 0;

    forAll(added, celli)
    {
        if (sphere.moves(celli))
        {
            const vector now(profile(sphere.mesh().C()[celli]));
            const vector rate
            (
                ddt.c*now - ddt.c0*U0[celli] + ddt.c00*U00[celli]
              - added[celli]
            );

            // Differences of high order reach the fade, with small factors
            CHECK(mag(rate) < 1e-5*mag(V & G));
            ++n;
        }
    }
    CHECK(returnReduce(n, sumOp<label>()) > 100);
}


TEST_CASE("To move by one cell along the mesh is exact", "[frame]")
{
    towedSphere sphere({0, h, 0}, "Euler");
    sphere.setOld(rough, rough);

    const vectorField added(sphere.added());

    forAll(added, celli)
    {
        if (sphere.moves(celli))
        {
            const point& x = sphere.mesh().C()[celli];
            const vector change(rough(x - vector(0, h, 0)) - rough(x));

            CHECK(testTools::difference(added[celli], change) < 1e-12);
        }
    }
}


TEST_CASE("The frame conserves momentum", "[frame]")
{
    towedSphere sphere({0.4*h, 0.3*h, -0.1*h}, "backward");
    sphere.setOld(rough, [](const point& x) { return 2*rough(2*x); });

    const vectorField added(sphere.added()*sphere.mesh().V());

    CHECK(mag(gSum(added)) < 1e-13*gSum(mag(added)));
    CHECK(gSum(mag(added)) > 1e-3);
}


TEST_CASE("The flux of the frame is taken off and given back", "[frame]")
{
    const vector V(0.3*h, -0.2*h, 0.1*h);
    towedSphere sphere(V, "backward");
    const fvMesh& mesh = sphere.mesh();
    surfaceScalarField phi
    (
        IOobject("phi", "0", mesh),
        dimensionedVector("V", dimVelocity, V) & mesh.Sf()
    );
    const scalarField before(phi);

    sphere.frame.removeFlux(phi);

    forAll(phi, facei)
    {
        if
        (
            sphere.moves(mesh.owner()[facei])
         && sphere.moves(mesh.neighbour()[facei])
        )
        {
            CHECK(mag(phi[facei]) < 1e-15);
        }
    }

    sphere.frame.restoreFlux(phi);
    CHECK((before == phi.primitiveField()));
}


TEST_CASE("Pressure goes along, and its gradient", "[frame]")
{
    const vector V(0.3*h, -0.2*h, 0.1*h), g(2, 3, -1);
    towedSphere sphere(V, "backward");
    const fvMesh& mesh = sphere.mesh();
    volScalarField p
    (
        IOobject("p", "0", mesh), mesh, dimensionedScalar(dimless, Zero)
    );
    volVectorField gradP
    (
        IOobject("gradP", "0", mesh), mesh, dimensionedVector(dimless, Zero)
    );

    p.primitiveFieldRef() = mesh.C().primitiveField() & g;
    p.correctBoundaryConditions();
    sphere.frame.follow(0.5, p, gradP);

    forAll(p, celli)
    {
        if (sphere.moves(celli))
        {
            const scalar moved = (mesh.C()[celli] - 0.5*V) & g;

            CHECK(p[celli] == testTools::near(moved));
            CHECK(mag(gradP[celli] - g) < 0.2);
        }
    }
}


TEST_CASE("Of a body at rest there is no frame", "[frame]")
{
    CHECK(!towedSphere(vector::zero, "backward").frame.active());
    CHECK(towedSphere({0.1*h, 0, 0}, "backward").frame.active());
}


TEST_CASE("A slow body has no frame, a faster one a part of it", "[frame]")
{
    // Cell Reynolds number, and the part
    const std::vector<std::pair<scalar, scalar>> parts
    {
        {0.09, 0}, {0.11, 0.01/0.15}, {0.175, 0.5}, {0.26, 1}
    };
    const vector V(0.2*h, 0, 0);

    for (const auto& part : parts)
    {
        towedSphere sphere(V, "Euler", V.x()*h/part.first);
        surfaceScalarField phi
        (
            "phi",
            sphere.mesh().magSf()
           *dimensionedScalar(dimVelocity, Zero)
        );
        scalar largest = 0;

        INFO("V h/nu = " << part.first);
        CHECK(sphere.frame.active() == (part.second > 0));

        sphere.frame.removeFlux(phi);
        forAll(phi, facei)
        {
            largest =
                max(largest, mag(phi[facei])/sphere.mesh().magSf()[facei]);
        }
        reduce(largest, maxOp<scalar>());

        CHECK(largest == Approx(part.second*V.x()).margin(1e-12));
    }
}
