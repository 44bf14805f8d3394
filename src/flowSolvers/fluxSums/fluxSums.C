// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluxSums.H"
#include "faceSums.H"
#include "vector2D.H"

Foam::vector Foam::fluxSums::ofErrors
(
    const scalarField& V,
    const scalarField& errors
)
{
    vector sums(Zero);

    // In the order of the cells, for those of pimpleFoam to the last digit
    forAll(V, celli)
    {
        sums += V[celli]*vector(mag(errors[celli]), errors[celli], 1);
    }

    return sums;
}


Foam::fluxSums::fluxSums(const surfaceScalarField& phi)
:
    phi_(phi),
    event_(-1),
    fastest_(0),
    through_(0),
    continuity_(Zero)
{}


void Foam::fluxSums::update()
{
    if (event_ == phi_.eventNo())
    {
        return;
    }
    event_ = phi_.eventNo();

    const scalarField& V = phi_.mesh().V();

    scalarField div(V.size());
    scalar fastest = 0, through = 0;

    faceSums<vector2D>
    (
        phi_,
        [](const scalar flux) { return vector2D(mag(flux), flux); },
        [&](const label celli, const vector2D& sum)
        {
            fastest = max(fastest, sum[0]/V[celli]);
            through += sum[0];
            div[celli] = sum[1]/V[celli];
        }
    );

    fastest_ = fastest;
    through_ = through;
    continuity_ = ofErrors(V, div);
}


Foam::scalar Foam::fluxSums::courantNo
(
    const scalar deltaT,
    const char* prefix
)
{
    update();

    const scalar fastest = returnReduce(fastest_, maxOp<scalar>());
    vector2D sums(through_, continuity_[2]);
    reduce(sums, sumOp<vector2D>());

    const scalar CoNum = 0.5*fastest*deltaT;

    Info<< prefix << "Courant Number mean: " << 0.5*(sums[0]/sums[1])*deltaT
        << " max: " << CoNum << endl;

    return CoNum;
}


const Foam::vector& Foam::fluxSums::continuity()
{
    update();

    return continuity_;
}
