// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedBodies.H"
#include "compat.H"
#include "profiling.H"
#include "unresolvedCoupling.H"

Foam::label Foam::immersedBodies::nUnresolved() const
{
    label n = 0;

    for (const immersedBody& body : bodies_)
    {
        n += !body.resolved();
    }

    return n;
}


const Foam::DynamicList<Foam::label>& Foam::immersedBodies::cellsBeside
(
    const label bodyi
) const
{
    return bodies_[bodyi].resolved()
      ? region_.regions()[bodyi].cells
      : unresolved_->cells(bodyi);
}


void Foam::immersedBodies::placeInMesh()
{
    // Those of a previous run stay, or it could not go on exactly
    const bool known = size() == 0 || min(h_) > 0;

    if (!known)
    {
        forAll(h_, bodyi)
        {
            h_[bodyi] =
                unresolved_->cellSize(bodies_[bodyi].state().position);
        }
        compat::allReduce(h_, maxEqOp<scalar>());
    }

    forAll(bodies_, bodyi)
    {
        immersedBody& body = bodies_[bodyi];

        // What the mesh decided on in the previous run stays
        if (!restarted_ || unresolved_->type(body) != "auto")
        {
            body.setResolved(unresolved_->resolves(body, h_[bodyi]));
        }
    }

    region_.updateGeometry(bodies_);

    if (!known)
    {
        const scalarField atCentre(h_);

        h_.measure(bodies_, region_);

        // The cells at the surface may be larger than that at the centre
        forAll(bodies_, bodyi)
        {
            immersedBody& body = bodies_[bodyi];

            if (!unresolved_->resolves(body, h_[bodyi]) && body.resolved())
            {
                body.setResolved(false);
                h_[bodyi] = atCentre[bodyi];
            }
        }
        region_.updateGeometry(bodies_);
    }

    unresolved_->update(bodies_, h_);
}


Foam::scalarField Foam::immersedBodies::localCellSizes() const
{
    scalarField sizes(size(), -1);

    forAll(bodies_, bodyi)
    {
        const immersedBody& body = bodies_[bodyi];

        if (unresolved_->type(body) != "auto")
        {
            continue;
        }

        if (!body.resolved())
        {
            // Not for most of them, far from being resolved
            sizes[bodyi] = unresolved_->resolves(body, h_[bodyi])
              ? unresolved_->largestCell(bodyi, body.shape().boundingRadius())
              : h_[bodyi];
        }
        else if (inMesh(bodyi))
        {
            sizes[bodyi] = bodyCellSizes::largest
            (
                region_.regions()[bodyi], region_.search()
            ).first();
        }
    }

    compat::allReduce(sizes, maxEqOp<scalar>());

    return sizes;
}


void Foam::immersedBodies::selectCoupling(volVectorField& U)
{
    bool any = false;

    for (const immersedBody& body : bodies_)
    {
        any = any || unresolved_->type(body) == "auto";
    }

    if (!any)
    {
        return;
    }

    addProfiling(select, "immersedBodies::selectCoupling");

    const scalarField sizes(localCellSizes());
    DynamicList<label> resolved, unresolved;

    forAll(bodies_, bodyi)
    {
        immersedBody& body = bodies_[bodyi];

        // Not while it enters or leaves, where a part has no cells
        if (sizes[bodyi] <= 0 || body.passing().size())
        {
            continue;
        }

        h_[bodyi] = sizes[bodyi];

        const bool resolve = unresolved_->resolves(body, h_[bodyi]);

        if (resolve != body.resolved())
        {
            body.setResolved(resolve);
            (resolve ? resolved : unresolved).append(bodyi);
        }
    }

    if (resolved.empty() && unresolved.empty())
    {
        return;
    }

    Info<< "Cells per width: " << resolved.size()
        << " bodies resolved from now on, " << unresolved.size()
        << " no longer" << endl;

    region_.updateGeometry(bodies_, true);

    for (const bodyRegion& region : region_.regions())
    {
        if (resolved.found(region.body()))
        {
            region_.interior().restartFluid(bodies_[region.body()], region, U);
        }
    }
    U.correctBoundaryConditions();
    unresolved_->update(bodies_, h_);
}


bool Foam::immersedBodies::disperse() const
{
    return unresolved_->disperses();
}


void Foam::immersedBodies::addUnresolved(vectorField& force) const
{
    if (unresolved_->active())
    {
        force.resize(mesh_.nCells(), Zero);
        unresolved_->addLoads(bodies_, 1, force);
    }
}


void Foam::immersedBodies::noteUnresolved()
{
    forAll(bodies_, bodyi)
    {
        if (!bodies_[bodyi].resolved())
        {
            loads_[bodyi].volume =
                unresolved_->inside(bodyi) ? bodies_[bodyi].volume() : 0;
        }
    }
}


Foam::tmp<Foam::vectorField> Foam::immersedBodies::correctUnresolved
(
    const ddtCoefficients& ddt,
    const carrierFlow& flow
)
{
    addProfiling(correct, "immersedBodies::correctUnresolved");

    tmp<vectorField> tchange(new vectorField(mesh_.nCells(), Zero));

    unresolved_->addLoads(bodies_, -1, tchange.ref());
    unresolved_->correct(bodies_, ddt, g_, window_.velocity(), flow);
    unresolved_->addLoads(bodies_, 1, tchange.ref());
    noteUnresolved();

    return tchange;
}


Foam::scalar Foam::immersedBodies::minVoid() const
{
    return unresolved_->minVoid();
}


void Foam::immersedBodies::updateKernels()
{
    unresolved_->update(bodies_, h_);
}


void Foam::immersedBodies::linearise
(
    const ddtCoefficients& ddt,
    const carrierFlow& flow,
    const vectorField& a,
    scalarField& drag,
    scalarField& part,
    vectorField& force
)
{
    addProfiling(linearise, "immersedBodies::linearise");

    unresolved_->linearise(bodies_, ddt, g_, flow, a, drag, part, force);
}


void Foam::immersedBodies::advance
(
    const ddtCoefficients& ddt,
    const vectorField& U,
    const vectorField& a
)
{
    addProfiling(advance, "immersedBodies::advance");

    unresolved_->advance(bodies_, ddt, g_, U, a);
    noteUnresolved();
}


Foam::tmp<Foam::volScalarField> Foam::immersedBodies::bodyFraction() const
{
    tmp<volScalarField> tfraction(region_.interior().fraction());

    unresolved_->addFraction(tfraction.ref().primitiveFieldRef());
    tfraction.ref().correctBoundaryConditions();

    return tfraction;
}
