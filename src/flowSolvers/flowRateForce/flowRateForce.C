// SPDX-License-Identifier: GPL-3.0-or-later

#include "flowRateForce.H"
#include "addToRunTimeSelectionTable.H"
#include "fvMatrices.H"
#include "volFields.H"

namespace Foam
{
namespace fv
{
    defineTypeNameAndDebug(flowRateForce, 0);
    addToRunTimeSelectionTable(option, flowRateForce, dictionary);
}
}


Foam::fv::flowRateForce::flowRateForce
(
    const word& name,
    const word& modelType,
    const dictionary& dict,
    const fvMesh& mesh
)
:
    option(name, modelType, dict, mesh),
    direction_(normalised(coeffs_.get<vector>("direction"))),
    meanVelocity_(Function1<scalar>::New("meanVelocity", coeffs_)),
    g_(0),
    oldG_(0),
    state_(name_ + "Properties", mesh)
{
    fieldNames_ = wordList(1, coeffs_.lookupOrDefault<word>("U", "U"));
    applied_.setSize(1, false);

    checkWalls();
    setG(state_.lookupOrDefault<scalar>("acceleration", 0));
    beginStep();
}


void Foam::fv::flowRateForce::checkWalls() const
{
    for (const fvPatch& patch : mesh_.boundary())
    {
        scalar across = 0;

        if (!patch.coupled())
        {
            for (const vector& Sf : patch.Sf())
            {
                across = max(across, mag(Sf & direction_)/mag(Sf));
            }
        }

        if (returnReduce(across, maxOp<scalar>()) > 1e-6)
        {
            FatalIOErrorInFunction(coeffs_)
                << "'direction " << direction_ << "' is not parallel to the"
                << " patch '" << patch.name() << "': flowRateForce needs a"
                << " straight tube with cyclic ends" << nl
                << exit(FatalIOError);
        }
    }
}


Foam::scalar Foam::fv::flowRateForce::mean
(
    const surfaceScalarField& phi
) const
{
    // Without divergence, the integral of the velocity over a cell is the sum
    // of its outward fluxes times the places of the faces
    const vectorField& C = mesh_.cellCentres();
    scalar sum = 0;

    forAll(phi, facei)
    {
        const label own = mesh_.faceOwner()[facei];
        const label nei = mesh_.faceNeighbour()[facei];

        sum += phi[facei]*((C[nei] - C[own]) & direction_);
    }

    forAll(phi.boundaryField(), patchi)
    {
        const fvsPatchScalarField& patchPhi = phi.boundaryField()[patchi];
        const labelUList& own = patchPhi.patch().faceCells();
        const vectorField& Cf = patchPhi.patch().Cf();

        forAll(patchPhi, i)
        {
            sum += patchPhi[i]*((Cf[i] - C[own[i]]) & direction_);
        }
    }

    return returnReduce(sum, sumOp<scalar>())/gSum(mesh_.V());
}


void Foam::fv::flowRateForce::setG(const scalar g)
{
    g_ = g;
    state_.set("acceleration", g);
}


Foam::vector Foam::fv::flowRateForce::correctFlux
(
    const scalar tau,
    surfaceScalarField& phi
)
{
    const scalar now = mesh_.time().value();
    const scalar wanted = meanVelocity_->value(now);
    const scalar before =
        meanVelocity_->value(now - mesh_.time().deltaTValue());
    const scalar scale = max(mag(wanted), mag(wanted - before));
    const scalar du = wanted - mean(phi);
    const scalar friction = scale > VSMALL ? 0.5*mag(g_)/scale : 0;
    const vector dU(du*direction_);

    phi.primitiveFieldRef() += dU & mesh_.Sf().primitiveField();

    for (fvsPatchScalarField& patchPhi : phi.boundaryFieldRef())
    {
        if (patchPhi.coupled())
        {
            patchPhi += dU & patchPhi.patch().Sf();
        }
    }

    setG(g_ + du*(1/tau + friction));

    Info<< "flowRateForce " << name_ << ": mean velocity " << wanted
        << " m/s, acceleration " << g_ << " m/s2" << endl;

    return dU;
}


void Foam::fv::flowRateForce::addSup(fvMatrix<vector>& eqn, const label)
{
    if (!mesh_.foundObject<regIOobject>("immersedBodies"))
    {
        FatalIOErrorInFunction(coeffs_)
            << "flowRateForce needs immersed bodies; without, use"
            << " meanVelocityForce" << nl << exit(FatalIOError);
    }

    eqn.source() -= acceleration()*mesh_.V();
}
