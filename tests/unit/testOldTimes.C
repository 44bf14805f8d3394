// SPDX-License-Identifier: GPL-3.0-or-later

#include "oldTimes.H"
#include "poissonProblem.H"
#include "surfaceFields.H"
#include "testTools.H"
#include "volFields.H"

using namespace Foam;
using testTools::dict;

namespace
{
    //- A field with so many old levels
    template<class GeoField>
    autoPtr<GeoField> make
    (
        const word& name,
        const GeoField& values,
        const label levels
    )
    {
        autoPtr<GeoField> field
        (
            new GeoField
            (
                IOobject
                (
                    name, values.time().timeName(), values.mesh(),
                    IOobject::NO_READ, IOobject::AUTO_WRITE
                ),
                values
            )
        );

        if (levels > 0)
        {
            field->oldTime();
        }
        if (levels > 1)
        {
            field->oldTime().oldTime();
        }

        return field;
    }

    template<class GeoField>
    bool same(const GeoField& a, const GeoField& b)
    {
        typedef Field<typename GeoField::value_type> values;

        bool equal = a.primitiveField() == b.primitiveField()
         && a.timeIndex() == b.timeIndex() && a.writeOpt() == b.writeOpt();

        forAll(a.boundaryField(), patchi)
        {
            const values& onA = a.boundaryField()[patchi];
            const values& onB = b.boundaryField()[patchi];

            equal = equal && onA == onB;
        }

        return equal;
    }

    //- Does each level of a field become what OpenFOAM makes of it, in steps
    //  that change it to multiples of what it was
    template<class GeoField>
    void compare(Time& time, const GeoField& values, const label levels)
    {
        auto stored(make("stored", values, levels));
        auto known(make("known", values, levels));

        for (const scalar factor : {2, -3, 5, 7})
        {
            ++time;
            oldTimes::store(*stored);

            for (GeoField* field : {&*stored, &*known})
            {
                field->oldTime();
                *field == factor*(*field);
            }

            CHECK(same(*stored, *known));
            CHECK(stored->nOldTimes() == known->nOldTimes());
            CHECK((levels < 1 || same(stored->oldTime(), known->oldTime())));
            CHECK
            (
                (
                    levels < 2
                 || same
                    (
                        stored->oldTime().oldTime(), known->oldTime().oldTime()
                    )
                )
            );
        }
    }
}


TEST_CASE("Old times are those that OpenFOAM stores", "[oldTimes]")
{
    Time time(dict("deltaT 1; writeFrequency 1;"), "/tmp", "none");
    const auto mesh(testTools::smallBox().make(time));

    for (const label levels : {0, 1, 2})
    {
        CAPTURE(levels);
        compare<volVectorField>(time, mesh->C(), levels);
        compare<surfaceScalarField>(time, mesh->magSf(), levels);
    }

    // Once in each step
    auto field(make<volVectorField>("field", mesh->C(), 2));

    ++time;
    oldTimes::store(*field);
    *field == 2*(*field);
    oldTimes::store(*field);
    CHECK(field->oldTime().primitiveField() == mesh->C().primitiveField());
}
