// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshWalls.H"
#include "bodyShare.H"
#include "exchange.H"
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
    setSizes();
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


Foam::labelList Foam::meshWalls::search
(
    const point& x,
    const scalar reach
) const
{
    const vector corner(reach*vector::one);
    labelList found(tree_().findBox(treeBoundBox(x - corner, x + corner)));

    Foam::sort(found);

    return found;
}


const Foam::labelList& Foam::meshWalls::facesNear
(
    const label bodyi,
    const point& x,
    const scalar reach
) const
{
    nearby& known = nearby_[bodyi];

    // Whatever was known before: those too far are left out later
    if (mag(x - known.centre) + reach > known.reach)
    {
        known.centre = x;
        known.reach = 1.5*reach;
        known.faces = search(x, known.reach);
    }

    return known.faces;
}


void Foam::meshWalls::pack
(
    const label i,
    const label key,
    const periodicity::image& im,
    const UList<tmp<vectorField>>& wallU,
    DynamicList<vector>& packed
) const
{
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    const label facei = faces_[i];
    const label patchi = patches.patchID()[facei - mesh_.nInternalFaces()];
    const face& f = mesh_.faces()[facei];
    vector U(-im.velocity);

    if (wallU[patchi].valid())
    {
        U += wallU[patchi]()[facei - patches[patchi].start()];
    }

    const bool moves = U != vector::zero;

    packed.append(vector(key, (moves ? -1 : 1)*f.size(), patchi));
    for (const label pointi : f)
    {
        packed.append(mesh_.points()[pointi] - im.shift);
    }
    if (moves)
    {
        packed.append(U);
    }
}


void Foam::meshWalls::collect
(
    const UList<point>& centres,
    const UList<scalar>& radii,
    const periodicity& periods,
    const bodyShare* share,
    List<DynamicList<vector>>& ofRank
) const
{
    if (!tree_.valid())
    {
        return;
    }

    const List<tmp<vectorField>> wallU(velocities());

    nearby_.resize(centres.size());

    forAll(centres, bodyi)
    {
        if (radii[bodyi] <= 0)
        {
            continue;
        }

        DynamicList<vector>& packed =
            ofRank[share ? share->owner(bodyi) : Pstream::myProcNo()];
        const label key = share ? share->key(bodyi) : bodyi;
        const scalar reach = radii[bodyi] + largestMargin_;
        const List<periodicity::image> images
        (
            periods.localImages(centres[bodyi], reach)
        );

        for (const periodicity::image& im : images)
        {
            const point x(centres[bodyi] + im.shift);
            label nWithin;
            const DynamicList<label> chosen
            (
                choose
                (
                    images.size() > 1
                  ? search(x, reach)
                  : facesNear(bodyi, x, reach),
                    x, radii[bodyi], nWithin
                )
            );

            forAll(chosen, i)
            {
                const label k = i < nWithin ? key : -1 - key;

                pack(chosen[i], k, im, wallU, packed);
            }
        }
    }
}


void Foam::meshWalls::unpack
(
    const bodyShare* share,
    const UList<vector>& packed
)
{
    for (label i = 0; i < packed.size();)
    {
        const label key = label(packed[i].x());
        const label known = key < 0 ? -1 - key : key;
        const label bodyi = share ? share->find(known) : known;
        const label n = label(mag(packed[i].y()));
        const bool moves = packed[i].y() < 0;
        facet f(SubList<point>(packed, n, i + 1));

        f.patch = label(packed[i].z());
        f.U = moves ? packed[i + n + 1] : vector::zero;

        facets_[bodyi].append(f);
        within_[bodyi] = within_[bodyi] || key >= 0;
        i += n + 1 + moves;
    }
}


void Foam::meshWalls::update
(
    const UList<point>& centres,
    const UList<scalar>& radii,
    const periodicity& periods,
    const bodyShare* share
)
{
    facets_.clear();
    facets_.resize(centres.size());
    within_.setSize(centres.size());
    within_ = false;

    if (!any_)
    {
        return;
    }

    List<DynamicList<vector>> ofRank(Pstream::nProcs());
    collect(centres, radii, periods, share, ofRank);

    if (share)
    {
        for (const List<vector>& one : exchangeLists(ofRank))
        {
            unpack(share, one);
        }
    }
    else
    {
        unpack(share, gatherAll<vector>(ofRank[Pstream::myProcNo()]));
    }

    forAll(facets_, bodyi)
    {
        if (!within_[bodyi])
        {
            facets_[bodyi].clear();
        }
    }
}
