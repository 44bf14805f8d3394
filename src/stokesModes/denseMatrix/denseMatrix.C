// SPDX-License-Identifier: GPL-3.0-or-later

#include "denseMatrix.H"

extern "C"
{

void dsyev_
(
    const char* job, const char* triangle, const int* n, double* A,
    const int* ldA, double* eigenvalues, double* work, const int* nWork,
    int* info
);

void dgesv_
(
    const int* n, const int* nRhs, double* A, const int* ldA, int* pivots,
    double* B, const int* ldB, int* info
);

}


Foam::scalarField Foam::denseMatrix::eigenvalues(const scalarSquareMatrix& A)
{
    const int n = A.n(), nWork = 8*n;
    int info = 0;
    scalarField values(n), work(nWork);
    scalarSquareMatrix symmetric(0.5*(A + A.T()));

    dsyev_
    (
        "N", "U", &n, symmetric.v(), &n, values.begin(), work.begin(), &nWork,
        &info
    );

    if (info != 0)
    {
        FatalErrorInFunction
            << "LAPACK's dsyev failed with info " << info << exit(FatalError);
    }

    return values;
}


Foam::scalarSquareMatrix Foam::denseMatrix::inverse
(
    const scalarSquareMatrix& A
)
{
    const int n = A.n();
    int info = 0;
    List<int> pivots(n);

    // By columns for LAPACK: the inverse of the transpose is by rows
    scalarSquareMatrix work(A);
    scalarSquareMatrix inverse(n, Identity<scalar>());

    dgesv_
    (
        &n, &n, work.v(), &n, pivots.begin(), inverse.v(), &n, &info
    );

    if (info != 0)
    {
        FatalErrorInFunction
            << "The matrix of the resistances of bodies is singular" << nl
            << exit(FatalError);
    }

    return inverse;
}


Foam::scalarField Foam::denseMatrix::multiply
(
    const scalarSquareMatrix& A,
    const scalarField& x
)
{
    scalarField y(A.m(), Zero);

    forAll(y, i)
    {
        for (label j = 0; j < A.n(); ++j)
        {
            y[i] += A(i, j)*x[j];
        }
    }

    return y;
}
