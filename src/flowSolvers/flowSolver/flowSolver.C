// SPDX-License-Identifier: GPL-3.0-or-later

#include "flowSolver.H"
#include "argList.H"

namespace Foam
{
    defineTypeNameAndDebug(flowSolver, 0);
    defineRunTimeSelectionTable(flowSolver, dynamicFvMesh);
}


Foam::flowSolver::flowSolver(dynamicFvMesh& mesh)
:
    mesh_(mesh),
    runTime_(const_cast<Time&>(mesh.time())),
    pimple_(mesh)
{
    checkTimeControls();
}


void Foam::flowSolver::checkTimeControls() const
{
    const dictionary& dict = runTime_.controlDict();

    for (const word key : {"deltaT", "maxCo", "maxDeltaT", "writeInterval"})
    {
        if (dict.found(key) && !(dict.get<scalar>(key) > 0))
        {
            FatalIOErrorInFunction(dict)
                << "'" << key << ' ' << dict.get<scalar>(key)
                << "' must be greater than 0" << nl << exit(FatalIOError);
        }
    }
}


Foam::autoPtr<Foam::flowSolver> Foam::flowSolver::New
(
    const word& solverName,
    dynamicFvMesh& mesh
)
{
    Info<< "Selecting solver " << solverName << endl;

    if (!validNames().found(solverName))
    {
        const_cast<Time&>(mesh.time()).libs().open
        (
            "lib" + solverName + ".so",
            false
        );
    }

    if (!validNames().found(solverName))
    {
        FatalErrorInFunction
            << "Unknown solver " << solverName << nl
            << "given by the option -solver or by the entry solver in "
            << mesh.time().system()/"controlDict" << nl << nl
            << "Valid solvers: " << flatOutput(validNames()) << nl
            << exit(FatalError);
    }

    return dynamicFvMeshConstructorTablePtr_->find(solverName)()(mesh);
}


Foam::autoPtr<Foam::flowSolver> Foam::flowSolver::New
(
    const argList& args,
    dynamicFvMesh& mesh
)
{
    word solverName;

    if
    (
        !args.readIfPresent("solver", solverName)
     && !mesh.time().controlDict().readIfPresent("solver", solverName)
    )
    {
        FatalErrorInFunction
            << "No solver is selected: add the entry solver to "
            << mesh.time().system()/"controlDict"
            << " or use the option -solver <name>" << nl << nl
            << "Valid solvers: " << flatOutput(validNames()) << nl
            << exit(FatalError);
    }

    return New(solverName, mesh);
}


Foam::wordList Foam::flowSolver::validNames()
{
    if (!dynamicFvMeshConstructorTablePtr_)
    {
        return wordList();
    }

    return dynamicFvMeshConstructorTablePtr_->sortedToc();
}


bool Foam::flowSolver::outerLoop()
{
    return pimple_.loop();
}


void Foam::flowSolver::check()
{
    const objectRegistry& db = mesh_;
    wordList names;
    forAllConstIters(db, iter)
    {
        const regIOobject& io = *iter();

        if
        (
            io.writeOpt() == IOobject::AUTO_WRITE
         && io.instance() == runTime_.timeName()
         && io.local().empty()
        )
        {
            names.append(io.name());
        }
    }
    Foam::sort(names);

    wordList patchNames(mesh_.boundaryMesh().names());
    patchNames.resize(mesh_.boundaryMesh().nNonProcessor());

    Info<< nl << "Checking the case " << runTime_.globalCaseName() << nl
        << "    cells            " << mesh_.globalData().nTotalCells() << nl
        << "    patches          "
        << flatOutput(patchNames) << nl
        << "    moving mesh      " << Switch(mesh_.dynamic()) << nl
        << "    fields to write  " << flatOutput(names) << nl
        << "    start time       " << runTime_.timeName() << nl
        << "    end time         " << runTime_.endTime().value() << nl
        << "    deltaT           " << runTime_.deltaTValue() << endl;
}
