// SPDX-License-Identifier: GPL-3.0-or-later

#include "LeesEdwardsFvPatchFields.H"
#include "addToRunTimeSelectionTable.H"
#include "volFields.H"

namespace Foam
{
    makePatchFields(LeesEdwards);
}
