// SPDX-License-Identifier: GPL-3.0-or-later

#include "geometricSpace.H"

Foam::geometricSpace::geometricSpace(const polyMesh& mesh)
:
    emptyCmpt_(-1),
    depth_(1),
    midPlane_(0)
{
    const Vector<label>& dirs = mesh.solutionD();

    if (mesh.nSolutionD() == 2 && mesh.nGeometricD() == 2)
    {
        for (direction cmpt = 0; cmpt < vector::nComponents; ++cmpt)
        {
            if (dirs[cmpt] < 0)
            {
                emptyCmpt_ = cmpt;
            }
        }

        depth_ = mesh.bounds().span()[emptyCmpt_];
        midPlane_ = mesh.bounds().midpoint()[emptyCmpt_];
    }
    else if (mesh.nSolutionD() != 3 || mesh.nGeometricD() != 3)
    {
        FatalErrorInFunction
            << "Immersed bodies need a mesh in three dimensions or, between"
            << " two empty patches, in two; this one has "
            << mesh.nGeometricD() << " geometric and " << mesh.nSolutionD()
            << " solution directions" << nl << exit(FatalError);
    }
}


Foam::geometricSpace::geometricSpace
(
    const label emptyCmpt,
    const scalar depth
)
:
    emptyCmpt_(emptyCmpt),
    depth_(depth),
    midPlane_(0)
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
