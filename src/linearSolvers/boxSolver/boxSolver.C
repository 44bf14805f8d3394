// SPDX-License-Identifier: GPL-3.0-or-later

#include "boxSolver.H"
#include "fastestTransform.H"
#include "fourierTransform.H"
#include "PstreamReduceOps.H"
#include <fftw3.h>


bool Foam::boxSolver::suits(const label direction) const
{
    const slidingPair* pair = laplacian_.sliding();

    if (!pair)
    {
        return true;
    }

    const label along = slidingModes::axis(pair->direction());

    return
        direction == slidingModes::axis(pair->height())
     && along >= 0
     && laplacian_.line(along).trigonometric()
     == lineOperator::basis::periodic;
}


Foam::autoPtr<Foam::slabs> Foam::boxSolver::choose
(
    const tensorGrid& grid
) const
{
    // Time to send a value forth and back [ns]
    const scalar message = 20;

    autoPtr<slabs> best;
    scalar least = GREAT;

    for (label d = 0; d < 3; ++d)
    {
        autoPtr<slabs> parts(new slabs(grid, d));
        const lineOperator& line = laplacian_.line(d);

        if
        (
            !parts().valid()
         || (line.cyclic() && line.size() < 2)
         || !suits(d)
        )
        {
            continue;
        }

        scalar cost = message*parts().moved() - fastestTransform::cost(line);

        for (label i = 0; i < 3; ++i)
        {
            cost += fastestTransform::cost(laplacian_.line(i));
        }

        // Of equal ones the last, along which cells are usually numbered last
        if (cost <= least)
        {
            least = cost;
            best = std::move(parts);
        }
    }

    return best;
}


void Foam::boxSolver::addDirection
(
    const label direction,
    const label inner,
    const label outer,
    const label nLayers,
    scalarField& lambda
)
{
    const char name = "xyz"[direction];
    const lineOperator& line = laplacian_.line(direction);
    const label n = line.size();

    if (n == 1)
    {
        lambda += line.diag(0) - 2*line.off(0);
        return;
    }

    const slidingPair* pair = laplacian_.sliding();
    const bool slides =
        pair && direction == slidingModes::axis(pair->direction());
    autoPtr<lineTransform> transform
    (
        slides
      ? autoPtr<lineTransform>
        (
            new fourierTransform(line, inner, outer*nLayers)
        )
      : fastestTransform::New(line, inner, outer*nLayers)
    );

    forAll(lambda, m)
    {
        lambda[m] += transform().eigenvalues()[(m/inner) % n];
    }

    norm_ *= transform().norm();
    description_ += ", " + transform().description() + " in " + name;
    transforms_.append(transform.release());
}


void Foam::boxSolver::setUp(const tensorGrid& grid, const slabs& parts)
{
    const label t = parts.direction();
    const label a = (t == 0 ? 1 : 0), b = (t == 2 ? 1 : 2);
    scalarField lambda(grid.n(a)*grid.n(b), Zero);

    description_ = std::string("tridiagonal in ") + "xyz"[t];
    addDirection(a, 1, grid.n(b), parts.nLayers(), lambda);
    addDirection(b, grid.n(a), 1, parts.nLayers(), lambda);

    map_.reset(new slabMap(grid, parts));

    if (laplacian_.sliding())
    {
        sliding_.reset
        (
            new slidingModes(*laplacian_.sliding(), t, grid.n(a), grid.n(b))
        );
        description_ += ", sides slide";
    }
    systems_.reset
    (
        new slabTridiagonal
        (
            laplacian_.line(t), parts, lambda, laplacian_.singular(),
            sliding_.get()
        )
    );

    const size_t size = size_t(lambda.size())*parts.nLayers();
    v_ = fftw_alloc_real(size);
    other_ = fftw_alloc_real(size);

    if (laplacian_.singular())
    {
        volumeShare_.setSize(grid.index().size());

        forAll(volumeShare_, celli)
        {
            volumeShare_[celli] = grid.volume(grid.index()[celli]);
        }

        volumeShare_ /= gSum(volumeShare_);
    }

    direction_ = t;
}


Foam::boxSolver::boxSolver
(
    const boxLaplacian& laplacian,
    const tensorGrid& grid
)
:
    laplacian_(laplacian),
    direction_(-1),
    norm_(1),
    v_(nullptr),
    other_(nullptr)
{
    const autoPtr<slabs> parts(choose(grid));

    if (parts.valid())
    {
        setUp(grid, parts());
    }
}


Foam::boxSolver::~boxSolver()
{
    fftw_free(v_);
    fftw_free(other_);
}
