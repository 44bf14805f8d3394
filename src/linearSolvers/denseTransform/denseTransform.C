// SPDX-License-Identifier: GPL-3.0-or-later

#include "denseTransform.H"
#include "blasLibrary.H"

extern "C"
{

void dgemm_
(
    const char* transA, const char* transB,
    const int* m, const int* n, const int* k,
    const double* alpha, const double* A, const int* ldA,
    const double* B, const int* ldB,
    const double* beta, double* C, const int* ldC
);

void dsyevd_
(
    const char* job, const char* triangle, const int* n, double* A,
    const int* ldA, double* eigenvalues, double* work, const int* nWork,
    int* iWork, const int* nIWork, int* info
);

}


Foam::denseTransform::denseTransform
(
    const lineOperator& line,
    const label inner,
    const label outer
)
:
    lineTransform(line.size(), inner, outer),
    vectors_(n_*n_, Zero)
{
    blasLibrary::prepare();

    for (label i = 0; i < n_; ++i)
    {
        const label j = (i + 1) % n_;
        vectors_[i*n_ + i] += line.diag(i);
        vectors_[i*n_ + j] -= line.off(i);
        vectors_[j*n_ + i] -= line.off(i);
    }

    const int n = n_, nWork = 1 + 6*n + 2*n*n, nIWork = 3 + 5*n;
    scalarField work(nWork);
    List<int> iWork(nIWork);
    int info = 0;
    eigenvalues_.setSize(n_);

    dsyevd_
    (
        "V", "U", &n, vectors_.begin(), &n, eigenvalues_.begin(),
        work.begin(), &nWork, iWork.begin(), &nIWork, &info
    );

    if (info != 0)
    {
        FatalErrorInFunction
            << "LAPACK's dsyevd failed with info " << info << exit(FatalError);
    }

    if (line.singular())
    {
        eigenvalues_[0] = 0;
    }
}


void Foam::denseTransform::multiply
(
    const scalar* v,
    scalar* result,
    const bool toThem
) const
{
    const int n = n_, inner = inner_, outer = outer_;
    const double one = 1, zero = 0;
    const scalar* Q = vectors_.begin();

    if (inner == 1)
    {
        dgemm_
        (
            toThem ? "T" : "N", "N", &n, &outer, &n,
            &one, Q, &n, v, &n, &zero, result, &n
        );
        return;
    }

    for (label i = 0; i < outer_; ++i)
    {
        dgemm_
        (
            "N", toThem ? "N" : "T", &inner, &n, &n,
            &one, v, &inner, Q, &n, &zero, result, &inner
        );
        v += n_*inner_;
        result += n_*inner_;
    }
}


void Foam::denseTransform::forward(scalar*& v, scalar*& other) const
{
    multiply(v, other, true);
    std::swap(v, other);
}


void Foam::denseTransform::backward(scalar*& v, scalar*& other) const
{
    multiply(v, other, false);
    std::swap(v, other);
}
