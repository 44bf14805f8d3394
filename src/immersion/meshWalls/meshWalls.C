// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshWalls.H"
#include "compat.H"
#include "wallPolyPatch.H"

Foam::meshWalls::meshWalls
(
    const fvMesh& mesh,
    const geometricSpace& space
)
:
    wallFacets(space),
    mesh_(mesh)
{
    DynamicList<label> faces;

    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (isA<wallPolyPatch>(patch))
        {
            forAll(patch, i)
            {
                faces.append(patch.start() + i);
            }
        }
    }
    faces_.transfer(faces);
    any_ = returnReduce(faces_.size(), sumOp<label>()) > 0;

    if (!faces_.empty())
    {
        treeBoundBox box(mesh.points());
        box.inflate(0.01);

        tree_.reset
        (
            new indexedOctree<treeDataFace>
            (
                treeDataFace(true, mesh, faces_), box, 8, 10, 3
            )
        );
    }
}


void Foam::meshWalls::collect
(
    const UList<point>& centres,
    const UList<scalar>& radii,
    const periodicity& periods,
    DynamicList<vector>& packed
) const
{
    if (!tree_.valid())
    {
        return;
    }

    const List<tmp<vectorField>> wallU(velocities());
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();

    forAll(centres, bodyi)
    {
        if (radii[bodyi] <= 0)
        {
            continue;
        }

        const List<periodicity::image> images
        (
            periods.localImages(centres[bodyi], radii[bodyi])
        );

        for (const periodicity::image& im : images)
        {
            const point x(centres[bodyi] + im.shift);
            const vector reach(radii[bodyi]*vector::one);
            labelList found
            (
                tree_().findBox(treeBoundBox(x - reach, x + reach))
            );
            Foam::sort(found);

            for (const label i : found)
            {
                const face& f = mesh_.faces()[faces_[i]];
                const pointHit hit(f.nearestPoint(x, mesh_.points()));

                if (hit.distance() > radii[bodyi])
                {
                    continue;
                }

                const label patchi =
                    patches.patchID()[faces_[i] - mesh_.nInternalFaces()];
                const vector U
                (
                    wallU[patchi].valid()
                  ? wallU[patchi]()[faces_[i] - patches[patchi].start()]
                    - im.velocity
                  : -im.velocity
                );
                const bool moves = U != vector::zero;

                packed.append
                (
                    vector(bodyi, (moves ? -1 : 1)*f.size(), patchi)
                );
                for (const label pointi : f)
                {
                    packed.append(mesh_.points()[pointi] - im.shift);
                }
                if (moves)
                {
                    packed.append(U);
                }
            }
        }
    }
}


void Foam::meshWalls::unpack(const UList<vector>& packed)
{
    for (label i = 0; i < packed.size();)
    {
        const label bodyi = label(packed[i].x());
        const label n = label(mag(packed[i].y()));
        const bool moves = packed[i].y() < 0;
        facet f(SubList<point>(packed, n, i + 1));

        f.patch = label(packed[i].z());
        f.U = moves ? packed[i + n + 1] : vector::zero;

        facets_[bodyi].append(f);
        i += n + 1 + moves;
    }
}


void Foam::meshWalls::update
(
    const UList<point>& centres,
    const UList<scalar>& radii,
    const periodicity& periods
)
{
    facets_.clear();
    facets_.resize(centres.size());

    if (!any_)
    {
        return;
    }

    DynamicList<vector> packed;
    collect(centres, radii, periods, packed);

    List<List<vector>> all(Pstream::nProcs());
    all[Pstream::myProcNo()] = packed;
    compat::allGather(all);

    for (const List<vector>& one : all)
    {
        unpack(one);
    }
}
