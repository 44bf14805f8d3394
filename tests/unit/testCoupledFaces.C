// SPDX-License-Identifier: GPL-3.0-or-later

#include "coupledFaces.H"
#include "poissonProblem.H"
#include "syncTools.H"
#include "testTools.H"

using namespace Foam;
using testTools::dict;

TEST_CASE("Values are swapped as on all boundary faces", "[coupledFaces]")
{
    const Time time(dict("deltaT 1; writeFrequency 1;"), "/tmp", "none");
    const auto mesh(testTools::smallBox().make(time));
    const coupledFaces faces(*mesh);
    const label nInternal = mesh->nInternalFaces();

    // The centre of the cell at each boundary face
    vectorField all(mesh->nFaces() - nInternal);
    vectorField joined(faces.size());
    label n = 0;

    forAll(all, face)
    {
        all[face] = mesh->cellCentres()[mesh->faceOwner()[nInternal + face]];
    }

    for (const polyPatch& patch : mesh->boundaryMesh())
    {
        CHECK(faces.joined(patch.index()) == patch.coupled());

        for (label i = 0; patch.coupled() && i < patch.size(); ++i, ++n)
        {
            joined[faces.index(patch.index(), i)] =
                all[patch.start() + i - nInternal];
        }
    }

    CHECK(faces.size() == n);
    CHECK(returnReduce(n, sumOp<label>()) >= 2*(4*3 + 5*4));
    faces.swap(joined);
    syncTools::swapBoundaryFaceList(*mesh, all);

    for (const polyPatch& patch : mesh->boundaryMesh())
    {
        for (label i = 0; patch.coupled() && i < patch.size(); ++i)
        {
            CHECK
            (
                joined[faces.index(patch.index(), i)]
             == all[patch.start() + i - nInternal]
            );
        }
    }
}
