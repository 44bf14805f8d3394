// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyKernel.H"

namespace
{

//- Is x inside the mesh, and in the cell but for a tenth of its size h [m]? The
//  planes of warped faces have gaps between them.
bool isBeside
(
    const Foam::fvMesh& mesh,
    const Foam::label celli,
    const Foam::scalar h,
    const Foam::point& x
)
{
    for (const Foam::label facei : mesh.cells()[celli])
    {
        const Foam::vector& Sf = mesh.faceAreas()[facei];
        const Foam::scalar outwards =
            mesh.faceOwner()[facei] == celli ? 1 : -1;
        const Foam::label patchi = mesh.boundaryMesh().whichPatch(facei);
        const bool between =
            patchi < 0 || mesh.boundaryMesh()[patchi].coupled();

        if
        (
            outwards*((x - mesh.faceCentres()[facei]) & Sf)
          > (between ? 0.1 : 1e-9)*h*Foam::mag(Sf)
        )
        {
            return false;
        }
    }

    return true;
}

} // End anonymous namespace


Foam::bodyKernel::bodyKernel()
:
    searchCentre_(Zero),
    searchRadius_(0),
    searchMargin_(-1),
    centre_(Zero),
    centreCell(-1),
    nBeside(0),
    hBeside(0)
{}


void Foam::bodyKernel::clear()
{
    images_.clear();
    near_.clear();
    nearImage_.clear();
    cells.clearStorage();
    image.clearStorage();
    weight.clearStorage();
    searchMargin_ = -1;
    centreCell = -1;
    nBeside = 0;
    hBeside = 0;
}


void Foam::bodyKernel::search
(
    const point& x,
    const scalar R,
    const boundBox& centres,
    const cellSearch& search,
    const periodicity& periods
)
{
    searchCentre_ = x;
    searchRadius_ = R;
    searchMargin_ = 0.25*R;

    const scalar reach = R + searchMargin_;

    // Kept without room for more: there may be a million of them
    DynamicList<periodicity::image> images
    (
        1, periodicity::image{Zero, Zero, Zero}
    );
    DynamicList<label> near, nearImage;

    for (const periodicity::image& im : periods.localImages(x, reach))
    {
        const point image(x + im.shift);

        if (!centres.overlaps(image, sqr(reach)))
        {
            continue;
        }
        images.append(im);

        for (const label celli : search.cellsAround(image, reach))
        {
            const vector d(search.mesh().cellCentres()[celli] - image);

            if (magSqr(d) < sqr(reach))
            {
                near.append(celli);
                nearImage.append(images.size() - 1);
            }
        }
    }

    images_ = images;
    near_ = near;
    nearImage_ = nearImage;
}


void Foam::bodyKernel::update
(
    const point& x,
    const scalar R,
    const boundBox& centres,
    const cellSearch& search,
    const periodicity& periods
)
{
    if
    (
        searchMargin_ < 0
     || periods.sliding()
     || R != searchRadius_
     || mag(x - searchCentre_) > searchMargin_
    )
    {
        this->search(x, R, centres, search, periods);
    }

    const fvMesh& mesh = search.mesh();
    const pointField& C = mesh.cellCentres();
    scalar nearest = GREAT;
    label nearesti = -1;

    cells.clear();
    image.clear();
    weight.clear();
    centre_ = x;
    centreCell = -1;
    nBeside = 0;
    hBeside = 0;

    forAll(near_, i)
    {
        const vector& shift = images_[nearImage_[i]].shift;
        const vector ri(C[near_[i]] - x - shift);
        const scalar s = magSqr(ri)/sqr(R);

        if (s >= 1)
        {
            continue;
        }

        if (s < nearest)
        {
            nearest = s;
            nearesti = cells.size();
        }
        cells.append(near_[i]);
        image.append(nearImage_[i]);
        weight.append(sqr(1 - s));
    }

    auto holds = [&](const label i)
    {
        return search.contains
        (
            cells[i],
            C[cells[i]] - r(i, C)
        );
    };

    // Next to smaller cells the nearest centre may be that of another
    if (nearesti >= 0 && holds(nearesti))
    {
        centreCell = cells[nearesti];
        return;
    }

    forAll(cells, i)
    {
        if (mag(r(i, C)) < search.hMax(cells[i]) && holds(i))
        {
            centreCell = cells[i];
            return;
        }
    }

    // From small cells into a large one, whose centre is beyond the kernel
    if (near_.size())
    {
        centreCell = search.findCell(x);
    }
    if (centreCell >= 0 && cells.empty())
    {
        cells.append(centreCell);
        image.append(0);
        weight.append(1);
    }
    if (centreCell >= 0)
    {
        return;
    }

    forAll(cells, i)
    {
        const scalar h = search.hMax(cells[i]);

        if
        (
            mag(r(i, C)) < h
         && isBeside(mesh, cells[i], h, C[cells[i]] - r(i, C))
        )
        {
            ++nBeside;
            hBeside += h;
        }
    }
}


Foam::scalar Foam::bodyKernel::sum(const UList<scalar>& V) const
{
    scalar total = 0;

    forAll(cells, i)
    {
        total += weight[i]*V[cells[i]];
    }

    return total;
}


void Foam::bodyKernel::normalise(const scalar sum)
{
    for (scalar& w : weight)
    {
        w /= sum;
    }
}
