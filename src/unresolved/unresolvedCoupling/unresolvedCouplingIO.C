// SPDX-License-Identifier: GPL-3.0-or-later

#include "unresolvedCoupling.H"
#include "checkKeywords.H"

const Foam::wordList Foam::unresolvedCoupling::keywords
({
    "type", "resolvedFrom", "dragModel", "dispersion", "lift", "shapeModel",
    "fluid", "kernel", "voidFraction", "minVoidFraction"
});


Foam::word Foam::unresolvedCoupling::fluid(const dictionary& coupling)
{
    return Foam::keywords::choice
    (
        coupling, "fluid", {"solved", "frozen", "projected"}, "solved"
    );
}


bool Foam::unresolvedCoupling::voidFraction(const dictionary& coupling)
{
    return
        Foam::keywords::choice(coupling, "voidFraction", {"yes", "no"}, "no")
     == "yes";
}


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
    frozen_(fluid(dict) == "frozen"),
    dense_(voidFraction(dict)),
    minVoid_(Foam::keywords::positiveOr(dict, "minVoidFraction", 0.3)),
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

    if (dense_)
    {
        checkDense(dict);
    }

    forAll(bodies, bodyi)
    {
        check(bodies[bodyi], grains_[bodyi]);
    }
}


void Foam::unresolvedCoupling::checkDense(const dictionary& coupling) const
{
    if (choice_.type() != "unresolved")
    {
        FatalIOErrorInFunction(coupling)
            << "'voidFraction yes' in 'coupling' needs 'type unresolved' there"
            << " and not '" << choice_.type() << "'" << nl
            << exit(FatalIOError);
    }

    if (fluid(coupling) != "solved")
    {
        FatalIOErrorInFunction(coupling)
            << "'voidFraction yes' in 'coupling' needs 'fluid solved' there"
            << " and not '" << fluid(coupling) << "'" << nl
            << exit(FatalIOError);
    }

    if (minVoid_ >= 1)
    {
        FatalIOErrorInFunction(coupling)
            << "'minVoidFraction " << minVoid_ << "' in 'coupling' must be"
            << " less than 1" << nl << exit(FatalIOError);
    }
}


void Foam::unresolvedCoupling::checkDense(const immersedBody& body) const
{
    const dictionary dict
    (
        fileName(mesh_.time().constant()/"immersedBodyProperties")
    );

    if (choice_.type(body) != "unresolved")
    {
        FatalIOErrorInFunction(dict)
            << "'voidFraction yes' in 'coupling' needs bodies that are all"
            << " 'unresolved', and " << body.name() << " is of the type '"
            << choice_.type(body) << "'" << nl << exit(FatalIOError);
    }

    const vector free
    (
        body.isFree() ? body.status().freedom().U() : vector::zero
    );

    if (cmptMax(free) != cmptMin(free))
    {
        FatalIOErrorInFunction(dict)
            << "'voidFraction yes' in 'coupling' needs bodies that move freely"
            << " or in no direction: 'translate' in 'constraints' of "
            << body.name() << " is " << free
            << ", allowed are (1 1 1) and (0 0 0)" << nl << exit(FatalIOError);
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
    if (frozen_)
    {
        os  << ", frozen fluid";
    }
    if (dense_)
    {
        os  << ", with the void fraction";
    }
    if (dispersion_.valid())
    {
        os  << ", dispersion by " << dispersion_->type();
    }
}
