// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedBodyEnergy.H"
#include "addToRunTimeSelectionTable.H"
#include "bodyContacts.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(immersedBodyEnergy, 0);
    addToRunTimeSelectionTable(functionObject, immersedBodyEnergy, dictionary);
}
}


Foam::functionObjects::immersedBodyEnergy::immersedBodyEnergy
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    tableFile(mesh_, name, typeName, dict)
{
    read(dict);
}


bool Foam::functionObjects::immersedBodyEnergy::read(const dictionary& dict)
{
    return fvMeshFunctionObject::read(dict) && writeFile::read(dict);
}


bool Foam::functionObjects::immersedBodyEnergy::write()
{
    immersedBodies* found =
        mesh_.getObjectPtr<immersedBodies>(immersedBodies::typeName);

    if (!found)
    {
        FatalErrorInFunction
            << "Function object '" << name() << "' needs immersed bodies: run"
            << " it with the solver immersedFluid and bodies in"
            << " constant/immersedBodyProperties" << nl << exit(FatalError);
    }

    found->unite();

    if (!writeToFile())
    {
        return true;
    }

    const immersedBodies& bodies = *found;
    OFstream& os = file();

    if (!writtenHeader_)
    {
        writeCommented(os, "time[s]");

        for
        (
            const char* column
          : {
                "translation[J]", "rotation[J]", "potential[J]", "springs[J]",
                "dashpots[J]", "friction[J]", "lubrication[J]"
            }
        )
        {
            os  << tab << column;
        }
        os  << nl;
        writtenHeader_ = true;
    }

    scalar translation = 0, rotation = 0, potential = 0;

    for (label bodyi = 0; bodyi < bodies.size(); ++bodyi)
    {
        const immersedBody& body = bodies[bodyi];
        const bodyState& s = body.state();
        const scalar r = body.densityRatio();

        translation += 0.5*r*body.volume()*magSqr(s.U);
        rotation += 0.5*r*(s.omega & body.inertia(s) & s.omega);
        potential -=
            (r - 1)*body.volume()*(bodies.g() & body.motion().unwrapped());
    }

    const contactEnergy contact(bodies.contacts().model().energy());

    writeCurrentTime(os);

    for
    (
        const scalar energy
      : {
            translation, rotation, potential, contact.springs(),
            contact.dashpots, contact.friction(), contact.lubrication
        }
    )
    {
        os  << tab << bodies.rho()*energy;
    }
    os  << endl;

    return true;
}
