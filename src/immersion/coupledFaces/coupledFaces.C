// SPDX-License-Identifier: GPL-3.0-or-later

#include "coupledFaces.H"
#include "cellSearch.H"

Foam::coupledFaces::coupledFaces(const fvMesh& mesh)
:
    mesh_(mesh),
    first_(mesh.boundary().size(), -1)
{
    forAll(first_, patchi)
    {
        if (cellSearch::matched(mesh.boundaryMesh()[patchi]))
        {
            first_[patchi] = cells_.size();
            cells_.append(mesh.boundary()[patchi].faceCells());
        }
    }
}
