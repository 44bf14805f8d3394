// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluidChoice.H"
#include "checkKeywords.H"

const Foam::wordList Foam::fluidChoice::keywords
({
    "fluid", "voidFraction", "minVoidFraction"
});


Foam::fluidChoice::fluidChoice(const dictionary& coupling)
:
    where_(coupling.name()),
    fluid_
    (
        Foam::keywords::choice
        (
            coupling, "fluid", {"solved", "frozen", "projected"}, "solved"
        )
    ),
    dense_
    (
        Foam::keywords::choice(coupling, "voidFraction", {"yes", "no"}, "no")
     == "yes"
    ),
    minVoid_(Foam::keywords::positiveOr(coupling, "minVoidFraction", 0.3))
{
    if (dense_)
    {
        checkDense(coupling);
    }
}


void Foam::fluidChoice::checkDense(const dictionary& coupling) const
{
    const word type(couplingChoice(coupling).type());

    if (type != "unresolved")
    {
        FatalIOErrorInFunction(coupling)
            << "'voidFraction yes' in 'coupling' needs 'type unresolved' there"
            << " and not '" << type << "'" << nl << exit(FatalIOError);
    }

    if (fluid_ != "solved")
    {
        FatalIOErrorInFunction(coupling)
            << "'voidFraction yes' in 'coupling' needs 'fluid solved' there"
            << " and not '" << fluid_ << "'" << nl << exit(FatalIOError);
    }

    if (minVoid_ >= 1)
    {
        FatalIOErrorInFunction(coupling)
            << "'minVoidFraction " << minVoid_ << "' in 'coupling' must be"
            << " less than 1" << nl << exit(FatalIOError);
    }
}


void Foam::fluidChoice::checkDense
(
    const immersedBody& body,
    const word& type
) const
{
    if (type != "unresolved")
    {
        FatalIOErrorInFunction(dictionary(where_))
            << "'voidFraction yes' in 'coupling' needs bodies that are all"
            << " 'unresolved', and " << body.name() << " is of the type '"
            << type << "'" << nl << exit(FatalIOError);
    }

    const vector free
    (
        body.isFree() ? body.status().freedom().U() : vector::zero
    );

    if (cmptMax(free) != cmptMin(free))
    {
        FatalIOErrorInFunction(dictionary(where_))
            << "'voidFraction yes' in 'coupling' needs bodies that move freely"
            << " or in no direction: 'translate' in 'constraints' of "
            << body.name() << " is " << free
            << ", allowed are (1 1 1) and (0 0 0)" << nl << exit(FatalIOError);
    }
}


void Foam::fluidChoice::check
(
    const immersedBody& body,
    const word& type
) const
{
    if (frozen() && type != "unresolved")
    {
        FatalIOErrorInFunction(dictionary(where_))
            << "'fluid frozen' in 'coupling' of immersedBodyProperties"
            << " needs bodies that are all unresolved, and "
            << body.name() << " is of the type '" << type << "'" << nl
            << exit(FatalIOError);
    }

    if (dense_)
    {
        checkDense(body, type);
    }
}


void Foam::fluidChoice::report(Ostream& os) const
{
    if (frozen())
    {
        os  << ", frozen fluid";
    }
    if (dense_)
    {
        os  << ", with the void fraction";
    }
}
