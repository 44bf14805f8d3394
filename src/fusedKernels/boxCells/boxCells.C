// SPDX-License-Identifier: GPL-3.0-or-later

#include "boxCells.H"
#include "surfaceFields.H"
#include "volFields.H"

namespace Foam
{
    defineTypeNameAndDebug(boxCells, 0);
}

namespace
{
    //- Relative difference of what is the same
    const Foam::scalar rounding = 1e-10;

    bool same(const Foam::scalar a, const Foam::scalar b)
    {
        return Foam::mag(a - b) < rounding*Foam::mag(b);
    }
}


Foam::boxCells::boxCells(const fvMesh& mesh)
:
    MeshObject<fvMesh, GeometricMeshObject, boxCells>(mesh),
    ownerStart_(mesh.lduAddr().ownerStartAddr())
{
    for (line& along : lines_)
    {
        along.n = 0;
    }

    const alignedFaces& faces = alignedFaces::New(mesh);

    if
    (
        !faces.valid()
     || !countCells()
     || !setLines(faces)
     || !isBox(faces)
    )
    {
        lines_[0].n = 0;
    }
}


bool Foam::boxCells::countCells()
{
    const labelUList& neighbour = mesh().neighbour();
    const label nCells = mesh().nCells();
    label n = 0;

    // Along the first direction neighbours follow each other
    while
    (
        n < nCells - 1
     && ownerStart_[n + 1] > ownerStart_[n]
     && neighbour[ownerStart_[n]] == n + 1
    )
    {
        ++n;
    }
    ++n;

    if (n < 2 || n >= nCells || nCells % n)
    {
        return false;
    }
    lines_[0].n = n;
    lines_[0].stride = 1;

    // The first cells of rows are neighbours along the second, by their second
    // faces
    const label nRows = nCells/n;
    label rows = 1;

    while (rows < nRows)
    {
        const label facei = ownerStart_[(rows - 1)*n] + 1;

        if (facei >= neighbour.size() || neighbour[facei] != rows*n)
        {
            break;
        }
        ++rows;
    }

    if (rows < 2 || nRows % rows)
    {
        return false;
    }
    lines_[1].n = rows;
    lines_[1].stride = n;
    lines_[2].n = nRows/rows;
    lines_[2].stride = n*rows;

    return true;
}


void Foam::boxCells::setDerivative(line& along)
{
    along.low.resize(along.n, Zero);
    along.own.resize(along.n, Zero);
    along.high.resize(along.n, Zero);

    for (label i = 0; i + 1 < along.n; ++i)
    {
        const scalar w = along.weight[i];

        along.own[i] += along.sign*w/along.width[i];
        along.high[i] += along.sign*(1 - w)/along.width[i];
        along.low[i + 1] -= along.sign*w/along.width[i + 1];
        along.own[i + 1] -= along.sign*(1 - w)/along.width[i + 1];
    }
}


bool Foam::boxCells::setLines(const alignedFaces& faces)
{
    const scalarField& V = mesh().V();
    const scalarField& magSf = mesh().magSf();

    for (direction d = 0; d < 3; ++d)
    {
        line& along = lines_[d];

        // Of an axis along which there is one cell, what the others leave
        along.cmpt = d < 2 ? 0 : 3 - lines_[0].cmpt - lines_[1].cmpt;
        along.sign = 1;
        along.width.resize
        (
            along.n,
            d < 2 ? 0 : V[0]/(lines_[0].width[0]*lines_[1].width[0])
        );
        along.weight.resize(along.n - 1);
        along.deltaCoeff.resize(along.n - 1);

        for (label i = 0; i + 1 < along.n; ++i)
        {
            const row r
            {
                d > 0 ? i*along.stride : 0, d == 1 ? i : 0, d == 2 ? i : 0
            };
            const label facei = face(r, d > 0 ? 0 : i, d);

            if (facei >= magSf.size())
            {
                return false;
            }

            const alignedFaces::shape& shape = faces.of(facei);

            along.cmpt = shape.axis;
            along.sign = shape.sign;
            along.weight[i] = shape.weight;
            along.deltaCoeff[i] = shape.deltaCoeff;

            // The face is as large as both cells are wide
            along.width[i] = V[i*along.stride]/magSf[facei];
            along.width[i + 1] = V[(i + 1)*along.stride]/magSf[facei];
        }

        setDerivative(along);
    }

    return lines_[0].cmpt != lines_[1].cmpt
     && lines_[0].cmpt != lines_[2].cmpt
     && lines_[1].cmpt != lines_[2].cmpt;
}


bool Foam::boxCells::isBox(const alignedFaces& faces) const
{
    const scalarField& V = mesh().V();
    const scalarField& magSf = mesh().magSf();
    const labelUList& neighbour = mesh().neighbour();
    bool box = true;

    const auto check = [&](const row& r, const label i)
    {
        const FixedList<label, 3> at{i, r.j, r.k};
        const label celli = r.cell + i;
        label facei = ownerStart_[celli];

        for (direction d = 0; d < 3; ++d)
        {
            const line& along = lines_[d];

            if (at[d] == along.n - 1)
            {
                continue;
            }
            if
            (
                facei >= ownerStart_[celli + 1]
             || neighbour[facei] != celli + along.stride
            )
            {
                return false;
            }

            const alignedFaces::shape& shape = faces.of(facei);
            const scalar width = along.width[at[d]];

            if
            (
                shape.axis != along.cmpt
             || shape.sign != along.sign
             || !same(shape.weight, along.weight[at[d]])
             || !same(shape.deltaCoeff, along.deltaCoeff[at[d]])
             || !same(magSf[facei]*width, V[celli])
            )
            {
                return false;
            }
            ++facei;
        }

        const scalar volume = lines_[0].width[at[0]]
           *lines_[1].width[at[1]]*lines_[2].width[at[2]];

        return facei == ownerStart_[celli + 1] && same(volume, V[celli]);
    };

    forRows
    (
        [&](const row& r)
        {
            for (label i = 0; box && i < lines_[0].n; ++i)
            {
                box = check(r, i);
            }
        }
    );

    return box;
}
