// SPDX-License-Identifier: GPL-3.0-or-later

#include "pendingCorrection.H"
#include "labelVector.H"

namespace
{
    //- Part of all cells that bands take from which on waiting saves nothing
    const Foam::scalar maxPart = 0.08;
}


Foam::pendingCorrection::pendingCorrection
(
    const immersedRegion& region,
    const volScalarField& dp
)
:
    region_(region),
    sum_
    (
        IOobject("sum(dp)", dp.mesh().time().timeName(), dp.mesh()),
        dp.mesh(),
        dimensionedScalar(dp.dimensions(), Zero),
        dp.boundaryField().types()
    ),
    version_(-1),
    few_(false),
    active_(false)
{}


void Foam::pendingCorrection::findCells()
{
    version_ = region_.bands().version();

    const label nCells = sum_.size();
    labelVector n(region_.cells().size(), nCells, 0);
    reduce(n, sumOp<labelVector>());
    few_ = n[0] < maxPart*n[1];

    if (few_)
    {
        region_.surroundings().withBeside(region_.cells(), part_.cells);
        beside_.reset();
        beside_.resize(nCells);
        beside_.set(part_.cells);
        part_.find(region_.neighbours(), beside_);

        faces_ = part_.between;

        for (const auto& edge : part_.edges)
        {
            faces_.append(edge.beyond.face());
        }
    }
}


bool Foam::pendingCorrection::outdated() const
{
    return returnReduce(version_ != region_.bands().version(), orOp<bool>());
}


bool Foam::pendingCorrection::begin()
{
    if (!active_)
    {
        if (outdated())
        {
            findCells();
        }

        active_ = few_;

        if (active_)
        {
            sum_ = dimensionedScalar(sum_.dimensions(), Zero);
        }
    }

    return active_;
}


Foam::scalarField Foam::pendingCorrection::divergence
(
    const surfaceScalarField& phi
) const
{
    const scalarField& V = phi.mesh().V();
    scalarField div(V.size(), Zero);

    for (const label celli : part_.cells)
    {
        scalar sum = 0;

        for (const auto& n : region_.neighbours().of(celli))
        {
            sum += n.owner() ? phi[n.face()] : -phi[n.face()];
        }

        for (const auto& face : region_.neighbours().onPatches(celli))
        {
            sum += phi.boundaryField()[face.patch][face.face];
        }

        div[celli] = sum/V[celli];
    }

    return div;
}


void Foam::pendingCorrection::add
(
    const volScalarField& p,
    const volScalarField& dp,
    const scalar tau,
    volVectorField& gradP,
    vectorField& dU
)
{
    sum_.primitiveFieldRef() += dp.primitiveField();
    dU.resize(sum_.size());

    pairGradient::set(part_, p, dp, tau, gradP, dU);
}


void Foam::pendingCorrection::correct
(
    const vectorField& dU,
    volVectorField& U
) const
{
    vectorField& Ui = U.primitiveFieldRef();

    for (const label celli : part_.cells)
    {
        Ui[celli] -= dU[celli];
    }
}


void Foam::pendingCorrection::complete
(
    const volScalarField& p,
    const scalar tau,
    volVectorField& gradP,
    vectorField& dU,
    volVectorField& U
)
{
    sum_.correctBoundaryConditions();
    pairGradient::set(p, sum_, tau, gradP, dU);

    vectorField& Ui = U.primitiveFieldRef();

    forAll(Ui, celli)
    {
        if (!beside_.test(celli))
        {
            Ui[celli] -= dU[celli];
        }
    }

    active_ = false;
}
