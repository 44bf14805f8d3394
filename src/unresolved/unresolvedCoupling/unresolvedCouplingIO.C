// SPDX-License-Identifier: GPL-3.0-or-later

#include "unresolvedCoupling.H"
#include "checkKeywords.H"

const Foam::wordList Foam::unresolvedCoupling::keywords
({
    "type", "resolvedFrom", "dragModel", "dispersion", "lift", "shapeModel",
    "kernel"
});


Foam::unresolvedCoupling::unresolvedCoupling
(
    const dictionary& dict,
    const geometricSpace& space,
    const cellSearch& search,
    const periodicity& periods,
    bodyList& bodies
)
:
    mesh_(search.mesh()),
    choice_(dict),
    fluid_(dict),
    drag_(dragModel::New(dict.subOrEmptyDict("dragModel"))),
    dispersion_(dispersionModel::New(dict)),
    lifts_(liftModel::New(dict)),
    shapes_(dict.subOrEmptyDict("shapeModel")),
    grains_(bodies),
    kernels_(dict.subOrEmptyDict("kernel"), search, periods, bodies),
    covered_(mesh_)
{
    Foam::keywords::choice(shapes_, "type", shapeModel::types(), "sphericity");
    if (!shapes_.found("type"))
    {
        Foam::keywords::check(shapes_, {"type"});
    }

    // As each body is asked for its own
    if (choice_.type() != "resolved" && space.twoD())
    {
        FatalIOErrorInFunction(dict)
            << "'type " << choice_.type() << "' in 'coupling' can only be"
            << " 'resolved' in two dimensions: drag laws are those of spheres"
            << nl << exit(FatalIOError);
    }

    forAll(bodies, bodyi)
    {
        check(bodies[bodyi], grains_[bodyi]);
    }
}


void Foam::unresolvedCoupling::report(Ostream& os) const
{
    choice_.report(os);
    os  << ", " << nUnresolved() << " unresolved, drag of " << drag_->type()
        << ", ";
    kernels_.report(os);

    for (const liftModel& lift : lifts_)
    {
        os  << ", lift of " << lift.type();
    }
    if (shapes_.found("type"))
    {
        os  << ", shapes by " << shapes_.get<word>("type");
    }
    fluid_.report(os);
    if (dispersion_.valid())
    {
        os  << ", dispersion by " << dispersion_->type();
    }
}
