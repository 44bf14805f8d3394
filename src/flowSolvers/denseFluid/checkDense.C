// SPDX-License-Identifier: GPL-3.0-or-later

#include "denseFluid.H"
#include "bodyProperties.H"
#include "flowRateForce.H"

void Foam::flowSolvers::denseFluid::checkCase() const
{
    const IOdictionary properties(bodyProperties::read(mesh_));

    if (bodies_.window().comoving())
    {
        FatalIOErrorInFunction(properties.subDict("window"))
            << "'type comoving' in 'window' does not go with 'voidFraction yes'"
            << " in 'coupling': allowed is 'type fixed'" << nl
            << exit(FatalIOError);
    }

    const word scheme(mesh_.ddtScheme("ddt(" + U_.name() + ')'));

    if (scheme != "Euler")
    {
        FatalIOErrorInFunction(mesh_.schemesDict().subDict("ddtSchemes"))
            << "'" << scheme << "' in 'ddtSchemes' does not go with"
            << " 'voidFraction yes' in immersedBodyProperties: allowed is"
            << " 'Euler'" << nl << exit(FatalIOError);
    }

    const word type(momentumTransport->get<word>("simulationType"));

    if (type != "laminar")
    {
        FatalIOErrorInFunction(*momentumTransport)
            << "'simulationType " << type << "' does not go with"
            << " 'voidFraction yes' in immersedBodyProperties: allowed is"
            << " 'laminar'" << nl << exit(FatalIOError);
    }

    for (const fv::option& one : static_cast<const fv::optionList&>(fvOptions))
    {
        if (isA<fv::flowRateForce>(one))
        {
            FatalIOErrorInFunction(fvOptions)
                << "'type flowRateForce' in '" << one.name() << "' does not go"
                << " with 'voidFraction yes' in immersedBodyProperties: allowed"
                << " are forces, as 'vectorSemiImplicitSource'" << nl
                << exit(FatalIOError);
        }
    }

    if (MRF.MRFZoneList::size())
    {
        FatalIOErrorInFunction(MRF)
            << "Rotating zones do not go with 'voidFraction yes' in"
            << " immersedBodyProperties: allowed is no MRFProperties" << nl
            << exit(FatalIOError);
    }
}
