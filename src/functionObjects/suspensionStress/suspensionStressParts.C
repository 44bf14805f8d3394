// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyGaps.H"
#include "bodyContacts.H"
#include "bodyShare.H"
#include "bodyTractions.H"
#include "gaussGrad.H"
#include "meshProperties.H"
#include "surfaceInterpolate.H"
#include "suspensionStress.H"
#include "turbulentTransportModel.H"
#include <functional>

void Foam::functionObjects::suspensionStress::updateFluid
(
    const scalarField& inBodies
)
{
    const volVectorField& U = lookupObject<volVectorField>("U");
    const scalarField& p = lookupObject<volScalarField>("p");
    const scalarField& V = mesh_.V();
    const tmp<volScalarField> tnu
    (
        lookupObject<incompressible::turbulenceModel>
        (
            turbulenceModel::propertiesName
        ).nuEff()
    );
    const scalarField& nu = tnu();

    // The sum over the cells is that over the patches, exactly
    const tmp<volTensorField> tgradU
    (
        fv::gaussGrad<vector>::gradf(linearInterpolate(U), "gradU")
    );
    const tensorField& gradU = tgradU();

    symmTensor viscous(Zero);
    tensor gradient(Zero);
    scalar pressure = 0, fluidVolume = 0, volume = 0;

    forAll(V, celli)
    {
        const scalar fluidV = V[celli]*(1 - inBodies[celli]);

        viscous += V[celli]*nu[celli]*dev(twoSymm(gradU[celli]));
        gradient += V[celli]*gradU[celli];
        pressure += fluidV*p[celli];
        fluidVolume += fluidV;
        volume += V[celli];
    }

    reduce(viscous, sumOp<symmTensor>());
    reduce(gradient, sumOp<tensor>());
    reduce(pressure, sumOp<scalar>());
    reduce(fluidVolume, sumOp<scalar>());
    reduce(volume, sumOp<scalar>());

    parts_[fluid] = tensor(viscous - pressure*symmTensor::I)/volume;
    meanGradient_ = gradient/volume;
    fluidPressure_ = pressure/fluidVolume;
    phi_ = 1 - fluidVolume/volume;
}


void Foam::functionObjects::suspensionStress::updateBodies
(
    const bodyTractions& tractions
)
{
    const bodyShare& share = bodies_.list().share();
    const contactMoments& contacts = bodies_.contacts().moments();
    const scalar volume = gSum(mesh_.V());

    typedef std::function<tensor(const label)> ofBody;
    const std::pair<part, ofBody> ofBodies[] =
    {
        {particle, [&](const label i) { return tractions.surface(i); }},
        {inertia, [&](const label i) { return tractions.inertia(i); }},
        {contact, [&](const label i) { return contacts.contact(i); }},
        {film, [&](const label i) { return contacts.film(i); }}
    };

    for (const auto& one : ofBodies)
    {
        parts_[one.first] = share.sum<tensor>(one.second)/volume;
    }
}


void Foam::functionObjects::suspensionStress::updateReynolds
(
    const bodyFractions& fractions
)
{
    parts_[Reynolds] = tensor::zero;

    // Stokes flow
    if (word(mesh_.divScheme("div(phi,U)")) == "none")
    {
        return;
    }

    const vectorField& U = lookupObject<volVectorField>("U");
    const vectorField& x = mesh_.cellCentres();
    const scalarField& V = mesh_.V();
    const scalar volume = gSum(V);
    const vector meanU(gSum(V*U)/volume), meanX(gSum(V*x)/volume);
    scalarField rho(V.size(), 1);

    forAll(bodies_.region().regions(), regioni)
    {
        const bodyRegion& one = bodies_.region().regions()[regioni];
        const scalar r = bodies_[one.body()].densityRatio();

        forAll(one.cells, i)
        {
            rho[one.cells[i]] += (r - 1)*fractions[regioni][i];
        }
    }

    tensor sum(Zero);

    forAll(V, celli)
    {
        const vector u
        (
            U[celli] - meanU - ((x[celli] - meanX) & meanGradient_)
        );
        sum -= V[celli]*rho[celli]*(u*u);
    }
    reduce(sum, sumOp<tensor>());

    parts_[Reynolds] = sum/volume;
}


bool Foam::functionObjects::suspensionStress::update()
{
    if (index_ == time_.timeIndex())
    {
        return true;
    }

    const bodyFractions fractions(bodies_);
    const bodyTractions tractions
    (
        bodies_,
        fractions,
        lookupObject<volScalarField>("p"),
        meshProperties::ddt(mesh_, "U")
    );

    if (!tractions.known())
    {
        return false;
    }

    updateBodies(tractions);
    updateFluid(fractions.total(mesh_.nCells()));
    updateReynolds(fractions);
    setValues();
    index_ = time_.timeIndex();

    return true;
}


Foam::tensor Foam::functionObjects::suspensionStress::sum() const
{
    tensor total(Zero);

    for (label parti = 0; parti < nParts; ++parti)
    {
        if (parti != Reynolds || withReynolds_)
        {
            total += parts_[parti];
        }
    }

    return total;
}


void Foam::functionObjects::suspensionStress::setValues()
{
    const tensor S(sum());
    const vector v(flow_^gradient_);
    const bool twoD = bodies_.space().twoD();
    const scalar rate = shearRate_.valid()
      ? shearRate_->value(time_.value())
      : gradient_ & meanGradient_ & flow_;
    const scalar stress = flow_ & S & gradient_;
    const tensor ofBodies
    (
        parts_[particle] + parts_[inertia] + parts_[contact] + parts_[film]
    );
    const scalar trace = tr(ofBodies) - (twoD ? (v & ofBodies & v) : 0);
    const bodyGaps gaps(bodies_, contactGap_, clusterGap_);

    DynamicList<scalar> values;

    values.append(phi_);
    values.append(rate);
    values.append(stress);
    values.append(mag(rate) > VSMALL ? stress/rate : NAN);
    values.append((flow_ & S & flow_) - (gradient_ & S & gradient_));
    if (!twoD)
    {
        values.append((gradient_ & S & gradient_) - (v & S & v));
    }
    values.append(-trace/(twoD ? 2 : 3) - phi_*fluidPressure_);
    values.append(gaps.nContacts());
    values.append(gaps.least());
    values.append(gaps.meanNearest());
    values.append(gaps.clusters().n());
    values.append(gaps.clusters().largest());
    values.append(gaps.clusters().mean());

    values_ = values;
}
