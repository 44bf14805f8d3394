// SPDX-License-Identifier: GPL-3.0-or-later

#include "comovingDerivative.H"
#include "surfaceDisplacement.H"

namespace
{
    //- Around a body the frame ends where the band does, but not farther away
    //  than so many cells
    const Foam::scalar maxBand = 4;

    //- The part of the way there from which on it fades
    const Foam::scalar fadeFrom = 0.8;
}


template<class Centre, class Size>
void Foam::comovingDerivative::add
(
    const immersedBody& body,
    const vector& slide,
    const scalar bodyPart,
    const scalar end,
    const bool known,
    const UList<label>& faces,
    const Centre& centre,
    const UList<scalar>& distance,
    const Size& h
)
{
    const scalar fadeStart = fadeFrom*end;
    const surfaceDisplacement s0(body, body.motion().old());
    const surfaceDisplacement s00(body, body.motion().oldOld());
    const vector slide0(mesh_.time().deltaTValue()*slide);
    const vector slide00(slide0 + mesh_.time().deltaT0Value()*slide);

    forAll(faces, i)
    {
        const label facei = faces[i];
        const scalar hi = h(i);
        const scalar d = distance[i]/hi;

        if
        (
            d >= end
         || (known && faceAt_[facei] < 0)
         || onSliding_.test(facei)
        )
        {
            continue;
        }

        if (faceAt_[facei] < 0)
        {
            faceAt_[facei] = faces_.size();
            faces_.append(facei);
            s0_.append(Zero);
            s00_.append(Zero);
            weight_.append(0);
        }

        // Like the resistance; the one of the nearer body counts
        const scalar fade = min((end - d)/(end - fadeStart), 1);
        const scalar weight = fade*Foam::exp(-2*max(d, scalar(-20)));
        const point x(centre(i));
        const vector move(s0(x) + slide0);

        // No farther than a cell
        const scalar part =
            bodyPart*fade*weight*min(hi/max(mag(move), VSMALL), 1);
        const label at = faceAt_[facei];

        s0_[at] += part*move;
        s00_[at] += part*(s00(x) + slide00);
        weight_[at] += weight;
    }
}


void Foam::comovingDerivative::addBand
(
    const label regioni,
    const bodyRegion& region,
    const immersedBody& body,
    const scalar bandWidth,
    const bool known
)
{
    add
    (
        body, region.slideVelocity(), parts_[regioni],
        min(bandWidth, maxBand), known,
        region.faces, [&](const label i) { return region.faceX(i); },
        region.faceDistance,
        [&](const label i) { return region.faceH[i]; }
    );
}


void Foam::comovingDerivative::addFarther
(
    const label regioni,
    const bodyRegion& region,
    const immersedBody& body,
    const cellSearch& search,
    const scalar h,
    const scalar end
)
{
    const label bodyi = region.body();

    if (!near_.set(bodyi))
    {
        near_.set(bodyi, new nearFaces);
    }
    nearFaces& near = near_[bodyi];

    near.update(body, region.shift(), search, end*h);
    add
    (
        body, region.slideVelocity(), parts_[regioni], end, false,
        near.faces, [&](const label i) { return near.x[i]; }, near.distance,
        [&](label) { return h; }
    );
}
