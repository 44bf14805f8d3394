// SPDX-License-Identifier: GPL-3.0-or-later

#include "unresolvedCoupling.H"

void Foam::unresolvedCoupling::check
(
    const immersedBody& body,
    grain& one
) const
{
    fluid_.check(body, choice_.type(body));

    if (body.kind().restrained() && choice_.type(body) != "resolved")
    {
        FatalErrorInFunction
            << "'restraints' in immersedBodyProperties need bodies that are"
            << " resolved, and " << body.name() << " is of the type '"
            << choice_.type(body) << "'; use 'coupling resolved' for it" << nl
            << exit(FatalError);
    }

    if (choice_.type(body) != "resolved")
    {
        one.shape.reset(shapeModel::New(shapes_, body.shape()).ptr());
    }
    one.checked = true;
}


void Foam::unresolvedCoupling::update
(
    const PtrList<immersedBody>& bodies,
    scalarList& h
)
{
    forAll(bodies, i)
    {
        if (!grains_[i].checked)
        {
            check(bodies[i], grains_[i]);
        }
    }
    kernels_.update(bodies, h);

    covered_.clear();
    for (const label i : kernels_.ordered())
    {
        covered_.cover
        (
            kernels_[i], bodies[i].volume(), grainKernels::diameter(bodies[i])
        );
    }
}
