// SPDX-License-Identifier: GPL-3.0-or-later

#include "slidingPair.H"
#include "Time.H"

void Foam::slidingPair::read(const dictionary& dict)
{
    direction_ = dict.get<vector>("direction");

    if (mag(direction_) < VSMALL)
    {
        FatalIOErrorInFunction(dict)
            << "'direction' is " << direction_
            << ", and has to be a vector along the patch"
            << exit(FatalIOError);
    }
    direction_ /= mag(direction_);

    perHeight_ = dict.found("shearRate");

    if (perHeight_ == dict.found("speed"))
    {
        FatalIOErrorInFunction(dict)
            << (perHeight_ ? "Both" : "None") << " of 'speed' [m/s] and"
            << " 'shearRate' [1/s] is there, and one of them is needed"
            << exit(FatalIOError);
    }

    speed_ =
        Function1<scalar>::New(perHeight_ ? "shearRate" : "speed", dict);
    startShift_ = dict.lookupOrDefault<scalar>("shift", 0);
}


void Foam::slidingPair::refuse(const string& reason) const
{
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();

    FatalIOErrorInFunction(patches.objectPath())
        << "The patches '" << patches[patchi_].name() << "' and '"
        << patches[otherPatchi_].name() << "' of the type "
        << patches[patchi_].type() << ' ' << reason.c_str()
        << exit(FatalIOError);
}


Foam::slidingPair::slidingPair
(
    const polyMesh& mesh,
    const label patchi,
    const label otherPatchi,
    const dictionary& dict
)
:
    mesh_(mesh),
    patchi_(patchi),
    otherPatchi_(otherPatchi),
    nCells_(0),
    cellSize_(0)
{
    read(dict);

    const faceList first(gather(patchi_)), second(gather(otherPatchi_));

    findHeight(first, second);
    checkPeriodic();

    const List<labelPair> rows(findRows(first.centres));
    const List<labelPair> others(findRows(second.centres - height_));
    const label n = mesh_.boundaryMesh()[patchi_].size();
    const label nOther = mesh_.boundaryMesh()[otherPatchi_].size();

    setRows(rows, first.first, n, others, nOther, rows_[0]);
    setRows(others, second.first, nOther, rows, n, rows_[1]);
}


Foam::scalar Foam::slidingPair::time() const
{
    // A restarted run may have another last bit; whole time steps do not
    const scalar t = mesh_.time().value();
    const scalar dt = mesh_.time().deltaTValue();
    const scalar whole = dt*std::round(t/dt);

    return mag(t - whole) < 1e-9*mag(t) ? whole : t;
}


Foam::vector Foam::slidingPair::velocity() const
{
    const scalar speed = speed_().value(time());

    return (perHeight_ ? mag(height_) : 1)*speed*direction_;
}


Foam::scalar Foam::slidingPair::shift() const
{
    const scalar t = time();
    const scalar way = t == 0 ? 0 : speed_().integrate(0, t);
    const scalar s = startShift_ + (perHeight_ ? mag(height_) : 1)*way;

    return s - length()*std::floor(s/length());
}
