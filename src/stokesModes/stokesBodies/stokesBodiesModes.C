// SPDX-License-Identifier: GPL-3.0-or-later

#include "stokesBodies.H"
#include "compat.H"

Foam::rigidMotion Foam::stokesBodies::motion(const label mode) const
{
    const label n = nPerBody();
    const label k = mode % n;
    rigidMotion motion{mode/n, Zero, Zero};

    // Components that the space has, in order
    label i = 0;

    for (direction cmpt = 0; cmpt < 3; ++cmpt)
    {
        if (space_.translation()[cmpt] > 0)
        {
            motion.U[cmpt] = i++ == k;
        }
    }
    for (direction cmpt = 0; cmpt < 3; ++cmpt)
    {
        if (space_.rotation()[cmpt] > 0)
        {
            motion.omega[cmpt] = i++ == k;
        }
    }

    return motion;
}


void Foam::stokesBodies::addSources
(
    const label mode,
    vectorField& momentum,
    scalarField& flux
) const
{
    const rigidMotion moving(motion(mode));
    const point& centre = bodies_[moving.body].state().position;
    const vectorField& Sf = mesh_.faceAreas();

    for (const bodyRegion& region : region_.regions())
    {
        if (region.body() != moving.body)
        {
            continue;
        }

        forAll(region.cells, i)
        {
            momentum[region.cells[i]] +=
                region.resistance[i]*moving(region.x(i) - centre);
        }
        forAll(region.faces, i)
        {
            const label facei = region.faces[i];

            flux[facei] += region.faceShare[i]
               *(moving(region.faceX(i) - centre) & Sf[facei]);
        }
    }
}


Foam::scalarField Foam::stokesBodies::loads
(
    const stokesFlow& flow,
    const vector& f,
    const label moving
) const
{
    const scalarField& V = mesh_.V();
    const label n = nPerBody();
    scalarField loads(nModes(), Zero);
    const label mover = moving >= 0 ? motion(moving).body : -1;
    vectorField KU(mesh_.nCells(), Zero);
    scalarField flux(mesh_.nFaces(), Zero);

    if (moving >= 0)
    {
        addSources(moving, KU, flux);
    }

    for (const bodyRegion& region : region_.regions())
    {
        const label bodyi = region.body();
        const point& centre = bodies_[bodyi].state().position;
        vector force(Zero), torque(Zero);

        forAll(region.cells, i)
        {
            const label celli = region.cells[i];
            const vector r(region.x(i) - centre);
            const vector Ub(bodyi == mover ? motion(moving)(r) : Zero);
            const vector drive(flow.gradP[celli] - f);
            const scalar A0 = A0_[celli], K = K_[celli];

            // As bandLoads::add(): rows are solved to a velocity, and
            // the resistance times a difference of velocities is not accurate
            const vector q
            (
                region.resistance[i]/(A0 + K)
               *(
                    A0*(Ub - flow.U[celli]) + (K*Ub - KU[celli])
                  + (1 - shield_[celli])*drive - flow.divStress[celli]
                )
              + region.share[i]*drive
            );

            force += V[celli]*q;
            torque += V[celli]*(r^q);
        }

        for (label k = 0; k < n; ++k)
        {
            const rigidMotion one(motion(n*bodyi + k));

            loads[n*bodyi + k] += (one.U & force) + (one.omega & torque);
        }
    }

    compat::allReduce(loads, plusEqOp<scalar>());

    return loads;
}
