// SPDX-License-Identifier: GPL-3.0-or-later

#include "boxMesh.H"
#include "Pstream.H"
#include <algorithm>
#include <map>
#include <random>

using namespace Foam;
using testTools::boxMesh;

namespace
{

//- Where a face goes: the name of its patch, its order there; for those to
//  another processor its number and the cyclic patch they pass through
struct target
{
    std::string patch;
    label processor;
    std::string through;
};

//- Faces of a patch with their owners, by their order
struct patchFaces
{
    target to;
    std::map<label, std::pair<face, label>> faces;
};


//- Collects the faces of the local cells
class builder
{
    const boxMesh& box_;

public:

    //- Local cell of each cell, -1 if it is on another processor
    labelList local;

    pointField points;

    //- Internal faces by owner and neighbour
    std::map<std::pair<label, label>, face> internal;

    //- Those of patches by name, those to other processors last
    std::map<std::string, patchFaces> patches;


    explicit builder(const boxMesh& box)
    :
        box_(box)
    {
        number();
        makePoints();

        for (label d = 0; d < 3; ++d)
        {
            for (const std::string side : {"0", "1"})
            {
                const std::string name = "side" + std::to_string(d) + side;
                patches[name].to = target{name, -1, ""};
            }
        }

        forAllCells([this](const labelVector& i)
        {
            for (label d = 0; d < 3; ++d)
            {
                addFace(i, d, -1);
                addFace(i, d, 1);
            }
        });
    }


    template<class Function>
    void forAllCells(Function f) const
    {
        for (label k = 0; k < box_.n(2); ++k)
        for (label j = 0; j < box_.n(1); ++j)
        for (label i = 0; i < box_.n(0); ++i)
        {
            f(labelVector(i, j, k));
        }
    }


    label cell(const labelVector& i) const
    {
        return (i[2]*box_.n(1) + i[1])*box_.n(0) + i[0];
    }


    bool mine(const labelVector& i) const
    {
        return !Pstream::parRun()
          || box_.processor(i) == Pstream::myProcNo();
    }


    void number()
    {
        std::vector<label> cells;
        forAllCells([&](const labelVector& i)
        {
            if (mine(i))
            {
                cells.push_back(cell(i));
            }
        });

        if (box_.seed)
        {
            std::mt19937 engine(box_.seed);
            std::shuffle(cells.begin(), cells.end(), engine);
        }

        local.setSize(box_.n(0)*box_.n(1)*box_.n(2), -1);

        for (label i = 0; i < label(cells.size()); ++i)
        {
            local[cells[i]] = i;
        }
    }


    label corner(const labelVector& i) const
    {
        return (i[2]*(box_.n(1) + 1) + i[1])*(box_.n(0) + 1) + i[0];
    }


    void makePoints()
    {
        for (const scalar z : box_.x[2])
        for (const scalar y : box_.x[1])
        for (const scalar x : box_.x[0])
        {
            points.append(point(x, y, z));
        }
    }


    //- Face of a cell in direction d, to the low or high side, normal outward
    face makeFace(const labelVector& i, const label d, const label side) const
    {
        const label d1 = (d + 1) % 3, d2 = (d + 2) % 3;
        labelVector a(i);
        a[d] += side > 0 ? 1 : 0;
        labelVector b(a), c(a), e(a);
        ++b[d1];
        ++c[d1];
        ++c[d2];
        ++e[d2];

        face f(4);
        f[0] = corner(a);
        f[1] = corner(side > 0 ? b : e);
        f[2] = corner(c);
        f[3] = corner(side > 0 ? e : b);
        return f;
    }


    void addFace(const labelVector& i, const label d, const label side)
    {
        if (!mine(i))
        {
            return;
        }

        const label n = box_.n(d), owner = local[cell(i)];
        const face f(makeFace(i, d, side));
        labelVector next(i);
        next[d] += side;
        const bool outside = next[d] < 0 || next[d] >= n;
        next[d] = (next[d] + n) % n;

        const std::string name =
            "side" + std::to_string(d) + (side > 0 ? "1" : "0");

        if (outside && (box_.sides[d][0] != 'c' || mine(next)))
        {
            // Both sides of a cyclic pair in the same order
            labelVector j(i);
            j[d] = 0;
            patches[name].faces[cell(j)] = std::make_pair(f, owner);
        }
        else if (mine(next))
        {
            const label neighbour = local[cell(next)];
            if (owner < neighbour)
            {
                internal[std::make_pair(owner, neighbour)] = f;
            }
        }
        else
        {
            // Both processors have them in the same order
            labelVector j(i);
            j[d] = outside ? 0 : min(i[d], next[d]);
            const label other = box_.processor(next);
            const std::string through = outside ? name : "";
            const std::string key = "to" + std::to_string(other) + through;
            patches[key].to = target{"", other, through};
            patches[key].faces[3*cell(j) + d] = std::make_pair(f, owner);
        }
    }


    //- Dictionary of a patch
    dictionary patchDict(const patchFaces& patch, const label start) const
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
        else if (box_.sides[name[4] - '0'][0] == 'c')
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
    word patchName(const patchFaces& patch) const
    {
        return
            patch.to.processor < 0
          ? patch.to.patch
          : "procBoundary" + std::to_string(Pstream::myProcNo()) + "to"
              + std::to_string(patch.to.processor)
              + (patch.to.through == "" ? "" : "through" + patch.to.through);
    }
};

} // End anonymous namespace


std::unique_ptr<fvMesh> boxMesh::make(const Time& time) const
{
    builder all(*this);
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
                all.patchName(patch.second),
                all.patchDict(patch.second, start[patchi]),
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
