// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodiesInOrder.H"
#include "OStringStream.H"

Foam::label Foam::bodiesInOrder::nextNumber
(
    const bodyList& bodies,
    label& bodyi
)
{
    while (bodyi < bodies.size() && !bodies.share().mine(bodyi))
    {
        ++bodyi;
    }

    return returnReduce
    (
        bodyi < bodies.size() ? bodies[bodyi].number() : labelMax,
        minOp<label>()
    );
}


void Foam::bodiesInOrder::write
(
    const bodyList& bodies,
    Ostream& os,
    const std::function<void(Ostream&, label)>& one
)
{
    if (!bodies.share().spread())
    {
        forAll(bodies, bodyi)
        {
            one(os, bodyi);
        }
        return;
    }

    visit<char>
    (
        bodies,
        [&](const label bodyi, DynamicList<char>& text)
        {
            OStringStream ofBody;

            ofBody.precision(os.precision());
            ofBody.indentLevel() = os.indentLevel();
            one(ofBody, bodyi);

            for (const char c : ofBody.str())
            {
                text.append(c);
            }
        },
        [&](const UList<char>& text)
        {
            os.writeQuoted(std::string(text.cdata(), text.size()), false);
        }
    );
}
