// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyRestraint.H"
#include "checkKeywords.H"

namespace Foam
{
    defineTypeNameAndDebug(bodyRestraint, 0);
    defineRunTimeSelectionTable(bodyRestraint, dictionary);
}


Foam::autoPtr<Foam::bodyRestraint> Foam::bodyRestraint::New
(
    const dictionary& dict,
    const geometricSpace& space,
    const scalar rho
)
{
    const word type
    (
        keywords::choice
        (
            dict,
            "type",
            dictionaryConstructorTablePtr_->sortedToc(),
            dict.get<word>("type")
        )
    );

    return dictionaryConstructorTablePtr_->cfind(type)()(dict, space, rho);
}


Foam::bodyRestraint::list Foam::bodyRestraint::readList
(
    const dictionary& body,
    const geometricSpace& space,
    const scalar rho,
    const bool free
)
{
    const dictionary dict
    (
        body.subOrEmptyDict
        (
            "restraints", keyType::REGEX, body.found("restraints")
        )
    );

    if (dict.empty())
    {
        return list();
    }

    if (!free)
    {
        FatalIOErrorInFunction(body)
            << "'restraints' in '" << body.dictName() << "' act on a body that"
            << " is free in some direction, and this one is not: see its"
            << " 'motion' and 'constraints'" << nl << exit(FatalIOError);
    }

    if (!(rho > 0))
    {
        FatalIOErrorInFunction(body)
            << "'restraints' in '" << body.dictName() << "' need the density of"
            << " the fluid: set 'rho' [kg/m3] in immersedBodyProperties or"
            << " transportProperties" << nl << exit(FatalIOError);
    }

    std::shared_ptr<PtrList<bodyRestraint>> restraints
    (
        new PtrList<bodyRestraint>()
    );

    for (const entry& e : dict)
    {
        if (!e.isDict())
        {
            FatalIOErrorInFunction(body)
                << "'" << e.keyword() << "' in 'restraints' of '"
                << body.dictName() << "' must be a dictionary"
                << " '{ type ...; ... }'" << nl << exit(FatalIOError);
        }

        restraints->append(New(e.dict(), space, rho));
    }

    return restraints;
}


Foam::vector Foam::bodyRestraint::turn
(
    const quaternion& from,
    const quaternion& to
)
{
    const quaternion q(to*conjugate(from));

    // The same rotation by less than half a turn
    const scalar sign = q.w() < 0 ? -1 : 1;
    const scalar s = mag(q.v());

    return s > VSMALL
      ? sign*2*Foam::atan2(s, sign*q.w())/s*q.v()
      : vector::zero;
}
