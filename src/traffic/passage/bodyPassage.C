// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyPassage.H"
#include "checkKeywords.H"
#include "compat.H"
#include "contactPoint.H"

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
    PtrList<immersedBody>& bodies
)
:
    mesh_(mesh),
    leaving_(dict.subOrEmptyDict("leaving"), mesh),
    nextNumber_(0),
    table_(mesh)
{
    const dictionary& injection = dict.subOrEmptyDict("injection");

    for (immersedBody& body : bodies)
    {
        body.setNumber(nextNumber_++);
    }

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
    checkNames(injection, bodies);

    if (leaving_.active() || injects())
    {
        open_.reset(new patchGaps(mesh, boundaries(mesh, true)));
        closed_.reset(new patchGaps(mesh, boundaries(mesh, false)));
    }
}


void Foam::bodyPassage::checkNames
(
    const dictionary& dict,
    const PtrList<immersedBody>& bodies
) const
{
    // Most scenes have none, and may have many bodies
    if (injectors_.empty())
    {
        return;
    }

    DynamicList<word> names(bodies.size() + injectors_.size());

    for (const immersedBody& body : bodies)
    {
        names.append(body.name());
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


Foam::labelList Foam::bodyPassage::touch
(
    PtrList<immersedBody>& bodies,
    const UPtrList<const DynamicList<label>>& beside,
    const List<bodyLoad>& loads
) const
{
    DynamicList<label> held;

    if (!leaving_.active())
    {
        return held;
    }

    scalarField gaps(bodies.size());
    labelList patches(bodies.size());

    forAll(bodies, bodyi)
    {
        gaps[bodyi] =
            open_->gap(bodies[bodyi], beside[bodyi], patches[bodyi]);
    }

    // The patch of the processor with the smallest gap
    scalarField smallest(gaps);
    compat::allReduce(smallest, minEqOp<scalar>());

    forAll(bodies, bodyi)
    {
        if (gaps[bodyi] > smallest[bodyi])
        {
            patches[bodyi] = -1;
        }
    }
    compat::allReduce(patches, maxEqOp<label>());

    forAll(bodies, bodyi)
    {
        immersedBody& body = bodies[bodyi];

        if (body.isFixed())
        {
            continue;
        }

        // One that has just been put beside a patch may touch it by rounding
        if (smallest[bodyi] > -1e-6*body.shape().boundingRadius())
        {
            // Not while the last of it is beyond the patch
            if (loads[bodyi].volume > 0.5*body.volume())
            {
                body.status().pass(word::null);
            }
            continue;
        }

        const leavingRules::action what = leaving_[patches[bodyi]].what;

        if (what != leavingRules::action::stop)
        {
            body.status().pass(mesh_.boundaryMesh()[patches[bodyi]].name());
        }
        if (what == leavingRules::action::hold)
        {
            held.append(bodyi);
        }
    }

    return held;
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


bool Foam::bodyPassage::room
(
    const immersedBody& body,
    const UList<label>& beside,
    const PtrList<immersedBody>& bodies,
    const scalar h,
    const scalar gap
) const
{
    const scalar wanted = max(gap, h);
    const scalar R = body.shape().boundingRadius();
    const point& x = body.state().position;

    for (const immersedBody& other : bodies)
    {
        const scalar apart = mag(other.state().position - x);

        if
        (
            apart < R + other.shape().boundingRadius() + wanted
         && contactPoint(body, other).gap < wanted
        )
        {
            return false;
        }
    }

    // An open patch it may touch
    label patchi;
    const scalar clearance = min
    (
        closed_->gap(body, beside, patchi) - wanted,
        open_->gap(body, beside, patchi) + 1e-6*R
    );

    return returnReduce(clearance, minOp<scalar>()) >= 0;
}
