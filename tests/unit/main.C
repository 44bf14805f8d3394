// SPDX-License-Identifier: GPL-3.0-or-later
/* Application
    grainFoamUnitTests
Description
    Unit tests: no case, most without a mesh.

        grainFoamUnitTests [arguments of Catch2]
        mpirun -np 2 grainFoamUnitTests -parallel [arguments of Catch2]

    In parallel every processor runs all tests. The master prints; another one
    only what fails on it. */

#define CATCH_CONFIG_RUNNER
#include "testTools.H"
#include "PstreamReduceOps.H"
#include <iostream>
#include <sstream>

using namespace Foam;

int main(int argc, char* argv[])
{
    std::vector<char*> args;
    bool parallel = false;

    for (int i = 0; i < argc; ++i)
    {
        if (std::string(argv[i]) == "-parallel")
        {
            parallel = true;
        }
        else
        {
            args.push_back(argv[i]);
        }
    }

    if (parallel && !UPstream::init(argc, argv, false))
    {
        return 1;
    }

    FatalError.throwExceptions();
    FatalIOError.throwExceptions();

    std::ostringstream log;
    std::streambuf* const screen = std::cout.rdbuf();

    if (!UPstream::master())
    {
        std::cout.rdbuf(log.rdbuf());
    }

    Catch::Session session;
    label failed = session.applyCommandLine(int(args.size()), args.data());

    if (!failed)
    {
        failed = session.run();
    }

    std::cout.rdbuf(screen);

    if (!parallel)
    {
        return failed ? 1 : 0;
    }

    if (failed && !UPstream::master())
    {
        std::cerr
            << "On processor " << UPstream::myProcNo() << ":\n" << log.str();
    }

    reduce(failed, maxOp<label>());
    UPstream::exit(failed ? 1 : 0);
}
