// SPDX-License-Identifier: GPL-3.0-or-later

#include "geometricSpace.H"

Foam::geometricSpace::geometricSpace
(
    const label emptyCmpt,
    const scalar depth,
    const scalar midPlane
)
:
    emptyCmpt_(emptyCmpt),
    depth_(depth),
    midPlane_(midPlane)
{}


Foam::vector Foam::geometricSpace::emptyDir() const
{
    vector dir(Zero);

    if (twoD())
    {
        dir[emptyCmpt_] = 1;
    }

    return dir;
}


Foam::vector Foam::geometricSpace::translation() const
{
    return vector::one - emptyDir();
}


Foam::vector Foam::geometricSpace::rotation() const
{
    return twoD() ? emptyDir() : vector::one;
}


Foam::point Foam::geometricSpace::inPlane(const point& x) const
{
    point result(x);

    if (twoD())
    {
        result[emptyCmpt_] = midPlane_;
    }

    return result;
}


Foam::scalar Foam::geometricSpace::cellSize(const scalar cellVolume) const
{
    return twoD() ? Foam::sqrt(cellVolume/depth_) : Foam::cbrt(cellVolume);
}
