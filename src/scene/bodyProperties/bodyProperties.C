// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyProperties.H"
#include "checkKeywords.H"
#include "fluidChoice.H"
#include "outerIteration.H"
#include "unresolvedCoupling.H"

Foam::IOdictionary Foam::bodyProperties::read(const fvMesh& mesh)
{
    return keywords::readIfThere
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
}


const Foam::dictionary& Foam::bodyProperties::checked(const dictionary& dict)
{
    keywords::check
    (
        dict,
        {
            "rho", "resistance", "coupling", "contact",
            "lubrication", "window", "steady", "sleep", "leaving",
            "injection", "bodies", "grains", "turbulentWalls"
        }
    );
    for (const entry& e : dict)
    {
        if (!e.isDict() && e.keyword() != "rho")
        {
            FatalIOErrorInFunction(dict)
                << "'" << e.keyword() << "' is not a sub-dictionary, as '"
                << e.keyword() << " { "
                << (
                       e.keyword() == "bodies" || e.keyword() == "injection"
                     ? "name { ... }"
                     : "type ...;"
                   )
                << " }' is; allowed without braces is 'rho' only" << nl
                << exit(FatalIOError);
        }
    }

    wordList ofCoupling(unresolvedCoupling::keywords);
    ofCoupling.append(fluidChoice::keywords);
    ofCoupling.append(outerIteration::keywords);
    ofCoupling.append("spread");
    keywords::check(dict.subOrEmptyDict("coupling"), ofCoupling);

    return dict;
}


bool Foam::bodyProperties::any(const dictionary& dict)
{
    checked(dict);

    return dict.subOrEmptyDict("bodies").size()
     || dict.subOrEmptyDict("injection").size();
}
