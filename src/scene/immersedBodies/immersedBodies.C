// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedBodies.H"
#include "bodyPassage.H"
#include "checkKeywords.H"
#include "comovingDerivative.H"
#include "contactModel.H"
#include "meshProperties.H"
#include "meshWalls.H"
#include "symmetryPlanes.H"
#include "unresolvedCoupling.H"

namespace Foam
{
    defineTypeNameAndDebug(immersedBodies, 0);
}


namespace
{

//- Place the bodies of a dictionary, with their velocities at the start
Foam::PtrList<Foam::immersedBody> placeBodies
(
    const Foam::dictionary& dict,
    const Foam::geometricSpace& space,
    const Foam::Time& time,
    const Foam::scalar rho
)
{
    Foam::PtrList<Foam::immersedBody> bodies;
    Foam::bodyPlacement(space, time.globalPath(), rho).place
    (
        dict.subOrEmptyDict("bodies"),
        bodies
    );

    for (Foam::immersedBody& body : bodies)
    {
        // Wrong ones that start from zero are refused here as well
        body.prescribe(time.value() + time.deltaTValue());
        body.startPrescribed(time.value());
    }

    return bodies;
}


//- Does any body move through the mesh?
bool movesThroughMesh(const Foam::PtrList<Foam::immersedBody>& bodies)
{
    for (const Foam::immersedBody& body : bodies)
    {
        if (body.isFree() || body.asleep() || !body.isFixed())
        {
            return true;
        }
    }

    return false;
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
    dict_(checked(dict)),
    space_(meshProperties::space(mesh)),
    periodicity_(meshProperties::periods(mesh)),
    rho_(readRho(dict, mesh)),
    g_(readGravity(mesh)),
    bodies_(placeBodies(dict, space_, mesh.time(), rho_)),
    passage_(new bodyPassage(dict_, space_, mesh, rho_, bodies_)),
    clock_(mesh.time().value()),
    window_(dict.subOrEmptyDict("window"), mesh, bodies_),
    h_(bodies_),
    oldH_(bodies_),
    lubrication_
    (
        lubricationModel::New
        (
            dict.subOrEmptyDict("lubrication"), space_, readNu(mesh)
        )
    ),
    contact_
    (
        contactModel::New
        (
            dict.subOrEmptyDict("contact"), rho_, lubrication_()
        )
    ),
    sleep_(dict, g_, contact_->active(), window_.comoving()),
    crowd_(bodies_),
    restarted_(readState()),
    moving_(movesThroughMesh(bodies_) || passage_->injects()),
    region_
    (
        mesh,
        space_,
        periodicity_,
        dict.subOrEmptyDict("resistance"),
        bodies_,
        moving_
    ),
    pressure_(bodies_, region_, periodicity_),
    frame_(new comovingDerivative(mesh, region_.neighbours())),
    proximity_(mesh, periodicity_, contact_()),
    nParts_(bodies_, 1),
    loads_(bodies_),
    steady_(dict)
{
    const dictionary& coupling = dict.subOrEmptyDict("coupling");

    if (contact_->active())
    {
        walls_.reset(new meshWalls(mesh, space_));
        contact_->readMaterials(dict_, walls_());
    }

    if (steady_.active())
    {
        checkSteady();
    }

    if (!restarted_)
    {
        wrapPositions();
    }

    const symmetryPlanes planes(mesh);

    forAll(bodies_, bodyi)
    {
        nParts_[bodyi] =
            planes.bind(bodies_[bodyi], dict_.subOrEmptyDict("bodies"));
    }
    unresolved_.reset
    (
        new unresolvedCoupling
        (
            coupling, space_, region_.search(), periodicity_, bodies_
        )
    );
    placeInMesh();
    checkInside();
    h_.checkResolution(bodies_, dict_.subOrEmptyDict("bodies"));

    if (proximity_.check(bodies_, region_, h_))
    {
        FatalIOErrorInFunction(dict_.subOrEmptyDict("bodies"))
            << "'bodies' must not overlap each other or a wall"
            << (contact_->active() ? " by that much: " : ": ")
            << proximity_.overlaps().c_str() << nl << exit(FatalIOError);
    }
}


Foam::immersedBodies::~immersedBodies()
{}


bool Foam::immersedBodies::anyFree() const
{
    for (const immersedBody& body : bodies_)
    {
        if (body.isFree() && body.resolved())
        {
            return true;
        }
    }

    return false;
}


bool Foam::immersedBodies::atRest() const
{
    for (const immersedBody& body : bodies_)
    {
        if (!body.isFixed())
        {
            return false;
        }
    }

    return true;
}


Foam::label Foam::immersedBodies::nAsleep() const
{
    label n = 0;

    for (const immersedBody& body : bodies_)
    {
        n += body.asleep();
    }

    return n;
}


Foam::scalar Foam::immersedBodies::maxSpeed() const
{
    scalar speed = 0;

    for (const immersedBody& body : bodies_)
    {
        speed = max(speed, body.maxSpeed());
    }

    return speed;
}


Foam::scalar Foam::immersedBodies::slip() const
{
    scalar sum = 0, volume = 0;

    forAll(loads_, bodyi)
    {
        if (bodies_[bodyi].resolved())
        {
            sum += loads_[bodyi].slip;
            volume += loads_[bodyi].volume;
        }
    }

    return Foam::sqrt(sum/max(volume, VSMALL));
}


Foam::scalar Foam::immersedBodies::courantNo() const
{
    scalar Co = 0;

    forAll(bodies_, bodyi)
    {
        const scalar speed = bodies_[bodyi].maxSpeed(window_.velocity());

        Co = max(Co, speed/h_[bodyi]);
    }

    return Co*mesh_.time().deltaTValue();
}
