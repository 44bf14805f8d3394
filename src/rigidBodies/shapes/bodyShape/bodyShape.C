// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyShape.H"
#include "checkKeywords.H"

namespace Foam
{
    defineTypeNameAndDebug(bodyShape, 0);
    defineRunTimeSelectionTable(bodyShape, dictionary);
}


Foam::autoPtr<Foam::bodyShape> Foam::bodyShape::New
(
    const dictionary& dict,
    const geometricSpace& space
)
{
    const word type(dict.get<word>("type"));
    auto iter = dictionaryConstructorTablePtr_->cfind(type);

    if (!iter.found())
    {
        keywords::refuse
        (
            dict,
            "type",
            type,
            dictionaryConstructorTablePtr_->sortedToc()
        );
    }

    return iter()(dict, space);
}


void Foam::bodyShape::checkSpace
(
    const dictionary& dict,
    const geometricSpace& space,
    const label nDims,
    const word& instead
)
{
    if (space.nDims() != nDims)
    {
        const std::string advice
        (
            instead.empty() ? "" : "; use '" + instead + "'"
        );

        FatalIOErrorInFunction(dict)
            << "'type " << dict.get<word>("type") << "' is a shape for "
            << nDims << "D and this mesh has " << space.nDims()
            << " dimensions" << advice.c_str() << nl << exit(FatalIOError);
    }
}


void Foam::bodyShape::checkPositive
(
    const dictionary& dict,
    const word& key,
    const vector& sizes
)
{
    if (!(cmptMin(sizes) > 0))
    {
        FatalIOErrorInFunction(dict)
            << "All components of '" << key << "' in '" << dict.dictName()
            << "' must be greater than 0" << nl << exit(FatalIOError);
    }
}


Foam::symmTensor Foam::bodyShape::inertiaOf
(
    const vector& secondMoments,
    const vector& emptyDir
)
{
    const vector& m = secondMoments;
    const scalar sum = m.x() + m.y() + m.z();

    if (emptyDir != vector::zero)
    {
        return (sum - (m & emptyDir))*sqr(emptyDir);
    }

    return symmTensor(sum - m.x(), 0, 0, sum - m.y(), 0, sum - m.z());
}


Foam::scalar Foam::bodyShape::distance(const point& X) const
{
    scalar d = 0;
    UList<scalar> result(&d, 1);
    distance(UList<point>(const_cast<point*>(&X), 1), result);

    return d;
}


bool Foam::bodyShape::hasExtent() const
{
    return hasSupport() || !knownSides().faces.empty();
}


Foam::point Foam::bodyShape::support(const vector&) const
{
    FatalErrorInFunction
        << "The shape '" << type() << "' has no support" << nl
        << exit(FatalError);

    return Zero;
}


void Foam::bodyShape::curvature
(
    const UList<vector>&,
    UList<scalar>& kappa
) const
{
    kappa = 0;
}


void Foam::bodyShape::multiply
(
    dictionary& dict,
    const word& key,
    const scalar factor
)
{
    if (dict.found(key))
    {
        tokenList tokens(static_cast<const tokenList&>(dict.lookup(key)));

        for (token& t : tokens)
        {
            if (t.isNumber())
            {
                t = token(factor*t.number());
            }
        }
        dict.set(new primitiveEntry(key, std::move(tokens)));
    }
}


void Foam::bodyShape::scaleEntries(dictionary& dict, const scalar) const
{
    FatalIOErrorInFunction(dict)
        << "The shape 'type " << type() << "' in '" << dict.dictName()
        << "' cannot be scaled: leave out 'size'" << nl << exit(FatalIOError);
}


Foam::autoPtr<Foam::bodyShape> Foam::bodyShape::makeScaled
(
    const dictionary& dict,
    const geometricSpace& space,
    const scalar factor
) const
{
    dictionary own(dict);

    scaleEntries(own, factor);

    return New(own, space);
}


const Foam::bodyShape::edgedSides& Foam::bodyShape::knownSides() const
{
    if (!sides_)
    {
        sides_.reset(new edgedSides(sides()));
    }

    return *sides_;
}


const Foam::pointField& Foam::bodyShape::surfacePoints() const
{
    if (!surfacePoints_.valid())
    {
        pointField points;
        faceList faces;
        surface(points, faces);
        surfacePoints_.reset(new pointField(std::move(points)));
    }

    return surfacePoints_();
}
