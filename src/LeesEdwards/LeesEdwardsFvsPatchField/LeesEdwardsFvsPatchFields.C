// SPDX-License-Identifier: GPL-3.0-or-later

#include "LeesEdwardsFvsPatchField.H"
#include "addToRunTimeSelectionTable.H"
#include "fieldTypes.H"
#include "fvsPatchFields.H"

namespace Foam
{
    makeFvsPatchTypeFieldTypedefs(LeesEdwards);

    makeFvsPatchFields(LeesEdwards);
}
