// SPDX-License-Identifier: GPL-3.0-or-later

#include "poissonProblem.H"
#include "surfaceGradient.H"
#include "testTools.H"

using namespace Foam;
using testTools::dict;

namespace
{

//- Velocity on the side x = 0, and what it is in the cells does not matter
vector onSide(const point& x, const bool periodic)
{
    return vector(0.3*x.y(), -x.y() + 2, periodic ? 0.5 : 0.7*x.z());
}


//- A box with its low x side and the conditions on the others of fixed value;
//  side y by y or, if periodic, z cyclic
volVectorField sideField(const fvMesh& mesh, const bool periodic)
{
    wordList types(mesh.boundary().size(), "fixedValue");

    forAll(types, patchi)
    {
        if (mesh.boundary()[patchi].coupled())
        {
            types[patchi] = mesh.boundary()[patchi].type();
        }
    }

    volVectorField U
    (
        IOobject("U", mesh.time().timeName(), mesh),
        mesh,
        dimensionedVector(dimVelocity, Zero),
        types
    );
    testTools::RandomNumbers random(1 + Pstream::myProcNo());

    for (vector& value : U.primitiveFieldRef())
    {
        value = vector(random.number(), random.number(), random.number());
    }

    forAll(types, patchi)
    {
        fvPatchVectorField& Up = U.boundaryFieldRef()[patchi];
        vectorField values(Up.size());

        forAll(values, i)
        {
            values[i] = onSide(Up.patch().Cf()[i], periodic);
        }
        if (!Up.coupled())
        {
            Up == values;
        }
    }
    U.correctBoundaryConditions();

    return U;
}


//- Largest error of the gradient on the side x = 0, over all processors
scalar largestError(const bool periodic)
{
    const Time time(dict("deltaT 1; writeFrequency 1;"), "/tmp", "none");
    testTools::boxMesh box;

    box.x = {{
        testTools::graded(4, 3, 1.2),
        testTools::graded(6, 2, 0.8),
        testTools::graded(5, 1, 1.1)
    }};
    box.sides = {{"ff", "ff", periodic ? "cc" : "ff"}};
    box.processor = [](const labelVector& i)
    {
        return min((i.y() + i.z())/3, Pstream::nProcs() - 1);
    };

    const auto mesh(box.make(time));
    const volVectorField U(sideField(*mesh, periodic));
    tensor exact(Zero);

    exact.yx() = 0.3;
    exact.yy() = -1;
    exact.zz() = periodic ? 0 : 0.7;

    // All processors, of which one may have no such side
    const label patchi = mesh->boundaryMesh().findPatchID("side00");
    const tensorField G(surfaceGradient::calculate(U, patchi));

    return returnReduce(gMax(mag(G - exact)()), maxOp<scalar>());
}

} // End anonymous namespace


TEST_CASE("Gradients along a side are exact where linear", "[surfaceGradient]")
{
    CHECK(largestError(false) < 1e-12);
    CHECK(largestError(true) < 1e-12);
}
