// SPDX-License-Identifier: GPL-3.0-or-later

#include "projection.H"
#include "fvmLaplacian.H"
#include "projectionOvershoot.H"
#include "residualTarget.H"
#include "sumInParts.H"

namespace
{

//- Flux of an increment on an internal face, as of fvMatrix::flux()
class faceFlux
{
    const Foam::labelUList& owner_;
    const Foam::labelUList& neighbour_;
    const Foam::scalarField& upper_;
    const Foam::scalarField& dp_;

public:

    faceFlux(const Foam::lduMatrix& equation, const Foam::scalarField& dp)
    :
        owner_(equation.lduAddr().lowerAddr()),
        neighbour_(equation.lduAddr().upperAddr()),
        upper_(equation.upper()),
        dp_(dp)
    {}

    Foam::scalar operator()(const Foam::label facei) const
    {
        return upper_[facei]*dp_[neighbour_[facei]]
          - upper_[facei]*dp_[owner_[facei]];
    }
};

} // End anonymous namespace


Foam::wordList Foam::projection::patchTypes(const volScalarField& p)
{
    wordList types(p.boundaryField().size(), "zeroGradient");

    forAll(types, patchi)
    {
        if (p.boundaryField()[patchi].fixesValue())
        {
            types[patchi] = "fixedValue";
        }
    }

    return types;
}


Foam::projection::projection(const volScalarField& p, const label refCell)
:
    dp_
    (
        IOobject("dp", p.mesh().time().timeName(), p.mesh()),
        p.mesh(),
        dimensionedScalar(p.dimensions(), Zero),
        patchTypes(p)
    ),
    refCell_(refCell),
    first_(true),
    firstOuter_(true),
    firstNorm_(0),
    corrected_(false),
    nReported_(-1)
{
    p.mesh().setFluxRequired(dp_.name());
    assemble();
    overshoot_ = projectionOvershoot::largest(equation_());
    checkScheme();
}


void Foam::projection::checkScheme()
{
    if
    (
        !equation_->faceFluxCorrectionPtr()
     && !projectionOvershoot::stable(overshoot_)
    )
    {
        FatalIOErrorInFunction
        (
            dp_.mesh().schemesDict().subDict("laplacianSchemes")
        )   << "'laplacian((1|A(U)),p)' has no correction for non-orthogonal"
            << " meshes, and the pressure of bodies needs one on this mesh:"
            << " set 'Gauss linear corrected' or 'Gauss linear limited 0.5'"
            << nl << exit(FatalIOError);
    }
}


Foam::label Foam::projection::nCorrections(const label n)
{
    const label needed = projectionOvershoot::nCorrections(overshoot_, n);

    if (needed != n && nReported_ != n)
    {
        Info<< "On this mesh, which is not orthogonal, the pressure needs "
            << needed << " corrections instead of 'nNonOrthogonalCorrectors "
            << n << "'" << endl;
        nReported_ = n;
    }

    return needed;
}


void Foam::projection::assemble()
{
    equation_.reset
    (
        new fvScalarMatrix(fvm::laplacian(dp_, "laplacian((1|A(U)),p)"))
    );
    equation_->setReference(refCell_, 0);
}


void Foam::projection::setControls(const dictionary& controls)
{
    const scalar norm =
        returnReduce(magnitudeSum(equation_->source()), sumOp<scalar>());

    if (firstOuter_)
    {
        firstNorm_ = norm;
    }

    controls_ = residualTarget::controls
    (
        controls,
        max(firstNorm_/max(norm, VSMALL), 1)
    );
}


void Foam::projection::begin(const bool firstOuter)
{
    firstOuter_ = firstOuter;

    // In later iterations the increment is small: its last value is no guess
    dp_ = dimensionedScalar(dp_.dimensions(), Zero);
    first_ = true;
}


void Foam::projection::solve
(
    const dictionary& controls,
    const scalarField& divPhi,
    const dimensionedScalar& tau,
    const scalar reference
)
{
    if (!equation_.valid() || corrected_ || !first_)
    {
        assemble();
    }
    corrected_ = !first_;

    scalarField& source = equation_->source();
    const scalarField& V = dp_.mesh().V();

    forAll(source, celli)
    {
        // From dp = 0 there is nothing to correct for
        const scalar correction = first_ ? 0 : source[celli];

        source[celli] = correction + V[celli]*divPhi[celli]/tau.value();
    }

    // Half of this diagonal, as setReference has doubled it
    if (dp_.needReference() && refCell_ >= 0)
    {
        source[refCell_] += 0.5*equation_->diag()[refCell_]*reference;
    }

    if (first_)
    {
        setControls(controls);
    }

    equation_->solve(controls_);
    first_ = false;
}


void Foam::projection::correctInside
(
    const scalar tau,
    const scalarField& dp,
    scalarField& phi
) const
{
    const faceFlux flux(equation_(), dp);

    forAll(phi, facei)
    {
        phi[facei] -= tau*flux(facei);
    }
}


void Foam::projection::correctOnPatches
(
    const scalar tau,
    surfaceScalarField& phi
) const
{
    forAll(dp_.boundaryField(), patchi)
    {
        const fvPatchScalarField& dp = dp_.boundaryField()[patchi];
        scalarField flux
        (
            equation_->internalCoeffs()[patchi]*dp.patchInternalField()
        );

        if (dp.coupled())
        {
            flux -= equation_->boundaryCoeffs()[patchi]
               *dp.patchNeighbourField();
        }

        phi.boundaryFieldRef()[patchi] -= tau*flux;
    }
}


void Foam::projection::correctFlux
(
    const dimensionedScalar& tau,
    surfaceScalarField& phi
)
{
    if (!compact())
    {
        phi -= tau*equation_->flux();
        return;
    }

    // The same in one pass over the faces
    correctInside(tau.value(), dp_, phi.primitiveFieldRef());
    correctOnPatches(tau.value(), phi);
}


void Foam::projection::correctFlux
(
    const scalar tau,
    const labelUList& faces,
    surfaceScalarField& phi
) const
{
    const faceFlux flux(equation_(), dp_);

    for (const label facei : faces)
    {
        phi[facei] -= tau*flux(facei);
    }
    correctOnPatches(tau, phi);
}


void Foam::projection::correctOtherFluxes
(
    const scalar tau,
    const scalarField& sum,
    const labelUList& faces,
    surfaceScalarField& phi
) const
{
    scalarField& inside = phi.primitiveFieldRef();
    const scalarField before(inside, faces);

    correctInside(tau, sum, inside);
    UIndirectList<scalar>(inside, faces) = before;
}
