// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshProperties.H"
#include "cyclicPolyPatch.H"
#include "LeesEdwardsPolyPatch.H"
#include "processorCyclicPolyPatch.H"
#include "SubField.H"

namespace
{

using namespace Foam;

//- Sums over all processors of area vectors, of areas and of areas times
//  centres of the faces of a patch, wherever they are
void sumFaces
(
    const polyMesh& mesh,
    const label patchi,
    vector& area,
    scalar& magArea,
    vector& moment
)
{
    area = moment = Zero;
    magArea = 0;

    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        // Decomposition makes patches of their own of those faces whose
        // partners are on other processors
        const auto* part = isA<processorCyclicPolyPatch>(patch);

        if (patch.index() == patchi || (part && part->referPatchID() == patchi))
        {
            const vectorField::subField Sf(patch.faceAreas());
            const vectorField::subField Cf(patch.faceCentres());

            forAll(Sf, i)
            {
                area += Sf[i];
                magArea += mag(Sf[i]);
                moment += mag(Sf[i])*Cf[i];
            }
        }
    }

    reduce(area, sumOp<vector>());
    reduce(magArea, sumOp<scalar>());
    reduce(moment, sumOp<vector>());
}


//- Refuse patches that are coupled, but not face by face: bodies do not reach
//  across them, and what they exchange takes all processors
void checkCoupled(const polyBoundaryMesh& patches)
{
    for (const polyPatch& patch : patches)
    {
        if
        (
            isA<coupledPolyPatch>(patch)
         && !isA<cyclicPolyPatch>(patch)
         && !isA<processorPolyPatch>(patch)
         && !isA<LeesEdwardsPolyPatch>(patch)
        )
        {
            FatalIOErrorInFunction(patches.objectPath())
                << "Immersed bodies need coupled patches that match face by"
                << " face, and '" << patch.name() << "' is of the type '"
                << patch.type() << "': allowed are 'type cyclic' and 'type "
                << LeesEdwardsPolyPatch::typeName << "'" << nl
                << exit(FatalIOError);
        }
    }
}

} // End anonymous namespace


Foam::periodicity Foam::meshProperties::periods(const polyMesh& mesh)
{
    periodicity result;

    checkCoupled(mesh.boundaryMesh());

    if (const slidingPair* pair = LeesEdwardsPolyPatch::findPair(mesh))
    {
        const polyPatch& patch = mesh.boundaryMesh()[pair->patchIndex()];
        const point onPatch(gSum(patch.faceCentres())/returnReduce
        (
            patch.size(), sumOp<label>()
        ));

        result.addSliding
        (
            pair->height(),
            normalised(pair->height()),
            onPatch - pair->height()
        );
        slide(mesh, result);
    }

    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        const cyclicPolyPatch* cyclic = isA<cyclicPolyPatch>(patch);

        if (!cyclic || !cyclic->owner())
        {
            continue;
        }

        vector Sf, Sf1, moment, moment1;
        scalar area, area1;
        sumFaces(mesh, patch.index(), Sf, area, moment);
        sumFaces(mesh, cyclic->neighbPatchID(), Sf1, area1, moment1);

        if (area < VSMALL)
        {
            continue;
        }

        if
        (
            cyclic->transform() == cyclicPolyPatch::ROTATIONAL
         || mag(Sf + Sf1) > 1e-4*area
        )
        {
            WarningInFunction
                << "Bodies are not continued across the cyclic patches '"
                << patch.name() << "' and '" << cyclic->neighbPatchName()
                << "', which are turned against each other" << nl << endl;
            continue;
        }

        // Outward normals: the other patch is on the other side
        result.add(moment1/area1 - moment/area, -Sf/mag(Sf), moment/area);
    }

    result.setLocal(mesh.points());

    return result;
}


void Foam::meshProperties::slide(const polyMesh& mesh, periodicity& periods)
{
    if (periods.sliding())
    {
        const slidingPair& pair = *LeesEdwardsPolyPatch::findPair(mesh);

        periods.slide(pair.shift()*pair.direction(), pair.velocity());
    }
}
