// SPDX-License-Identifier: GPL-3.0-or-later

#include "poissonProblem.H"
#include "fluxSums.H"
#include "fvcDiv.H"
#include "fvcSurfaceIntegrate.H"
#include "testTools.H"

using namespace Foam;
using testTools::dict;
using testTools::near;

TEST_CASE("Sums of a flux are found again when it changes", "[fluxSums]")
{
    const Time time(dict("deltaT 1; writeFrequency 1;"), "/tmp", "none");
    const auto mesh(testTools::smallBox().make(time));
    const dimensionedVector way("way", dimLength, vector(1, -5, 2));
    surfaceScalarField phi
    (
        IOobject("phi", time.timeName(), *mesh),
        (mesh->Cf() + way) & mesh->Sf()
    );
    fluxSums sums(phi);

    const auto check = [&]()
    {
        const scalarField& V = mesh->V();
        const scalarField div(fvc::div(phi)().primitiveField());
        const scalarField through
        (
            fvc::surfaceSum(mag(phi))().primitiveField()
        );
        const scalar dt = 0.2;

        CHECK
        (
            sums.courantNo(dt, "")
         == near(0.5*dt*gMax(scalarField(through/V)))
        );
        CHECK(sums.continuity()[0] == near(sum(mag(V*div))));
        CHECK(sums.continuity()[1] == near(sum(V*div)));
        CHECK(sums.continuity()[2] == near(sum(V)));
    };

    check();
    phi *= -2.5;
    check();

    // What OpenFOAM does not note is not seen: nothing has been summed again
    const vector before(sums.continuity());
    static_cast<scalarField&>(phi) = 0;
    CHECK(sums.continuity() == before);
    phi.boundaryFieldRef();
    CHECK(sums.continuity() != before);
}
