// SPDX-License-Identifier: GPL-3.0-or-later

#include "nonsmoothContact.H"
#include "checkKeywords.H"

Foam::contactModels::nonsmoothContact::nonsmoothContact
(
    const dictionary& dict,
    const lubricationModel& lubrication
)
:
    historyContact<contactMultiplier>("contactMultipliers"),
    tolerance_(keywords::positiveOr(dict, "tolerance", 1e-8)),
    largestOverlap_(keywords::positiveOr(dict, "largestOverlap", 0.1)),
    maxIter_(dict.lookupOrDefault<label>("maxIter", 1000)),
    wholeProjection_(tolerance_, maxIter_),
    sharedProjection_(movers_, tolerance_, maxIter_),
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
    if (!projection().solve(floor) && !told_)
    {
        told_ = true;
        WarningInFunction
            << "Contact: the residual of complementarity is "
            << projection().residual() << " after "
            << projection().nIterations()
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
    // One that is hit may go as far as the fastest
    const scalar furthest =
        2*movers_.ranks().largest(contactMovers::ways(bodies, dt, meshU));

    if (beyondReach(furthest))
    {
        return;
    }

    begin(bodies);

    if (search(bodies, walls, periods, dt, furthest))
    {
        const label n = nParts(bodies, dt, meshU);

        for (label i = 0; i < n; ++i)
        {
            step(bodies, walls, dt/n, meshU);
        }

        movers_.putBack(bodies);
        movers_.collect();
        movers_.setContact(bodies, dt);
        remember();
    }
    sumEnergy();
}


void Foam::contactModels::nonsmoothContact::report(Ostream& os) const
{
    os  << type() << ", tolerance " << tolerance_;
}
