// SPDX-License-Identifier: GPL-3.0-or-later

#include "projection.H"
#include "randomFlow.H"

using namespace Foam;
using testTools::dict;
using testTools::randomFlow;


TEST_CASE("Fluxes that wait are those of all increments", "[projection]")
{
    randomFlow flow("orthogonal", 0);
    projection increments(flow.p, -1);
    const dimensionedScalar tau("tau", dimTime, 0.3);
    const dictionary controls
    (
        dict("solver PCG; preconditioner DIC; tolerance 1e-12; relTol 0;")
    );
    const scalarField given(flow.phi.primitiveField());
    surfaceScalarField waiting("waiting", flow.phi);
    scalarField sum(flow.p.size(), Zero);
    DynamicList<label> some;

    REQUIRE(increments.compact());

    forAll(flow.phi, facei)
    {
        if (facei % 5 < 2)
        {
            some.append(facei);
        }
    }

    for (label i = 0; i < 2; ++i)
    {
        scalarField divPhi(flow.p.size());

        for (scalar& value : divPhi)
        {
            value = flow.number();
        }
        increments.begin(i == 0);
        increments.solve(controls, divPhi, tau, 0);
        increments.correctFlux(tau, flow.phi);
        increments.correctFlux(tau.value(), some, waiting);
        sum += increments.dp().primitiveField();
    }

    const scalar largest = gMax(mag(flow.phi.primitiveField() - given)());

    CHECK(largest > 1e-3);

    // On patches, and faces that do not wait
    forAll(flow.phi.boundaryField(), patchi)
    {
        const scalarField& onPatch = waiting.boundaryField()[patchi];

        CHECK(onPatch == flow.phi.boundaryField()[patchi]);
    }
    for (const label facei : some)
    {
        CHECK(waiting[facei] == flow.phi[facei]);
    }

    increments.correctOtherFluxes(tau.value(), sum, some, waiting);

    forAll(waiting, facei)
    {
        CHECK(mag(waiting[facei] - flow.phi[facei]) < 1e-13*largest);
    }
}
