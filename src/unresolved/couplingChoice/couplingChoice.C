// SPDX-License-Identifier: GPL-3.0-or-later

#include "couplingChoice.H"
#include "checkKeywords.H"

const Foam::wordList Foam::couplingChoice::types
({
    "resolved", "unresolved", "auto"
});


Foam::couplingChoice::couplingChoice(const dictionary& dict)
:
    type_(keywords::choice(dict, "type", types, "resolved")),
    resolvedFrom_(keywords::positiveOr(dict, "resolvedFrom", 4))
{}


const Foam::word& Foam::couplingChoice::type(const immersedBody& body) const
{
    return body.kind().coupling().empty() ? type_ : body.kind().coupling();
}


bool Foam::couplingChoice::resolves
(
    const immersedBody& body,
    const scalar h
) const
{
    const word& t = type(body);

    if (t != "auto")
    {
        return t == "resolved";
    }

    // Else one that moves along where the cells change size would be neither
    const scalar hysteresis = body.resolved() ? 1 : 1.1;

    return body.shape().width() >= hysteresis*resolvedFrom_*h;
}


void Foam::couplingChoice::report(Ostream& os) const
{
    os  << type_;

    if (type_ == "auto")
    {
        os  << ", from " << resolvedFrom_ << " cells per width";
    }
}
