// SPDX-License-Identifier: GPL-3.0-or-later

#include "stokesRun.H"
#include "checkKeywords.H"
#include "directStokes.H"
#include "iterativeStokes.H"
#include "Time.H"

namespace
{
    //- Of directStokes [bytes]
    const Foam::scalar largestTable = 4e9;
}


Foam::IOdictionary Foam::stokesRun::readDict(const fvMesh& mesh)
{
    const IOdictionary dict
    (
        keywords::readIfThere
        (
            IOobject
            (
                "stokesModesDict",
                mesh.time().system(),
                mesh,
                IOobject::READ_IF_PRESENT,
                IOobject::NO_WRITE,
                false
            )
        )
    );

    keywords::check
    (
        dict,
        {
            "states", "angles", "drive", "inertia", "writeFlows",
            "tolerance", "maxIterations", "solver", "mirrors"
        }
    );

    return dict;
}


Foam::stokesRun::stokesRun(const fvMesh& mesh)
:
    mesh_(mesh),
    dict_(readDict(mesh)),
    equations_(mesh),
    bodies_(mesh),
    states_(dict_, bodies_),
    drive_(dict_.subOrEmptyDict("drive")),
    tolerance_(keywords::positiveOr(dict_, "tolerance", 1e-7)),
    inertia_(dict_.lookupOrDefault("inertia", true)),
    writeFlows_(dict_.lookupOrDefault("writeFlows", false))
{
    bodies_.setFluid(equations_.A0(), equations_.nu());
    setSolver();
    modes_.reset(new stokesModes(equations_, bodies_, solver_(), drive_));
    mirrors_.reset
    (
        new stokesMirrors(dict_, equations_, bodies_, states_, drive_)
    );
    table_.reset(new stokesTable(bodies_, states_));

    Info<< "Stokes flows around " << bodies_.size() << " bodies: "
        << bodies_.nModes() << " modes" << nl << "    states: "
        << states_.size() << ", of which the table has " << table_->nFound()
        << nl << endl;
}


void Foam::stokesRun::setSolver()
{
    const word name
    (
        keywords::choice
        (
            dict_, "solver", {"auto", "direct", "iterative"}, "auto"
        )
    );
    const label maxIterations =
        keywords::positiveOr(dict_, "maxIterations", 500);
    string why("'solver iterative' is set");

    if (name != "iterative")
    {
        grid_.reset(new tubeGrid(mesh_));
        why = grid_->why();

        if (why.empty() && tubeOperator::tableSize(grid_()) > largestTable)
        {
            why = "its table would take "
              + Foam::name(tubeOperator::tableSize(grid_())/1e9) + " GB";
        }
    }

    if (why.empty())
    {
        solver_.reset(new directStokes(equations_, grid_()));
        Info<< "Stokes flows: direct solver, table of "
            << tubeOperator::tableSize(grid_())/1e9 << " GB, made in "
            << mesh_.time().elapsedCpuTime() << " s" << endl;
        return;
    }

    if (name == "direct")
    {
        FatalIOErrorInFunction(dict_)
            << "'solver direct' does not serve here: " << why.c_str() << nl
            << exit(FatalIOError);
    }

    solver_.reset(new iterativeStokes(equations_, tolerance_, maxIterations));
    Info<< "Stokes flows: iterative solver, as " << why.c_str() << endl;
}


void Foam::stokesRun::solve(const label state)
{
    Info<< "State " << state << ": "
        << flatOutput(states_.positions(state)) << endl;

    const string forbidden
    (
        bodies_.setPoses(states_.positions(state), states_.angles(state))
    );

    if (!forbidden.empty())
    {
        if (states_.size() == 1)
        {
            FatalIOErrorInFunction(bodies_.dict().subDict("bodies"))
                << "There is no flow: " << forbidden.c_str() << nl
                << exit(FatalIOError);
        }
        Info<< "    no flows: " << forbidden.c_str() << endl;
        table_->write(state, scalarList());
        return;
    }

    equations_.setBodies(&bodies_);
    modes_->solve(inertia_);
    table_->print(modes_(), Info);
    table_->write(state, table_->row(modes_()));

    Info<< "    residual " << modes_->residual << ", ";
    solver_->report(Info);
    Info<< endl;

    if (modes_->residual > tolerance_)
    {
        WarningInFunction
            << "The residual " << modes_->residual << " of a flow of state "
            << state << " is larger than 'tolerance " << tolerance_
            << "': increase 'maxIterations' in " << dict_.name() << nl << endl;
    }

    if (modes_->eigenvalues[0] <= 0)
    {
        WarningInFunction
            << "The resistance of state " << state
            << " is not positive definite: the mesh does not resolve the flow"
            << nl << endl;
    }

    if (writeFlows_)
    {
        writeFlows(state);
    }
}


void Foam::stokesRun::write(autoPtr<stokesFlow> flow, const word& name) const
{
    flow->U.rename("U." + name);
    flow->p.rename("p." + name);
    flow->U.write();
    flow->p.write();
}


void Foam::stokesRun::writeFlows(const label state)
{
    const label n = bodies_.nModes();
    const word prefix(Foam::name(state) + ".");

    for (label i = 0; i < n; ++i)
    {
        write(modes_->flow(i), prefix + table_->name(i));
    }
    write(modes_->flow(n), prefix + "fixed");
    write(modes_->flow(n + 1), prefix + "free");
}


void Foam::stokesRun::run()
{
    const scalar start = mesh_.time().elapsedCpuTime();
    scalar taken = 0;
    label left = states_.size() - table_->nFound();
    label n = 0;

    for (label state = 0; state < states_.size(); ++state)
    {
        if (table_->has(state))
        {
            mirrors_->note(state);
            continue;
        }

        const label other = mirrors_->find(state);

        if (other >= 0)
        {
            table_->write
            (
                state, mirrors_->reflected(state, other, table_->row(other))
            );
            Info<< "State " << state << ": mirror image of state " << other
                << nl << endl;
            --left;
            continue;
        }
        solve(state);
        mirrors_->note(state);
        ++n;
        --left;

        const scalar before = taken;
        taken = mesh_.time().elapsedCpuTime() - start;

        Info<< "    took " << taken - before << " s, states left " << left
            << ", time left " << round(taken*left/n) << " s" << nl << endl;
    }
}
