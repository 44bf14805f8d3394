// SPDX-License-Identifier: GPL-3.0-or-later

#include "wallRoughness.H"
#include "keyedRandom.H"
#include "labelList.H"
#include "mathematicalConstants.H"

namespace
{

using Foam::scalar;

//- Slopes of more standard deviations are not drawn
const scalar steepest = 6;


//- An angle above `least` from a normal distribution of standard deviation s,
//  with the weight sin(a + angle), which is `most` at most
scalar draw
(
    Foam::Random& random,
    const scalar s,
    const scalar a,
    const scalar least,
    const scalar most
)
{
    // With s > 0 at least one number in 50 is accepted
    for (int i = 0; i < 10000; ++i)
    {
        const scalar g = s*random.GaussNormal<scalar>();
        const bool seen =
            g > least && Foam::mag(g) < steepest*s
         && most*random.sample01<scalar>() < Foam::sin(a + g);

        if (seen)
        {
            return g;
        }
    }

    return 0;
}


//- A unit vector across n
Foam::vector across(const Foam::vector& n)
{
    using Foam::vector;

    return Foam::normalised
    (
        n ^ (Foam::mag(n.x()) < 0.7 ? vector(1, 0, 0) : vector(0, 1, 0))
    );
}

} // End anonymous namespace


Foam::wallRoughness::wallRoughness(const dictionary& dict)
:
    seed_(dict.lookupOrDefault<label>("seed", 1))
{}


void Foam::wallRoughness::begin(const PtrList<immersedBody>& bodies)
{
    if (old_.size() > bodies.size())
    {
        // Some have left
        Map<label> kept;

        for (const immersedBody& body : bodies)
        {
            const auto iter = old_.cfind(body.number());

            if (iter.found())
            {
                kept.insert(body.number(), iter());
            }
        }
        old_.transfer(kept);
    }

    impacts_ = old_;
}


Foam::vector Foam::wallRoughness::slope
(
    const immersedBody& body,
    const vector& n,
    const vector& U,
    const scalar s
)
{
    const label number = body.number();
    const label impact = impacts_.found(number) ? impacts_[number] + 1 : 1;

    impacts_.set(number, impact);

    const geometricSpace& space = body.kind().space();
    const scalar right = constant::mathematical::piByTwo;
    const vector along(U - (U & n)*n);
    const scalar a = Foam::atan2(U & n, mag(along));

    // Of one that comes straight, any direction
    const vector any(space.twoD() ? vector(n^space.emptyDir()) : across(n));
    const vector t
    (
        mag(along) > SMALL*mag(U) ? vector(along/mag(along)) : any
    );

    Random random(keyedRandom::generator(seed_, number, impact));
    const scalar g =
        draw(random, s, a, -a, Foam::sin(min(a + steepest*s, right)));
    const scalar h = space.twoD() ? 0 : draw(random, s, right, -right, 1);

    return
        Foam::cos(h)*(Foam::cos(g)*n + Foam::sin(g)*t) + Foam::sin(h)*(n^t);
}


void Foam::wallRoughness::endStep(const contactMovers& movers)
{
    DynamicList<labelPair> bodies(impacts_.size());
    DynamicList<vector> packed(impacts_.size());

    forAllConstIters(impacts_, iter)
    {
        bodies.append(labelPair(iter.key(), -1));
        packed.append(vector(iter.key(), iter(), 0));
    }

    // Those that meet the wall elsewhere are behind
    old_.clear();
    for (const vector& one : movers.ranks().keep(bodies, packed))
    {
        label& n = old_(label(one.x()), 0);

        n = max(n, label(one.y()));
    }
}


void Foam::wallRoughness::readState(const label number, const dictionary& dict)
{
    const label n = dict.lookupOrDefault<label>("wallImpacts", 0);

    if (n > 0)
    {
        old_.set(number, n);
        impacts_.set(number, n);
    }
}


void Foam::wallRoughness::writeState(Ostream& os, const label number) const
{
    const auto iter = old_.cfind(number);

    if (iter.found())
    {
        os.writeEntry("wallImpacts", iter());
    }
}
