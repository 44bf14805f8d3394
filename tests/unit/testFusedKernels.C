// SPDX-License-Identifier: GPL-3.0-or-later

#include "boxMesh.H"
#include "fusedKernels.H"
#include "linearTransport.H"
#include "poissonProblem.H"
#include "smoothedFlux.H"
#include "vectorSmoothSolver.H"
#include "fvmDiv.H"
#include "fvmLaplacian.H"
#include "linear.H"
#include "OSspecific.H"

using namespace Foam;
using testTools::dict;

namespace
{

//- Folder of a case with system/fvSchemes, as long as this is there
class schemesCase
{
public:

    const fileName folder;

    explicit schemesCase(const std::string& snGrad)
    :
        folder("/tmp/grainFoamUnitTests." + Foam::name(label(pid())))
    {
        mkDir(folder/"system");

        std::ofstream(folder/"system"/"fvSchemes")
            << "FoamFile { version 2.0; format ascii; class dictionary;"
            << " object fvSchemes; }\n"
            << "divSchemes { default Gauss linear; }\n"
            << "laplacianSchemes { default Gauss linear " << snGrad << "; }\n"
            << "interpolationSchemes { default linear; }\n"
            << "gradSchemes { default Gauss linear; }\n"
            << "snGradSchemes { default " << snGrad << "; }\n";
    }

    ~schemesCase()
    {
        rmDir(folder);
    }
};


//- Read the schemes of a mesh that is not read itself
void readSchemes(fvMesh& mesh)
{
    #if OPENFOAM < 2212
    mesh.fvSchemes::readOpt() = IOobject::MUST_READ;
    #else
    mesh.fvSchemes::readOpt(IOobject::MUST_READ);
    #endif
    mesh.fvSchemes::read();
}


//- The plain forms, as long as this is there
struct plainForms
{
    plainForms()
    {
        fusedKernels::active = 0;
    }

    ~plainForms()
    {
        fusedKernels::active = 1;
    }
};


//- A box with all kinds of sides, of which none is at a right angle, with
//  random fields, on all processors
struct randomFlow
{
    schemesCase files;
    Time time;
    std::unique_ptr<fvMesh> mesh;
    testTools::RandomNumbers random;
    volScalarField p, tau;
    volVectorField U, gradP;
    surfaceScalarField phi;

    explicit randomFlow(const std::string& snGrad)
    :
        files(snGrad),
        time
        (
            dict("deltaT 1; writeFrequency 1;"),
            files.folder.path(),
            files.folder.name()
        ),
        random(1 + Pstream::myProcNo()),
        p(make<scalar>("p", sqr(dimVelocity))),
        tau(make<scalar>("tau", dimTime)),
        U(make<vector>("U", dimVelocity)),
        gradP(make<vector>("gradP", dimAcceleration)),
        phi("phi", linearInterpolate(U) & mesh->Sf())
    {}

    scalar number()
    {
        return random.number();
    }

    void draw(scalar& value)
    {
        value = number();
    }

    void draw(vector& value)
    {
        value = vector(number(), number(), number());
    }

    template<class Type>
    GeometricField<Type, fvPatchField, volMesh> make
    (
        const word& name,
        const dimensionSet& dimensions
    )
    {
        testTools::boxMesh box;

        box.x = {{
            testTools::graded(7, 3, 1.2),
            testTools::graded(6, 2, 0.8),
            testTools::graded(4, 1, 1)
        }};
        box.sides = {{"zz", "fz", "cc"}};
        box.seed = 3;
        box.shear = 0.4;
        box.processor = testTools::processors(1, box);

        if (!mesh)
        {
            mesh = box.make(time);
            readSchemes(*mesh);
        }

        GeometricField<Type, fvPatchField, volMesh> field
        (
            IOobject(name, "0", *mesh),
            *mesh,
            dimensioned<Type>(dimensions, Zero),
            box.conditions(*mesh)
        );

        for (Type& value : field.primitiveFieldRef())
        {
            draw(value);
        }
        field.correctBoundaryConditions();

        return field;
    }
};


//- Largest difference of two fields on the faces of a mesh, on this processor
scalar difference(const surfaceScalarField& a, const surfaceScalarField& b)
{
    scalar largest = max(mag(a.primitiveField() - b.primitiveField()));

    forAll(a.boundaryField(), patchi)
    {
        forAll(a.boundaryField()[patchi], i)
        {
            largest = max
            (
                largest,
                mag
                (
                    a.boundaryField()[patchi][i] - b.boundaryField()[patchi][i]
                )
            );
        }
    }

    return largest;
}


//- Largest difference of the coefficients of two matrices
scalar difference(const fvVectorMatrix& a, const fvVectorMatrix& b)
{
    scalar largest = max
    (
        max(mag(a.diag() - b.diag())),
        max(max(mag(a.upper() - b.upper())), max(mag(a.lower() - b.lower())))
    );

    forAll(a.internalCoeffs(), patchi)
    {
        forAll(a.internalCoeffs()[patchi], i)
        {
            largest = max
            (
                largest,
                mag
                (
                    a.internalCoeffs()[patchi][i]
                  - b.internalCoeffs()[patchi][i]
                )
              + mag
                (
                    a.boundaryCoeffs()[patchi][i]
                  - b.boundaryCoeffs()[patchi][i]
                )
            );
        }
    }

    return largest;
}

} // End anonymous namespace


TEST_CASE("The smoothed flux is that of fields", "[fusedKernels]")
{
    for (const std::string snGrad : {"corrected", "uncorrected"})
    {
        randomFlow flow(snGrad);
        const smoothedFlux flux(flow.U, flow.p, flow.gradP, flow.tau);
        surfaceScalarField fused(0*flow.phi), plain(0*flow.phi);

        flux.set(fused);
        {
            const plainForms off;
            flux.set(plain);
        }
        CHECK(gMax(mag(plain.primitiveField())()) > 0.1);
        CHECK(difference(fused, plain) < 1e-13);

        // Some of the faces, and the others stay
        const label n = flow.mesh->nFaces()/2;
        surfaceScalarField some(0*flow.phi), somePlain(0*flow.phi);
        labelList faces(n);

        forAll(faces, i)
        {
            faces[i] = 2*i;
        }
        flux.set(faces, some);
        {
            const plainForms off;
            flux.set(faces, somePlain);
        }
        CHECK(difference(some, somePlain) < 1e-13);
        CHECK(some[1] == 0);
        CHECK(some[2] == fused[2]);
    }
}


TEST_CASE("Linear transport is that of OpenFOAM", "[fusedKernels]")
{
    randomFlow flow("orthogonal");
    const scalar nu = 0.3;
    const volScalarField nuField
    (
        IOobject("nu", "0", *flow.mesh),
        *flow.mesh,
        dimensionedScalar("nu", dimViscosity, nu)
    );
    const fvVectorMatrix plain
    (
        fvm::div(flow.phi, flow.U) - fvm::laplacian(nuField, flow.U)
    );
    const linearTransport kernel(flow.U, "div(phi,U)", "laplacian(nu,U)");
    fvVectorMatrix fused(flow.U, plain.dimensions());

    fused.diag() = 0;
    REQUIRE(kernel.serves());
    kernel.add(&flow.phi, nu, fused);
    CHECK(difference(fused, plain) < 1e-13);

    const plainForms off;
    CHECK(!linearTransport(flow.U, "div(phi,U)", "laplacian(nu,U)").serves());
}


TEST_CASE("Sweeps over components at once are those of each", "[fusedKernels]")
{
    randomFlow flow("orthogonal");
    const dimensionedScalar nu("nu", dimViscosity, 0.3);
    fvVectorMatrix eqn
    (
        fvm::div(flow.phi, flow.U) - fvm::laplacian(nu, flow.U)
    );
    const dictionary controls
    (
        dict
        (
            "solver smoothSolver; smoother symGaussSeidel; tolerance 0;"
            " relTol 0; maxIter 3; minIter 3;"
        )
    );

    eqn.diag() += 3;
    eqn.source() = flow.gradP.primitiveField();

    volVectorField start("start", flow.U);
    REQUIRE(vectorSmoothSolver::serves(controls));
    vectorSmoothSolver(eqn, flow.U).solve(controls);

    const vectorField fused(flow.U.primitiveField());
    const plainForms off;
    REQUIRE(!vectorSmoothSolver::serves(controls));
    flow.U = start;
    eqn.solve(controls);

    const vectorField change(fused - start.primitiveField());
    CHECK(gMax(mag(change)()) > 0.1);
    CHECK(gMax(mag(fused - flow.U.primitiveField())()) < 1e-13);
}
