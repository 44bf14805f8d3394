// SPDX-License-Identifier: GPL-3.0-or-later

#include "distanceWeighted.H"
#include "addToRunTimeSelectionTable.H"
#include "checkKeywords.H"
#include "surfaceFields.H"
#include "volFields.H"

namespace Foam
{
namespace resistanceModels
{
    defineTypeNameAndDebug(distanceWeighted, 0);
    addToRunTimeSelectionTable(resistanceModel, distanceWeighted, dictionary);
}
}


Foam::resistanceModels::distanceWeighted::distanceWeighted
(
    const dictionary& dict,
    const fvMesh& mesh,
    const bool
)
:
    resistanceModel(),
    mesh_(mesh),
    indexOf_(mesh.nCells(), -1),
    delta_(mesh.boundary().size())
{
    keywords::check(dict, {"type"});

    forAll(delta_, patchi)
    {
        if (mesh.boundary()[patchi].coupled())
        {
            delta_[patchi] = mesh.boundary()[patchi].delta();
        }
    }
}


Foam::scalar Foam::resistanceModels::distanceWeighted::bandWidth() const
{
    // Neighbours of cells inside, and faces that the surface can cut
    return 2;
}


Foam::scalar Foam::resistanceModels::distanceWeighted::crossing
(
    const immersedBody& body,
    const point& outside,
    const point& inside
)
{
    // A wall closer than this to the cell centre changes nothing any more
    const scalar thetaMin = 1e-3;

    const posedShape shape(body.posed());
    scalar lower = 0, dLower = shape.distance(outside);
    scalar upper = 1, dUpper = shape.distance(inside);
    scalar theta = 0;

    // Regula falsi: few steps suffice for a distance, linear but for curvature
    for (label iter = 0; iter < 5; ++iter)
    {
        theta = lower + (upper - lower)*dLower/(dLower - dUpper);

        const scalar d = shape.distance(outside + theta*(inside - outside));

        if (d > 0)
        {
            lower = theta;
            dLower = d;
        }
        else
        {
            upper = theta;
            dUpper = d;
        }

        if (mag(d) < SMALL*mag(inside - outside))
        {
            break;
        }
    }

    return min(max(theta, thetaMin), scalar(1));
}


Foam::scalar Foam::resistanceModels::distanceWeighted::areaInside
(
    const immersedBody& body,
    const vector& shift,
    const face& f
) const
{
    const pointField x(pointField(mesh_.points(), f) - shift);
    scalarField d(x.size());
    body.posed().distance(x, d);

    if (min(d) > 0 || max(d) <= 0)
    {
        return max(d) <= 0;
    }

    // The polygon clipped to where the distance, linear on edges, is negative
    DynamicList<point> inside(x.size() + 2);

    forAll(x, i)
    {
        const label next = f.fcIndex(i);

        if (d[i] <= 0)
        {
            inside.append(x[i]);
        }
        if ((d[i] <= 0) != (d[next] <= 0))
        {
            inside.append(x[i] + d[i]/(d[i] - d[next])*(x[next] - x[i]));
        }
    }

    const face clipped(identity(inside.size()));

    return clipped.mag(inside)/f.mag(mesh_.points());
}


void Foam::resistanceModels::distanceWeighted::setShield
(
    const immersedBody& body,
    bodyRegion& region
) const
{
    forAll(region.shield, i)
    {
        region.shield[i] = 0;
    }

    forAll(region.faces, i)
    {
        const label facei = region.faces[i];

        // No point of a face of this size is further from its centre
        region.faceShield[i] =
            mag(region.faceDistance[i]) > 2*region.faceH[i]
          ? region.faceDistance[i] < 0
          : areaInside(body, region.shift(), mesh_.faces()[facei]);
    }
}


Foam::scalar Foam::resistanceModels::distanceWeighted::wallResistance
(
    const label facei,
    const label celli,
    const scalar nu,
    const scalar theta
) const
{
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    scalar deltaCoeff;

    if (mesh_.isInternalFace(facei))
    {
        deltaCoeff = mesh_.nonOrthDeltaCoeffs()[facei];
    }
    else
    {
        const label patchi = patches.whichPatch(facei);

        deltaCoeff = mesh_.nonOrthDeltaCoeffs().boundaryField()
            [patchi][facei - patches[patchi].start()];
    }

    return
        nu*mag(mesh_.faceAreas()[facei])*deltaCoeff
       *(1/theta - 1)/mesh_.V()[celli];
}


void Foam::resistanceModels::distanceWeighted::setResistance
(
    const immersedBody& body,
    const scalarField& A0,
    const scalarField& nu,
    bodyRegion& region
) const
{
    const scalar inside = 1e6;
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    const vectorField& centres = mesh_.cellCentres();

    forAll(region.cells, i)
    {
        const label celli = region.cells[i];

        indexOf_[celli] = i;
        region.resistance[i] = region.distance[i] <= 0 ? inside*A0[celli] : 0;
    }

    // Add the wall between an outer cell and a neighbour at y
    auto addWall = [&](const label facei, const label celli, const point& y)
    {
        const label i = indexOf_[celli];
        const point x(y - region.shift());

        if (i >= 0 && region.distance[i] > 0 && body.posed().distance(x) <= 0)
        {
            const scalar theta =
                crossing(body, centres[celli] - region.shift(), x);

            region.resistance[i] +=
                wallResistance(facei, celli, nu[celli], theta);
        }
    };

    for (const label facei : region.faces)
    {
        const label own = mesh_.faceOwner()[facei];

        if (mesh_.isInternalFace(facei))
        {
            const label nei = mesh_.faceNeighbour()[facei];

            addWall(facei, own, centres[nei]);
            addWall(facei, nei, centres[own]);
        }
        else
        {
            const label patchi = patches.whichPatch(facei);
            const label i = facei - patches[patchi].start();
            const vector& delta = delta_[patchi][i];

            addWall(facei, own, centres[own] + delta);
        }
    }

    for (const label celli : region.cells)
    {
        indexOf_[celli] = -1;
    }
}


void Foam::resistanceModels::distanceWeighted::report(Ostream& os) const
{
    os  << "distanceWeighted";
}
