// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedBodies.H"
#include "bodyPassage.H"
#include "profiling.H"
#include "unresolvedCoupling.H"

bool Foam::immersedBodies::enterAgain(volVectorField& U)
{
    PtrList<immersedBody>& waiting = passage_->waiting();
    PtrList<immersedBody> still;
    const label nOld = size();

    for (label i = 0; i < waiting.size(); ++i)
    {
        autoPtr<immersedBody> body(waiting.release(i));

        if (enter(body, 0, U))
        {
            passage_->table().add
            (
                bodies_.last(), "enters", "again", window_.displacement()
            );
        }
        else
        {
            still.append(body.ptr());
        }
    }
    waiting.transfer(still);

    return size() > nOld;
}


bool Foam::immersedBodies::inject(volVectorField& U)
{
    const label nOld = size();

    // A body that is due at the end of the step must not miss it by rounding
    const scalar t = clock_ + 1e-6*mesh_.time().deltaTValue();

    for (injector& one : passage_->injectors())
    {
        label tries = 0;
        bool first = one.first();

        while (one.schedule().due() <= t && tries < one.maxTries())
        {
            autoPtr<immersedBody> body(one.draw());

            body->setNumber(passage_->nextNumber());
            ++tries;

            if (enter(body, one.gap(), U))
            {
                passage_->useNumber();
                passage_->table().add
                (
                    bodies_.last(), "enters", one.name(),
                    window_.displacement()
                );
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

    return size() > nOld;
}


void Foam::immersedBodies::enter(volVectorField& U)
{
    if (!passage_->due(clock_ + 1e-6*mesh_.time().deltaTValue()))
    {
        return;
    }

    addProfiling(enter, "immersedBodies::enter");

    const bool again = enterAgain(U);
    const bool injected = inject(U);

    if (again || injected)
    {
        U.correctBoundaryConditions();
        region_.updateGeometry(bodies_, true);
        unresolved_->update(bodies_, h_);
    }
}
