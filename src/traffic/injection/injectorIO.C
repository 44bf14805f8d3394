// SPDX-License-Identifier: GPL-3.0-or-later

#include "injector.H"

Foam::autoPtr<Foam::immersedBody> Foam::injector::remake
(
    const word& name,
    const bodyOrigin& origin
) const
{
    dictionary dict(dict_);
    dict.remove("density");
    dict.set("densityRatio", origin.densityRatio);

    autoPtr<immersedBody> body
    (
        new immersedBody
        (
            name,
            dict,
            size_.valid() ? scaledShape(origin.size) : shape_,
            space_,
            point::zero,
            rho_
        )
    );
    body->setOrigin(origin);

    return body;
}


void Foam::injector::readState(const dictionary& dict)
{
    schedule_.readState(dict);
    tries_ = dict.get<label>("tries");
}


void Foam::injector::writeState(Ostream& os) const
{
    os.beginBlock(name_);
    schedule_.writeState(os);
    os.writeEntry("tries", tries_);
    os.endBlock();
}
