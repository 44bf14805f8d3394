// SPDX-License-Identifier: GPL-3.0-or-later
/* Description
    On pointMesh a LeesEdwards patch is any patch. */

#include "LeesEdwardsPolyPatch.H"
#include "addToRunTimeSelectionTable.H"
#include "facePointPatch.H"

namespace Foam
{
    addNamedToRunTimeSelectionTable
    (
        facePointPatch, facePointPatch, polyPatch, LeesEdwards
    );
}
