// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshWalls.H"
#include "noSlipFvPatchVectorField.H"
#include "volFields.H"
#include "wallMotion.H"
#include "wallPolyPatch.H"

Foam::wordList Foam::meshWalls::patches() const
{
    wordList names;

    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        names.append(isA<wallPolyPatch>(patch) ? patch.name() : word::null);
    }

    return names;
}


Foam::List<Foam::tmp<Foam::vectorField>> Foam::meshWalls::velocities() const
{
    List<tmp<vectorField>> result(mesh_.boundaryMesh().size());

    if (!mesh_.foundObject<volVectorField>("U"))
    {
        return result;
    }

    for
    (
        const fvPatchVectorField& U
      : mesh_.lookupObject<volVectorField>("U").boundaryField()
    )
    {
        const label patchi = U.patch().index();

        if (!isA<wallPolyPatch>(U.patch().patch()))
        {
            continue;
        }

        if (const auto* wall = dynamic_cast<const wallMotion*>(&U))
        {
            result[patchi] = wall->wallVelocity();
        }
        else if (U.fixesValue() && !isA<noSlipFvPatchVectorField>(U))
        {
            result[patchi] = tmp<vectorField>(U);
        }
    }

    return result;
}


Foam::scalar Foam::meshWalls::maxSpeed() const
{
    scalar speed = 0;

    if (any_)
    {
        for (const tmp<vectorField>& U : velocities())
        {
            if (U.valid())
            {
                for (const vector& u : U())
                {
                    speed = max(speed, mag(u));
                }
            }
        }
        reduce(speed, maxOp<scalar>());
    }

    return speed;
}
