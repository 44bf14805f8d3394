// SPDX-License-Identifier: GPL-3.0-or-later

#include "boxSolverCache.H"

namespace Foam
{
    defineTypeNameAndDebug(boxSolverCache, 0);
}


const Foam::tensorGrid& Foam::boxSolverCache::grid() const
{
    if (!grid_.valid())
    {
        grid_.reset(new tensorGrid(mesh()));
    }

    return grid_();
}


void Foam::boxSolverCache::say
(
    const word& fieldName,
    const std::string& text
) const
{
    if (said_.lookup(fieldName, std::string()) != text)
    {
        Info<< "fastPoisson: " << fieldName << ": " << text.c_str() << endl;
        said_.set(fieldName, text);
    }
}


Foam::boxSolverCache::boxSolverCache(const polyMesh& mesh)
:
    MeshObject<polyMesh, MoveableMeshObject, boxSolverCache>(mesh)
{}


const Foam::boxSolver* Foam::boxSolverCache::find(const word& fieldName) const
{
    return solvers_.found(fieldName) ? solvers_[fieldName] : nullptr;
}


const Foam::boxSolver* Foam::boxSolverCache::make
(
    const lduMatrix::solver& solver
) const
{
    const word& name = solver.fieldName();
    solvers_.erase(name);

    if (!grid().valid())
    {
        refuse(name, grid().reason());
        return nullptr;
    }

    const boxLaplacian laplacian(solver, mesh(), grid());

    if (!laplacian.valid())
    {
        refuse(name, laplacian.reason());
        return nullptr;
    }

    autoPtr<boxSolver> direct(new boxSolver(laplacian, grid()));

    if (!direct().valid())
    {
        refuse(name, "no direction has two layers of cells per processor");
        return nullptr;
    }

    say(name, grid().description() + " cells: " + direct().description());
    solvers_.set(name, direct.release());

    return find(name);
}


void Foam::boxSolverCache::prepare(const lduMatrix::solver& solver) const
{
    if (!said_.found(solver.fieldName()))
    {
        make(solver);
    }
}


void Foam::boxSolverCache::refuse
(
    const word& fieldName,
    const std::string& reason
) const
{
    say(fieldName, "not solved directly: " + reason);
}


bool Foam::boxSolverCache::movePoints()
{
    solvers_.clear();
    grid_.clear();

    return true;
}
