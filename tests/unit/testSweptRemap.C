// SPDX-License-Identifier: GPL-3.0-or-later

#include "boxMesh.H"
#include "sweptRemap.H"
#include "testTools.H"

using namespace Foam;
using testTools::dict;

namespace
{

const scalar h = 0.1;

//- Square cells of a square, on all ranks; all faces of which are displaced
class square
{
    const Time time_;
    const std::unique_ptr<fvMesh> mesh_;
    const cellNeighbours neighbours_;
    sweptRemap remap_;
    labelList faces_;

    static std::unique_ptr<fvMesh> makeMesh(const Time& time)
    {
        testTools::boxMesh box;
        box.x = {{
            testTools::graded(20, 20*h, 1),
            testTools::graded(20, 20*h, 1),
            testTools::graded(1, h, 1)
        }};
        box.sides = {{"zz", "zz", "ee"}};
        box.processor = [](const labelVector& i)
        {
            return Pstream::parRun() && i.x() > 9 ? 1 : 0;
        };

        return box.make(time);
    }

public:

    volScalarField y;

    square()
    :
        time_(dict("deltaT 1; writeFrequency 1;"), "/tmp", "none"),
        mesh_(makeMesh(time_)),
        neighbours_(*mesh_),
        remap_(*mesh_, neighbours_),
        faces_(identity(mesh_->nInternalFaces())),
        y
        (
            IOobject("y", "0", *mesh_),
            *mesh_,
            dimensionedScalar(dimless, Zero)
        )
    {
        for (const polyPatch& patch : mesh_->boundaryMesh())
        {
            if (patch.coupled())
            {
                faces_.append(patch.start() + identity(patch.size()));
            }
        }
        remap_.setFaces(faces_);
    }

    const fvMesh& mesh() const
    {
        return *mesh_;
    }

    template<class Function>
    void set(const Function& f)
    {
        forAll(y, celli)
        {
            y[celli] = f(mesh().C()[celli]);
        }
        y.correctBoundaryConditions();
    }

    //- Move y; what has left the cells, in all
    scalar move(const vector& s)
    {
        const scalarField sum
        (
            remap_.move(vectorField(faces_.size(), s), {0, 1}, true, y)
        );

        return gSum(sum);
    }

    //- Largest difference from a function, far from the patches
    template<class Function>
    scalar error(const Function& f) const
    {
        scalar largest = 0;

        forAll(y, celli)
        {
            const point& x = mesh().C()[celli];
            const scalar toPatch = min
            (
                min(x.x(), 20*h - x.x()), min(x.y(), 20*h - x.y())
            );

            if (toPatch > 6*h)
            {
                largest = max(largest, mag(y[celli] - f(x)));
            }
        }

        return returnReduce(largest, maxOp<scalar>());
    }
};


//- A wave of so many radians per cell in each direction
struct wave
{
    const vector k;

    scalar operator()(const point& x) const
    {
        return Foam::cos((k & x)/h);
    }
};


//- Error of a move along the mesh, or obliquely, of a wave
scalar errorOf(const vector& s, const vector& k)
{
    square p;
    const wave f{k};

    p.set(f);
    p.move(s);

    return p.error([&](const point& x) { return f(x - s); });
}

} // End anonymous namespace


TEST_CASE("Of sixth order along the mesh, in all parts of a cell", "[remap]")
{
    for (const scalar m : {-0.7, 0.1, 0.3, 0.5})
    {
        const vector s(m*h, 0, 0);
        const scalar coarse = errorOf(s, {0.6, 0, 0});
        const scalar fine = errorOf(s, {0.3, 0, 0});

        // 128 for the sixth order of a rate, in one step
        CHECK(coarse/fine > 100);
        CHECK(coarse < 4e-4);
    }
}


TEST_CASE("Cross derivatives are no worse", "[remap]")
{
    const vector s(0.4*h, 0.3*h, 0);
    const scalar coarse = errorOf(s, {0.5, 0.5, 0});
    const scalar fine = errorOf(s, {0.25, 0.25, 0});

    CHECK(coarse/fine > 100);
    CHECK(coarse < 4e-4);
}


TEST_CASE("What leaves a cell enters another", "[remap]")
{
    square p;

    p.set(wave{{1.1, 0.7, 0}});

    CHECK(mag(p.move({0.3*h, -0.2*h, 0})) < 1e-14);
}


TEST_CASE("Constants stay, in cells at patches too", "[remap]")
{
    square p;
    const auto constant = [](const point&) { return 3.; };

    p.set(constant);
    p.y.boundaryFieldRef() == 3;
    p.move({0.3*h, -0.2*h, 0});

    forAll(p.y, celli)
    {
        CHECK(mag(p.y[celli] - 3) < 1e-13);
    }
}
