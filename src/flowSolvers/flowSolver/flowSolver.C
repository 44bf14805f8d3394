// SPDX-License-Identifier: GPL-3.0-or-later

#include "flowSolver.H"
#include "argList.H"
#include <cstdlib>
#include <malloc.h>
#include <sys/mman.h>

namespace Foam
{
    defineTypeNameAndDebug(flowSolver, 0);
    defineRunTimeSelectionTable(flowSolver, dynamicFvMesh);
}


namespace
{

//- Keep the memory of temporary fields. Given back to the system after each, it
//  would be cleared again for the next: 5 % of a step of 64^3 cells.
void keepFreedMemory()
{
    #ifdef __GLIBC__
    mallopt(M_MMAP_MAX, 0);
    mallopt(M_TRIM_THRESHOLD, -1);
    #endif
}


//- Let fields lie in large pages where the system leaves that to programs: 4 %
//  of a step of 64^3 cells. Nothing is lost if it cannot be done.
void useLargePages(const Foam::label nCells)
{
    #if defined(__GLIBC__) && defined(MADV_HUGEPAGE)
    const size_t perCell = 2000;        // Bytes, about what a run takes
    const size_t page = 1 << 21;
    const size_t size = perCell*nCells/page*page;

    // What is freed again is what fields are made of next
    if (void* some = std::malloc(size + page))
    {
        const size_t at = reinterpret_cast<size_t>(some);
        const size_t begin = (at + page - 1)/page*page;

        madvise(reinterpret_cast<void*>(begin), size, MADV_HUGEPAGE);
        std::free(some);
    }
    #endif
}

} // End anonymous namespace


Foam::flowSolver::flowSolver(dynamicFvMesh& mesh)
:
    mesh_(mesh),
    runTime_(const_cast<Time&>(mesh.time())),
    pimple_(mesh)
{}


Foam::autoPtr<Foam::flowSolver> Foam::flowSolver::New
(
    const word& solverName,
    dynamicFvMesh& mesh
)
{
    keepFreedMemory();
    useLargePages(mesh.nCells());

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
