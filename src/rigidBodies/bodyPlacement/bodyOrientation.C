// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyOrientation.H"
#include "checkKeywords.H"
#include "coordinateRotation.H"
#include "mathematicalConstants.H"

namespace
{

//- Refuse a rotation that takes the empty direction out of itself
void checkInPlane
(
    const Foam::dictionary& dict,
    const Foam::tensor& R,
    const Foam::vector& emptyDir
)
{
    using namespace Foam;

    if (mag((R & emptyDir) - emptyDir) > 1e-6)
    {
        FatalIOErrorInFunction(dict)
            << "'orientation' in '" << dict.dictName() << "' turns the body"
            << " out of the plane of the mesh; in 2D the axis of the rotation"
            << " must be " << emptyDir << nl << exit(FatalIOError);
    }
}

} // End anonymous namespace


bool Foam::bodyOrientation::isRandom(const dictionary& dict)
{
    if (!dict.found("orientation") || dict.isDict("orientation"))
    {
        return false;
    }

    const token first(dict.lookup("orientation"));

    if (!first.isWord() || first.wordToken() != "random")
    {
        FatalIOErrorInFunction(dict)
            << "'orientation' in '" << dict.dictName() << "' must be 'random'"
            << " or a rotation such as"
            << " '{ type axisAngle; axis (0 0 1); angle 30; }'" << nl
            << exit(FatalIOError);
    }

    return true;
}


Foam::autoPtr<Foam::Random> Foam::bodyOrientation::generator
(
    const dictionary& dict
)
{
    const bool positions = dict.found("random");

    if (dict.found("seed") && (positions || !isRandom(dict)))
    {
        FatalIOErrorInFunction(dict)
            << "'seed' in '" << dict.dictName() << "' is for 'orientation"
            << " random' where the positions are not; that of random ones is"
            << " an entry of 'random'" << nl << exit(FatalIOError);
    }

    autoPtr<Random> random;

    if (positions)
    {
        random.reset(new Random(dict.subDict("random").get<label>("seed")));
    }
    else if (isRandom(dict))
    {
        random.reset(new Random(dict.get<label>("seed")));
    }

    return random;
}


Foam::quaternion Foam::bodyOrientation::read
(
    const dictionary& dict,
    const geometricSpace& space
)
{
    if (!dict.found("orientation"))
    {
        return quaternion::I;
    }

    const dictionary& rotation = dict.subDict("orientation");

    keywords::check
    (
        rotation,
        {
            "type", "axis", "angle", "angles", "degrees", "order", "e1", "e2",
            "e3", "direction"
        }
    );
    keywords::choice
    (
        rotation, "type", {"axisAngle", "euler", "axes"}, word::null
    );

    for (const word key : {"axis", "e1", "e2", "e3", "direction"})
    {
        if (rotation.found(key) && !(mag(rotation.get<vector>(key)) > 0))
        {
            FatalIOErrorInFunction(rotation)
                << "'" << key << "' in '" << rotation.dictName()
                << "' must not be zero" << nl << exit(FatalIOError);
        }
    }

    const tensor R(coordinateRotation::New(rotation)->R());

    checkInPlane(dict, R, space.emptyDir());

    const quaternion q(R);

    return q/mag(q);
}


Foam::quaternion Foam::bodyOrientation::draw
(
    Random& random,
    const geometricSpace& space
)
{
    if (space.twoD())
    {
        const scalar angle =
            constant::mathematical::twoPi*random.sample01<scalar>();

        return quaternion(space.emptyDir(), angle);
    }

    // Four normal deviates have no preferred direction
    const vector v(random.GaussNormal<vector>());
    const quaternion q(random.GaussNormal<scalar>(), v);

    return q/mag(q);
}
