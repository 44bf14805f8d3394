// SPDX-License-Identifier: GPL-3.0-or-later

#include "phaseSources.H"
#include "bodyContacts.H"
#include "bodyTractions.H"
#include "gaussGrad.H"
#include "surfaceInterpolate.H"
#include "turbulentTransportModel.H"

void Foam::phaseSources::add(scalar* row, const column k, const vector& v)
{
    for (direction i = 0; i < 3; ++i)
    {
        row[k + i] += v[i];
    }
}


void Foam::phaseSources::add(scalar* row, const column k, const symmTensor& t)
{
    for (direction i = 0; i < 6; ++i)
    {
        row[k + i] += t[i];
    }
}


void Foam::phaseSources::slide(scalar* row, const vector& v)
{
    // Before the means of first order change
    const auto second = [&](const column mean, const column k, const scalar m)
    {
        const vector first(row[mean], row[mean + 1], row[mean + 2]);

        add(row, k, symmTensor(twoSymm(first*v) + m*sqr(v)));
    };

    second(U, UU, row[fluid]);
    second(momentum, momentumU, row[mass]);

    add(row, U, row[fluid]*v);
    add(row, Ub, row[bodies]*v);
    add(row, momentum, row[mass]*v);
}


void Foam::phaseSources::addBodies(const bodyTractions& tractions)
{
    const PtrList<bodyRegion>& regions = bodies_.region().regions();
    const contactMoments& contacts = bodies_.contacts().moments();

    forAll(regions, regioni)
    {
        const bodyRegion& one = regions[regioni];
        const immersedBody& body = bodies_[one.body()];
        const scalar r = body.densityRatio();
        const scalar Vb = max(fractions_.volume(one.body()), VSMALL);
        const scalar nParts = bodies_.loads().nParts(one.body());
        const vector f(body.fluid().force()/nParts/Vb);
        const symmTensor S(symm(tractions.surface(one.body()))/Vb);
        const symmTensor C
        (
            symm(contacts.contact(one.body()) + contacts.film(one.body()))/Vb
        );

        forAll(one.cells, i)
        {
            const scalar chi = fractions_[regioni][i];
            scalar* to = row(one.cells[i]);
            const vector& w = body.state().omega;
            const vector V
            (
                body.state().U + one.slideVelocity()
              + (w^(one.x(i) - one.position()))
            );

            to[fluid] -= chi;
            to[bodies] += chi;
            to[mass] += r*chi;
            add(to, Ub, chi*V);
            add(to, omega, chi*w);
            add(to, force, chi*f);
            add(to, momentum, r*chi*V);
            add(to, traction, chi*S);
            add(to, momentumU, r*chi*sqr(V));
            add(to, contact, chi*C);
        }
    }
}


void Foam::phaseSources::addFluid
(
    const vectorField& velocity,
    const scalarField& pressure,
    const scalarField& nu,
    const tensorField& gradU
)
{
    forAll(velocity, celli)
    {
        scalar* to = row(celli);
        const scalar e = to[fluid];

        to[p] += e*pressure[celli];
        add(to, U, e*velocity[celli]);
        add(to, UU, e*sqr(velocity[celli]));
        add
        (
            to,
            stress,
            nu[celli]*dev(twoSymm(gradU[celli]))
          - e*pressure[celli]*symmTensor::I
        );
    }
}


Foam::phaseSources::phaseSources
(
    const fvMesh& mesh,
    const immersedBodies& bodies,
    const bodyFractions& fractions,
    const bodyTractions& tractions
)
:
    bodies_(bodies),
    fractions_(fractions),
    values_(nColumns*mesh.nCells(), Zero)
{
    for (label celli = 0; celli < mesh.nCells(); ++celli)
    {
        row(celli)[fluid] = 1;
    }

    addBodies(tractions);

    const volVectorField& velocity = mesh.lookupObject<volVectorField>("U");
    const tmp<volScalarField> tnu
    (
        mesh.lookupObject<incompressible::turbulenceModel>
        (
            turbulenceModel::propertiesName
        ).nuEff()
    );
    const tmp<volTensorField> tgradU
    (
        fv::gaussGrad<vector>::gradf(linearInterpolate(velocity), "gradU")
    );

    addFluid
    (
        velocity, mesh.lookupObject<volScalarField>("p"), tnu(), tgradU()
    );
}
