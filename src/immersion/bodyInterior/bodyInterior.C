// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyInterior.H"
#include "zeroGradientFvPatchFields.H"

Foam::bodyInterior::bodyInterior
(
    const cellSearch& search,
    const bodyBands& bands
)
:
    search_(search),
    mesh_(search.mesh()),
    bands_(bands)
{}


Foam::tmp<Foam::volScalarField> Foam::bodyInterior::fraction() const
{
    tmp<volScalarField> tfraction
    (
        new volScalarField
        (
            IOobject("bodyFraction", mesh_.time().timeName(), mesh_),
            mesh_,
            dimensionedScalar(dimless, Zero),
            zeroGradientFvPatchScalarField::typeName
        )
    );
    scalarField& fraction = tfraction.ref().primitiveFieldRef();

    for (const bodyRegion& region : bands_.regions())
    {
        forAll(region.cells, i)
        {
            fraction[region.cells[i]] += region.fractionInside(i);
        }
    }
    tfraction.ref().correctBoundaryConditions();

    return tfraction;
}


Foam::displacedFluid Foam::bodyInterior::fluidInside
(
    const immersedBody& body,
    const bodyRegion& region,
    const vectorField& U
) const
{
    const point centre(region.centre(body.state()));
    displacedFluid fluid;

    forAll(region.cells, i)
    {
        const label celli = region.cells[i];
        const scalar inside = region.fractionInside(i);

        if (inside > 0)
        {
            fluid.add
            (
                mesh_.V()[celli]*inside,
                mesh_.cellCentres()[celli] - centre,
                U[celli] - region.slideVelocity()
            );
        }
    }

    fluid.reduce();

    return fluid;
}


Foam::displacedFluid Foam::bodyInterior::fluidAt
(
    const point& x,
    const vectorField& U
) const
{
    const label celli = search_.findCell(x);
    displacedFluid fluid;

    if (celli >= 0)
    {
        // As six parts, for an inertia
        const scalar V = mesh_.V()[celli]/6;
        const scalar r = 0.5*search_.h()[celli];

        for (direction k = 0; k < 3; ++k)
        {
            vector arm(Zero);
            arm[k] = r;

            fluid.add(V, arm, U[celli]);
            fluid.add(V, -arm, U[celli]);
        }
    }

    fluid.reduce();

    return fluid;
}


void Foam::bodyInterior::setRigidMotion
(
    const PtrList<immersedBody>& bodies,
    vectorField& U
) const
{
    for (const bodyRegion& region : bands_.regions())
    {
        setRigidMotion(bodies[region.body()], region, U);
    }
}


void Foam::bodyInterior::setRigidMotion
(
    const immersedBody& body,
    const bodyRegion& region,
    vectorField& U
) const
{
    const vectorField& centres = mesh_.cellCentres();

    forAll(region.cells, i)
    {
        // Linear across the surface: which side a centre on it is taken to be
        // must not matter
        const label celli = region.cells[i];
        const vector Ub(region.velocity(body.state(), centres[celli]));

        U[celli] += region.fractionInside(i)*(Ub - U[celli]);
    }
}


void Foam::bodyInterior::restartFluid
(
    const immersedBody& body,
    const bodyRegion& region,
    volVectorField& U
) const
{
    setRigidMotion(body, region, U.primitiveFieldRef());

    if (U.nOldTimes())
    {
        setRigidMotion(body, region, U.oldTime().primitiveFieldRef());
    }
}
