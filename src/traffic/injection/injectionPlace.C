// SPDX-License-Identifier: GPL-3.0-or-later

#include "injectionPlace.H"
#include "checkKeywords.H"
#include "mathematicalConstants.H"
#include "SubField.H"
#include "vectorField.H"

const Foam::wordList Foam::injectionPlace::keywords
({
    "position", "positions", "region", "patch"
});


Foam::injectionPlace::injectionPlace
(
    const dictionary& dict,
    const geometricSpace& space,
    const polyMesh& mesh
)
:
    space_(space),
    origin_(Zero),
    axes_(vector::zero),
    round_(false),
    inward_(Zero),
    gap_(0)
{
    wordList given;

    for (const word& key : keywords)
    {
        if (dict.found(key))
        {
            given.append(key);
        }
    }

    if (given.size() != 1)
    {
        FatalIOErrorInFunction(dict)
            << "'" << dict.dictName() << "' needs exactly one of "
            << flatOutput(keywords) << " and has " << flatOutput(given) << nl
            << exit(FatalIOError);
    }

    if (given[0] == "position")
    {
        positions_ = pointField(1, dict.get<point>("position"));
    }
    else if (given[0] == "positions")
    {
        positions_ = dict.get<pointField>("positions");

        if (positions_.empty())
        {
            FatalIOErrorInFunction(dict)
                << "'positions' in '" << dict.dictName() << "' is empty" << nl
                << exit(FatalIOError);
        }
    }
    else if (given[0] == "region")
    {
        readRegion(dict.subDict("region"));
    }
    else
    {
        readPatch(dict.subDict("patch"), mesh);
    }
}


void Foam::injectionPlace::setCircle(const vector& n, const scalar radius)
{
    // Any direction that is not along n
    vector e(Zero);
    e[mag(n.x()) < 0.6 ? 0 : mag(n.y()) < 0.6 ? 1 : 2] = 1;

    axes_[0] = radius*normalised(e - (e & n)*n);
    axes_[1] = n ^ axes_[0];
    round_ = true;
}


void Foam::injectionPlace::readRegion(const dictionary& dict)
{
    const word type
    (
        Foam::keywords::choice
        (
            dict, "type", {"box", "cylinder", "disc"}, word::null
        )
    );

    if (type == "box")
    {
        Foam::keywords::check(dict, {"type", "min", "max"});
        origin_ = dict.get<point>("min");

        const vector span(dict.get<point>("max") - origin_);

        for (direction k = 0; k < 3; ++k)
        {
            axes_[k][k] = span[k];
        }
        return;
    }

    if (type == "cylinder")
    {
        Foam::keywords::check(dict, {"type", "p1", "p2", "radius"});
        origin_ = dict.get<point>("p1");
        axes_[2] = dict.get<point>("p2") - origin_;
    }
    else
    {
        Foam::keywords::check(dict, {"type", "centre", "normal", "radius"});
        origin_ = dict.get<point>("centre");
    }

    const vector along
    (
        type == "cylinder" ? axes_[2] : dict.get<vector>("normal")
    );

    if (!(mag(along) > 0))
    {
        FatalIOErrorInFunction(dict)
            << (type == "cylinder" ? "'p1' and 'p2'" : "'normal'") << " of a "
            << type << " must give it a direction" << nl << exit(FatalIOError);
    }
    setCircle(normalised(along), Foam::keywords::positive(dict, "radius"));
}


void Foam::injectionPlace::readPatch
(
    const dictionary& dict,
    const polyMesh& mesh
)
{
    Foam::keywords::check(dict, {"name", "gap"});
    gap_ = dict.lookupOrDefault<scalar>("gap", 0);

    const polyBoundaryMesh& patches = mesh.boundaryMesh();
    const wordList names
    (
        SubList<word>(patches.names(), patches.nNonProcessor())
    );
    const polyPatch& patch =
        patches[Foam::keywords::choice(dict, "name", names, word::null)];

    const vector sum(gSum(patch.faceAreas()));
    const scalar area = gSum(mag(patch.faceAreas()));

    if (mag(sum) < (1 - 1e-6)*area)
    {
        FatalIOErrorInFunction(dict)
            << "Patch '" << patch.name() << "' is not plane: bodies cannot be"
            << " set back from it; use 'region'" << nl << exit(FatalIOError);
    }

    inward_ = -sum/mag(sum);
    setCircle(inward_, 1);
    round_ = false;

    // The rectangle about it; beside the patch there is no room
    point low(point::max), high(point::min);

    for (const point& x : patch.localPoints())
    {
        const point along(x & axes_[0], x & axes_[1], x & inward_);

        low = min(low, along);
        high = max(high, along);
    }
    reduce(low, minOp<point>());
    reduce(high, maxOp<point>());

    origin_ = low.x()*axes_[0] + low.y()*axes_[1] + low.z()*inward_;
    axes_[0] *= high.x() - low.x();
    axes_[1] *= high.y() - low.y();
}


Foam::point Foam::injectionPlace::position
(
    const label number,
    const scalar radius,
    Random& random
) const
{
    if (positions_.size())
    {
        return space_.inPlane(positions_[number % positions_.size()]);
    }

    vector x(random.sample01<vector>());

    if (round_)
    {
        const scalar r = Foam::sqrt(x.x());
        const scalar angle = constant::mathematical::twoPi*x.y();

        x = vector(r*Foam::cos(angle), r*Foam::sin(angle), x.z());
    }

    return space_.inPlane
    (
        origin_ + x.x()*axes_[0] + x.y()*axes_[1] + x.z()*axes_[2]
      + (inward_ == vector::zero ? 0 : radius + gap_)*inward_
    );
}
