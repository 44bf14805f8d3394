// SPDX-License-Identifier: GPL-3.0-or-later

#include "wallFacets.H"
#include "compat.H"
#include "wallPolyPatch.H"

Foam::wallFacets::facet::facet(const UList<point>& x)
:
    points(x)
{
    const face f(identity(points.size()));

    centre = f.centre(points);
    normal = -f.areaNormal(points);
    normal /= mag(normal) + VSMALL;
}


Foam::point Foam::wallFacets::facet::nearest(const point& x) const
{
    return face(identity(points.size())).nearestPoint(x, points).rawPoint();
}


Foam::wallFacets::wallFacets
(
    const fvMesh& mesh,
    const geometricSpace& space
)
:
    mesh_(&mesh),
    inSpace_(space.translation())
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


Foam::wallFacets::wallFacets
(
    const UList<pointField>& faces,
    const label nBodies,
    const geometricSpace& space
)
:
    mesh_(nullptr),
    inSpace_(space.translation()),
    any_(false),
    facets_(nBodies)
{
    for (DynamicList<facet>& facets : facets_)
    {
        for (const pointField& points : faces)
        {
            facets.append(facet(points));
        }
    }
}


void Foam::wallFacets::collect
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

    forAll(centres, bodyi)
    {
        if (radii[bodyi] <= 0)
        {
            continue;
        }

        const List<vector> shifts
        (
            periods.localShifts(centres[bodyi], radii[bodyi])
        );

        for (const vector& shift : shifts)
        {
            const point x(centres[bodyi] + shift);
            const vector reach(radii[bodyi]*vector::one);
            labelList found
            (
                tree_().findBox(treeBoundBox(x - reach, x + reach))
            );
            Foam::sort(found);

            for (const label i : found)
            {
                const face& f = mesh_->faces()[faces_[i]];
                const pointHit hit(f.nearestPoint(x, mesh_->points()));

                if (hit.distance() > radii[bodyi])
                {
                    continue;
                }

                packed.append(vector(bodyi, f.size(), 0));
                for (const label pointi : f)
                {
                    packed.append(mesh_->points()[pointi] - shift);
                }
            }
        }
    }
}


void Foam::wallFacets::unpack(const UList<vector>& packed)
{
    for (label i = 0; i < packed.size();)
    {
        const label bodyi = label(packed[i].x());
        const label n = label(packed[i].y());

        facets_[bodyi].append
        (
            facet(SubList<point>(packed, n, i + 1))
        );
        i += n + 1;
    }
}


void Foam::wallFacets::update
(
    const UList<point>& centres,
    const UList<scalar>& radii,
    const periodicity& periods
)
{
    if (!mesh_)
    {
        return;
    }

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
