// SPDX-License-Identifier: GPL-3.0-or-later

#include "stokesStates.H"

void Foam::stokesStates::check
(
    const dictionary& dict,
    const word& key,
    const List<vectorField>& list,
    const label nBodies
) const
{
    if (list.empty() || (key == "angles" && list.size() != size()))
    {
        FatalIOErrorInFunction(dict)
            << "'" << key << "' has " << list.size() << " states, "
            << (key == "angles" ? "'states' has " : "and must have ")
            << (key == "angles" ? size() : label(1))
            << (key == "angles" ? "" : " or more") << nl
            << exit(FatalIOError);
    }

    forAll(list, i)
    {
        if (list[i].size() != nBodies)
        {
            FatalIOErrorInFunction(dict)
                << "State " << i << " in '" << key << "' has "
                << list[i].size() << " vectors, and must have one for each of "
                << nBodies << " bodies" << nl << exit(FatalIOError);
        }
    }
}


Foam::stokesStates::stokesStates
(
    const dictionary& dict,
    const stokesBodies& bodies
)
{
    if (dict.found("states"))
    {
        positions_ = dict.get<List<vectorField>>("states");
        check(dict, "states", positions_, bodies.size());
    }
    else
    {
        positions_.setSize(1);
        positions_[0].setSize(bodies.size());

        forAll(positions_[0], bodyi)
        {
            positions_[0][bodyi] = bodies[bodyi].state().position;
        }
    }

    if (dict.found("angles"))
    {
        angles_ = dict.get<List<vectorField>>("angles");
        check(dict, "angles", angles_, bodies.size());
    }
}
