// SPDX-License-Identifier: GPL-3.0-or-later

#include "nonsmoothContact.H"
#include "checkKeywords.H"
#include "compat.H"

Foam::contactModels::nonsmoothContact::nonsmoothContact
(
    const dictionary& dict,
    const lubricationModel& lubrication
)
:
    tolerance_(keywords::positiveOr(dict, "tolerance", 1e-8)),
    largestOverlap_(keywords::positiveOr(dict, "largestOverlap", 0.1)),
    projection_(tolerance_, dict.lookupOrDefault<label>("maxIter", 1000)),
    told_(false)
{
    keywords::check
    (
        dict, {"type", "tolerance", "maxIter", "largestOverlap"}
    );

    keywords::positiveOr(dict, "maxIter", 1);

    if (tolerance_ >= 1 || largestOverlap_ >= 1)
    {
        FatalIOErrorInFunction(dict)
            << "'tolerance " << tolerance_ << "' and 'largestOverlap "
            << largestOverlap_ << "' in '" << dict.dictName()
            << "' must be less than 1" << nl << exit(FatalIOError);
    }

    if (lubrication.active())
    {
        FatalIOErrorInFunction(dict)
            << "'lubrication' of the type '" << lubrication.type()
            << "' acts in the sub-steps of 'contact { type softSphere; }'"
            << " only: 'contact' has the type '" << dict.get<word>("type")
            << "'; allowed is 'lubrication { type none; }'" << nl
            << exit(FatalIOError);
    }
}


void Foam::contactModels::nonsmoothContact::solve(const scalar floor)
{
    if (!projection_.solve(floor) && !told_)
    {
        told_ = true;
        WarningInFunction
            << "Contact: the residual of complementarity is "
            << projection_.residual() << " after " << projection_.nIterations()
            << " sweeps ('maxIter'), above 'tolerance " << tolerance_
            << "'. This is said once." << nl << endl;
    }
}


void Foam::contactModels::nonsmoothContact::advance
(
    PtrList<immersedBody>& bodies,
    const UList<scalar>&,
    wallFacets& walls,
    const periodicity& periods,
    const scalar dt,
    const vector& meshU
)
{
    history_.clear();
    energy_ = oldEnergy_;
    history_.append(old_, asleep(bodies));

    if (!search(bodies, walls, periods, dt))
    {
        return;
    }

    const label n = nParts(bodies, dt, meshU);

    for (label i = 0; i < n; ++i)
    {
        step(bodies, walls, dt/n, meshU);
    }

    for (const mover& m : movers_)
    {
        bodies[m.body].setContact
        (
            m.state, m.dU, m.dOmega, (1/dt)*m.impulse
        );
    }

    remember();
}


Foam::DynamicList<Foam::contactModel::pairMoment>
Foam::contactModels::nonsmoothContact::moments(const scalar dt) const
{
    DynamicList<pairMoment> all;

    for (const candidate& c : candidates_)
    {
        if (magSqr(c.impulse) > 0)
        {
            all.append
            (
                pairMoment
                {
                    movers_[c.a].body,
                    c.b < 0 ? -1 : movers_[c.b].body,
                    c.shift,
                    c.impulse/dt,
                    c.moment/dt,
                    Zero
                }
            );
        }
    }

    return all;
}


void Foam::contactModels::nonsmoothContact::endStep()
{
    oldEnergy_ = energy_;

    vectorList packed(history_.pack());

    // As the states of the bodies: the copies must not drift apart
    if (Pstream::parRun())
    {
        compat::broadcast(packed);
    }
    old_.unpack(packed);
}


void Foam::contactModels::nonsmoothContact::readState(const dictionary& dict)
{
    old_.unpack
    (
        dict.lookupOrDefault<vectorList>("contactMultipliers", vectorList())
    );
    history_ = old_;

    const vector lost(dict.lookupOrDefault<vector>("contactLosses", Zero));
    oldEnergy_.dashpots = lost.x();
    energy_ = oldEnergy_;
}


void Foam::contactModels::nonsmoothContact::writeState(Ostream& os) const
{
    // As text, whatever the format
    os.writeKeyword("contactMultipliers") << token::BEGIN_LIST;

    for (const vector& v : old_.pack())
    {
        os  << token::SPACE << v;
    }
    os  << token::SPACE << token::END_LIST << token::END_STATEMENT << nl;

    os.writeEntry("contactLosses", vector(oldEnergy_.dashpots, 0, 0));
}


void Foam::contactModels::nonsmoothContact::report(Ostream& os) const
{
    os  << type() << ", tolerance " << tolerance_;
}
