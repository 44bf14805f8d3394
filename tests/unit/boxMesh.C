// SPDX-License-Identifier: GPL-3.0-or-later

#include "boxMeshFaces.H"

using namespace Foam;
using testTools::boxMesh;
using testTools::boxMeshFaces;
using testTools::patchFaces;

namespace
{

//- Dictionary of a patch
dictionary patchDict
(
    const boxMesh& box,
    const patchFaces& patch,
    const label start
)
{
    dictionary dict;
    dict.add("startFace", start);
    dict.add("nFaces", label(patch.faces.size()));
    const std::string& name = patch.to.patch;

    if (patch.to.processor >= 0)
    {
        const bool cyclic = patch.to.through != "";
        dict.add("type", word(cyclic ? "processorCyclic" : "processor"));
        dict.add("myProcNo", Pstream::myProcNo());
        dict.add("neighbProcNo", patch.to.processor);
        if (cyclic)
        {
            dict.add("referPatch", word(patch.to.through));
        }
    }
    else if (box.sides[name[4] - '0'][0] == 'c')
    {
        dict.add("type", word("cyclic"));
        std::string other(name);
        other.back() = name.back() == '0' ? '1' : '0';
        dict.add("neighbourPatch", word(other));
    }
    else
    {
        dict.add("type", word("patch"));
    }

    return dict;
}


//- Name of a patch as decomposePar has it
word patchName(const patchFaces& patch)
{
    return
        patch.to.processor < 0
      ? patch.to.patch
      : "procBoundary" + std::to_string(Pstream::myProcNo()) + "to"
          + std::to_string(patch.to.processor)
          + (patch.to.through == "" ? "" : "through" + patch.to.through);
}

} // End anonymous namespace


std::unique_ptr<fvMesh> boxMesh::make(const Time& time) const
{
    boxMeshFaces all(*this);
    DynamicList<face> faces;
    DynamicList<label> owner, neighbour;

    for (const auto& item : all.internal)
    {
        faces.append(item.second);
        owner.append(item.first.first);
        neighbour.append(item.first.second);
    }

    DynamicList<label> start;

    for (const auto& patch : all.patches)
    {
        start.append(faces.size());

        for (const auto& item : patch.second.faces)
        {
            faces.append(item.second.first);
            owner.append(item.second.second);
        }
    }

    std::unique_ptr<fvMesh> mesh
    (
        new fvMesh
        (
            IOobject
            (
                fvMesh::defaultRegion, time.constant(), time, IOobject::NO_READ
            ),
            std::move(all.points),
            faceList(faces),
            labelList(owner),
            labelList(neighbour),
            false
        )
    );

    PtrList<polyPatch> patches(all.patches.size());
    label patchi = 0;

    for (const auto& patch : all.patches)
    {
        patches.set
        (
            patchi,
            polyPatch::New
            (
                patchName(patch.second),
                patchDict(*this, patch.second, start[patchi]),
                patchi,
                mesh->boundaryMesh()
            )
        );
        ++patchi;
    }

    mesh->addFvPatches(patches, true);
    return mesh;
}


wordList boxMesh::conditions(const fvMesh& mesh) const
{
    wordList types(mesh.boundary().size());

    forAll(types, patchi)
    {
        const fvPatch& patch = mesh.boundary()[patchi];

        if (patch.coupled())
        {
            types[patchi] = patch.type();
            continue;
        }

        // Of the name side00 to side21
        const label d = patch.name()[4] - '0', side = patch.name()[5] - '0';
        types[patchi] = sides[d][side] == 'f' ? "fixedValue" : "zeroGradient";
    }

    return types;
}
