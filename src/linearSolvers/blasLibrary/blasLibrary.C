// SPDX-License-Identifier: GPL-3.0-or-later

#include "blasLibrary.H"
#include "OSspecific.H"

// There in OpenBLAS only, the last three where it has kernels of several
// processors
extern "C"
{
    void openblas_set_num_threads(int) __attribute__((weak));
    char* openblas_get_corename() __attribute__((weak));
    void gotoblas_dynamic_quit() __attribute__((weak));
    void gotoblas_dynamic_init() __attribute__((weak));
}

namespace
{
    // Of the environment, read by gotoblas_dynamic_init
    const char* const coreType = "OPENBLAS_CORETYPE";

    //- OpenBLAS' name of the newest kernels that this processor can run; none
    //  if these are not newer than what it takes for processors unknown to it
    std::string newestCore()
    {
        #ifdef __x86_64__
        if
        (
            __builtin_cpu_supports("avx512f")
         && __builtin_cpu_supports("avx512cd")
         && __builtin_cpu_supports("avx512bw")
         && __builtin_cpu_supports("avx512dq")
         && __builtin_cpu_supports("avx512vl")
        )
        {
            return "SkylakeX";
        }
        if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
        {
            return "Haswell";
        }
        #endif

        return "";
    }

    void chooseCore()
    {
        const std::string core(newestCore());

        // No processor of that name has AVX
        if
        (
            !Foam::getEnv(coreType).empty() || core.empty()
         || std::string(openblas_get_corename()) != "Prescott"
        )
        {
            return;
        }

        Foam::setEnv(coreType, core, true);
        gotoblas_dynamic_quit();
        gotoblas_dynamic_init();
    }
}


void Foam::blasLibrary::prepare()
{
    if (openblas_set_num_threads)
    {
        openblas_set_num_threads(1);
    }

    if
    (
        openblas_get_corename && gotoblas_dynamic_quit
     && gotoblas_dynamic_init
    )
    {
        chooseCore();
    }
}
