// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyResolution.H"
#include "bodyShare.H"
#include "compat.H"
#include "profiling.H"

Foam::bodyResolution::bodyResolution
(
    bodyList& bodies,
    immersedRegion& region,
    unresolvedBodies& unresolved,
    const bodyLoads& loads,
    bodyCellSizes& h
)
:
    bodies_(bodies),
    region_(region),
    unresolved_(unresolved),
    loads_(loads),
    h_(h)
{}


const Foam::DynamicList<Foam::label>& Foam::bodyResolution::cellsBeside
(
    const label bodyi
) const
{
    return bodies_[bodyi].resolved()
      ? region_.bands().region(bodyi).cells
      : kernels()[bodyi].cells();
}


void Foam::bodyResolution::findAtCentres()
{
    forAll(h_, bodyi)
    {
        h_[bodyi] = kernels().cellSize(bodies_[bodyi].state().position);
    }
    bodies_.share().combine(h_, maxEqOp<scalar>());
}


void Foam::bodyResolution::findAtSurfaces()
{
    const scalarField atCentre(h_);

    h_.measure(bodies_, region_);

    forAll(bodies_, bodyi)
    {
        immersedBody& body = bodies_[bodyi];

        if (!choice().resolves(body, h_[bodyi]) && body.resolved())
        {
            body.status().setResolved(false);
            h_[bodyi] = atCentre[bodyi];
        }
    }
}


void Foam::bodyResolution::choose(const bool restarted)
{
    forAll(bodies_, bodyi)
    {
        immersedBody& body = bodies_[bodyi];

        // What the mesh decided on in the previous run stays
        if (!restarted || choice().type(body) != "auto")
        {
            body.status().setResolved(choice().resolves(body, h_[bodyi]));
        }
    }
}


void Foam::bodyResolution::start(const bool restarted)
{
    // Those of a previous run stay, or it could not go on exactly
    const bool known = bodies_.share().all(h_.empty() || min(h_) > 0);

    if (!known)
    {
        findAtCentres();
    }
    choose(restarted);

    region_.updateGeometry(bodies_);

    if (!known)
    {
        findAtSurfaces();
        region_.updateGeometry(bodies_);
    }

    unresolved_.update();
}


void Foam::bodyResolution::replace()
{
    region_.updateGeometry(bodies_, true);
    unresolved_.update();
}


bool Foam::bodyResolution::anyAuto() const
{
    bool any = false;

    for (const immersedBody& body : bodies_)
    {
        any = any || choice().type(body) == "auto";
    }

    return bodies_.share().any(any);
}


Foam::scalarField Foam::bodyResolution::localCellSizes() const
{
    scalarField sizes(bodies_.size(), -1);

    forAll(bodies_, bodyi)
    {
        const immersedBody& body = bodies_[bodyi];

        if (choice().type(body) != "auto")
        {
            continue;
        }

        if (!body.resolved())
        {
            // Not for most of them, far from being resolved
            sizes[bodyi] = choice().resolves(body, h_[bodyi])
              ? kernels().largestCell(bodyi, body.shape().boundingRadius())
              : h_[bodyi];
        }
        else if (loads_.inMesh(bodyi))
        {
            sizes[bodyi] = bodyCellSizes::largest
            (
                region_.bands().region(bodyi), region_.search()
            ).first();
        }
    }

    bodies_.share().combine(sizes, maxEqOp<scalar>());

    return sizes;
}


void Foam::bodyResolution::select(volVectorField& U)
{
    if (!anyAuto())
    {
        return;
    }

    addProfiling(select, "immersedBodies::selectCoupling");

    const bodyShare& share = bodies_.share();
    const scalarField sizes(localCellSizes());
    DynamicList<label> resolved;
    Pair<label> changed(0, 0);

    forAll(bodies_, bodyi)
    {
        immersedBody& body = bodies_[bodyi];

        // Not while it enters or leaves, where a part has no cells
        if (sizes[bodyi] <= 0 || body.status().passing().size())
        {
            continue;
        }

        h_[bodyi] = sizes[bodyi];

        const bool resolve = choice().resolves(body, h_[bodyi]);

        if (resolve != body.resolved())
        {
            body.status().setResolved(resolve);
            (resolve ? changed.first() : changed.second()) += share.mine(bodyi);
            if (resolve)
            {
                resolved.append(bodyi);
            }
        }
    }

    changed.first() = share.total(changed.first());
    changed.second() = share.total(changed.second());

    if (changed != Pair<label>(0, 0))
    {
        Info<< "Cells per width: " << changed.first()
            << " bodies resolved from now on, " << changed.second()
            << " no longer" << endl;

        replace();
        fill(resolved, U);
    }
}


void Foam::bodyResolution::fill
(
    const UList<label>& resolved,
    volVectorField& U
) const
{
    for (const bodyRegion& region : region_.regions())
    {
        if (resolved.found(region.body()))
        {
            region_.interior().restartFluid(bodies_[region.body()], region, U);
        }
    }
    U.correctBoundaryConditions();
}


Foam::scalar Foam::bodyResolution::resolve
(
    immersedBody& body,
    const bodyRegion& region
) const
{
    const Pair<scalar> local(bodyCellSizes::largest(region, region_.search()));

    // The last is that of the cell with the centre
    scalarField largest(3);
    largest[0] = local.first();
    largest[1] = local.second();
    largest[2] = kernels().cellSize(body.state().position);
    compat::allReduce(largest, maxEqOp<scalar>());

    if (largest[2] == 0)
    {
        return 0;
    }

    const scalar h = bodyCellSizes::at(body, {largest[0], largest[1]});

    body.status().setResolved(choice().resolves(body, max(h, largest[2])));

    return body.resolved() ? h : largest[2];
}
