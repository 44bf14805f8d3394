// SPDX-License-Identifier: GPL-3.0-or-later

#include "softSphere.H"
#include "addToRunTimeSelectionTable.H"
#include "checkKeywords.H"

namespace Foam
{
namespace contactModels
{
    defineTypeNameAndDebug(softSphere, 0);
    addToRunTimeSelectionTable(contactModel, softSphere, dictionary);
}
}


Foam::contactModels::softSphere::softSphere
(
    const dictionary& dict,
    const scalar rho,
    const lubricationModel& lubrication
)
:
    historyContact<springRecord>("springContacts"),
    law_(contactLaw::New(dict, rho)),
    materials_(dict, law_()),
    roughness_(dict),
    rough_(materials_.largest().wallRoughness > 0),
    subSteps_(keywords::positiveOr(dict, "subSteps", 30)),
    largestOverlap_(keywords::positiveOr(dict, "largestOverlap", 0.2)),
    touches_(law_(), movers_, meetings_),
    films_(lubrication, movers_),
    slideSpeed_(0),
    advanced_(false)
{
    wordList ours
    ({
        "type", "law", "subSteps", "largestOverlap", "seed"
    });
    ours.append(impactCoefficients::keywords);
    ours.append(contactMaterials::keywords);

    wordList ofLaw(law_->keywords());
    ofLaw.append(law_->materialKeywords());

    for (const word& key : ofLaw)
    {
        if (ours.found(key))
        {
            FatalIOErrorInFunction(dict)
                << "The contact law '" << law_->type() << "' has a keyword '"
                << key << "', which means something else in '"
                << dict.dictName() << "'; in use are " << flatOutput(ours)
                << nl << exit(FatalIOError);
        }
    }

    ours.append(ofLaw);
    keywords::check(dict, ours);

    if (largestOverlap_ >= 1)
    {
        FatalIOErrorInFunction(dict)
            << "'largestOverlap " << largestOverlap_ << "' in '"
            << dict.dictName() << "' must be less than 1: bodies would be"
            << " within each other" << nl << exit(FatalIOError);
    }
}


void Foam::contactModels::softSphere::readMaterials
(
    const dictionary& properties,
    const wallFacets& walls
)
{
    if (!materials_.active())
    {
        return;
    }

    wallMaterials_ = materials_.ofWalls(walls.patches());
    wordList ofBodies;

    for (const char* kind : {"bodies", "injection"})
    {
        const dictionary& entries = properties.subOrEmptyDict(kind);

        for (const entry& e : entries)
        {
            if (e.isDict() && e.dict().found("material"))
            {
                const word name(e.dict().get<word>("material"));

                materials_.number(name, e.dict());
                if (!ofBodies.found(name))
                {
                    ofBodies.append(name);
                }
            }
        }
    }

    materials_.checkSpelling(properties.subDict("contact"), ofBodies);
}


const Foam::impactCoefficients&
Foam::contactModels::softSphere::coefficients
(
    const candidate& c,
    const contactPoint& point
) const
{
    const label other =
        c.b >= 0 ? moverMaterials_[c.b]
      : wallMaterials_.size() && point.patch >= 0
      ? wallMaterials_[point.patch]
      : -1;

    return materials_.pair(moverMaterials_[c.a], other);
}


bool Foam::contactModels::softSphere::goThrough
(
    PtrList<immersedBody>& bodies,
    const UList<scalar>& h,
    wallFacets& walls,
    const periodicity& periods,
    const scalar dt,
    const vector& meshU,
    const UList<scalar>& furthest
)
{
    // Films act one after the other, slopes are drawn so
    begin(bodies, !films_.active());
    roughness_.begin(bodies);

    if (!search(bodies, h, walls, periods, dt, furthest))
    {
        return false;
    }

    const label n = max
    (
        label(ceil(dt*subSteps_/shortestTime(dt))),
        label(1)
    );
    const bool films = films_.active();
    subStepMotion motion(movers_, bodies, clearance_, n, dt, meshU, films);
    const scalar subDt = motion.h();

    clearance_.setSlide(0.5*subDt*slideSpeed_, subDt*slideSpeed_);
    slide(0.5*subDt);

    for (label i = 0; i < n; ++i)
    {
        findTouches(bodies, walls, motion, dt);
        touches_.kick(motion, energy_);
        if (films)
        {
            accelerate(subDt);
            lubricate(subDt);
        }
        if (i < n - 1)
        {
            motion.next();
            slide(subDt);
        }
    }
    motion.end();
    slide(0.5*subDt);
    touches_.sumSprings(subDt, energy_);
    movers_.putBack(bodies);
    movers_.collect();

    return true;
}


void Foam::contactModels::softSphere::advance
(
    PtrList<immersedBody>& bodies,
    const UList<scalar>& h,
    wallFacets& walls,
    const periodicity& periods,
    const scalar dt,
    const vector& meshU
)
{
    // Those that were hit and went further than the search has known may have
    // met others
    scalarField furthest(likelyWays(bodies, dt, meshU));
    bool any;

    do
    {
        if (beyondReach(movers_.ranks().largest(furthest)))
        {
            return;
        }
        any = goThrough(bodies, h, walls, periods, dt, meshU, furthest);
    }
    while (any && !movers_.within(furthest));

    if (any)
    {
        movers_.setContact(bodies, dt);
        remember();
    }
    sumEnergy();
    advanced_ = true;
}


bool Foam::contactModels::softSphere::pairsAtEnd
(
    DynamicList<closePairs::pair>& pairs
) const
{
    for (const candidate& c : candidates())
    {
        if (c.b >= 0)
        {
            pairs.append
            (
                closePairs::pair
                {
                    movers_[c.a].body, movers_[c.b].body, c.shift, c.velocity
                }
            );
        }
    }

    return advanced_;
}


void Foam::contactModels::softSphere::endStep()
{
    historyContact<springRecord>::endStep();
    roughness_.endStep(movers_);
}


void Foam::contactModels::softSphere::readState
(
    const immersedBody& body,
    const dictionary& dict
)
{
    historyContact<springRecord>::readState(body, dict);
    roughness_.readState(body.number(), dict);
}


void Foam::contactModels::softSphere::writeState
(
    Ostream& os,
    const immersedBody& body
) const
{
    historyContact<springRecord>::writeState(os, body);
    roughness_.writeState(os, body.number());
}


void Foam::contactModels::softSphere::report(Ostream& os) const
{
    os  << "softSphere, " << law_->type();
    law_->coefficients().report(os);
    os  << ", ";
    law_->report(os);
}
