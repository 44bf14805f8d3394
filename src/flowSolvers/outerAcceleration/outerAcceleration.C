// SPDX-License-Identifier: GPL-3.0-or-later

#include "outerAcceleration.H"
#include "bodyShare.H"
#include "freeVelocities.H"

namespace
{
    //- Iterations that are combined: each holds the pressure once
    const Foam::label depth = 10;

    //- Iterations that are not combined, and the part of the change that one of
    //  those after them may leave
    const Foam::label nPlain = 2;
    const Foam::scalar slow = 0.5;

    //- Iterations that are combined only if they change more than so many times
    //  the least: steps that are nearly there end sooner if each does what it
    //  can
    const Foam::label nSmall = 4;
    const Foam::scalar large = 100;

    //- The same if patient, and then only if changes grow
    const Foam::label nPatient = 10;
    const Foam::scalar largePatient = 30;
}


Foam::outerAcceleration::outerAcceleration(const fvMesh& mesh)
:
    mesh_(mesh),
    fixedPoint_(depth),
    first_(true),
    change_(0),
    active_(false),
    jump_(0)
{}


void Foam::outerAcceleration::begin()
{
    fixedPoint_.clear();
    first_ = true;
    change_ = 0;
    active_ = false;
    jump_ = 0;
}


void Foam::outerAcceleration::watch
(
    const label outer,
    const scalar change,
    const scalar least,
    const bool patient
)
{
    // The first of those that do what they can changes more than those before
    const bool early = outer <= (patient ? nPatient : nSmall);
    const bool wait = patient && early;
    const label last = wait ? nPlain + 1 : nPlain;

    const bool begins =
        change > (wait ? change_ : slow*change_)
     && (!early || change > (patient ? largePatient : large)*least);

    active_ = outer > last && change > least && (active_ || begins);
    change_ = change;

    if (!active_)
    {
        jump_ = 0;
    }
}


void Foam::outerAcceleration::apply
(
    const UList<vector>& changes,
    const UList<vector>& dU,
    immersedBodies& bodies,
    volScalarField& p
)
{
    if (first_)
    {
        first_ = false;
        cells_ = bodies.region().cells();
    }

    const bodyShare& share = bodies.list().share();
    const labelList free(freeVelocities::bodies(bodies.list()));
    vectorField velocities(freeVelocities::get(bodies.list()));
    const vectorField weights(freeVelocities::weights(bodies.list()));
    const label nBodies = 3*velocities.size();
    scalarField result(mesh_.nCells() + nBodies);
    scalarField residual(3*cells_.size() + nBodies);
    label at = 0;

    for (const label celli : cells_)
    {
        const vector change(Foam::sqrt(mesh_.V()[celli])*dU[celli]);

        for (direction k = 0; k < 3; ++k)
        {
            residual[at++] = change[k];
        }
    }

    forAll(velocities, i)
    {
        for (direction k = 0; k < 3; ++k)
        {
            result[mesh_.nCells() + 3*i + k] = velocities[i][k];

            if (share.counts(free[i/2]))
            {
                residual[at++] = weights[i][k]*changes[i][k];
            }
        }
    }
    residual.resize(at);
    SubField<scalar>(result, mesh_.nCells()) = p.primitiveField();

    fixedPoint_.apply(residual, result);

    p.primitiveFieldRef() = SubField<scalar>(result, mesh_.nCells());
    p.correctBoundaryConditions();

    jump_ = 0;

    forAll(velocities, i)
    {
        const vector before(velocities[i]);

        for (direction k = 0; k < 3; ++k)
        {
            velocities[i][k] = result[mesh_.nCells() + 3*i + k];
        }

        // Those of rotation follow those of the centre, as what they move the
        // body by
        jump_ = max
        (
            jump_,
            mag(cmptMultiply(weights[i], velocities[i] - before))
           /weights[i - i % 2].x()
        );
    }
    jump_ = share.largest(jump_);
    bodies.setVelocities(velocities);
}
