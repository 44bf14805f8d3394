// SPDX-License-Identifier: GPL-3.0-or-later

#include "cellSearch.H"
#include "cyclicPolyPatch.H"
#include "LeesEdwardsPolyPatch.H"
#include "processorPolyPatch.H"
#include "zeroGradientFvPatchFields.H"

Foam::cellSearch::cellSearch(const fvMesh& mesh, const geometricSpace& space)
:
    mesh_(mesh),
    h_(mesh.nCells()),
    edges_
    (
        IOobject("cellEdges", mesh.time().timeName(), mesh),
        mesh,
        dimensionedSymmTensor(dimArea, Zero),
        zeroGradientFvPatchSymmTensorField::typeName
    ),
    hMax_(0),
    bounds_(mesh.points(), false),
    uniform_(false),
    boxes_(mesh.nCells()),
    inside_(mesh.boundaryMesh().size()),
    faceMet_(mesh.nFaces())
{
    forAll(inside_, patchi)
    {
        const polyPatch& patch = mesh.boundaryMesh()[patchi];

        inside_[patchi] =
            matched(patch) || isA<LeesEdwardsPolyPatch>(patch);
    }

    forAll(h_, celli)
    {
        h_[celli] = space.cellSize(mesh.V()[celli]);
    }

    // Of a polyhedron as of a box: twelve times the second moment of the faces'
    // centres, each weighted with the volume of its pyramid
    const vector across(vector::one - space.emptyDir());

    forAll(h_, celli)
    {
        const point& centre = mesh.cellCentres()[celli];
        symmTensor& M = edges_[celli];

        boxes_.set(celli, isBox(mesh.cells()[celli]));

        for (const label facei : mesh.cells()[celli])
        {
            const vector r(mesh.faceCentres()[facei] - centre);
            const vector inPlane(cmptMultiply(r, across));
            const scalar pyramid = mag(mesh.faceAreas()[facei] & r)/3;

            M += 12*pyramid/mesh.V()[celli]*sqr(inPlane);
        }
    }
    edges_.correctBoundaryConditions();
    findSizes(space);

    // On coupled patches those of the other side, also if they are cyclic
    for (auto& patchEdges : edges_.boundaryFieldRef())
    {
        if (patchEdges.coupled())
        {
            patchEdges == patchEdges.patchNeighbourField()();
        }
    }
}


bool Foam::cellSearch::isBox(const cell& faces) const
{
    for (const label facei : faces)
    {
        const vector& Sf = mesh_.faceAreas()[facei];

        if (cmptMax(cmptMag(Sf)) < (1 - 1e-9)*mag(Sf))
        {
            return false;
        }
    }

    return faces.size() == 6;
}


void Foam::cellSearch::findSizes(const geometricSpace& space)
{
    forAll(h_, celli)
    {
        hMax_ = max(hMax_, hMax(celli));
    }
    reduce(hMax_, maxOp<scalar>());
    bounds_.min() -= vector::uniform(0.5*hMax_);
    bounds_.max() += vector::uniform(0.5*hMax_);

    const vector h2(sqr(hMax_)*(vector::one - space.emptyDir()));
    const symmTensor cube(h2.x(), 0, 0, h2.y(), 0, h2.z());
    bool uniform = true;

    for (const symmTensor& M : edges_)
    {
        uniform = uniform && mag(M - cube) < 1e-9*sqr(hMax_);
    }
    uniform_ = returnReduce(uniform, andOp<bool>());
}


Foam::symmTensor Foam::cellSearch::faceEdges(const label facei) const
{
    if (mesh_.isInternalFace(facei))
    {
        return 0.5
           *(
                edges_[mesh_.faceOwner()[facei]]
              + edges_[mesh_.faceNeighbour()[facei]]
            );
    }

    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    const label patchi = patches.patchID()[facei - mesh_.nInternalFaces()];

    return 0.5
       *(
            edges_[mesh_.faceOwner()[facei]]
          + edges_.boundaryField()[patchi][facei - patches[patchi].start()]
        );
}


Foam::scalar Foam::cellSearch::faceH
(
    const label facei,
    const vector& n
) const
{
    return uniform_ ? hMax_ : Foam::sqrt(n & (faceEdges(facei) & n));
}


Foam::scalar Foam::cellSearch::faceHMax(const label facei) const
{
    return uniform_ ? hMax_ : Foam::sqrt(maxEigenvalue(faceEdges(facei)));
}


Foam::scalar Foam::cellSearch::c4(const label celli, const vector& n) const
{
    if (boxes_.test(celli))
    {
        // The sum below, of a box
        const symmTensor& M = edges_[celli];
        const vector n2(cmptMultiply(n, n));
        const vector h2n2(cmptMultiply(vector(M.xx(), M.yy(), M.zz()), n2));

        return (h2n2 & n2)/max(cmptSum(h2n2), VSMALL);
    }

    const point& centre = mesh_.cellCentres()[celli];
    scalar second = 0;
    scalar fourth = 0;

    for (const label facei : mesh_.cells()[celli])
    {
        // To the centre beyond the face, were the mesh regular
        const vector r(2*(mesh_.faceCentres()[facei] - centre));
        const vector& Sf = mesh_.faceAreas()[facei];
        const scalar x2 = sqr(r & n);
        const scalar weight = magSqr(Sf)/max(mag(Sf & r), VSMALL);

        second += weight*x2;
        fourth += weight*sqr(x2);
    }

    return fourth/max(second*sqr(h(celli, n)), VSMALL);
}


bool Foam::cellSearch::matched(const polyPatch& patch)
{
    return isA<processorPolyPatch>(patch) || isA<cyclicPolyPatch>(patch);
}


Foam::labelList Foam::cellSearch::facesOf(const labelUList& cells) const
{
    const cellList& cellFaces = mesh_.cells();
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    DynamicList<label> faces(4*cells.size());

    for (const label celli : cells)
    {
        for (const label facei : cellFaces[celli])
        {
            const bool counts =
                mesh_.isInternalFace(facei)
             || inside_[patches.patchID()[facei - mesh_.nInternalFaces()]];

            if (counts && faceMet_.set(facei))
            {
                faces.append(facei);
            }
        }
    }

    // Sorted: as of the cells, the order must not depend on where the search
    // was made
    label facei = faces.empty() ? -1 : min(faces);

    for (label& sorted : faces)
    {
        sorted = facei;
        faceMet_.unset(facei);
        facei = faceMet_.find_next(facei);
    }

    return labelList(std::move(faces));
}
