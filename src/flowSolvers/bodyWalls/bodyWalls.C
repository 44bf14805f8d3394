// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyWalls.H"
#include "checkKeywords.H"
#include "fvMatrices.H"
#include "lawOfTheWall.H"

namespace Foam
{
namespace fv
{
    defineTypeNameAndDebug(bodyWalls, 0);
}
}

namespace
{
    //- Width of the zone, in cells
    const Foam::scalar zoneWidth = 1.87;
}


bool Foam::fv::bodyWalls::wanted(const fvMesh& mesh)
{
    const IOdictionary properties
    (
        IOobject
        (
            "immersedBodyProperties",
            mesh.time().constant(),
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE,
            false
        )
    );
    const dictionary& dict = properties.subOrEmptyDict("turbulentWalls");

    keywords::check(dict, {"type"});

    const word type
    (
        keywords::choice(dict, "type", {"lawOfTheWall", "none"}, "lawOfTheWall")
    );

    return type != "none" && mesh.foundObject<volScalarField>("nut");
}


Foam::fv::bodyWalls::bodyWalls
(
    const immersedBodies& bodies,
    const volVectorField& U,
    const bool largeEddy
)
:
    option(typeName, typeName, dictionary(), U.mesh()),
    bodies_(bodies),
    U_(U),
    largeEddy_(largeEddy),
    width_(min(zoneWidth, bodies.region().resistance().bandWidth() - 1)),
    wallDistance_(U.mesh(), bodies),
    uTau_(U.size(), Zero),
    kLog_(U.size(), Zero),
    nut_(U.size(), Zero)
{
    fieldNames_ = wordList({"k", "omega", "epsilon", "nuTilda", "nut"});
    applied_.setSize(fieldNames_.size(), false);

    Info<< "Bodies are walls for the turbulence model, up to " << width_
        << " cells outside" << nl << endl;
}


Foam::scalar Foam::fv::bodyWalls::speed(const bodyCell& c) const
{
    const bodyRegion& r = region(c);
    const vector& n = r.normal[c.i];
    const vector slip
    (
        U_[c.cell]
      - r.velocity
        (
            bodies_[r.body()].state(),
            mesh_.cellCentres()[c.cell]
        )
    );

    return mag(slip - (slip & n)*n);
}


bool Foam::fv::bodyWalls::usesK() const
{
    return !largeEddy_ && mesh_.foundObject<volScalarField>("k");
}


Foam::lawOfTheWall Foam::fv::bodyWalls::law(const bodyCell& c) const
{
    return lawOfTheWall(nu_[c.cell], uTau_[c.cell], kLog_[c.cell]);
}


Foam::scalar Foam::fv::bodyWalls::value
(
    const word& variable,
    const bodyCell& c
) const
{
    // Models replace what is not positive by a mean of the neighbours
    if (variable == "k")
    {
        return inside(c) ? SMALL : max(law(c).k(y(c)), SMALL);
    }
    if (variable == "omega")
    {
        return law(c).omega(y(c));
    }
    if (variable == "epsilon")
    {
        // Inside, k is next to nothing: the same rate epsilon/k, as models
        // divide by it
        const scalar k = law(c).k(y(c));
        const scalar epsilon = law(c).epsilon(y(c));

        return max(inside(c) && k > SMALL ? SMALL/k*epsilon : epsilon, SMALL);
    }

    return inside(c) ? 0 : law(c).nuTilda(y(c));
}


void Foam::fv::bodyWalls::update(const scalarField& nu)
{
    const bool moved = wallDistance_.update();

    nu_ = nu;
    if (moved || !inward_.valid())
    {
        findCells();
    }
    setLayer();
}


void Foam::fv::bodyWalls::constrain
(
    fvMatrix<scalar>& eqn,
    const label fieldi
)
{
    const word& variable = fieldNames_[fieldi];
    const bool insideOnly = largeEddy_ && variable == "k";

    DynamicList<label> cells(zone_.size());
    DynamicList<scalar> values(zone_.size());

    for (const bodyCell& c : zone_)
    {
        if (!insideOnly || inside(c))
        {
            cells.append(c.cell);
            values.append(value(variable, c));
        }
    }

    eqn.setValues(cells, values);
}


void Foam::fv::bodyWalls::correct(volScalarField& field)
{
    if (field.name() != "nut")
    {
        return;
    }

    // With the k that has just been solved for, from which a run goes on
    setLayer();
    setViscosity();

    for (const bodyCell& c : zone_)
    {
        field[c.cell] = nut_[c.cell];
    }
    field.correctBoundaryConditions();
}
