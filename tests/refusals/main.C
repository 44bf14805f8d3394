// SPDX-License-Identifier: GPL-3.0-or-later
/* Application
    grainFoamRefusals
Description
    Runs foamRun in many cases, for tests of what it refuses: the libraries,
    which take most of the time of a run that ends before its first time step,
    are loaded once. Each case is run by a process of its own, a fork.

        grainFoamRefusals [-check] CASE...

    Each writes CASE/log.foamRun; a line "status CASE" is printed for each. */

#include <cstdio>
#include <fcntl.h>
#include <string>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

// The solver as it is, with another name for its main
#define main foamRun
#include "foamRun.C"
#undef main


//- Run foamRun in this process, return its exit status
static int runIn(const char* folder, std::vector<char*> args)
{
    if (chdir(folder))
    {
        std::perror(folder);
        return 127;
    }

    const int log = open("log.foamRun", O_WRONLY | O_CREAT | O_TRUNC, 0666);

    if (log < 0 || dup2(log, 1) < 0 || dup2(log, 2) < 0)
    {
        std::perror(folder);
        return 127;
    }

    args.push_back(nullptr);
    return foamRun(int(args.size()) - 1, args.data());
}


int main(int argc, char* argv[])
{
    std::string name("foamRun");
    std::vector<char*> args{&name[0]};
    int first = 1;

    for (; first < argc && argv[first][0] == '-'; ++first)
    {
        args.push_back(argv[first]);
    }

    for (int i = first; i < argc; ++i)
    {
        const pid_t child = fork();

        if (child == 0)
        {
            std::exit(runIn(argv[i], args));
        }

        int status = 1;

        if (child < 0 || waitpid(child, &status, 0) != child)
        {
            std::perror("fork");
            return 1;
        }

        std::printf
        (
            "%d %s\n",
            WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
            argv[i]
        );
        std::fflush(stdout);
    }

    return 0;
}
