// SPDX-License-Identifier: GPL-3.0-or-later

#include "stokesMirrors.H"
#include "cellSearch.H"

namespace
{
    //- Difference that rounding makes, relative
    const Foam::scalar rounding = 1e-6;
}


Foam::stokesMirrors::stokesMirrors
(
    const dictionary& dict,
    const stokesEquations& equations,
    const stokesBodies& bodies,
    const stokesStates& states,
    const stokesDrive& drive
)
:
    bodies_(bodies),
    states_(states),
    middle_(equations.mesh().bounds().centre())
{
    for
    (
        const vector& n
      : dict.lookupOrDefault<List<vector>>("mirrors", List<vector>())
    )
    {
        const vector size(cmptMag(n)/max(mag(n), VSMALL));
        const direction cmpt = findMax(size);

        if
        (
            size[cmpt] < 1 - SMALL || axes_.found(cmpt)
         || !equations.components().found(cmpt)
        )
        {
            FatalIOErrorInFunction(dict)
                << "'mirrors' has the normal " << n << " and may have each axis"
                << " of the mesh, as (0 1 0), once" << nl
                << exit(FatalIOError);
        }
        axes_.append(cmpt);

        // 1 along the plane, -1 across it, and nothing between
        const scalar across = mag(drive.direction[cmpt]);

        if (across > SMALL && across < 1 - SMALL)
        {
            FatalIOErrorInFunction(dict)
                << "'mirrors' has the normal " << n << ", which is neither"
                << " along nor across the direction " << drive.direction
                << " of 'drive'" << nl << exit(FatalIOError);
        }
        flowSigns_.append(across > 0.5 ? -1 : 1);
    }

    if (axes_.size())
    {
        check(dict, equations);
    }
}


void Foam::stokesMirrors::check
(
    const dictionary& dict,
    const stokesEquations& equations
) const
{
    const fvMesh& mesh = equations.mesh();
    const label n = mesh.nCells();
    const scalarField& source = equations.patchSource();
    const scalar largest = max(mag(source));
    bool same = !Pstream::parRun() && !states_.turned();

    for (label bodyi = 0; bodyi < bodies_.size(); ++bodyi)
    {
        same = same && bodies_[bodyi].shape().round();
    }

    for (label i = 0; same && i < axes_.size(); ++i)
    {
        const direction axis = axes_[i];

        for (label celli = 0; same && celli < n; ++celli)
        {
            point x(mesh.cellCentres()[celli]);
            x[axis] = 2*middle_[axis] - x[axis];

            const label other = bodies_.region().search().findCell(x);
            const scalar h = cbrt(mesh.V()[celli]);

            same = other >= 0
             && mag(mesh.cellCentres()[other] - x) < rounding*h
             && mag(mesh.V()[other]/mesh.V()[celli] - 1) < rounding
             && mag(equations.A0()[other]/equations.A0()[celli] - 1)
              < rounding;

            for (label k = 0; same && k <= equations.components().size(); ++k)
            {
                const bool turned = k < equations.components().size()
                 && equations.components()[k] == axis;
                const scalar sign = flowSigns_[i]*(turned ? -1 : 1);

                same = mag(source[k*n + other] - sign*source[k*n + celli])
                    <= rounding*largest;
            }
        }
    }

    if (!same)
    {
        FatalIOErrorInFunction(dict)
            << "'mirrors' are for round bodies without 'angles' on one"
            << " processor, in a mesh and a flow that are their own images"
            << " about these planes through " << middle_ << ", or in which the"
            << " flow is reversed, and this case is not like that" << nl
            << exit(FatalIOError);
    }
}
