// SPDX-License-Identifier: GPL-3.0-or-later

#include "stokesBodies.H"
#include "bodyPlacement.H"
#include "bodyProperties.H"
#include "compat.H"
#include "meshProperties.H"
#include "symmetryPlanes.H"
#include "Time.H"

Foam::PtrList<Foam::immersedBody> Foam::stokesBodies::place
(
    const dictionary& dict,
    const geometricSpace& space,
    const fvMesh& mesh
)
{
    if (!bodyProperties::any(dict))
    {
        FatalIOErrorInFunction(dict)
            << "'bodies' has no body, and the flows looked for are those around"
            << " bodies: add 'bodies { name { shape ...; position ...; } }'"
            << nl << exit(FatalIOError);
    }

    PtrList<immersedBody> bodies;

    // Density and motion have no part in the flow
    dictionary entries(dict.subOrEmptyDict("bodies"));

    for (entry& e : entries)
    {
        if (e.isDict())
        {
            for (const word key : {"density", "motion", "constraints"})
            {
                e.dict().remove(key);
            }
            e.dict().set("densityRatio", 1);
        }
    }
    bodyPlacement(space, mesh.time().globalPath(), 1).place(entries, bodies);

    const symmetryPlanes planes(mesh);

    for (immersedBody& body : bodies)
    {
        if (planes.bind(body, dict.subOrEmptyDict("bodies")) > 1)
        {
            FatalIOErrorInFunction(dict.subDict("bodies"))
                << "A plane of symmetry cuts body '" << body.name()
                << "', which cannot move across it: the modes need the whole"
                << " body in the mesh" << nl << exit(FatalIOError);
        }
    }

    return bodies;
}


Foam::stokesBodies::stokesBodies(const fvMesh& mesh)
:
    mesh_(mesh),
    dict_(bodyProperties::read(mesh)),
    space_(meshProperties::space(mesh)),
    periodicity_(meshProperties::periods(mesh)),
    bodies_(place(dict_, space_, mesh)),
    region_
    (
        mesh,
        space_,
        periodicity_,
        dict_.subOrEmptyDict("resistance"),
        bodies_,
        false
    ),
    lubrication_(lubricationModel::New(dictionary(), space_, 1)),
    contact_(contactModel::New(dictionary(), 1, lubrication_())),
    proximity_(mesh, periodicity_, contact_()),
    h_(bodies_),
    K_(mesh.nCells(), Zero),
    shield_(mesh.nCells(), Zero),
    faceShield_(mesh.nFaces(), Zero)
{}


void Foam::stokesBodies::setFluid(const scalarField& A0, const scalar nu)
{
    A0_ = A0;
    nu_ = scalarField(A0.size(), nu);
}


Foam::string Foam::stokesBodies::outside() const
{
    labelList inside(bodies_.size(), 0);

    forAll(inside, bodyi)
    {
        inside[bodyi] =
            region_.search().findCell(bodies_[bodyi].state().position) >= 0;
    }
    compat::allReduce(inside, maxEqOp<label>());

    OStringStream os;

    forAll(inside, bodyi)
    {
        if (!inside[bodyi])
        {
            os  << "the centre " << bodies_[bodyi].state().position
                << " of body '" << bodies_[bodyi].name()
                << "' is outside the mesh, ";
        }
    }

    if (!os.str().empty())
    {
        os  << "whose bounds are " << mesh_.bounds();
    }

    return os.str();
}


Foam::string Foam::stokesBodies::setPoses
(
    const UList<point>& x,
    const UList<vector>& angles
)
{
    forAll(bodies_, bodyi)
    {
        bodyState state(bodies_[bodyi].motion().old());

        state.position = space_.inPlane(x[bodyi]);

        if (periodicity_.active())
        {
            state.position += periodicity_.wrap(state.position).shift;
        }

        if (angles.size() && mag(angles[bodyi]) > 0)
        {
            const scalar angle = mag(angles[bodyi]);

            state.orientation =
                quaternion(angles[bodyi]/angle, angle)*state.orientation;
        }
        bodies_[bodyi].setState(state);
    }

    const string forbidden(outside());

    if (!forbidden.empty())
    {
        return forbidden;
    }

    region_.updateGeometry(bodies_, true);
    h_.measure(bodies_, region_);
    h_.checkResolution(bodies_, dict_.subOrEmptyDict("bodies"));

    if (proximity_.check(bodies_, region_, h_))
    {
        return "bodies overlap: " + proximity_.overlaps();
    }
    update();

    return string();
}


void Foam::stokesBodies::update()
{
    region_.updateResistance(bodies_, A0_, nu_);

    K_ = 0;
    shield_ = 0;
    faceShield_ = 0;

    for (const bodyRegion& region : region_.regions())
    {
        forAll(region.cells, i)
        {
            K_[region.cells[i]] += region.resistance[i];
            shield_[region.cells[i]] += region.share[i];
        }
        forAll(region.faces, i)
        {
            faceShield_[region.faces[i]] += region.faceShare[i];
        }
    }
}
