// SPDX-License-Identifier: GPL-3.0-or-later

#include "fieldMemory.H"
#include "labelIOList.H"
#include "polyMesh.H"
#include "Time.H"
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


//- Number of cells of the mesh, from the header of its file of owners; zero if
//  that does not say
Foam::label nCellsOf(const Foam::Time& runTime)
{
    using namespace Foam;

    IOobject owner
    (
        "owner",
        runTime.findInstance
        (
            polyMesh::meshSubDir, "owner", IOobject::READ_IF_PRESENT
        ),
        polyMesh::meshSubDir,
        runTime,
        IOobject::READ_IF_PRESENT,
        IOobject::NO_WRITE,
        false
    );
    const std::string key("nCells:");

    if (!owner.typeHeaderOk<labelIOList>(false))
    {
        return 0;
    }

    const std::string::size_type at = owner.note().find(key);

    return at == std::string::npos
      ? 0
      : std::atol(owner.note().c_str() + at + key.size());
}


//- Let the mesh and fields lie in large pages where the system leaves that to
//  programs: a tenth of 20 steps with 500 spheres in 96^3 cells. Nothing is
//  lost if it cannot be done.
void useLargePages(const Foam::label nCells)
{
    #if defined(__GLIBC__) && defined(MADV_HUGEPAGE)
    // Bytes that a run takes at most: 2400 with spheres in 15 % of the volume.
    // No memory is used before something lies there.
    const size_t perCell = 4000;
    const size_t page = 1 << 21;
    size_t size = perCell*nCells;
    void* some = std::malloc(size + page);

    // The system may refuse more than it has
    while (!some && size > page)
    {
        size /= 2;
        some = std::malloc(size + page);
    }

    // What is freed again is what fields are made of next
    if (some)
    {
        const size_t at = reinterpret_cast<size_t>(some);
        const size_t begin = (at + page - 1)/page*page;

        madvise(reinterpret_cast<void*>(begin), size, MADV_HUGEPAGE);
        std::free(some);
    }
    #endif
}

} // End anonymous namespace


void Foam::fieldMemory::prepare(const Time& runTime)
{
    keepFreedMemory();
    useLargePages(nCellsOf(runTime));
}
