// SPDX-License-Identifier: GPL-3.0-or-later
#include "testTools.H"

#include "blasLibrary.H"
#include "OSspecific.H"

using namespace Foam;

extern "C"
{
    char* openblas_get_corename() __attribute__((weak));
    void gotoblas_dynamic_quit() __attribute__((weak));
    void gotoblas_dynamic_init() __attribute__((weak));
}

namespace
{
    const char* const coreType = "OPENBLAS_CORETYPE";

    //- OpenBLAS' kernels after blasLibrary::prepare() where it began with
    //  those for processors that it does not know; chosen: by the user
    std::string coreAfter(const bool chosen)
    {
        setEnv(coreType, "Prescott", true);
        gotoblas_dynamic_quit();
        gotoblas_dynamic_init();

        if (!chosen)
        {
            unsetenv(coreType);
        }
        blasLibrary::prepare();

        return openblas_get_corename();
    }
}


TEST_CASE("OpenBLAS gets kernels of an unknown processor", "[blasLibrary]")
{
    if (!openblas_get_corename || !gotoblas_dynamic_init)
    {
        WARN("Not an OpenBLAS that chooses its kernels");
        return;
    }

    const std::string before(getEnv(coreType));

    CHECK(coreAfter(true) == "Prescott");

    #ifdef __x86_64__
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    {
        CHECK(coreAfter(false) != "Prescott");
    }
    #endif

    if (before.empty())
    {
        unsetenv(coreType);
    }
    else
    {
        setEnv(coreType, before, true);
    }
}
