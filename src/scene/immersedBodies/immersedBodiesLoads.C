// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedBodies.H"
#include "compat.H"
#include "profiling.H"

void Foam::immersedBodies::reduceLoads(const bool response)
{
    if (!Pstream::parRun())
    {
        return;
    }

    const label n = response ? bodyLoad::nPacked : bodyLoad::nPackedLoad;
    const auto measured = [&](const label bodyi)
    {
        return bodies_[bodyi].resolved() && region_.selected(bodyi);
    };
    scalarField packed(n*nResolved());
    label at = 0;

    forAll(loads_, bodyi)
    {
        if (measured(bodyi))
        {
            loads_[bodyi].pack(packed, at, n);
            at += n;
        }
    }

    packed.resize(at);
    compat::allReduce(packed, plusEqOp<scalar>());
    at = 0;

    forAll(loads_, bodyi)
    {
        if (measured(bodyi))
        {
            loads_[bodyi].unpack(packed, at, n);
            at += n;
        }
    }
}


Foam::scalar Foam::immersedBodies::correct
(
    const ddtCoefficients& ddt,
    const fvVectorMatrix& E0,
    const volScalarField& A0,
    const volVectorField& U,
    const vectorField& gradP,
    const vectorField& dU,
    const bool response,
    const bool addedMass
)
{
    addProfiling(correct, "immersedBodies::correct");

    if (nResolved())
    {
        region_.load(bodies_, ddt, E0, A0, U, gradP, dU, response, loads_);

        forAll(loads_, bodyi)
        {
            if (region_.selected(bodyi))
            {
                loads_[bodyi].scale(nParts_[bodyi], response);
            }
        }

        reduceLoads(response);
        noteUnresolved();
    }

    const scalar added = !addedMass ? 0 : space_.twoD() ? 1 : 0.5;
    scalar most = 0;

    forAll(bodies_, bodyi)
    {
        immersedBody& body = bodies_[bodyi];

        if (!body.resolved() || !region_.selected(bodyi))
        {
            // correctUnresolved() has moved it on, or it stays as it is
            continue;
        }

        // One that is all but outside the mesh has nothing to go by
        const scalar change = !body.isFree() || inMesh(bodyi)
          ? body.correctVelocity
            (
                loads_[bodyi], ddt, g_, added
            )
          : 0;

        crowd_.note(bodyi, change);
        most = max(most, change);
    }

    window_.follow(bodies_);

    return most;
}


template<class Function>
void Foam::immersedBodies::forFree(const Function& f) const
{
    forAll(bodies_, bodyi)
    {
        if (bodies_[bodyi].isFree() && bodies_[bodyi].resolved())
        {
            f(bodyi);
        }
    }
}


Foam::vectorField Foam::immersedBodies::velocities() const
{
    DynamicList<vector> velocities(2*size());

    forFree([&](const label bodyi)
    {
        const Pair<vector> both(bodies_[bodyi].velocitiesWithoutContact());

        velocities.append(both.first());
        velocities.append(both.second());
    });

    return vectorField(std::move(velocities));
}


void Foam::immersedBodies::setVelocities(const vectorField& velocities)
{
    label i = 0;

    forFree([&](const label bodyi)
    {
        bodies_[bodyi].setVelocitiesWithoutContact
        (
            Pair<vector>(velocities[i], velocities[i + 1])
        );
        i += 2;
    });
    window_.follow(bodies_);
}


Foam::vectorField Foam::immersedBodies::velocityWeights() const
{
    DynamicList<vector> weights(2*size());

    forFree([&](const label bodyi)
    {
        const immersedBody& body = bodies_[bodyi];
        const tensor I(body.inertia(body.state()));

        weights.append(Foam::sqrt(body.volume())*vector::one);
        weights.append(vector(sqrt(I.xx()), sqrt(I.yy()), sqrt(I.zz())));
    });

    return vectorField(std::move(weights));
}
