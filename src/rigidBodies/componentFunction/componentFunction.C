// SPDX-License-Identifier: GPL-3.0-or-later

#include "componentFunction.H"

Foam::componentFunction::componentFunction
(
    const dictionary& dict,
    const word& key,
    const vector& allowed,
    const string& reason
)
:
    dict_(dict),
    key_(key),
    allowed_(allowed),
    reason_(reason)
{
    if (dict_.found(key))
    {
        function_ = Function1<vector>::New(key, dict_);
    }
}


Foam::vector Foam::componentFunction::value(const scalar t) const
{
    if (!given())
    {
        return Zero;
    }

    const vector v(function_->value(t));

    if (magSqr(v - cmptMultiply(v, allowed_)) > 0)
    {
        std::string components;

        for (direction i = 0; i < 3; ++i)
        {
            components += std::string(i ? " " : "")
              + (allowed_[i] > 0 ? vector::componentNames[i] : "0");
        }

        FatalIOErrorInFunction(dict_)
            << "'" << key_ << "' in '" << dict_.dictName() << "' is " << v
            << " at time " << t << " and " << reason_.c_str()
            << "; allowed is (" << components.c_str() << ')' << nl
            << exit(FatalIOError);
    }

    return v;
}
