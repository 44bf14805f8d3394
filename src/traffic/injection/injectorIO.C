// SPDX-License-Identifier: GPL-3.0-or-later

#include "injector.H"

Foam::autoPtr<Foam::immersedBody> Foam::injector::remake
(
    const word& name,
    const bodyOrigin& origin
) const
{
    std::shared_ptr<const bodyKind> kind(kind_);

    if (size_.valid() || origin.densityRatio != kind->densityRatio())
    {
        dictionary dict(dict_);
        dict.remove("density");
        dict.set("densityRatio", origin.densityRatio);

        kind = std::make_shared<const bodyKind>
        (
            dict,
            size_.valid() ? scaledShape(origin.size) : shape_,
            space_,
            rho_
        );
    }

    return autoPtr<immersedBody>
    (
        new immersedBody
        (
            name, kind, point::zero, quaternion::I,
            std::make_shared<const bodyOrigin>(origin)
        )
    );
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
