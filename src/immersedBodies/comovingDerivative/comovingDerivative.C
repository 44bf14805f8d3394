// SPDX-License-Identifier: GPL-3.0-or-later

#include "comovingDerivative.H"

namespace
{
    //- Largest distance, in cell sizes, at which the frame moves with the body,
    //  and the part of it from which on it fades
    const Foam::scalar maxReach = 4;
    const Foam::scalar fadeFrom = 0.8;

    //- Displacement over the body's width that is none
    const Foam::scalar still = 1e-7;


    //- How far a body has turned, and that takes its surface along
    Foam::quaternion turn
    (
        const Foam::immersedBody& body,
        const Foam::bodyState& before
    )
    {
        return body.shape().round()
          ? Foam::quaternion::I
          : before.orientation*conjugate(body.state().orientation);
    }


    //- Displacement of the points of a body since another state of it; a round
    //  one takes its surface along by translation only
    class displacement
    {
        const Foam::point& centre_;
        const Foam::vector move_;
        const Foam::tensor back_;

    public:

        displacement
        (
            const Foam::immersedBody& body,
            const Foam::bodyState& before
        )
        :
            centre_(body.state().position),
            move_(centre_ - before.position),
            back_(turn(body, before).R())
        {}

        Foam::vector operator()(const Foam::point& x) const
        {
            const Foam::vector r(x - centre_);

            return move_ + r - (back_ & r);
        }
    };


    //- The farthest that the surface can have moved since another state
    Foam::scalar farthest
    (
        const Foam::immersedBody& body,
        const Foam::bodyState& before
    )
    {
        return mag(body.state().position - before.position)
          + 2*mag(turn(body, before).v())*body.shape().boundingRadius();
    }
}


Foam::comovingDerivative::comovingDerivative
(
    const fvMesh& mesh,
    const cellNeighbours& neighbours
)
:
    mesh_(mesh),
    neighbours_(neighbours),
    coupled_(false),
    ddt_("Euler", 1, 1),
    active_(false),
    delta_(mesh.boundary().size())
{
    forAll(delta_, patchi)
    {
        if (mesh.boundary()[patchi].coupled())
        {
            delta_[patchi] = mesh.boundary()[patchi].delta();
            coupled_ = true;
        }
    }
    reduce(coupled_, orOp<bool>());
}


bool Foam::comovingDerivative::moves(const immersedBody& body)
{
    const scalar far = max
    (
        farthest(body, body.oldState()),
        farthest(body, body.oldOldState())
    );

    return body.resolved() && far > still*body.shape().width();
}


void Foam::comovingDerivative::add
(
    const bodyRegion& region,
    const immersedBody& body,
    const scalar fadeEnd,
    const bool known
)
{
    const scalar fadeStart = fadeFrom*fadeEnd;
    const displacement s0(body, body.oldState());
    const displacement s00(body, body.oldOldState());

    forAll(region.faces, i)
    {
        const label facei = region.faces[i];
        const scalar h = region.faceH[i];
        const scalar d = region.faceDistance[i]/h;

        if (d >= fadeEnd || (known && faceAt_[facei] < 0))
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
        const scalar fade = min((fadeEnd - d)/(fadeEnd - fadeStart), 1);
        const scalar weight = fade*Foam::exp(-2*max(d, scalar(-20)));
        const vector move(s0(region.faceX[i]));

        // No farther than a cell
        const scalar part = fade*weight*min(h/max(mag(move), VSMALL), 1);
        const label at = faceAt_[facei];

        s0_[at] += part*move;
        s00_[at] += part*s00(region.faceX[i]);
        weight_[at] += weight;
    }
}


void Foam::comovingDerivative::update
(
    const PtrList<bodyRegion>& regions,
    const PtrList<immersedBody>& bodies,
    const scalar bandWidth,
    const ddtCoefficients& ddt
)
{
    UIndirectList<label>(faceAt_, faces_) = -1;
    UIndirectList<label>(cellAt_, cells_) = -1;
    faces_.clear();
    s0_.clear();
    s00_.clear();
    weight_.clear();
    cells_.clear();
    wide_.clear();
    ddt_ = ddt;
    active_ = false;

    boolList moving(bodies.size());

    // The same on all processors
    forAll(bodies, bodyi)
    {
        moving[bodyi] = moves(bodies[bodyi]);
        active_ = active_ || moving[bodyi];
    }

    if (!active_)
    {
        return;
    }

    faceAt_.resize(mesh_.nFaces(), -1);
    cellAt_.resize(mesh_.nCells(), -1);

    const scalar fadeEnd = min(bandWidth, maxReach);

    for (const bool known : {false, true})
    {
        for (const bodyRegion& region : regions)
        {
            if (moving[region.body()] != known)
            {
                add(region, bodies[region.body()], fadeEnd, known);
            }
        }
    }

    forAll(faces_, i)
    {
        s0_[i] /= weight_[i];
        s00_[i] /= weight_[i];
    }

    findCells();
}


Foam::scalar& Foam::comovingDerivative::at
(
    surfaceScalarField& phi,
    const label facei
)
{
    const polyMesh& mesh = phi.mesh();

    if (mesh.isInternalFace(facei))
    {
        return phi[facei];
    }

    const polyBoundaryMesh& patches = mesh.boundaryMesh();
    const label patchi = patches.patchID()[facei - mesh.nInternalFaces()];

    return phi.boundaryFieldRef()[patchi][facei - patches[patchi].start()];
}


void Foam::comovingDerivative::removeFlux(surfaceScalarField& phi)
{
    kept_.resize(faces_.size());

    // The first access to patches would store what is changed here
    phi.storeOldTimes();

    forAll(faces_, i)
    {
        scalar& flux = at(phi, faces_[i]);

        kept_[i] = flux;
        flux -= (ddt_.c0*s0_[i] - ddt_.c00*s00_[i])
          & mesh_.faceAreas()[faces_[i]];
    }
}


void Foam::comovingDerivative::restoreFlux(surfaceScalarField& phi) const
{
    forAll(faces_, i)
    {
        at(phi, faces_[i]) = kept_[i];
    }
}
