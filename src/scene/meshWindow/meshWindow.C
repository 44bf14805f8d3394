// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshWindow.H"
#include "bodyShare.H"
#include "checkKeywords.H"
#include "wallPolyPatch.H"

Foam::meshWindow::meshWindow
(
    const dictionary& dict,
    const fvMesh& mesh,
    const placedBodies& placed
)
:
    comoving_
    (
        keywords::choice(dict, "type", {"fixed", "comoving"}, "fixed")
     == "comoving"
    ),
    prescribed_(dict.found("velocity")),
    velocity_(Zero),
    oldVelocity_(Zero),
    displacement_(Zero),
    oldDisplacement_(Zero)
{
    if (!comoving_)
    {
        keywords::check(dict, {"type"});
        return;
    }

    keywords::check
    (
        dict, {"type", "direction", "directions", "follow", "velocity"}
    );
    directions_ = readDirections(dict);
    checkWalls(dict, mesh);

    wordList names({"centroid"});

    for (label number = 0; number < placed.size(); ++number)
    {
        names.append(placed.name(number));
    }

    follow_ = keywords::choice(dict, "follow", names, "centroid");

    if (follow_ == "centroid")
    {
        follow_.clear();
    }

    if (prescribed_)
    {
        velocity_ = readVelocity(dict);
    }
}


Foam::List<Foam::vector> Foam::meshWindow::readDirections
(
    const dictionary& dict
)
{
    if (dict.found("direction") == dict.found("directions"))
    {
        FatalIOErrorInFunction(dict)
            << "'" << dict.dictName() << "' of the type comoving needs one of"
            << " 'direction' and 'directions'" << nl << exit(FatalIOError);
    }

    if (dict.found("direction"))
    {
        return List<vector>(1, normalised(dict.get<vector>("direction")));
    }

    const List<vector> given(dict.get<List<vector>>("directions"));
    List<vector> directions(given);
    bool good = given.size() > 0;

    forAll(given, i)
    {
        vector& e = directions[i];

        for (label j = 0; j < i; ++j)
        {
            e -= (e & directions[j])*directions[j];
        }
        good = good && mag(e) > 1e-6*mag(given[i]) && mag(e) > 0;
        e = normalised(e);
    }

    if (!good)
    {
        FatalIOErrorInFunction(dict)
            << "'directions " << flatOutput(given) << "' in '"
            << dict.dictName() << "' must be one to three vectors, none of"
            << " them in the span of those before it" << nl
            << exit(FatalIOError);
    }

    return directions;
}


Foam::vector Foam::meshWindow::readVelocity(const dictionary& dict) const
{
    const bool one = dict.found("direction");

    if (token(dict.lookup("velocity")).isNumber() != one)
    {
        FatalIOErrorInFunction(dict)
            << "'velocity' in '" << dict.dictName() << "' must be a speed [m/s]"
            << " with 'direction', a vector [m/s] with 'directions'" << nl
            << exit(FatalIOError);
    }

    if (one)
    {
        return dict.get<scalar>("velocity")*directions_[0];
    }

    const vector V(dict.get<vector>("velocity"));

    if (mag(V - along(V)) > 1e-6*mag(V))
    {
        FatalIOErrorInFunction(dict)
            << "'velocity " << V << "' in '" << dict.dictName() << "' must be"
            << " in the span of 'directions'" << nl << exit(FatalIOError);
    }

    return V;
}


Foam::vector Foam::meshWindow::along(const vector& v) const
{
    vector sum((v & directions_[0])*directions_[0]);

    for (label i = 1; i < directions_.size(); ++i)
    {
        sum += (v & directions_[i])*directions_[i];
    }

    return sum;
}


void Foam::meshWindow::checkWalls
(
    const dictionary& dict,
    const fvMesh& mesh
) const
{
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        for (const vector& e : directions_)
        {
            scalar across = 0;

            if (isA<wallPolyPatch>(patch))
            {
                for (const vector& Sf : patch.faceAreas())
                {
                    across = max(across, mag(Sf & e)/mag(Sf));
                }
            }

            if (returnReduce(across, maxOp<scalar>()) > 1e-6)
            {
                FatalIOErrorInFunction(dict)
                    << "'direction " << e << "' is not parallel to the"
                    << " wall '" << patch.name() << "': a comoving window"
                    << " needs walls that slide along themselves, as those of"
                    << " a straight tube do" << nl << exit(FatalIOError);
            }
        }
    }
}


void Foam::meshWindow::beginStep()
{
    oldVelocity_ = velocity_;
    oldDisplacement_ = displacement_;
}


void Foam::meshWindow::undoStep()
{
    velocity_ = oldVelocity_;
    displacement_ = oldDisplacement_;
}


void Foam::meshWindow::follow(const bodyList& bodies)
{
    if (!comoving_ || prescribed_)
    {
        return;
    }

    const bodyShare& share = bodies.share();
    const auto followed = [&](const label bodyi)
    {
        return follow_.empty() || bodies[bodyi].name() == follow_;
    };
    const label n = share.sum<label>(followed);

    if (n)
    {
        const vector sum = share.sum<vector>
        (
            [&](const label bodyi)
            {
                return followed(bodyi) ? bodies[bodyi].state().U : vector(Zero);
            }
        );

        velocity_ = along(sum/n);
    }
}


void Foam::meshWindow::move(const scalar dt)
{
    displacement_ = oldDisplacement_ + dt*meanVelocity();
}


void Foam::meshWindow::readState(const dictionary& dict)
{
    velocity_ = dict.get<vector>("velocity");
    displacement_ = dict.get<vector>("displacement");
}


void Foam::meshWindow::writeState(Ostream& os) const
{
    os.beginBlock("window");
    os.writeEntry("velocity", velocity_);
    os.writeEntry("displacement", displacement_);
    os.endBlock();
}
