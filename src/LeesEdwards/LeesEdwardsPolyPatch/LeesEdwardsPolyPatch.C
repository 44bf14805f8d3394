// SPDX-License-Identifier: GPL-3.0-or-later

#include "LeesEdwardsPolyPatch.H"
#include "addToRunTimeSelectionTable.H"
#include "checkKeywords.H"
#include "polyMesh.H"

namespace Foam
{
    defineTypeNameAndDebug(LeesEdwardsPolyPatch, 0);
    addToRunTimeSelectionTable(polyPatch, LeesEdwardsPolyPatch, word);
    addToRunTimeSelectionTable(polyPatch, LeesEdwardsPolyPatch, dictionary);
}

const Foam::wordList Foam::LeesEdwardsPolyPatch::motionKeywords_
({"direction", "speed", "shearRate", "shift"});


namespace
{
    //- What patches of a mesh and of blockMesh have
    const Foam::wordList ofAllPatches
    {
        "type", "nFaces", "startFace", "inGroups", "physicalType", "faces",
        "geometricType", "matchTolerance", "transform"
    };
}


void Foam::LeesEdwardsPolyPatch::readMotion(const dictionary& dict)
{
    wordList valid(motionKeywords_);

    valid.append(ofAllPatches);
    valid.append(word("neighbourPatch"));

    for (const entry& e : dict)
    {
        const word& key = e.keyword();

        if (key.endsWith("Coeffs"))
        {
            valid.append(key);
            motion_.add(e);
        }
        else if (motionKeywords_.found(key))
        {
            motion_.add(e);
        }
    }
    keywords::check(dict, valid);
}


Foam::LeesEdwardsPolyPatch::LeesEdwardsPolyPatch
(
    const word& name,
    const label size,
    const label start,
    const label index,
    const polyBoundaryMesh& bm,
    const word& patchType
)
:
    coupledPolyPatch(name, size, start, index, bm, patchType, NOORDERING)
{}


Foam::LeesEdwardsPolyPatch::LeesEdwardsPolyPatch
(
    const word& name,
    const dictionary& dict,
    const label index,
    const polyBoundaryMesh& bm,
    const word& patchType
)
:
    coupledPolyPatch(name, dict, index, bm, patchType),
    neighbourPatch_(dict.get<word>("neighbourPatch"))
{
    // Not in the word that a base class has read
    transform() = NOORDERING;
    motion_.name() = dict.name();
    readMotion(dict);
}


Foam::LeesEdwardsPolyPatch::LeesEdwardsPolyPatch
(
    const LeesEdwardsPolyPatch& patch,
    const polyBoundaryMesh& bm
)
:
    coupledPolyPatch(patch, bm),
    neighbourPatch_(patch.neighbourPatch_),
    motion_(patch.motion_)
{}


Foam::LeesEdwardsPolyPatch::LeesEdwardsPolyPatch
(
    const LeesEdwardsPolyPatch& patch,
    const polyBoundaryMesh& bm,
    const label index,
    const label newSize,
    const label newStart
)
:
    coupledPolyPatch(patch, bm, index, newSize, newStart),
    neighbourPatch_(patch.neighbourPatch_),
    motion_(patch.motion_)
{}


Foam::LeesEdwardsPolyPatch::LeesEdwardsPolyPatch
(
    const LeesEdwardsPolyPatch& patch,
    const polyBoundaryMesh& bm,
    const label index,
    const labelUList& mapAddressing,
    const label newStart
)
:
    coupledPolyPatch(patch, bm, index, mapAddressing, newStart),
    neighbourPatch_(patch.neighbourPatch_),
    motion_(patch.motion_)
{}


Foam::autoPtr<Foam::polyPatch> Foam::LeesEdwardsPolyPatch::clone
(
    const polyBoundaryMesh& bm
) const
{
    return autoPtr<polyPatch>(new LeesEdwardsPolyPatch(*this, bm));
}


Foam::autoPtr<Foam::polyPatch> Foam::LeesEdwardsPolyPatch::clone
(
    const polyBoundaryMesh& bm,
    const label index,
    const label newSize,
    const label newStart
) const
{
    return autoPtr<polyPatch>
    (
        new LeesEdwardsPolyPatch(*this, bm, index, newSize, newStart)
    );
}


Foam::autoPtr<Foam::polyPatch> Foam::LeesEdwardsPolyPatch::clone
(
    const polyBoundaryMesh& bm,
    const label index,
    const labelUList& mapAddressing,
    const label newStart
) const
{
    return autoPtr<polyPatch>
    (
        new LeesEdwardsPolyPatch(*this, bm, index, mapAddressing, newStart)
    );
}


void Foam::LeesEdwardsPolyPatch::initGeometry(PstreamBuffers& buffers)
{
    polyPatch::initGeometry(buffers);
}


void Foam::LeesEdwardsPolyPatch::calcGeometry(PstreamBuffers&)
{}


void Foam::LeesEdwardsPolyPatch::initMovePoints
(
    PstreamBuffers& buffers,
    const pointField& points
)
{
    polyPatch::initMovePoints(buffers, points);
    pair_.clear();
}


void Foam::LeesEdwardsPolyPatch::movePoints
(
    PstreamBuffers& buffers,
    const pointField& points
)
{
    polyPatch::movePoints(buffers, points);
}


void Foam::LeesEdwardsPolyPatch::initUpdateMesh(PstreamBuffers& buffers)
{
    polyPatch::initUpdateMesh(buffers);
    pair_.clear();
}


void Foam::LeesEdwardsPolyPatch::updateMesh(PstreamBuffers& buffers)
{
    polyPatch::updateMesh(buffers);
}


bool Foam::LeesEdwardsPolyPatch::order
(
    PstreamBuffers&,
    const primitivePatch& patch,
    labelList& faceMap,
    labelList& rotation
) const
{
    faceMap = identity(patch.size());
    rotation = labelList(patch.size(), Zero);

    return false;
}


void Foam::LeesEdwardsPolyPatch::write(Ostream& os) const
{
    coupledPolyPatch::write(os);
    os.writeEntry("neighbourPatch", neighbourPatch_);

    for (const entry& e : motion_)
    {
        os << e;
    }
}
