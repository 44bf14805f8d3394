// SPDX-License-Identifier: GPL-3.0-or-later

#include "alignedFaces.H"
#include "surfaceFields.H"
#include "volFields.H"
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace Foam
{
    defineTypeNameAndDebug(alignedFaces, 0);
}

namespace
{
    //- Relative difference of what is the same
    const Foam::scalar rounding = 1e-10;
}


Foam::alignedFaces::alignedFaces(const fvMesh& mesh)
:
    MeshObject<fvMesh, GeometricMeshObject, alignedFaces>(mesh),
    magSf_(mesh.magSf())
{
    if (!findShapes())
    {
        shapes_.clearStorage();
        shape_.clear();
    }
}


bool Foam::alignedFaces::align(const label facei, shape& one) const
{
    const vector& S = mesh().Sf()[facei];
    const vector d
    (
        mesh().C()[mesh().neighbour()[facei]]
      - mesh().C()[mesh().owner()[facei]]
    );

    one.axis = 0;
    for (direction cmpt = 1; cmpt < vector::nComponents; ++cmpt)
    {
        one.axis = mag(S[cmpt]) > mag(S[one.axis]) ? cmpt : one.axis;
    }
    one.sign = sign(S[one.axis]);

    vector unit(Zero);
    unit[one.axis] = one.sign;

    return
        mag(S - (S & unit)*unit) < rounding*mag(S)
     && mag(d - (d & unit)*unit) < rounding*mag(d);
}


bool Foam::alignedFaces::findShapes()
{
    typedef std::array<int64_t, 3> roundedShape;

    const std::size_t most = std::numeric_limits<uint16_t>::max();
    std::map<roundedShape, uint16_t> known;

    shape_.resize(mesh().nInternalFaces());

    forAll(shape_, facei)
    {
        shape one;

        if (!align(facei, one))
        {
            return false;
        }
        one.weight = mesh().weights()[facei];
        one.deltaCoeff = mesh().nonOrthDeltaCoeffs()[facei];

        const roundedShape key
        {{
            one.sign > 0 ? one.axis : -1 - one.axis,
            std::llround(one.weight/rounding),
            std::llround(std::log(one.deltaCoeff)/rounding)
        }};
        const auto found = known.find(key);

        if (found != known.end())
        {
            shape_[facei] = found->second;
            continue;
        }
        if (known.size() == most)
        {
            return false;
        }

        known[key] = shape_[facei] = shapes_.size();
        shapes_.append(one);
    }

    return true;
}
