// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedBodies.H"
#include "bodyPassage.H"
#include "compat.H"
#include "unresolvedCoupling.H"

const Foam::UList<Foam::bodyDeparture>& Foam::immersedBodies::departed() const
{
    return passage_->departed();
}


bool Foam::immersedBodies::leave()
{
    UPtrList<const DynamicList<label>> beside(size());

    forAll(beside, bodyi)
    {
        beside.set(bodyi, &cellsBeside(bodyi));
    }

    const labelList held(passage_->touch(bodies_, beside, loads_));
    bool good = true;
    bool changed = false;

    for (const label bodyi : held)
    {
        immersedBody& body = bodies_[bodyi];

        passage_->table().add
        (
            body, "held", body.passing(), window_.displacement()
        );
        body.hold();
    }

    // From the last on, as those after one that is taken out move up
    for (label bodyi = size() - 1; bodyi >= 0; --bodyi)
    {
        const immersedBody& body = bodies_[bodyi];

        if (inMesh(bodyi) || body.isFixed())
        {
            continue;
        }

        if (body.passing().empty())
        {
            Info<< "Body " << body.name() << " has left the mesh at "
                << body.state().position + window_.displacement()
                << ", moving with " << body.state().U << endl;
            good = false;
            continue;
        }

        passage_->table().add
        (
            body, "leaves", body.passing(), window_.displacement()
        );
        passage_->take(bodies_.take(bodyi));
        changed = true;
    }

    if (changed)
    {
        region_.updateGeometry(bodies_, true);
    }

    return good;
}


Foam::scalar Foam::immersedBodies::resolve
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
    largest[2] = unresolved_->cellSize(body.state().position);
    compat::allReduce(largest, maxEqOp<scalar>());

    if (largest[2] == 0)
    {
        return 0;
    }

    const scalar h = bodyCellSizes::at(body, {largest[0], largest[1]});

    body.setResolved(unresolved_->resolves(body, max(h, largest[2])));

    return body.resolved() ? h : largest[2];
}


bool Foam::immersedBodies::room
(
    const immersedBody& body,
    const bodyRegion& region,
    const scalar h,
    const scalar gap
) const
{
    if (body.resolved())
    {
        return passage_->room(body, region.cells, bodies_, h, gap);
    }

    // Unresolved ones may come as close as they fit
    const labelList beside
    (
        region_.search().cellsAround
        (
            body.state().position,
            body.shape().boundingRadius() + gap + h
        )
    );

    return passage_->room(body, beside, bodies_, 0, gap);
}


bool Foam::immersedBodies::enter
(
    autoPtr<immersedBody>& body,
    const scalar gap,
    volVectorField& U
)
{
    bodyRegion region(size());
    region.update(body(), region_.search(), region_.resistance().bandWidth());

    const scalar h = resolve(body(), region);

    if (h == 0 || !room(body(), region, h, gap))
    {
        return false;
    }

    const displacedFluid fluid
    (
        body->resolved()
      ? region_.interior().fluidInside(body(), region, U)
      : region_.interior().fluidAt(body->state().position, U)
    );

    body->setAmbient(fluid.velocity(), fluid.angularVelocity());

    // As at the start of a run, for all time levels there are
    if (body->resolved())
    {
        region_.interior().restartFluid(body(), region, U);
    }

    bodies_.append(std::move(body));
    h_.last() = h;

    return true;
}
