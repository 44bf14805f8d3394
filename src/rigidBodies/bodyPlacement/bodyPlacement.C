// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyPlacement.H"
#include "bodyOrientation.H"
#include "checkKeywords.H"
#include "IFstream.H"

namespace
{

const Foam::wordList placements
({
    "position", "positions", "positionsFile", "random"
});


//- Smallest distance of x from the points and the surfaces of other bodies,
//  less the radius of a body at x and of those at the points
Foam::scalar clearance
(
    const Foam::point& x,
    const Foam::scalar radius,
    const Foam::UList<Foam::point>& points,
    const Foam::UPtrList<Foam::immersedBody>& others
)
{
    Foam::scalar gap = Foam::GREAT;

    for (const Foam::point& y : points)
    {
        gap = Foam::min(gap, Foam::mag(x - y) - 2*radius);
    }
    forAll(others, i)
    {
        gap = Foam::min(gap, others[i].posed().distance(x) - radius);
    }

    return gap;
}

} // End anonymous namespace


Foam::bodyPlacement::bodyPlacement
(
    const geometricSpace& space,
    const fileName& root,
    const scalar rho
)
:
    space_(space),
    root_(root),
    rho_(rho)
{}


Foam::pointField Foam::bodyPlacement::randomPositions
(
    const dictionary& dict,
    const scalar radius,
    const placedBodies& before,
    Random& random
) const
{
    PtrList<immersedBody> others(before.size());

    forAll(others, i)
    {
        others.set(i, before.make(i));
    }

    const label number = label(keywords::positive(dict, "number"));
    const point lower(dict.get<point>("min")), upper(dict.get<point>("max"));
    const scalar gap = dict.lookupOrDefault<scalar>("gap", 0);

    const label maxTries = 1000*number;
    DynamicList<point> found(number);

    for (label tries = 0; found.size() < number; ++tries)
    {
        if (tries == maxTries)
        {
            FatalIOErrorInFunction(dict)
                << "Found room for " << found.size() << " of 'number "
                << number << "' bodies in " << maxTries << " draws; enlarge"
                << " the box from 'min' to 'max' or reduce 'gap'" << nl
                << exit(FatalIOError);
        }

        const vector draw(random.sample01<vector>());
        const point x
        (
            space_.inPlane(lower + cmptMultiply(draw, upper - lower))
        );

        if (clearance(x, radius, found, others) >= gap)
        {
            found.append(x);
        }
    }

    return pointField(found);
}


Foam::pointField Foam::bodyPlacement::positions
(
    const dictionary& dict,
    const scalar radius,
    const placedBodies& before,
    autoPtr<Random>& random
) const
{
    wordList given;

    for (const word& key : placements)
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
            << flatOutput(placements) << " and has "
            << flatOutput(given) << nl << exit(FatalIOError);
    }

    if (given[0] == "position")
    {
        return pointField(1, dict.get<point>("position"));
    }
    if (given[0] == "positions")
    {
        return dict.get<pointField>("positions");
    }
    if (given[0] == "random")
    {
        return randomPositions
        (
            dict.subDict("random"), radius, before, *random
        );
    }

    fileName file(dict.get<fileName>("positionsFile"));
    file.expand();
    IFstream is(file.isAbsolute() ? file : root_/file);

    if (!is.good())
    {
        FatalIOErrorInFunction(dict)
            << "Cannot read 'positionsFile' " << is.name() << nl
            << exit(FatalIOError);
    }

    return pointField(is);
}


void Foam::bodyPlacement::check(const dictionary& dict, const entry& e)
{
    if (!e.isDict())
    {
        FatalIOErrorInFunction(dict)
            << "'" << e.keyword() << "' in '" << dict.dictName()
            << "' must be a dictionary that describes a body" << nl
            << exit(FatalIOError);
    }

    wordList valid(bodyKind::keywords);
    valid.append(placements);
    valid.append(word("orientation"));
    valid.append(word("seed"));

    keywords::check(e.dict(), valid);
    keywords::check
    (
        e.dict().subOrEmptyDict("random"),
        {"number", "min", "max", "gap", "seed"}
    );
}


void Foam::bodyPlacement::checkNames
(
    const dictionary& dict,
    const placedBodies& all
)
{
    for (const placedBodies::entry& e : all.entries())
    {
        for (const label place : all.before(e.name))
        {
            const placedBodies::entry& other = all.entries()[place];

            forAll(e.positions, i)
            {
                if (other.find(e.nameOf(i)) >= 0)
                {
                    FatalIOErrorInFunction(dict)
                        << "The entries '" << other.name << "' and '"
                        << e.name << "' both have a body '" << e.nameOf(i)
                        << "': give one of them another name" << nl
                        << exit(FatalIOError);
                }
            }
        }
    }
}


Foam::placedBodies Foam::bodyPlacement::place(const dictionary& dict) const
{
    placedBodies all;

    for (const entry& e : dict)
    {
        check(dict, e);

        const dictionary& bodyDict = e.dict();
        const std::shared_ptr<const bodyShape> shape
        (
            bodyShape::New(bodyDict.subDict("shape"), space_).ptr()
        );
        autoPtr<Random> random(bodyOrientation::generator(bodyDict));
        const pointField x
        (
            positions(bodyDict, shape->boundingRadius(), all, random)
        );
        const bool turned = bodyOrientation::isRandom(bodyDict);
        List<quaternion> orientations(turned ? x.size() : 1);

        for (quaternion& q : orientations)
        {
            q = turned
              ? bodyOrientation::draw(*random, space_)
              : bodyOrientation::read(bodyDict, space_);
        }

        all.append
        (
            {
                e.keyword(),
                std::make_shared<const bodyKind>
                (
                    bodyDict, shape, space_, rho_
                ),
                x.size() == 1 && bodyDict.found("position"),
                x,
                orientations,
                0
            }
        );
    }

    checkNames(dict, all);

    return all;
}


void Foam::bodyPlacement::place
(
    const dictionary& dict,
    PtrList<immersedBody>& bodies
) const
{
    const placedBodies all(place(dict));

    bodies.resize(all.size());
    forAll(bodies, i)
    {
        bodies.set(i, all.make(i));
    }
}
