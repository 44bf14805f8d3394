// SPDX-License-Identifier: GPL-3.0-or-later

#include "cellSearch.H"
#include <algorithm>

namespace
{

//- Collect the points in a box from a node of the tree on. Like findBox(),
//  which puts them into a hash table: most of its time.
void collect
(
    const Foam::indexedOctree<Foam::treeDataPoint>& tree,
    const Foam::label nodei,
    const Foam::treeBoundBox& box,
    const Foam::pointField& points,
    Foam::DynamicList<Foam::label>& found
)
{
    const auto& node = tree.nodes()[nodei];

    if (!node.bb_.overlaps(box))
    {
        return;
    }

    for (const auto& child : node.subNodes_)
    {
        if (tree.isNode(child))
        {
            collect(tree, tree.getNode(child), box, points, found);
        }
        else if (tree.isContent(child))
        {
            for (const Foam::label i : tree.contents()[tree.getContent(child)])
            {
                if (box.contains(points[i]))
                {
                    found.append(i);
                }
            }
        }
    }
}

} // End anonymous namespace


const Foam::indexedOctree<Foam::treeDataPoint>& Foam::cellSearch::tree() const
{
    if (!treePtr_.valid())
    {
        // Somewhat larger than the centres' box, so that none is on its edge
        treeBoundBox box(mesh_.cellCentres());
        box.inflate(1e-3);
        box.min() -= point::uniform(SMALL);
        box.max() += point::uniform(SMALL);

        treePtr_.reset
        (
            new indexedOctree<treeDataPoint>
            (
                treeDataPoint(mesh_.cellCentres()), box, 12, 10, 3
            )
        );
    }

    return *treePtr_;
}


Foam::labelList Foam::cellSearch::cellsAround
(
    const point& x,
    const scalar radius
) const
{
    const vector extent(vector::uniform(radius));
    DynamicList<label> cells;

    if (!tree().nodes().empty())
    {
        collect
        (
            tree(),
            0,
            treeBoundBox(x - extent, x + extent),
            mesh_.cellCentres(),
            cells
        );
    }

    // The tree's order depends on its history; sums over the cells must not,
    // or a restarted run would differ in the last bit. A centre between
    // octants is in several.
    Foam::sort(cells);

    const auto last = std::unique(cells.begin(), cells.end());

    cells.resize(label(last - cells.begin()));

    return labelList(std::move(cells));
}


bool Foam::cellSearch::contains(const label celli, const point& x) const
{
    const scalar tolerance = 1e-9*h_[celli];

    for (const label facei : mesh_.cells()[celli])
    {
        const vector& Sf = mesh_.faceAreas()[facei];
        const scalar beyond = (x - mesh_.faceCentres()[facei]) & Sf;
        const bool owner = mesh_.faceOwner()[facei] == celli;

        if ((owner ? beyond : -beyond) > tolerance*mag(Sf))
        {
            return false;
        }
    }

    return true;
}


Foam::label Foam::cellSearch::findCell(const point& x) const
{
    if (!mesh_.nCells())
    {
        return -1;
    }

    const label nearest = tree().findNearest(x, sqr(GREAT)).index();

    if (contains(nearest, x))
    {
        return nearest;
    }

    // Next to smaller cells, whose centres are nearer
    for (const label celli : cellsAround(x, 4*hMax(nearest)))
    {
        if (contains(celli, x))
        {
            return celli;
        }
    }

    return -1;
}


Foam::labelList Foam::cellSearch::cellsAt(const point& x) const
{
    const label first = findCell(x);
    DynamicList<label> cells;

    if (first >= 0)
    {
        for (const label celli : cellsAround(x, 4*hMax(first)))
        {
            if (celli == first || contains(celli, x))
            {
                cells.append(celli);
            }
        }
    }

    return labelList(std::move(cells));
}
