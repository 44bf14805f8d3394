// SPDX-License-Identifier: GPL-3.0-or-later

#include "injector.H"

std::shared_ptr<const Foam::bodyKind> Foam::injector::kindOf
(
    const bodyOrigin& origin
) const
{
    if (!size_.valid() && origin.densityRatio == kind_->densityRatio())
    {
        return kind_;
    }

    dictionary dict(dict_);

    dict.remove("density");
    dict.set("densityRatio", origin.densityRatio);

    return std::make_shared<const bodyKind>
    (
        dict,
        size_.valid() ? scaledShape(origin.size) : shape_,
        space_,
        rho_
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
