// SPDX-License-Identifier: GPL-3.0-or-later

#include "stokesEquations.H"
#include "fixedTractionVelocityFvPatchVectorField.H"
#include "fvmLaplacian.H"
#include "linear.H"

namespace
{
    //- As momentumEquation has it
    const Foam::scalar smoothingPart = 0.1;

    //- Leak of bodies: a part of the smoothing
    const Foam::scalar leakPart = 1e-3;

    //- Evaluations of conditions that follow the velocity step by step, and
    //  the change, relative, at which they have caught up
    const Foam::label maxEvaluations = 200;
    const Foam::scalar caughtUp = 1e-13;

    //- Growth of a change that says that they do not
    const Foam::scalar lost = 1e6;

    //- Values on all patches
    Foam::vectorField patchValues(const Foam::volVectorField& U)
    {
        Foam::DynamicList<Foam::vector> values;

        for (const Foam::fvPatchVectorField& patch : U.boundaryField())
        {
            values.append(patch);
        }

        return Foam::vectorField(std::move(values));
    }

    Foam::IOobject fieldIO
    (
        const Foam::word& name,
        const Foam::fvMesh& mesh,
        const Foam::IOobject::readOption read = Foam::IOobject::NO_READ
    )
    {
        return Foam::IOobject
        (
            name,
            mesh.time().timeName(),
            mesh,
            read,
            Foam::IOobject::NO_WRITE
        );
    }
}


Foam::dimensionedScalar Foam::stokesEquations::readNu(const fvMesh& mesh)
{
    // Registered: conditions of patches look for it
    IOdictionary* dict = new IOdictionary
    (
        IOobject
        (
            "transportProperties",
            mesh.time().constant(),
            mesh,
            IOobject::MUST_READ,
            IOobject::NO_WRITE
        )
    );
    dict->store();

    const word model(dict->get<word>("transportModel"));

    if (model != "Newtonian")
    {
        FatalIOErrorInFunction(*dict)
            << "'transportModel' is '" << model << "' and must be 'Newtonian':"
            << " flows are added up, which is right for a viscosity that does"
            << " not depend on them only" << nl << exit(FatalIOError);
    }

    const dimensionedScalar nu("nu", dimViscosity, *dict);

    if (!(nu.value() > 0))
    {
        FatalIOErrorInFunction(*dict)
            << "The viscosity 'nu' [m2/s] is " << nu.value()
            << " and must be greater than 0" << nl << exit(FatalIOError);
    }

    return nu;
}


Foam::stokesEquations::stokesEquations(const fvMesh& mesh)
:
    mesh_(mesh),
    nu_(readNu(mesh)),
    U_(fieldIO("U", mesh, IOobject::MUST_READ), mesh),
    p_(fieldIO("p", mesh, IOobject::MUST_READ), mesh),
    phi_
    (
        fieldIO("phi", mesh),
        mesh,
        dimensionedScalar(dimVolume/dimTime, Zero)
    ),
    lagging_(false),
    A0_
    (
        fieldIO("A0", mesh),
        mesh,
        dimensionedScalar(dimless/dimTime, Zero),
        "zeroGradient"
    ),
    smoothing_
    (
        fieldIO("smoothing", mesh),
        mesh,
        dimensionedScalar(dimTime, Zero),
        "zeroGradient"
    ),
    leak_
    (
        fieldIO("leak", mesh),
        mesh,
        dimensionedScalar(dimTime*dimLength, Zero)
    ),
    area_(mesh.nCells(), Zero),
    bodies_(nullptr)
{
    for (direction cmpt = 0; cmpt < 3; ++cmpt)
    {
        if (mesh.geometricD()[cmpt] > 0)
        {
            components_.append(cmpt);
        }
    }
    checkPatches();

    const vectorField& Sf = mesh.faceAreas();

    forAll(area_, celli)
    {
        for (const label facei : mesh.cells()[celli])
        {
            // Empty faces take no part
            for (const direction cmpt : components_)
            {
                area_[celli] += mag(Sf[facei][cmpt]);
            }
        }
    }

    viscous_.reset
    (
        new fvVectorMatrix(fvm::laplacian(-nu_, U_, viscousScheme()))
    );
    A0_.primitiveFieldRef() = viscous_->A()().primitiveField();
    A0_.correctBoundaryConditions();
    smoothing_.primitiveFieldRef() = smoothingPart/A0_.primitiveField();
    smoothing_.correctBoundaryConditions();
    leak_ = leakPart*linearInterpolate(smoothing_)*mesh.nonOrthDeltaCoeffs()
       *mesh.magSf();

    data_ = flow(scalarField(size(), Zero), true);
    setBodies(nullptr);
}


void Foam::stokesEquations::checkPatches()
{
    for (const fvPatchVectorField& patch : U_.boundaryField())
    {
        typedef fixedTractionVelocityFvPatchVectorField traction;

        if (!isA<traction>(patch))
        {
            continue;
        }
        lagging_ = true;

        if (refCast<const traction>(patch).backflow() > 0)
        {
            FatalErrorInFunction
                << "The traction by 'backflow' on patch '"
                << patch.patch().name() << "' in " << U_.objectPath()
                << " depends on the sign of the flow, and flows are added up:"
                << " set 'backflow 0'" << nl << exit(FatalError);
        }
        if (refCast<const traction>(patch).hasFan())
        {
            FatalErrorInFunction
                << "The pressure of the 'fan' on patch '"
                << patch.patch().name() << "' in " << U_.objectPath()
                << " depends on the flow, and flows are added up: give a"
                << " 'traction' instead" << nl << exit(FatalError);
        }
    }
}


void Foam::stokesEquations::evaluatePatches()
{
    U_.correctBoundaryConditions();

    // What is left of the flow before this one counts as well: beside a flow
    // without velocity on the ends it would never be small
    const scalar last = lagging_ ? gMax(mag(patchValues(U_))()) : scalar(0);
    bool settled = !lagging_;
    scalar first = 0;

    for (label i = 0; !settled && i < maxEvaluations; ++i)
    {
        const vectorField before(patchValues(U_));

        U_.boundaryFieldRef().updateCoeffs();
        U_.correctBoundaryConditions();

        const vectorField after(patchValues(U_));
        const scalar change = gMax(mag(after - before)());

        settled = !(change > caughtUp*max(gMax(mag(after)()), last));
        first = max(first, i < 3 ? change : scalar(0));

        if (change > lost*first)
        {
            break;
        }
    }

    if (!settled)
    {
        FatalErrorInFunction
            << "The velocity on ends under traction does not settle, as cells"
            << " there are long along the flow and thin across: make them"
            << " square, or set 'tangentialVelocity zero' in "
            << U_.objectPath() << nl << exit(FatalError);
    }

    p_.correctBoundaryConditions();
}


void Foam::stokesEquations::setBodies(const stokesBodies* bodies)
{
    bodies_ = bodies;
    source_ = residual(scalarField(size(), Zero));
}
