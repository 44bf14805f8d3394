// SPDX-License-Identifier: GPL-3.0-or-later

#include "boxLaplacian.H"

namespace
{

using namespace Foam;

//- Direction of the largest component
label mainDirection(const vector& v)
{
    return mag(v.x()) >= mag(v.y())
      ? (mag(v.x()) >= mag(v.z()) ? 0 : 2)
      : (mag(v.y()) >= mag(v.z()) ? 1 : 2);
}

} // End anonymous namespace


void Foam::boxLaplacian::add
(
    coefficients& c,
    const label link,
    const scalar value,
    const label n
)
{
    c.low[link] = min(c.low[link], value);
    c.high[link] = max(c.high[link], value);
    c.n[link] += n;
}


bool Foam::boxLaplacian::readInternal
(
    const lduMatrix& matrix,
    const tensorGrid& grid,
    FixedList<coefficients, 3>& found
) const
{
    const labelUList& lower = matrix.lduAddr().lowerAddr();
    const labelUList& upper = matrix.lduAddr().upperAddr();
    const scalarField& values = matrix.upper();

    forAll(values, facei)
    {
        const labelVector& i = grid.index()[lower[facei]];
        const labelVector& j = grid.index()[upper[facei]];
        const labelVector step(j - i);
        const label d =
            mainDirection(vector(step.x(), step.y(), step.z()));

        if (cmptSum(cmptMag(step)) != 1)
        {
            return false;
        }

        add
        (
            found[d],
            min(i[d], j[d]),
            sign(sum_)*values[facei]/grid.area(i, d),
            2
        );
    }

    return true;
}


bool Foam::boxLaplacian::readPatches
(
    const lduMatrix::solver& solver,
    const polyMesh& mesh,
    const tensorGrid& grid,
    FixedList<coefficients, 3>& found
) const
{
    const polyBoundaryMesh& patches = mesh.boundaryMesh();

    if (solver.interfaceIntCoeffs().size() != patches.size())
    {
        return false;
    }

    forAll(patches, patchi)
    {
        const bool coupled = solver.interfaces().set(patchi);
        const scalarField& values =
            coupled
          ? solver.interfaceBouCoeffs()[patchi]
          : solver.interfaceIntCoeffs()[patchi];

        // On an empty patch there are none
        forAll(values, i)
        {
            const labelVector& index =
                grid.index()[patches[patchi].faceCells()[i]];
            const vector& Sf = mesh.faceAreas()[patches[patchi].start() + i];
            const label d = mainDirection(Sf);
            const label n = grid.n(d);
            const bool up = Sf[d] > 0;
            const scalar value = -sign(sum_)*values[i]/grid.area(index, d);

            if (coupled)
            {
                add(found[d], (index[d] + (up ? 0 : n - 1)) % n, value, 1);
            }
            else if (index[d] == (up ? n - 1 : 0))
            {
                add(found[d], up ? n + 1 : n, value, 1);
            }
            else
            {
                return false;
            }
        }
    }

    return true;
}
