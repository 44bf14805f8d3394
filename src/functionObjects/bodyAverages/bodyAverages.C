// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyAverages.H"
#include "addToRunTimeSelectionTable.H"
#include "bodyFunctionObject.H"
#include "bodyShare.H"
#include "bodyTractions.H"
#include "checkKeywords.H"
#include "kernelSums.H"
#include "mathematicalConstants.H"
#include "meshProperties.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(bodyAverages, 0);
    addToRunTimeSelectionTable(functionObject, bodyAverages, dictionary);
}
}


Foam::functionObjects::bodyAverages::bodyAverages
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    tableFile(mesh_, name, typeName, dict),
    bodies_(bodyFunctionObject::actingIn(mesh_, name, "averages")),
    diameter_(-1),
    direction_(Zero),
    nLayers_(0),
    withFields_(true)
{
    read(dict);
}


bool Foam::functionObjects::bodyAverages::read(const dictionary& dict)
{
    keywords::checkFunctionObject
    (
        dict,
        {
            "kernel", "diameter", "direction", "layers", "fields"
        }
    );

    kernelDict_ = dict.subOrEmptyDict("kernel");
    diameter_ =
        dict.found("diameter") ? keywords::positive(dict, "diameter") : -1;
    direction_ = dict.lookupOrDefault<vector>("direction", vector(0, 1, 0));
    nLayers_ = label(keywords::positiveOr(dict, "layers", 20));
    withFields_ = dict.lookupOrDefault<bool>("fields", true);

    if (mag(direction_) < SMALL || nLayers_ < 1)
    {
        FatalIOErrorInFunction(dict)
            << "'direction' in '" << dict.dictName() << "' must not be zero,"
            << " 'layers' not less than 1" << nl << exit(FatalIOError);
    }
    direction_ /= mag(direction_);

    // Refuses wrong entries
    averagingKernel::New(kernelDict_, 1, bodies_.space().twoD());

    return fvMeshFunctionObject::read(dict) && writeFile::read(dict);
}


Foam::scalar Foam::functionObjects::bodyAverages::meanDiameter() const
{
    const scalar pi = constant::mathematical::pi;
    const bool twoD = bodies_.space().twoD();

    const scalar sum = bodies_.list().share().sum<scalar>
    (
        [&](const label bodyi)
        {
            const scalar size = bodies_[bodyi].shape().volume();

            return twoD ? sqrt(4*size/pi) : cbrt(6*size/pi);
        }
    );

    return sum/max(bodies_.nBodies(), 1);
}


void Foam::functionObjects::bodyAverages::report
(
    const bodyFractions& fractions,
    const scalarField& means
) const
{
    const bodyShare& share = bodies_.list().share();
    const scalar exact = share.sum<scalar>
    (
        [&](const label bodyi)
        {
            return bodies_[bodyi].volume()/bodies_.loads().nParts(bodyi);
        }
    );
    const scalar inCells = share.sum<scalar>
    (
        [&](const label bodyi) { return fractions.volume(bodyi); }
    );
    scalar averaged = 0;

    forAll(mesh_.V(), celli)
    {
        averaged += mesh_.V()[celli]
           *means[phaseSources::nColumns*celli + phaseSources::bodies];
    }
    reduce(averaged, sumOp<scalar>());

    Info<< type() << ' ' << name() << ": volume of the bodies " << exact
        << " m3, in cells " << inCells << ", of the averages " << averaged
        << "; kernels are one-sided where they reach out of the mesh" << nl
        << endl;
}


bool Foam::functionObjects::bodyAverages::write()
{
    const bodyFractions fractions(bodies_);
    const bodyTractions tractions
    (
        bodies_,
        fractions,
        lookupObject<volScalarField>("p"),
        meshProperties::ddt(mesh_, "U")
    );
    const scalar diameter = diameter_ > 0 ? diameter_ : meanDiameter();

    if (!tractions.known() || diameter <= 0)
    {
        return true;
    }

    const phaseSources sources(mesh_, bodies_, fractions, tractions);
    const autoPtr<averagingKernel> kernel
    (
        averagingKernel::New(kernelDict_, diameter, bodies_.space().twoD())
    );
    const kernelSums sums(mesh_, bodies_.periods(), kernel());
    const scalarField means
    (
        sums.average
        (
            phaseSources::nColumns, sources.values(), phaseSources::slide
        )
    );

    if (log)
    {
        report(fractions, means);
    }
    if (withFields_)
    {
        writeMeans(means);
        writeForces(means);
        writeStresses(means);
    }
    writeTable(means);

    return true;
}
