// SPDX-License-Identifier: GPL-3.0-or-later

#include "frozenFluid.H"
#include "functionObject.H"
#include "meshProperties.H"

namespace Foam
{
namespace flowSolvers
{
    defineTypeNameAndDebug(frozenFluid, 0);
}
}


Foam::flowSolvers::frozenFluid::frozenFluid(dynamicFvMesh& mesh)
:
    fluidWithBodies(mesh),
    done_(false)
{
    if (bodies_.window().comoving())
    {
        FatalErrorInFunction
            << "A fluid that is frozen does not go with a comoving window"
            << nl << exit(FatalError);
    }

    if (!functionObject::postProcess && !bodies_.restarted())
    {
        bodies_.setAmbient(U_);
    }
    correctViscosity();
    reportSetUp("", ", the fluid");
}


Foam::tmp<Foam::fvVectorMatrix>
Foam::flowSolvers::frozenFluid::assembleMomentum()
{
    return tmp<fvVectorMatrix>
    (
        new fvVectorMatrix(U_, U_.dimensions()*dimVolume/dimTime)
    );
}


void Foam::flowSolvers::frozenFluid::reportIterations(Ostream& os) const
{
    os  << "outer iterations 1";
}


void Foam::flowSolvers::frozenFluid::preSolve()
{
    setTimeStep();
    done_ = false;
}


bool Foam::flowSolvers::frozenFluid::outerLoop()
{
    const bool more = !done_;
    done_ = true;

    return more;
}


void Foam::flowSolvers::frozenFluid::motionCorrector()
{
    bodies_.beginStep();
    bodies_.predict(false);
}


void Foam::flowSolvers::frozenFluid::momentumPredictor()
{
    moveUnresolved(meshProperties::ddt(mesh_, U_.name()));
}
