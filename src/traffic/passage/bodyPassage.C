// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyPassage.H"
#include "bodyShare.H"
#include "checkKeywords.H"
#include "contactPoint.H"

namespace
{

//- That a body passes no patch, or the one it has passed before
enum { NONE = -1, AS_BEFORE = -2 };


//- Does a body with this gap [m] to a patch touch it? One that has just been
//  put beside it may by rounding.
bool touches(const Foam::immersedBody& body, const Foam::scalar gap)
{
    return gap <= -1e-6*body.shape().boundingRadius();
}


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


void Foam::bodyPassage::findTouched
(
    const bodyList& bodies,
    scalarField& gaps,
    labelList& patches
)
{
    scalarField smallest(gaps);
    const labelList all(identity(bodies.size()));

    bodies.share().combine(all, 1, smallest, minEqOp<scalar>());

    forAll(bodies, bodyi)
    {
        if (gaps[bodyi] > smallest[bodyi])
        {
            patches[bodyi] = -1;
        }
    }
    bodies.share().combine(all, 1, patches, maxEqOp<label>());
    gaps = smallest;
}


Foam::labelList Foam::bodyPassage::touch
(
    bodyList& bodies,
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
    bool any = false;

    forAll(bodies, bodyi)
    {
        gaps[bodyi] =
            open_->gap(bodies[bodyi], beside[bodyi], patches[bodyi]);
        any = any || touches(bodies[bodyi], gaps[bodyi])
         || bodies[bodyi].status().passing().size();
    }

    if (!returnReduce(any, orOp<bool>()))
    {
        return held;
    }
    findTouched(bodies, gaps, patches);

    // As the owner of each sees it
    labelList passed(bodies.size());

    forAll(passed, bodyi)
    {
        const immersedBody& body = bodies[bodyi];

        // Not while the last of it is beyond the patch
        passed[bodyi] = touches(body, gaps[bodyi]) ? patches[bodyi]
          : loads[bodyi].volume > 0.5*body.volume() ? NONE : AS_BEFORE;
    }
    bodies.share().give(passed);

    forAll(passed, bodyi)
    {
        immersedBody& body = bodies[bodyi];
        const label patchi = passed[bodyi];

        if (body.isFixed() || patchi == AS_BEFORE)
        {
            continue;
        }
        if (patchi == NONE)
        {
            body.status().pass(word::null);
            continue;
        }

        const leavingRules::action what = leaving_[patchi].what;

        if (what != leavingRules::action::stop)
        {
            body.status().pass(mesh_.boundaryMesh()[patchi].name());
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
    const bodyList& bodies,
    const scalar h,
    const scalar gap
) const
{
    const scalar wanted = max(gap, h);
    const scalar R = body.shape().boundingRadius();
    const point& x = body.state().position;
    bool free = true;

    for (label i = 0; i < bodies.size() && free; ++i)
    {
        const immersedBody& other = bodies[i];
        const scalar apart = mag(other.state().position - x);

        free = apart >= R + other.shape().boundingRadius() + wanted
         || contactPoint(body, other).gap >= wanted;
    }

    if (free)
    {
        // An open patch it may touch
        label patchi;

        free = closed_->gap(body, beside, patchi) >= wanted
         && open_->gap(body, beside, patchi) >= -1e-6*R;
    }

    return returnReduce(free, andOp<bool>());
}
