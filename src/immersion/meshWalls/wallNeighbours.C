// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshWalls.H"
#include "bitSet.H"
#include "syncTools.H"

namespace
{

//- Difference of normals above which faces are not in one plane
const Foam::scalar flat = 1e-4;

} // End anonymous namespace


Foam::boolList Foam::meshWalls::curvedPoints() const
{
    vectorField low(mesh_.nPoints(), vector::max);
    vectorField high(mesh_.nPoints(), vector::min);

    for (const label facei : faces_)
    {
        const face& f = mesh_.faces()[facei];
        const vector n(f.unitNormal(mesh_.points()));

        for (const label pointi : f)
        {
            low[pointi] = min(low[pointi], n);
            high[pointi] = max(high[pointi], n);
        }
    }

    syncTools::syncPointList(mesh_, low, minEqOp<vector>(), vector::max);
    syncTools::syncPointList(mesh_, high, maxEqOp<vector>(), vector::min);

    boolList curved(mesh_.nPoints(), false);

    for (const label facei : faces_)
    {
        for (const label pointi : mesh_.faces()[facei])
        {
            curved[pointi] = mag(high[pointi] - low[pointi]) > flat;
        }
    }

    return curved;
}


void Foam::meshWalls::setSizes()
{
    scalarField largest(mesh_.nPoints(), Zero);

    radii_.setSize(faces_.size());

    forAll(faces_, i)
    {
        const face& f = mesh_.faces()[faces_[i]];
        const point& centre = mesh_.faceCentres()[faces_[i]];

        radii_[i] = 0;
        for (const label pointi : f)
        {
            radii_[i] = max(radii_[i], mag(mesh_.points()[pointi] - centre));
        }
        for (const label pointi : f)
        {
            largest[pointi] = max(largest[pointi], 2*radii_[i]);
        }
    }

    syncTools::syncPointList(mesh_, largest, maxEqOp<scalar>(), scalar(0));
    setNeighbours(largest);
}


void Foam::meshWalls::setNeighbours(const UList<scalar>& largest)
{
    const boolList curved(curvedPoints());
    bitSet coupled(mesh_.nPoints());

    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if (patch.coupled())
        {
            coupled.set(patch.meshPoints());
        }
    }

    // By curved point, the faces that have it
    Map<DynamicList<label>> having;

    forAll(faces_, i)
    {
        for (const label pointi : mesh_.faces()[faces_[i]])
        {
            if (curved[pointi])
            {
                having(pointi).append(i);
            }
        }
    }

    beside_.setSize(faces_.size());
    margins_.setSize(faces_.size());
    chosen_.setSize(faces_.size());
    chosen_ = false;
    largestMargin_ = 0;

    forAll(faces_, i)
    {
        labelHashSet beside;

        margins_[i] = 0;
        for (const label pointi : mesh_.faces()[faces_[i]])
        {
            if (curved[pointi])
            {
                beside.insert(having[pointi]);
            }
            if (curved[pointi] && coupled.test(pointi))
            {
                margins_[i] = max(margins_[i], largest[pointi]);
            }
        }
        beside_[i] = beside.sortedToc();
        largestMargin_ = max(largestMargin_, margins_[i]);
    }
    reduce(largestMargin_, maxOp<scalar>());
}


Foam::DynamicList<Foam::label> Foam::meshWalls::choose
(
    const UList<label>& found,
    const point& x,
    const scalar radius,
    label& nWithin
) const
{
    DynamicList<label> within, others;

    for (const label i : found)
    {
        const face& f = mesh_.faces()[faces_[i]];
        const scalar most = radius + margins_[i];
        const scalar least =
            mag(x - mesh_.faceCentres()[faces_[i]]) - radii_[i];

        if (least <= most)
        {
            const scalar d = f.nearestPoint(x, mesh_.points()).distance();

            if (d <= most)
            {
                chosen_[i] = true;
                (d <= radius ? within : others).append(i);
            }
        }
    }

    for (const label i : within)
    {
        for (const label j : beside_[i])
        {
            if (!chosen_[j])
            {
                chosen_[j] = true;
                others.append(j);
            }
        }
    }

    nWithin = within.size();
    Foam::sort(others);
    within.append(others);

    for (const label i : within)
    {
        chosen_[i] = false;
    }

    return within;
}
