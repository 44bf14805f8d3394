// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodySums.H"
#include "zeroGradientFvPatchFields.H"

Foam::bodySums::bodySums
(
    const fvMesh& mesh,
    const resistanceModel& resistance,
    bodyBands& bands
)
:
    mesh_(mesh),
    resistance_(resistance),
    bands_(bands),
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
    bodyFlux_(mesh.nFaces(), Zero)
{}


void Foam::bodySums::clear
(
    const labelUList& cells,
    const labelUList& faces
)
{
    UIndirectList<scalar>(K_.primitiveFieldRef(), cells) = 0;
    UIndirectList<vector>(KU_, cells) = vector::zero;
    UIndirectList<vector>(shieldDU_, cells) = vector::zero;
    UIndirectList<scalar>(shield_, cells) = 0;
    UIndirectList<scalar>(faceShield_, faces) = 0;
    UIndirectList<scalar>(bodyFlux_, faces) = 0;
}


void Foam::bodySums::clear()
{
    clear(bands_.cells(), bands_.faces());
    clear(bands_.usedCells(), bands_.usedFaces());
}


void Foam::bodySums::combineShields
(
    const DynamicList<label> bodyRegion::*labels,
    const DynamicList<scalar> bodyRegion::*shields,
    DynamicList<scalar> bodyRegion::*shares,
    const labelUList& all,
    scalarField& total
)
{
    UPtrList<bodyRegion> regions(bands_.worked());

    // One body: the flat field is its list
    if (bands_.regions().size() == 1 && !bands_.few())
    {
        regions[0].*shares = regions[0].*shields;
        UIndirectList<scalar>(total, all) = regions[0].*shields;
        return;
    }

    // Places in the shields of several bodies
    bitSet shared(total.size());
    bool any = false;

    shieldSum_.resize(mesh_.nFaces());
    UIndirectList<scalar>(total, all) = 0;

    // One less the product of the open parts, and sum of the shields
    for (const bodyRegion& region : regions)
    {
        forAll(region.*labels, i)
        {
            const label at = (region.*labels)[i];
            const scalar shield = (region.*shields)[i];
            const scalar before = total[at];

            if (before > 0 && shield > 0)
            {
                shieldSum_[at] =
                    shield + (shared.set(at) ? before : shieldSum_[at]);
                any = true;
            }
            total[at] = before + shield*(1 - before);
        }
    }

    for (bodyRegion& region : regions)
    {
        region.*shares = region.*shields;

        forAll(region.*labels, i)
        {
            const label at = (region.*labels)[i];

            if (any && shared.test(at))
            {
                (region.*shares)[i] *= total[at]/shieldSum_[at];
            }
        }
    }
}


void Foam::bodySums::combineShields()
{
    combineShields
    (
        &bodyRegion::cells,
        &bodyRegion::shield,
        &bodyRegion::share,
        bands_.cells(),
        shield_
    );
    combineShields
    (
        &bodyRegion::faces,
        &bodyRegion::faceShield,
        &bodyRegion::faceShare,
        bands_.faces(),
        faceShield_
    );
}


void Foam::bodySums::updateResistance
(
    const PtrList<immersedBody>& bodies,
    const scalarField& A0,
    const scalarField& nu,
    const bool again
)
{
    if (again && bands_.same())
    {
        return;
    }

    scalarField& K = K_.primitiveFieldRef();
    UIndirectList<scalar>(K, bands_.cells()) = 0;

    UPtrList<bodyRegion> regions(bands_.worked());

    for (bodyRegion& region : regions)
    {
        if (!(again && region.same()))
        {
            resistance_.setResistance(bodies[region.body()], A0, nu, region);
        }

        forAll(region.cells, i)
        {
            K[region.cells[i]] += region.resistance[i];
        }
    }

    // The response of rows next to a coupled patch needs that beyond it
    K_.correctBoundaryConditions();
}


void Foam::bodySums::updateVelocity
(
    const PtrList<immersedBody>& bodies,
    const ddtCoefficients& ddt
)
{
    const vectorField& Sf = mesh_.faceAreas();

    UIndirectList<vector>(KU_, bands_.cells()) = vector::zero;
    UIndirectList<vector>(shieldDU_, bands_.cells()) = vector::zero;
    UIndirectList<scalar>(bodyFlux_, bands_.faces()) = 0;

    const UPtrList<bodyRegion> regions(bands_.worked());

    for (const bodyRegion& region : regions)
    {
        const immersedBody& body = bodies[region.body()];
        const bodyState& state = body.state();
        const vector U(state.U + region.slideVelocity());
        const rigidAcceleration acceleration(body.motion().acceleration(ddt));

        forAll(region.cells, i)
        {
            const label celli = region.cells[i];
            const vector r(region.x(i) - state.position);

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
            const vector r(region.faceX(i) - state.position);

            bodyFlux_[facei] +=
                region.faceShare[i]*((U + (state.omega^r)) & Sf[facei]);
        }
    }
}
