// SPDX-License-Identifier: GPL-3.0-or-later

#include "surfaceFile.H"
#include "labelVector.H"

Foam::surfaceFile::surfaceFile
(
    const immersedBodies& bodies,
    const fileName& file
)
:
    bodies_(bodies),
    list_(bodies.list()),
    shape_(nullptr)
{
    if (Pstream::master())
    {
        os_.open(file);
    }
    format_ = vtk::newFormatter(os_, 8);
}


void Foam::surfaceFile::findSurface(const label bodyi)
{
    const bodyShape& shape = list_[bodyi].shape();

    if (&shape != shape_)
    {
        shape_ = &shape;
        points_.clear();
        faces_.clear();
        shape.surface(points_, faces_);
    }
}


void Foam::surfaceFile::begin(const word& name, const label)
{
    format_->beginDataArray<label>(name);
}


void Foam::surfaceFile::begin(const word& name, const scalar)
{
    format_->beginDataArray<float>(name);
}


void Foam::surfaceFile::begin(const word& name, const vector&)
{
    format_->beginDataArray<float, 3>(name);
}


void Foam::surfaceFile::end()
{
    format_->flush();
    format_->endDataArray();
}


void Foam::surfaceFile::writePoints()
{
    begin("Points", vector::zero);
    write<point>
    (
        [&](const label bodyi, DynamicList<point>& points)
        {
            points.append(list_[bodyi].state().position);
        }
    );
    write<point>
    (
        [&](const label bodyi, DynamicList<point>& points)
        {
            const bodyState& state = list_[bodyi].state();
            const tensor R(state.orientation.R());

            findSurface(bodyi);
            for (const point& X : points_)
            {
                points.append(state.position + (R & X));
            }
        }
    );
    end();
}


void Foam::surfaceFile::writeCentres(const label n)
{
    for (const bool ends : {false, true})
    {
        begin(ends ? "offsets" : "connectivity", label());
        vtk::writeIdentity(format_(), n, ends ? 1 : 0);
        end();
    }
}


void Foam::surfaceFile::writeFaces(const label n)
{
    label start = n, last = 0;

    begin("connectivity", label());
    bodiesInOrder::visit<label>
    (
        list_,
        [&](const label bodyi, DynamicList<label>& corners)
        {
            findSurface(bodyi);
            corners.append(points_.size());
            for (const face& f : faces_)
            {
                corners.append(f);
            }
        },
        [&](UList<label> corners)
        {
            for (label i = 1; i < corners.size(); ++i)
            {
                format_->write(start + corners[i]);
            }
            start += corners[0];
        }
    );
    end();

    begin("offsets", label());
    bodiesInOrder::visit<label>
    (
        list_,
        [&](const label bodyi, DynamicList<label>& sizes)
        {
            findSurface(bodyi);
            for (const face& f : faces_)
            {
                sizes.append(f.size());
            }
        },
        [&](const UList<label>& sizes)
        {
            for (label i = 0; i < sizes.size(); ++i)
            {
                last += sizes[i];
                format_->write(last);
            }
        }
    );
    end();
}


void Foam::surfaceFile::writeData()
{
    writeCellData<label>
    (
        "body", [&](const label bodyi) { return list_[bodyi].number(); }
    );
    writeCellData<scalar>
    (
        "radius",
        [&](const label bodyi)
        {
            return list_[bodyi].shape().boundingRadius();
        }
    );
    writeCellData<vector>
    (
        "velocity", [&](const label bodyi) { return list_[bodyi].state().U; }
    );
    writeCellData<vector>
    (
        "angularVelocity",
        [&](const label bodyi) { return list_[bodyi].state().omega; }
    );
    writeCellData<vector>
    (
        "force",
        [&](const label bodyi) -> vector
        {
            return bodies_.rho()*list_[bodyi].fluid().force();
        }
    );
}


void Foam::surfaceFile::write()
{
    const labelVector n = list_.share().sum<labelVector>
    (
        [&](const label bodyi)
        {
            findSurface(bodyi);
            return labelVector(1, points_.size(), faces_.size());
        }
    );

    format_->xmlHeader();
    format_->beginVTKFile<vtk::fileTag::POLY_DATA>();
    format_->tag
    (
        vtk::fileTag::PIECE,
        "NumberOfPoints", n.x() + n.y(),
        "NumberOfVerts", n.x(),
        "NumberOfPolys", n.z()
    );
    format_->tag(vtk::fileTag::POINTS);
    writePoints();
    format_->endTag(vtk::fileTag::POINTS);
    format_->tag(vtk::fileTag::VERTS);
    writeCentres(n.x());
    format_->endTag(vtk::fileTag::VERTS);
    format_->tag(vtk::fileTag::POLYS);
    writeFaces(n.x());
    format_->endTag(vtk::fileTag::POLYS);
    format_->beginCellData();
    writeData();
    format_->endCellData();
    format_->endPiece();
    format_->endTag(vtk::fileTag::POLY_DATA);
    format_->endVTKFile();
}
