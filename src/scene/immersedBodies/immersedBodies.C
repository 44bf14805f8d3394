// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedBodies.H"
#include "ambientVelocities.H"
#include "bodyContacts.H"
#include "bodyHandover.H"
#include "bodyPassage.H"
#include "bodyProperties.H"
#include "bodyResolution.H"
#include "bodyTraffic.H"
#include "freeVelocities.H"
#include "meshProperties.H"
#include "uniformState.H"
#include "unresolvedBodies.H"

namespace Foam
{
    defineTypeNameAndDebug(immersedBodies, 0);
}


namespace
{

//- Does any body move through the mesh? Collective.
bool movesThroughMesh(const Foam::bodyList& bodies)
{
    bool moves = false;

    for (const Foam::immersedBody& body : bodies)
    {
        moves = moves
         || body.isFree() || body.status().asleep() || !body.isFixed();
    }

    return bodies.share().any(moves);
}

} // End anonymous namespace


Foam::immersedBodies::immersedBodies
(
    const fvMesh& mesh,
    const dictionary& dict
)
:
    regIOobject
    (
        IOobject
        (
            typeName,
            mesh.time().timeName(),
            "uniform",
            mesh,
            IOobject::NO_READ,
            IOobject::AUTO_WRITE
        )
    ),
    mesh_(mesh),
    dict_(bodyProperties::checked(dict)),
    space_(meshProperties::space(mesh)),
    periodicity_(meshProperties::periods(mesh)),
    fluid_(dict, mesh),
    start_
    (
        dict_, mesh, space_, fluid_.rho(),
        uniformState::found(mesh, typeName)
    ),
    bodies_(std::move(start_.bodies()), start_.nSpread()),
    passage_
    (
        new bodyPassage(dict_, space_, mesh, fluid_.rho(), start_.placed())
    ),
    clock_(mesh.time().value()),
    window_(dict.subOrEmptyDict("window"), mesh, start_.placed()),
    h_(bodies_),
    oldH_(bodies_),
    contacts_
    (
        new bodyContacts
        (
            dict, bodies_, mesh, space_, periodicity_, fluid_,
            window_.comoving()
        )
    ),
    crowd_(bodies_),
    restarted_(readState()),
    moving_(movesThroughMesh(bodies_) || passage_->injects()),
    steady_(dict),
    resolved_
    (
        new resolvedBodies
        (
            dict_,
            mesh,
            space_,
            periodicity_,
            window_,
            crowd_,
            fluid_.g(),
            moving_,
            bodies_,
            h_
        )
    ),
    unresolved_
    (
        new unresolvedBodies
        (
            dict.subOrEmptyDict("coupling"),
            space_,
            region().search(),
            periodicity_,
            window_,
            fluid_.g(),
            bodies_,
            h_
        )
    ),
    handover_
    (
        new bodyHandover
        (
            bodies_,
            start_.kinds(),
            passage_(),
            unresolved_->coupling().choice(),
            region(),
            unresolved_->coupling().kernels(),
            periodicity_,
            contacts_->wallMargin(),
            mayBeSpread()
        )
    ),
    resolution_
    (
        new bodyResolution
        (
            bodies_, resolved_->region(), unresolved_(), loads(), h_
        )
    ),
    traffic_
    (
        new bodyTraffic
        (
            bodies_,
            resolved_->region(),
            window_,
            loads(),
            resolution_(),
            h_,
            passage_(),
            handover_()
        )
    )
{
    const dictionary& bodies = dict_.subOrEmptyDict("bodies");

    if (steady_.active())
    {
        checkSteady();
    }

    resolution_->choose(restarted_);
    checkBounds();
    settle();
    resolution_->start(restarted_);
    start_.end();
    checkInside();
    h_.checkResolution(bodies_, bodies);
    checkGaps();
}


Foam::immersedBodies::~immersedBodies()
{}


const Foam::UList<Foam::bodyDeparture>& Foam::immersedBodies::departed() const
{
    return passage_->departed();
}


const Foam::bodyContacts& Foam::immersedBodies::contacts() const
{
    return contacts_();
}


const Foam::bodyHandover& Foam::immersedBodies::handover() const
{
    return handover_();
}


Foam::unresolvedBodies& Foam::immersedBodies::unresolved()
{
    return unresolved_();
}


Foam::label Foam::immersedBodies::nBodies() const
{
    return bodies_.share().nAll();
}


Foam::scalar Foam::immersedBodies::courantNo() const
{
    scalar Co = 0;

    forAll(bodies_, bodyi)
    {
        const scalar speed = bodies_[bodyi].maxSpeed(window_.velocity());

        Co = max(Co, speed/h_[bodyi]);
    }

    return bodies_.share().largest(Co)*mesh_.time().deltaTValue();
}


Foam::scalar Foam::immersedBodies::minCellSize() const
{
    return -bodies_.share().largest(h_.empty() ? -GREAT : -min(h_));
}


Foam::scalar Foam::immersedBodies::maxSpeed() const
{
    return bodies_.maxSpeed();
}


Foam::scalar Foam::immersedBodies::cellsOnTheWay(const bool resolved) const
{
    const scalar dt = mesh_.time().deltaTValue();
    scalar most = 0;

    forAll(bodies_, bodyi)
    {
        const immersedBody& body = bodies_[bodyi];

        if (body.resolved() == resolved)
        {
            const scalar h = body.shape().width()/cellsPerWidth(bodyi);
            const vector moved
            (
                body.state().position - body.motion().old().position
            );

            // Contact may move it further than its velocities say
            most = max
            (
                most,
                max(dt*body.maxSpeed(window_.velocity()), mag(moved))/h
            );
        }
    }

    return bodies_.share().largest(most);
}


void Foam::immersedBodies::holdWithin(const scalar widths)
{
    handover_->holdWithin(widths);
}


void Foam::immersedBodies::keepActions()
{
    region().loads().keepForces();
    contacts_->keepMoments(bodies_);
}


Foam::tmp<Foam::volScalarField> Foam::immersedBodies::bodyFraction() const
{
    tmp<volScalarField> tfraction(region().interior().fraction());

    unresolved_->coupling().addFraction(tfraction.ref().primitiveFieldRef());
    tfraction.ref().correctBoundaryConditions();

    return tfraction;
}


void Foam::immersedBodies::setAmbient(const volVectorField& U)
{
    ambientVelocities::set(U, region().search(), periodicity_, bodies_);
    window_.follow(bodies_);
}


void Foam::immersedBodies::setVelocities(const UList<vector>& velocities)
{
    freeVelocities::set(velocities, bodies_);
    window_.follow(bodies_);
}
