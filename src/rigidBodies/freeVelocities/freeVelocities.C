// SPDX-License-Identifier: GPL-3.0-or-later

#include "freeVelocities.H"

namespace
{

bool isOne(const Foam::immersedBody& body)
{
    return body.isFree() && body.resolved();
}


//- Call f with each free resolved body
template<class List, class Function>
void forFree(List& bodies, const Function& f)
{
    for (auto& body : bodies)
    {
        if (isOne(body))
        {
            f(body);
        }
    }
}

} // End anonymous namespace


Foam::labelList Foam::freeVelocities::bodies
(
    const PtrList<immersedBody>& bodies
)
{
    DynamicList<label> free(bodies.size());

    forAll(bodies, i)
    {
        if (isOne(bodies[i]))
        {
            free.append(i);
        }
    }

    return labelList(std::move(free));
}


Foam::vectorField Foam::freeVelocities::get
(
    const PtrList<immersedBody>& bodies
)
{
    DynamicList<vector> velocities(2*bodies.size());

    forFree(bodies, [&](const immersedBody& body)
    {
        velocities.append(body.state().U - body.contact().U());
        velocities.append(body.state().omega - body.contact().omega());
    });

    return vectorField(std::move(velocities));
}


void Foam::freeVelocities::set
(
    const UList<vector>& velocities,
    PtrList<immersedBody>& bodies
)
{
    label i = 0;

    forFree(bodies, [&](immersedBody& body)
    {
        bodyState state(body.state());

        state.U = velocities[i++] + body.contact().U();
        state.omega = velocities[i++] + body.contact().omega();
        body.setState(state);
    });
}


Foam::vectorField Foam::freeVelocities::weights
(
    const PtrList<immersedBody>& bodies
)
{
    DynamicList<vector> weights(2*bodies.size());

    forFree(bodies, [&](const immersedBody& body)
    {
        const tensor I(body.inertia(body.state()));

        weights.append(Foam::sqrt(body.volume())*vector::one);
        weights.append(vector(sqrt(I.xx()), sqrt(I.yy()), sqrt(I.zz())));
    });

    return vectorField(std::move(weights));
}
