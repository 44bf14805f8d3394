// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyKind.H"
#include "checkKeywords.H"

const Foam::wordList Foam::bodyKind::keywords
({
    "shape", "density", "densityRatio", "velocity", "angularVelocity",
    "constraints", "motion", "coupling", "material", "restraints"
});


Foam::bodyKind::bodyKind
(
    const dictionary& dict,
    const std::shared_ptr<const bodyShape>& shape,
    const geometricSpace& space,
    const scalar rho
)
:
    shape_(shape),
    space_(space),
    round_(shape->round()),
    volume_(shape->volume()*space.depth()),
    inertia_(space.depth()*shape->inertia()),
    densityRatio_(1),
    freedom_(space.translation(), space.rotation()),
    fixed_(false),
    material_(dict.lookupOrDefault("material", word::null)),
    U_(Zero),
    omega_(Zero),
    ambientU_(false),
    ambientOmega_(false)
{
    readMotion(dict);
    readCoupling(dict);
    readDensity(dict, rho);
    restraints_ = bodyRestraint::readList(dict, space, rho, freedom_.any());
}


void Foam::bodyKind::readDensity(const dictionary& dict, const scalar rho)
{
    if (dict.found("density") == dict.found("densityRatio"))
    {
        if (dict.found("density") || freedom_.any())
        {
            FatalIOErrorInFunction(dict)
                << "'" << dict.dictName() << "' needs one of 'density' and"
                << " 'densityRatio'" << nl << exit(FatalIOError);
        }
    }
    else if (dict.found("densityRatio"))
    {
        densityRatio_ = Foam::keywords::positive(dict, "densityRatio");
    }
    else
    {
        densityRatio_ = Foam::keywords::positive(dict, "density")/rho;

        if (!(rho > 0))
        {
            FatalIOErrorInFunction(dict)
                << "'density' needs the density of the fluid: set 'rho' [kg/m3]"
                << " in immersedBodyProperties or transportProperties, or use"
                << " 'densityRatio'" << nl << exit(FatalIOError);
        }
    }
}


void Foam::bodyKind::readCoupling(const dictionary& dict)
{
    if (!dict.found("coupling"))
    {
        return;
    }

    coupling_ = Foam::keywords::choice
    (
        dict, "coupling", {"resolved", "unresolved", "auto"}, word::null
    );

    if (space_.twoD() && coupling_ != "resolved")
    {
        FatalIOErrorInFunction(dict)
            << "'coupling " << coupling_ << "' in '" << dict.dictName()
            << "' can only be 'resolved' in two dimensions: drag laws are"
            << " those of spheres" << nl << exit(FatalIOError);
    }
}
