// SPDX-License-Identifier: GPL-3.0-or-later

#include "kernelSums.H"
#include "ListOps.H"

void Foam::kernelSums::sortIntoBins()
{
    const boundBox box(x_, false);
    const vector span(x_.empty() ? vector::zero : box.span());

    low_ = box.min();
    binSize_ = 0.25*kernel_.reach();
    for (direction k = 0; k < 3; ++k)
    {
        nBins_[k] = label(floor(span[k]/binSize_)) + 1;
    }

    labelList bins(x_.size());

    forAll(x_, i)
    {
        const label bx = binOf(x_[i].x(), 0);
        const label by = binOf(x_[i].y(), 1);
        const label bz = binOf(x_[i].z(), 2);

        bins[i] = bx + nBins_.x()*(by + nBins_.y()*bz);
    }

    // Stable: the same sums for the same cells
    sortedOrder(bins, order_);
    x_ = pointField(x_, order_);
    V_ = scalarField(V_, order_);

    first_.setSize(cmptProduct(nBins_) + 1);
    label i = 0;

    forAll(first_, bin)
    {
        while (i < order_.size() && bins[order_[i]] < bin)
        {
            ++i;
        }
        first_[bin] = i;
    }
}


void Foam::kernelSums::findNear
(
    const point& x,
    DynamicList<label>& near,
    DynamicList<vector>& r
) const
{
    const scalar reach = kernel_.reach();
    const vector all(vector::uniform(reach));
    labelVector from, to;

    near.clear();
    r.clear();

    for (direction k = 0; k < 3; ++k)
    {
        from[k] = binOf(x[k] - all[k], k);
        to[k] = binOf(x[k] + all[k], k);
    }

    for (label bz = from.z(); bz <= to.z(); ++bz)
    {
        for (label by = from.y(); by <= to.y(); ++by)
        {
            // Bins along x follow each other
            const label row = nBins_.x()*(by + nBins_.y()*bz);
            const label end = first_[row + to.x() + 1];

            for (label i = first_[row + from.x()]; i < end; ++i)
            {
                const vector d(x_[i] - x);

                if (cmptMax(cmptMag(d)) <= reach)
                {
                    near.append(i);
                    r.append(d);
                }
            }
        }
    }
}


Foam::kernelSums::kernelSums
(
    const fvMesh& mesh,
    const periodicity& periods,
    const averagingKernel& kernel
)
:
    mesh_(mesh),
    kernel_(kernel),
    sent_(Pstream::nProcs()),
    sentVelocity_(Pstream::nProcs())
{
    List<DynamicList<scalar>> places(Pstream::nProcs());

    findSent(periods, places);

    const scalarField x(swap(places));

    x_.setSize(x.size()/3);
    forAll(x_, i)
    {
        x_[i] = point(x[3*i], x[3*i + 1], x[3*i + 2]);
    }

    order_ = identity(x_.size());
    V_ = exchange(1, mesh.cellVolumes());
    sortIntoBins();
    grid_.reset(new gridSums(kernel, x_, mesh.cellCentres()));
}


Foam::scalarField Foam::kernelSums::averagePairs
(
    const label n,
    const UList<scalar>& values
) const
{
    const vectorField& centres = mesh_.cellCentres();
    scalarField means(n*mesh_.nCells(), Zero);
    DynamicList<label> near;
    DynamicList<vector> r;
    DynamicList<scalar> g;

    forAll(centres, celli)
    {
        findNear(centres[celli], near, r);
        g.setSize(near.size());
        kernel_.values(r, g);

        scalar* mean = &means[n*celli];
        scalar sum = 0;

        forAll(near, i)
        {
            const scalar w = V_[near[i]]*g[i];
            const scalar* value = &values[n*near[i]];

            sum += w;
            for (label k = 0; k < n; ++k)
            {
                mean[k] += w*value[k];
            }
        }
        for (label k = 0; k < n; ++k)
        {
            mean[k] /= sum;
        }
    }

    return means;
}


Foam::scalarField Foam::kernelSums::average
(
    const label n,
    const UList<scalar>& values,
    const slideRow& slide
) const
{
    const scalarField all(exchange(n, values, slide));

    if (!grid_->valid())
    {
        return averagePairs(n, all);
    }

    const scalarField sums(grid_->sum(V_));
    scalarField means(n*mesh_.nCells());
    scalarField one(V_.size());

    for (label k = 0; k < n; ++k)
    {
        forAll(one, i)
        {
            one[i] = V_[i]*all[n*i + k];
        }

        const scalarField mean(grid_->sum(one));

        forAll(mean, celli)
        {
            means[n*celli + k] = mean[celli]/sums[celli];
        }
    }

    return means;
}
