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


void Foam::fv::bodyWalls::findCells()
{
    const PtrList<bodyRegion>& regions = bodies_.region().regions();
    scalarField nearest(mesh_.nCells(), GREAT);

    for (const bodyRegion& r : regions)
    {
        forAll(r.cells, i)
        {
            scalar& d = nearest[r.cells[i]];

            d = min(d, r.distance[i]/r.h[i]);
        }
    }

    zone_.clear();
    outside_.clear();

    forAll(regions, regioni)
    {
        const bodyRegion& r = regions[regioni];

        forAll(r.cells, i)
        {
            const bodyCell c{r.cells[i], regioni, i};
            scalar& d = nearest[c.cell];

            if (cellsAway(c) == d && d < width_ + 1)
            {
                (d < width_ ? zone_ : outside_).append(c);

                // Of two bodies at the same distance it is the first
                d = -GREAT;
            }
        }
    }

    inward_.reset(new normalExtrapolation(mesh_, regions, width_));
    within_.reset(new normalExtrapolation(mesh_, regions, width_ - 1));
}


void Foam::fv::bodyWalls::setLayer()
{
    const volScalarField* k =
        usesK() ? &mesh_.lookupObject<volScalarField>("k") : nullptr;

    uTau_ = 0;
    kLog_ = 0;

    for (const bodyCell& c : outside_)
    {
        const scalar nu = nu_[c.cell];
        const scalar u = lawOfTheWall::frictionVelocity(speed(c), y(c), nu);

        uTau_[c.cell] = u;
        kLog_[c.cell] =
        (
            k
          ? lawOfTheWall::through((*k)[c.cell], y(c), nu, u)
          : lawOfTheWall(nu, u)
        ).kLog();
    }

    inward_->apply(uTau_, false);
    inward_->apply(kLog_, false);
}


void Foam::fv::bodyWalls::setViscosity()
{
    const bool byK = usesK();

    nut_ = 0;

    for (const bodyCell& c : zone_)
    {
        if (cellsAway(c) >= width_ - 1)
        {
            nut_[c.cell] = byK
              ? law(c).nut(y(c))
              : lawOfTheWall::nutByVelocity(speed(c), y(c), nu_[c.cell]);
        }
    }

    within_->apply(nut_, false);
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
        return max(law(c).epsilon(y(c)), SMALL);
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
