// SPDX-License-Identifier: GPL-3.0-or-later

#include "cellSearch.H"
#include "lineRemap.H"
#include "poissonProblem.H"
#include "sweptRemap.H"
#include "testTools.H"

using namespace Foam;
using testTools::dict;

namespace
{

//- Boxes of unequal cells, on all ranks, and a field on them
class lineBox
{
    const Time time_;
    const std::unique_ptr<fvMesh> mesh_;
    const cellNeighbours neighbours_;
    autoPtr<lineRemap> lines_;
    sweptRemap plain_;
    labelList faces_;
    vectorField s_;

    static std::unique_ptr<fvMesh> makeMesh
    (
        const Time& time,
        const std::array<std::string, 3>& sides,
        const direction across,
        const unsigned seed
    )
    {
        testTools::boxMesh box;
        box.x = {{
            testTools::graded(17, 0.9, 1.05),
            testTools::graded(16, 1.3, 0.96),
            testTools::graded(sides[2] == "ee" ? 1 : 8, 1, 1.05)
        }};
        box.sides = sides;
        box.seed = seed;
        box.processor = testTools::processors(across, box);

        return box.make(time);
    }

    //- Some displacement of a face, the same seen from both sides
    static vector displacement(const point& x)
    {
        const scalar a = 2*constant::mathematical::pi;

        return 0.05*vector
        (
            Foam::sin(a*x.y()/1.3), Foam::cos(a*x.z()), Foam::sin(a*x.y()/1.3)
        );
    }

public:

    volVectorField y;

    lineBox
    (
        const std::array<std::string, 3>& sides,
        const direction across = 0,
        const unsigned seed = 0
    )
    :
        time_(dict("deltaT 1; writeFrequency 1;"), "/tmp", "none"),
        mesh_(makeMesh(time_, sides, across, seed)),
        neighbours_(*mesh_),
        plain_(*mesh_, neighbours_),
        faces_(identity(mesh_->nInternalFaces())),
        y
        (
            IOobject("y", "0", *mesh_),
            *mesh_,
            dimensionedVector(dimless, Zero)
        )
    {
        for (const polyPatch& patch : mesh_->boundaryMesh())
        {
            if (cellSearch::matched(patch))
            {
                faces_.append(patch.start() + identity(patch.size()));
            }
        }
        for (const label facei : faces_)
        {
            s_.append(displacement(mesh_->faceCentres()[facei]));
        }
        autoPtr<lineGrid> grid(new lineGrid(*mesh_));

        if (grid->valid())
        {
            lines_.reset(new lineRemap(std::move(grid)));
            lines_->setFaces(faces_);
        }
        plain_.setFaces(faces_);

        forAll(y, celli)
        {
            const point& x = mesh_->cellCentres()[celli];

            y[celli] = vector
            (
                Foam::sin(5*x.x() + 3*x.y() - 4*x.z()), x.y(), sqr(x.z())
            );
        }
        y.correctBoundaryConditions();
        y.boundaryFieldRef() *= 1.1;
    }

    bool hasLines() const
    {
        return lines_.valid();
    }

    //- Largest difference between both ways of moving y, and of the sums that
    //  they return
    scalar difference
    (
        const List<direction>& components,
        const bool smooth
    ) const
    {
        volVectorField one("one", y), other("other", y);
        one.boundaryFieldRef() = y.boundaryField();
        other.boundaryFieldRef() = y.boundaryField();

        const vectorField sum(lines_->move(s_, components, smooth, one));
        const vectorField reference
        (
            plain_.move(s_, components, smooth, other)
        );
        scalar most =
            gMax(mag(one.primitiveField() - other.primitiveField())());

        const labelUList cells(plain_.cells());
        scalarField differences(cells.size());

        forAll(cells, i)
        {
            // Of all cells
            differences[i] =
                mag(sum[cells[i]] - reference[i])/mesh_->V()[cells[i]];
        }

        return max(most, gMax(differences));
    }

    //- Largest difference between both gradients
    scalar gradients() const
    {
        const volScalarField z("z", y.component(0));
        const vectorField grad(lines_->gradients(z));
        const labelUList cells(plain_.wideCells());

        return gMax
        (
            mag(vectorField(grad, cells) - plain_.gradients(z))()
        );
    }
};

} // End anonymous namespace


TEST_CASE("Lines give what any mesh gives", "[lineRemap]")
{
    for (const direction across : {0, 1})
    {
        for
        (
            const std::array<std::string, 3>& sides
          : std::vector<std::array<std::string, 3>>
            {
                {{"zz", "ff", "zz"}}, {{"cc", "cc", "cc"}}, {{"zz", "cc", "zf"}}
            }
        )
        {
            const lineBox box(sides, across);

            CHECK(box.hasLines());

            for
            (
                const List<direction>& components
              : List<List<direction>>{{0}, {2}, {0, 1}, {2, 0, 1}}
            )
            {
                CHECK(box.difference(components, true) < 1e-12);
                CHECK(box.difference(components, false) < 1e-12);
            }
            CHECK(box.gradients() < 1e-12);
        }
    }
}


TEST_CASE("In two dimensions too", "[lineRemap]")
{
    const lineBox box(std::array<std::string, 3>{{"cc", "zf", "ee"}});

    CHECK(box.hasLines());
    CHECK(box.difference({0, 1}, true) < 1e-12);
}


TEST_CASE("No lines if cells are numbered in another way", "[lineRemap]")
{
    const std::array<std::string, 3> walls{{"zz", "zz", "zz"}};

    CHECK(!lineBox(walls, 0, 1).hasLines());
}
