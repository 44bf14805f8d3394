// SPDX-License-Identifier: GPL-3.0-or-later

#include "fieldMemory.H"
#include <cstdlib>
#include <malloc.h>
#include <sys/mman.h>

namespace
{

//- Keep the memory of temporary fields. Given back to the system after each, it
//  would be cleared again for the next: 5 % of a step of 64^3 cells. And merge
//  what is freed at once: small pieces that are kept apart are all gone through
//  for each piece of a transform's scratch, 2 % of a step of 128^3 cells.
void keepFreedMemory()
{
    #ifdef __GLIBC__
    mallopt(M_MMAP_MAX, 0);
    mallopt(M_TRIM_THRESHOLD, -1);
    mallopt(M_MXFAST, 0);
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


void Foam::fieldMemory::prepare(const label nCells)
{
    keepFreedMemory();
    useLargePages(nCells);
}
