// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyPassage.H"
#include "checkKeywords.H"

namespace
{

//- Patches that bodies can leave through, or walls and planes of symmetry
Foam::boolList boundaries(const Foam::fvMesh& mesh, const bool open)
{
    Foam::boolList chosen(mesh.boundaryMesh().size(), false);

    for (const Foam::polyPatch& patch : mesh.boundaryMesh())
    {
        chosen[patch.index()] =
            Foam::leavingRules::open(patch) == open
         && !patch.coupled() && patch.type() != "empty";
    }

    return chosen;
}


//- Is a name that of an injector with a number
bool numbered(const Foam::word& name, const Foam::word& injector)
{
    return
        name.size() > injector.size()
     && name.compare(0, injector.size(), injector) == 0
     && name.find_first_not_of("0123456789", injector.size())
     == std::string::npos;
}

} // End anonymous namespace


Foam::bodyPassage::bodyPassage
(
    const dictionary& dict,
    const geometricSpace& space,
    const fvMesh& mesh,
    const scalar rho,
    const placedBodies& placed
)
:
    mesh_(mesh),
    leaving_(dict.subOrEmptyDict("leaving"), mesh),
    nextNumber_(placed.size()),
    table_(mesh)
{
    const dictionary& injection = dict.subOrEmptyDict("injection");

    for (const entry& e : injection)
    {
        if (!e.isDict())
        {
            FatalIOErrorInFunction(injection)
                << "'" << e.keyword() << "' in 'injection' must be a"
                << " dictionary that describes an injector" << nl
                << exit(FatalIOError);
        }
        injectors_.append
        (
            new injector(e.keyword(), e.dict(), space, mesh, rho)
        );
    }
    checkNames(injection, placed);

    if (leaving_.active() || injects())
    {
        open_.reset(new patchGaps(mesh, boundaries(mesh, true)));
        closed_.reset(new patchGaps(mesh, boundaries(mesh, false)));
    }
}


void Foam::bodyPassage::checkNames
(
    const dictionary& dict,
    const placedBodies& placed
) const
{
    // Most scenes have none, and may have many bodies
    if (injectors_.empty())
    {
        return;
    }

    DynamicList<word> names(placed.size() + injectors_.size());

    for (label number = 0; number < placed.size(); ++number)
    {
        names.append(placed.name(number));
    }
    for (const injector& other : injectors_)
    {
        names.append(other.name());
    }

    for (const injector& one : injectors_)
    {
        for (const word& name : names)
        {
            if (numbered(name, one.name()))
            {
                FatalIOErrorInFunction(dict)
                    << "Bodies of the injector '" << one.name() << "' could"
                    << " have the name '" << name << "', which there is"
                    << " already: give it another name" << nl
                    << exit(FatalIOError);
            }
        }
    }
}


bool Foam::bodyPassage::due(const scalar t) const
{
    bool any = waiting_.size();

    for (const injector& one : injectors_)
    {
        any = any || one.schedule().due() <= t;
    }

    return any;
}


void Foam::bodyPassage::take(autoPtr<immersedBody> body)
{
    const leavingRules::rule& rule =
        leaving_[mesh_.boundaryMesh().findPatchID(body->status().passing())];

    departed_.append
    (
        bodyDeparture
        {
            body->number(), body->motion().unwrapped(), body->state().U
        }
    );

    if (rule.what == leavingRules::action::reinject)
    {
        body->enter
        (
            rule.shifted ? body->state().position + rule.to : rule.to,
            rule.ambient
        );
        waiting_.append(body.ptr());
    }
    else if (!body->injected())
    {
        gone_.append(body->name());
    }
}
