// SPDX-License-Identifier: GPL-3.0-or-later

#include "restrainedMotion.H"

Foam::restrainedMotion::restrainedMotion(const bodyState& start)
:
    startPosition_(start.position),
    startOrientation_(start.orientation),
    time_(0),
    deltaT_(0),
    meshShift_(Zero)
{}


Foam::bodyRestraint::motion Foam::restrainedMotion::of
(
    const bodyMotion& body
) const
{
    return bodyRestraint::motion
    {
        body.unwrapped() + meshShift_,
        startPosition_,
        bodyRestraint::turn(startOrientation_, body.now().orientation),
        body.now().U,
        body.now().omega,
        time_,
        0.5*deltaT_
    };
}


void Foam::restrainedMotion::read(const dictionary& dict)
{
    dict.readIfPresent("startPosition", startPosition_);
    dict.readIfPresent("startOrientation", startOrientation_);
}


void Foam::restrainedMotion::write(Ostream& os) const
{
    os.writeEntry("startPosition", startPosition_);
    os.writeEntry("startOrientation", startOrientation_);
}
