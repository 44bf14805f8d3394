// SPDX-License-Identifier: GPL-3.0-or-later

#include "testTools.H"
#include "boxMesh.H"
#include "boxSolverCache.H"
#include "gaussLaplacianScheme.H"
#include "surfaceFields.H"
#include "volFields.H"

using namespace Foam;
using testTools::boxMesh;
using testTools::dict;
using testTools::graded;
using testTools::RandomNumbers;

namespace
{

const std::vector<std::string> allSides = {"zz", "ff", "zf", "fz", "cc"};


//- Mesh with a field p, and an equation for it with a known solution
class problem
{
    Time time_;
    std::unique_ptr<fvMesh> mesh_;

public:

    volScalarField p;
    scalarField exact;
    const bool singular;
    solverPerformance performance;


    explicit problem(const boxMesh& box)
    :
        time_(dict("deltaT 1; writeFrequency 1;"), "/tmp", "none"),
        mesh_(box.make(time_)),
        p
        (
            IOobject("p", time_.timeName(), *mesh_),
            *mesh_,
            dimensionedScalar(dimless, Zero),
            box.conditions(*mesh_)
        ),
        exact(mesh_->nCells()),
        singular
        (
            (box.sides[0] + box.sides[1] + box.sides[2]).find('f')
         == std::string::npos
        )
    {
        RandomNumbers random(1 + Pstream::myProcNo());

        for (scalar& value : exact)
        {
            value = random.number();
        }

        setBoundary(0.7);
    }


    fvMesh& mesh()
    {
        return *mesh_;
    }


    void setBoundary(const scalar value)
    {
        forAll(p.boundaryField(), patchi)
        {
            if (p.boundaryField()[patchi].fixesValue())
            {
                p.boundaryFieldRef()[patchi] == value;
            }
        }
    }


    //- Its residual. That of fvMatrix counts coupled patches twice.
    tmp<scalarField> residual(const fvScalarMatrix& eqn) const
    {
        tmp<scalarField> result(eqn.residual());

        forAll(p.boundaryField(), patchi)
        {
            const fvPatchScalarField& side = p.boundaryField()[patchi];

            if (side.coupled())
            {
                const scalarField twice
                (
                    eqn.boundaryCoeffs()[patchi]*side.patchNeighbourField()
                );
                forAll(twice, i)
                {
                    result.ref()[side.patch().faceCells()[i]] -= twice[i];
                }
            }
        }

        return result;
    }


    //- The equation with coefficient tau, solved by exact
    tmp<fvScalarMatrix> equation(const scalarField& tau)
    {
        const surfaceScalarField gamma
        (
            IOobject("gamma", time_.timeName(), *mesh_),
            *mesh_,
            dimensionedScalar(dimless, Zero)
        );
        surfaceScalarField gammaMagSf(gamma*mesh_->magSf());
        gammaMagSf.primitiveFieldRef() =
            mesh_->magSf().primitiveField()
           *SubField<scalar>(tau, mesh_->nInternalFaces());

        forAll(gammaMagSf.boundaryField(), patchi)
        {
            gammaMagSf.boundaryFieldRef()[patchi] ==
                tau.last()*mesh_->magSf().boundaryField()[patchi];
        }

        tmp<fvScalarMatrix> eqn
        (
            fv::gaussLaplacianScheme<scalar, scalar>
            ::fvmLaplacianUncorrected
            (
                gammaMagSf, mesh_->nonOrthDeltaCoeffs(), p
            )
        );
        p.primitiveFieldRef() = exact;
        p.correctBoundaryConditions();
        eqn.ref().source() -= residual(eqn());

        return eqn;
    }


    tmp<fvScalarMatrix> equation(const scalar tau)
    {
        return equation(scalarField(mesh_->nInternalFaces() + 1, tau));
    }


    //- Solve from 0; largest error, without a constant if that is open
    scalar solve
    (
        fvScalarMatrix& eqn,
        const bool levelOpen,
        const std::string& controls = "solver fastPoisson; tolerance 1e-10;"
    )
    {
        p = dimensionedScalar(dimless, Zero);
        performance = eqn.solve(dict(controls));

        const scalarField difference(p.primitiveField() - exact);
        const scalar level = levelOpen ? gAverage(difference) : 0;

        return gMax(mag(difference - level)());
    }


    //- What is kept for p
    std::string description()
    {
        const boxSolver* solver = boxSolverCache::New(*mesh_).find("p");
        return solver ? solver->description() : "";
    }
};


//- Ways to give the cells to processors
std::function<label(const labelVector&)> processors
(
    const label way,
    const boxMesh& box
)
{
    const label n = Pstream::nProcs();

    if (way < 3)
    {
        const label cells = box.n(way);
        return [=](const labelVector& i){ return i[way]*n/cells; };
    }

    return [=](const labelVector& i)
    {
        return (7*i[0] + 5*i[1] + 3*i[2] + i[0]*i[1]) % n;
    };
}


//- A box with the given sides; stretched in direction d if stretch has bit d
boxMesh makeBox
(
    const std::array<label, 3>& n,
    const std::array<std::string, 3>& sides,
    const label stretch
)
{
    boxMesh box;
    box.sides = sides;

    for (label d = 0; d < 3; ++d)
    {
        box.x[d] = graded(n[d], 1 + d, (stretch >> d) & 1 ? 1.1 : 1);
    }

    return box;
}


//- Solve on the box; with and without the reference if singular
void checkBox(const boxMesh& box)
{
    CAPTURE(box.sides, box.seed, box.n(0), box.n(1), box.n(2));
    problem made(box);
    tmp<fvScalarMatrix> eqn(made.equation(2.5));

    CHECK(made.solve(eqn.ref(), made.singular) < 1e-10);
    CHECK(made.performance.nIterations() == 1);
    CHECK(made.performance.finalResidual() < 1e-11);
    CHECK(made.description() != "");

    if (made.singular)
    {
        const label celli = made.mesh().nCells()/2;
        eqn.ref().setReference
        (
            Pstream::master() ? celli : -1,
            Pstream::master() ? made.exact[celli] : 0
        );
        CHECK(made.solve(eqn.ref(), false) < 1e-9);
        CHECK(made.performance.solverName() == "fastPoisson");
        CHECK(made.performance.finalResidual() < 1e-11);
    }
}

} // End anonymous namespace


TEST_CASE("All sides and spacings in 2D are solved directly", "[fastPoisson]")
{
    const std::string x = GENERATE(from_range(allSides));
    const std::string y = GENERATE(from_range(allSides));
    const label way = GENERATE(0, 1, 3);

    for (label stretch = 0; stretch < 4; ++stretch)
    {
        boxMesh box(makeBox({9, 7, 1}, {x, y, "zz"}, stretch));
        box.seed = stretch;
        box.processor = processors(way, box);
        checkBox(box);
    }
}


TEST_CASE("All sides in 3D are solved directly", "[fastPoisson]")
{
    const std::string x = GENERATE(from_range(allSides));
    const std::string y = GENERATE(from_range(allSides));
    const std::string z = GENERATE(from_range(allSides));

    static label n = 0;
    ++n;
    boxMesh box(makeBox({4, 5, 6}, {x, y, z}, n % 8));
    box.seed = n;
    box.processor = processors(n % 4, box);
    checkBox(box);
}


TEST_CASE("Long directions with equal cells are transformed", "[fastPoisson]")
{
    const std::string x = GENERATE(from_range(allSides));
    const std::string y = GENERATE(from_range(allSides));

    boxMesh box(makeBox({70, 66, 1}, {x, y, "zz"}, 1));
    box.processor = processors(0, box);
    checkBox(box);

    problem made(box);
    made.solve(made.equation(1).ref(), made.singular);
    CHECK(made.description().find("transform in y") != std::string::npos);
}
