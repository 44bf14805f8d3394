// SPDX-License-Identifier: GPL-3.0-or-later

#include "LeesEdwardsFvPatchField.H"

namespace Foam
{

//- Add a velocity to fields of vectors, nothing to others
template<class Type>
inline void addToVectors(const vector&, Field<Type>&)
{}

template<>
inline void addToVectors(const vector& velocity, Field<vector>& values)
{
    values += velocity;
}

} // End namespace Foam


template<class Type>
const Foam::LeesEdwardsFvPatch& Foam::LeesEdwardsFvPatchField<Type>::checked
(
    const fvPatch& p,
    const dictionary& dict
)
{
    if (!isA<LeesEdwardsFvPatch>(p))
    {
        FatalIOErrorInFunction(dict)
            << "'type " << typeName << "' needs a patch of that type in"
            << " constant/polyMesh/boundary, and '" << p.name()
            << "' is of the type " << p.type() << exit(FatalIOError);
    }

    return refCast<const LeesEdwardsFvPatch>(p);
}


template<class Type>
Foam::LeesEdwardsFvPatchField<Type>::LeesEdwardsFvPatchField
(
    const fvPatch& p,
    const DimensionedField<Type, volMesh>& iF
)
:
    coupledFvPatchField<Type>(p, iF),
    patch_(refCast<const LeesEdwardsFvPatch>(p))
{}


template<class Type>
Foam::LeesEdwardsFvPatchField<Type>::LeesEdwardsFvPatchField
(
    const fvPatch& p,
    const DimensionedField<Type, volMesh>& iF,
    const dictionary& dict
)
:
    coupledFvPatchField<Type>
    (
        checked(p, dict), iF, dict, dict.found("value")
    ),
    patch_(refCast<const LeesEdwardsFvPatch>(p))
{
    // Values of an earlier time have the shift of that time
    if (coupled() && !dict.found("value"))
    {
        this->evaluate(Pstream::commsTypes::blocking);
    }
}


template<class Type>
Foam::LeesEdwardsFvPatchField<Type>::LeesEdwardsFvPatchField
(
    const LeesEdwardsFvPatchField<Type>& field,
    const fvPatch& p,
    const DimensionedField<Type, volMesh>& iF,
    const fvPatchFieldMapper& mapper
)
:
    coupledFvPatchField<Type>(field, p, iF, mapper),
    patch_(refCast<const LeesEdwardsFvPatch>(p))
{}


template<class Type>
Foam::LeesEdwardsFvPatchField<Type>::LeesEdwardsFvPatchField
(
    const LeesEdwardsFvPatchField<Type>& field
)
:
    coupledFvPatchField<Type>(field),
    patch_(field.patch_)
{}


template<class Type>
Foam::LeesEdwardsFvPatchField<Type>::LeesEdwardsFvPatchField
(
    const LeesEdwardsFvPatchField<Type>& field,
    const DimensionedField<Type, volMesh>& iF
)
:
    coupledFvPatchField<Type>(field, iF),
    patch_(field.patch_)
{}


template<class Type>
void Foam::LeesEdwardsFvPatchField<Type>::addVelocity
(
    Field<Type>& values
) const
{
    if (this->internalField().dimensions() == dimVelocity)
    {
        addToVectors(patch_.pair().velocityBeyond(patch_.index()), values);
    }
}


template<class Type>
Foam::tmp<Foam::Field<Type>>
Foam::LeesEdwardsFvPatchField<Type>::patchNeighbourField() const
{
    tmp<Field<Type>> tvalues(patch_.beyond(this->primitiveField()));

    addVelocity(tvalues.ref());

    return tvalues;
}


template<class Type>
void Foam::LeesEdwardsFvPatchField<Type>::patchNeighbourField
(
    UList<Type>& values
) const
{
    values.deepCopy(patchNeighbourField()());
}


template<class Type>
template<class Type2>
void Foam::LeesEdwardsFvPatchField<Type>::addBeyond
(
    Field<Type2>& result,
    const bool add,
    const Field<Type2>& internal,
    const scalarField& coeffs
) const
{
    const Field<Type2> values(patch_.beyond(internal));
    const labelUList& cells = patch_.faceCells();

    forAll(cells, i)
    {
        // The coefficients are those of the other side of the equation
        if (add)
        {
            result[cells[i]] -= coeffs[i]*values[i];
        }
        else
        {
            result[cells[i]] += coeffs[i]*values[i];
        }
    }
}


template<class Type>
void Foam::LeesEdwardsFvPatchField<Type>::write(Ostream& os) const
{
    fvPatchField<Type>::write(os);
    this->writeEntry("value", os);
}
