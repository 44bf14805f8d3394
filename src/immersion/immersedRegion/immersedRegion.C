// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedRegion.H"
#include "normalExtrapolation.H"
#include "zeroGradientFvPatchFields.H"

Foam::immersedRegion::immersedRegion
(
    const fvMesh& mesh,
    const geometricSpace& space,
    const periodicity& periods,
    const dictionary& dict,
    bodyList& bodies,
    const bool bodiesMove
)
:
    bodyList::dependent(bodies),
    mesh_(mesh),
    periodicity_(periods),
    search_(mesh, space),
    neighbours_(mesh),
    delta_(mesh.boundary().size()),
    coupled_(false),
    resistance_(resistanceModel::New(dict, mesh, bodiesMove)),
    regions_(bodies.size()),
    selection_(mesh),
    K_
    (
        IOobject("resistance", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimless/dimTime, Zero),
        zeroGradientFvPatchScalarField::typeName
    ),
    KU_(mesh.nCells(), Zero),
    shieldDU_(mesh.nCells(), Zero),
    shield_(mesh.nCells(), Zero),
    faceShield_(mesh.nFaces(), Zero),
    bodyFlux_(mesh.nFaces(), Zero),
    same_(false),
    version_(0),
    weight_
    (
        IOobject
        (
            "weight",
            mesh.time().timeName(),
            mesh,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        mesh,
        dimensionedScalar(dimless, Zero)
    ),
    fluidPart_(mesh.nCells()),
    keepForces_(false)
{
    forAll(regions_, bodyi)
    {
        regions_.set(bodyi, new bodyRegion(bodyi));
    }

    forAll(delta_, patchi)
    {
        if (mesh.boundary()[patchi].coupled())
        {
            delta_[patchi] = mesh.boundary()[patchi].delta();
            coupled_ = true;
        }
    }
    reduce(coupled_, orOp<bool>());
}


Foam::scalar Foam::immersedRegion::overlap() const
{
    // With those in several bands as often as they are there
    label all = 0;

    for (const bodyRegion& region : regions_)
    {
        all += region.cells.size();
    }

    const scalar once = returnReduce(cells_.size(), sumOp<label>());

    return (returnReduce(all, sumOp<label>()) - once)/max(once, 1);
}


void Foam::immersedRegion::updateResistance
(
    const PtrList<immersedBody>& bodies,
    const scalarField& A0,
    const scalarField& nu,
    const bool again
)
{
    if (again && same_)
    {
        return;
    }

    scalarField& K = K_.primitiveFieldRef();
    UIndirectList<scalar>(K, cells()) = 0;

    UPtrList<bodyRegion> regions(worked());

    for (bodyRegion& region : regions)
    {
        if (!(again && region.same()))
        {
            resistance_->setResistance(bodies[region.body()], A0, nu, region);
        }

        forAll(region.cells, i)
        {
            K[region.cells[i]] += region.resistance[i];
        }
    }

    // The response of rows next to a coupled patch needs that beyond it
    K_.correctBoundaryConditions();
}


void Foam::immersedRegion::updateVelocity
(
    const PtrList<immersedBody>& bodies,
    const ddtCoefficients& ddt
)
{
    const vectorField& Sf = mesh_.faceAreas();

    UIndirectList<vector>(KU_, cells()) = vector::zero;
    UIndirectList<vector>(shieldDU_, cells()) = vector::zero;
    UIndirectList<scalar>(bodyFlux_, faces()) = 0;

    const UPtrList<bodyRegion> regions(worked());

    for (const bodyRegion& region : regions)
    {
        const immersedBody& body = bodies[region.body()];
        const bodyState& state = body.state();
        const vector U(state.U + region.slideVelocity());
        const rigidAcceleration acceleration(body.acceleration(ddt));

        forAll(region.cells, i)
        {
            const label celli = region.cells[i];
            const vector r(region.x[i] - state.position);

            if (region.resistance[i] > 0)
            {
                KU_[celli] += region.resistance[i]*(U + (state.omega^r));
            }
            if (region.share[i] > 0)
            {
                shieldDU_[celli] += region.share[i]*acceleration(r);
            }
        }

        forAll(region.faces, i)
        {
            const label facei = region.faces[i];
            const vector r(region.faceX[i] - state.position);

            bodyFlux_[facei] +=
                region.faceShare[i]*((U + (state.omega^r)) & Sf[facei]);
        }
    }
}


void Foam::immersedRegion::extrapolate(volScalarField& nu) const
{
    // From 1.5 cells on the shear rate is that of the fluid to a few per cent,
    // and from two cells an extrapolation is less accurate
    const scalar start = min(1.5, resistance_->bandWidth() - 1);

    // The logarithm, as it must not change its sign
    scalarField logNu(log(max(nu.primitiveField(), VSMALL)));

    normalExtrapolation(mesh_, regions_, start).apply(logNu);

    nu.primitiveFieldRef() = exp(logNu);
    nu.correctBoundaryConditions();
}


Foam::tmp<Foam::volScalarField> Foam::immersedRegion::bodyFraction() const
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

    for (const bodyRegion& region : regions_)
    {
        forAll(region.cells, i)
        {
            fraction[region.cells[i]] += fractionInside(region, i);
        }
    }
    tfraction.ref().correctBoundaryConditions();

    return tfraction;
}


void Foam::immersedRegion::setRigidMotion
(
    const PtrList<immersedBody>& bodies,
    vectorField& U
) const
{
    for (const bodyRegion& region : regions_)
    {
        setRigidMotion(bodies[region.body()], region, U);
    }
}


void Foam::immersedRegion::setRigidMotion
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

        U[celli] += fractionInside(region, i)*(Ub - U[celli]);
    }
}


void Foam::immersedRegion::restartFluid
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
