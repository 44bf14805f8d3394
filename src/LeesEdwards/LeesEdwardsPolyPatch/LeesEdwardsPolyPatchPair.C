// SPDX-License-Identifier: GPL-3.0-or-later

#include "LeesEdwardsPolyPatch.H"
#include "polyMesh.H"

const Foam::slidingPair* Foam::LeesEdwardsPolyPatch::findPair
(
    const polyMesh& mesh
)
{
    const slidingPair* found = nullptr;

    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        const auto* side = isA<LeesEdwardsPolyPatch>(patch);

        if (side && side->owner())
        {
            if (found)
            {
                FatalIOErrorInFunction(mesh.boundaryMesh().objectPath())
                    << "There are several pairs of patches of the type "
                    << typeName << ", and one pair is allowed"
                    << exit(FatalIOError);
            }
            found = &side->pair();
        }
    }

    return found;
}


Foam::label Foam::LeesEdwardsPolyPatch::neighbPatchID() const
{
    const label patchi = boundaryMesh().findPatchID(neighbourPatch_);
    const auto* other = patchi < 0
      ? nullptr
      : isA<LeesEdwardsPolyPatch>(boundaryMesh()[patchi]);

    if (!other || patchi == index() || other->neighbourPatch_ != name())
    {
        FatalIOErrorInFunction(boundaryMesh().objectPath())
            << "'neighbourPatch " << neighbourPatch_ << "' of the patch '"
            << name() << "' has to be another patch of the type " << typeName
            << " whose 'neighbourPatch' is " << name() << exit(FatalIOError);
    }

    return patchi;
}


const Foam::LeesEdwardsPolyPatch&
Foam::LeesEdwardsPolyPatch::neighbPatch() const
{
    return refCast<const LeesEdwardsPolyPatch>
    (
        boundaryMesh()[neighbPatchID()]
    );
}


const Foam::slidingPair& Foam::LeesEdwardsPolyPatch::pair() const
{
    const LeesEdwardsPolyPatch& other = neighbPatch();

    if (motion_.empty() == other.motion_.empty())
    {
        FatalIOErrorInFunction(boundaryMesh().objectPath())
            << (motion_.empty() ? "None" : "Both") << " of the patches '"
            << name() << "' and '" << other.name() << "' of the type "
            << typeName << " has entries of " << motionKeywords_
            << ", and one of them needs 'direction' and 'speed' or"
            << " 'shearRate'" << exit(FatalIOError);
    }
    if (motion_.empty())
    {
        return other.pair();
    }

    if (!pair_.valid())
    {
        pair_.reset
        (
            new slidingPair
            (
                boundaryMesh().mesh(), index(), neighbPatchID(), motion_
            )
        );
    }

    return pair_();
}
