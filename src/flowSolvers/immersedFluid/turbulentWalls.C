// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedFluid.H"

void Foam::flowSolvers::immersedFluid::addBodyWalls()
{
    if (!fv::bodyWalls::wanted(mesh_))
    {
        return;
    }

    bodyWalls_ = new fv::bodyWalls
    (
        bodies_(),
        U_,
        momentumTransport->get<word>("simulationType") == "LES"
    );
    static_cast<fv::optionList&>(fvOptions).append(bodyWalls_);

    // A file that has changed would be read again, for an entry of each option
    fvOptions.watchIndices().clear();

    bodyWalls_->update(momentumTransport->nu()());
    momentumTransport->validate();
}
