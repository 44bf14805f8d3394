// SPDX-License-Identifier: GPL-3.0-or-later

#include "immersedBodyEnergy.H"
#include "addToRunTimeSelectionTable.H"
#include "bodyContacts.H"
#include "bodyShare.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(immersedBodyEnergy, 0);
    addToRunTimeSelectionTable(functionObject, immersedBodyEnergy, dictionary);
}
}


namespace
{

//- Energies of translation, of rotation and in gravity of all bodies, over the
//  density of the fluid [m5/s2]. Collective.
Foam::vector sums(const Foam::immersedBodies& bodies)
{
    using namespace Foam;

    return bodies.list().share().sum<vector>
    (
        [&](const label bodyi)
        {
            const immersedBody& body = bodies[bodyi];
            const bodyState& s = body.state();
            const scalar r = body.densityRatio();

            return vector
            (
                0.5*r*body.volume()*magSqr(s.U),
                0.5*r*(s.omega & body.inertia(s) & s.omega),
                -(r - 1)*body.volume()
               *(bodies.g() & body.motion().unwrapped())
            );
        }
    );
}

} // End anonymous namespace


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
    const immersedBodies* found =
        mesh_.findObject<immersedBodies>(immersedBodies::typeName);

    if (!found)
    {
        FatalErrorInFunction
            << "Function object '" << name() << "' needs immersed bodies: run"
            << " it with the solver immersedFluid and bodies in"
            << " constant/immersedBodyProperties" << nl << exit(FatalError);
    }

    const immersedBodies& bodies = *found;
    const vector ofBodies(sums(bodies));

    if (!writeToFile())
    {
        return true;
    }

    OFstream& os = file();

    if (writesHeader())
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
    }

    const contactEnergy contact(bodies.contacts().model().energy());

    writeCurrentTime(os);

    for
    (
        const scalar energy
      : {
            ofBodies.x(), ofBodies.y(), ofBodies.z(), contact.springs(),
            contact.dashpots, contact.friction(), contact.lubrication
        }
    )
    {
        os  << tab << bodies.rho()*energy;
    }
    os  << endl;

    return true;
}
