// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshWindow.H"
#include "checkKeywords.H"
#include "wallPolyPatch.H"

Foam::meshWindow::meshWindow
(
    const dictionary& dict,
    const fvMesh& mesh,
    const PtrList<immersedBody>& bodies
)
:
    comoving_
    (
        keywords::choice(dict, "type", {"fixed", "comoving"}, "fixed")
     == "comoving"
    ),
    direction_(Zero),
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

    keywords::check(dict, {"type", "direction", "follow", "velocity"});
    direction_ = normalised(dict.get<vector>("direction"));
    checkWalls(dict, mesh);

    wordList names({"centroid"});

    for (const immersedBody& body : bodies)
    {
        names.append(body.name());
    }

    follow_ = keywords::choice(dict, "follow", names, "centroid");

    if (follow_ == "centroid")
    {
        follow_.clear();
    }

    if (prescribed_)
    {
        velocity_ = dict.get<scalar>("velocity")*direction_;
    }
}


void Foam::meshWindow::checkWalls
(
    const dictionary& dict,
    const fvMesh& mesh
) const
{
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        scalar across = 0;

        if (isA<wallPolyPatch>(patch))
        {
            for (const vector& Sf : patch.faceAreas())
            {
                across = max(across, mag(Sf & direction_)/mag(Sf));
            }
        }

        if (returnReduce(across, maxOp<scalar>()) > 1e-6)
        {
            FatalIOErrorInFunction(dict)
                << "'direction " << direction_ << "' is not parallel to the"
                << " wall '" << patch.name() << "': a comoving window needs a"
                << " straight tube" << nl << exit(FatalIOError);
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


void Foam::meshWindow::follow(const PtrList<immersedBody>& bodies)
{
    if (!comoving_ || prescribed_)
    {
        return;
    }

    vector sum(Zero);
    label n = 0;

    for (const immersedBody& body : bodies)
    {
        if (follow_.empty() || body.name() == follow_)
        {
            sum += body.state().U;
            ++n;
        }
    }

    if (n)
    {
        velocity_ = (sum/n & direction_)*direction_;
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
