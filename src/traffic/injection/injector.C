// SPDX-License-Identifier: GPL-3.0-or-later

#include "injector.H"
#include "bodyOrientation.H"
#include "checkKeywords.H"
#include "keyedRandom.H"

namespace
{

//- Numbers of the draws for a body; places come after them
enum draws { SIZE = 0, DENSITY = 1, ORIENTATION = 2, PLACE = 3 };

} // End anonymous namespace


Foam::injector::injector
(
    const word& name,
    const dictionary& dict,
    const geometricSpace& space,
    const polyMesh& mesh,
    const scalar rho
)
:
    name_(name),
    dict_(dict),
    space_(space),
    rho_(rho),
    schedule_(dict),
    place_(dict, space, mesh),
    seed_(isRandom(dict) ? dict.get<label>("seed") : 0),
    gap_(dict.lookupOrDefault<scalar>("gap", 0)),
    maxTries_(label(keywords::positiveOr(dict, "tries", 20))),
    kindNumber_(-1),
    tries_(0)
{
    wordList valid(schedule_.keywords());
    valid.append(injectionPlace::keywords);
    valid.append
    (
        wordList
        ({
            "shape", "size", "density", "densityRatio", "velocity",
            "angularVelocity", "constraints", "orientation", "coupling",
            "material", "gap", "tries"
        })
    );
    keywords::check(dict, valid);

    unscaled_ = std::shared_ptr<const bodyShape>
    (
        bodyShape::New(dict.subDict("shape"), space).ptr()
    );
    densityKey_ = dict.found("density") ? "density" : "densityRatio";
    size_ = readDistribution("size");
    density_ = readDistribution(densityKey_);

    if (!dict.found("velocity"))
    {
        dict_.add("velocity", word("ambient"));
    }

    // Wrong entries are refused now
    draw();
    tries_ = 0;
}


bool Foam::injector::isRandom(const dictionary& dict)
{
    return
        dict.found("region") || dict.found("patch") || dict.isDict("size")
     || dict.isDict("density") || dict.isDict("densityRatio")
     || bodyOrientation::isRandom(dict);
}


Foam::autoPtr<Foam::distributionModel> Foam::injector::readDistribution
(
    const word& key
)
{
    autoPtr<distributionModel> model;

    if (!dict_.isDict(key))
    {
        if (dict_.found(key))
        {
            keywords::positive(dict_, key);
        }
        return model;
    }

    model = distributionModel::New(dict_.subDict(key), random_);

    if (!(model->minValue() > 0))
    {
        FatalIOErrorInFunction(dict_.subDict(key))
            << "Values of '" << key << "' in '" << name_
            << "' must be greater than 0, and may be " << model->minValue()
            << nl << exit(FatalIOError);
    }

    return model;
}


Foam::scalar Foam::injector::value
(
    const autoPtr<distributionModel>& distribution,
    const word& key,
    const label draw
)
{
    if (!distribution.valid())
    {
        return dict_.lookupOrDefault<scalar>(key, 1);
    }

    // Not reset(): that would keep a second Gaussian number
    random_ = keyedRandom::generator(seed_, schedule_.next(), draw);

    return distribution->sample();
}


std::shared_ptr<const Foam::bodyShape> Foam::injector::scaledShape
(
    const scalar size
) const
{
    if (!size_.valid() && !dict_.found("size"))
    {
        return unscaled_;
    }

    return std::shared_ptr<const bodyShape>
    (
        unscaled_->makeScaled(dict_.subDict("shape"), space_, size).ptr()
    );
}


void Foam::injector::setKind(const label number, const scalar size)
{
    kindNumber_ = number;

    if (kind_ && !size_.valid() && !density_.valid())
    {
        // All are of one kind
        return;
    }
    if (!shape_ || size_.valid())
    {
        shape_ = scaledShape(size);
    }

    dictionary dict(dict_);

    if (dict.found(densityKey_))
    {
        dict.set(densityKey_, value(density_, densityKey_, DENSITY));
    }

    kind_ = std::make_shared<const bodyKind>(dict, shape_, space_, rho_);
}


Foam::autoPtr<Foam::immersedBody> Foam::injector::draw()
{
    const label number = schedule_.next();
    const scalar size = value(size_, "size", SIZE);

    if (number != kindNumber_)
    {
        setKind(number, size);
    }

    Random places(keyedRandom::generator(seed_, number, PLACE + tries_));
    Random turns(keyedRandom::generator(seed_, number, ORIENTATION));
    ++tries_;

    return autoPtr<immersedBody>
    (
        new immersedBody
        (
            name_ + Foam::name(number + 1),
            kind_,
            place_.position(number, shape_->boundingRadius(), places),
            bodyOrientation::isRandom(dict_)
          ? bodyOrientation::draw(turns, space_)
          : bodyOrientation::read(dict_, space_),
            std::make_shared<const bodyOrigin>
            (
                name_, size, kind_->densityRatio()
            )
        )
    );
}


void Foam::injector::advance()
{
    schedule_.advance();
    tries_ = 0;
}
