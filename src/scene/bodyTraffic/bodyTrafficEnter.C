// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyTraffic.H"
#include "profiling.H"

bool Foam::bodyTraffic::room
(
    const immersedBody& body,
    const bodyRegion& region,
    const scalar h,
    const scalar gap
) const
{
    if (body.resolved())
    {
        return passage_.room(body, region.cells, bodies_, h, gap);
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

    return passage_.room(body, beside, bodies_, 0, gap);
}


bool Foam::bodyTraffic::enter
(
    autoPtr<immersedBody>& body,
    const scalar gap,
    volVectorField& U
)
{
    bodyRegion region(bodies_.size());
    region.update(body(), region_.search(), region_.resistance().bandWidth());

    const scalar h = resolution_.resolve(body(), region);

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


void Foam::bodyTraffic::enterAgain(volVectorField& U)
{
    PtrList<immersedBody>& waiting = passage_.waiting();
    PtrList<immersedBody> still;

    for (label i = 0; i < waiting.size(); ++i)
    {
        autoPtr<immersedBody> body(waiting.release(i));

        if (enter(body, 0, U))
        {
            tell(bodies_.last(), "enters", "again");
        }
        else
        {
            still.append(body.ptr());
        }
    }
    waiting.transfer(still);
}


void Foam::bodyTraffic::inject(const scalar t, volVectorField& U)
{
    for (injector& one : passage_.injectors())
    {
        label tries = 0;
        bool first = one.first();

        while (one.schedule().due() <= t && tries < one.maxTries())
        {
            autoPtr<immersedBody> body(one.draw());

            body->setNumber(passage_.nextNumber());
            ++tries;

            if (enter(body, one.gap(), U))
            {
                passage_.useNumber();
                tell(bodies_.last(), "enters", one.name());
                one.advance();
                tries = 0;
                first = true;
            }
        }

        if (tries && first)
        {
            Info<< "Body " << one.name() << one.schedule().next() + 1
                << " waits: no room where it is to enter" << endl;
        }
    }
}


bool Foam::bodyTraffic::enter(const scalar t, volVectorField& U)
{
    if (!passage_.due(t))
    {
        return false;
    }

    addProfiling(enter, "immersedBodies::enter");

    const label nOld = bodies_.size();

    enterAgain(U);
    inject(t, U);

    const label nNew = bodies_.size() - nOld;

    if (nNew)
    {
        U.correctBoundaryConditions();
        handover_.entered(nNew);
        resolution_.replace();
    }

    return nNew;
}
