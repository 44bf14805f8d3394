// SPDX-License-Identifier: GPL-3.0-or-later

#include "unresolvedCoupling.H"
#include "checkKeywords.H"

const Foam::wordList Foam::unresolvedCoupling::types
({
    "resolved", "unresolved", "auto"
});

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
    search_(search),
    periods_(periods),
    type_(Foam::keywords::choice(dict, "type", types, "resolved")),
    resolvedFrom_(Foam::keywords::positiveOr(dict, "resolvedFrom", 4)),
    frozen_(fluid(dict) == "frozen"),
    dense_(voidFraction(dict)),
    minVoid_(Foam::keywords::positiveOr(dict, "minVoidFraction", 0.3)),
    drag_(dragModel::New(dict.subOrEmptyDict("dragModel"))),
    dispersion_(dispersionModel::New(dict)),
    lifts_(liftModel::New(dict)),
    shapes_(dict.subOrEmptyDict("shapeModel")),
    centres_(mesh_.cellCentres(), false),
    grains_(bodies),
    nUnresolved_(0)
{
    const dictionary& kernel = dict.subOrEmptyDict("kernel");

    Foam::keywords::choice(shapes_, "type", shapeModel::types(), "sphericity");
    if (!shapes_.found("type"))
    {
        Foam::keywords::check(shapes_, {"type"});
    }
    Foam::keywords::check(kernel, {"cells", "diameters"});
    kernelCells_ = Foam::keywords::positiveOr(kernel, "cells", 3);
    kernelDiameters_ = Foam::keywords::positiveOr(kernel, "diameters", 2);

    if (kernelCells_ < 1.5)
    {
        FatalIOErrorInFunction(kernel)
            << "'cells " << kernelCells_ << "' in 'kernel' must be at least"
            << " 1.5, or parts of the mesh have no cell in a kernel" << nl
            << exit(FatalIOError);
    }

    bool wanted = type_ != "resolved";

    for (const immersedBody& body : bodies)
    {
        wanted = wanted || type(body) != "resolved";
    }

    if (wanted && space.twoD())
    {
        FatalIOErrorInFunction(dict)
            << "'coupling' can only be 'resolved' in two dimensions: drag laws"
            << " are those of spheres" << nl << exit(FatalIOError);
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


void Foam::unresolvedCoupling::report(Ostream& os) const
{
    os  << type_;

    if (type_ == "auto")
    {
        os  << ", from " << resolvedFrom_ << " cells per width";
    }
    os  << ", " << nUnresolved_ << " unresolved, drag of " << drag_->type()
        << ", kernels of " << kernelCells_ << " cells or "
        << kernelDiameters_ << " diameters";

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
