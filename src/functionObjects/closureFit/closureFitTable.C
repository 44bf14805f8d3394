// SPDX-License-Identifier: GPL-3.0-or-later

#include "closureFit.H"

void Foam::functionObjects::closureFit::writeTableHeader(Ostream& os)
{
    writeHeader(os, "Drag and added mass; layer 0 is the whole mesh");
    writeCommented(os, "time[s]");
    os  << tab << "layer" << tab << "position[m]" << tab << "samples"
        << tab << "drag[1/s]" << tab << "errorOf_drag[1/s]"
        << tab << "addedMass[-]" << tab << "errorOf_addedMass[-]"
        << tab << "unexplained[-]" << tab << "bodyFraction";

    for (const char* name : {"interaction_@[m/s2]", "slip_@[m/s]",
        "slipAcceleration_@[m/s2]"})
    {
        for (const char* i : {"x", "y", "z"})
        {
            os  << tab << string(name).replace("@", i).c_str();
        }
    }
    os  << nl;
}


bool Foam::functionObjects::closureFit::write()
{
    if (!writeToFile())
    {
        return true;
    }

    OFstream& os = file();

    if (writesHeader())
    {
        writeTableHeader(os);
    }

    forAll(places_, i)
    {
        const place& one = places_[i];
        const twoTermFit& fit = record_->fit(i);
        const twoTermFit::pair c(fit.coefficients());
        const twoTermFit::pair error(fit.errors());

        writeCurrentTime(os);
        os  << tab << i << tab << one.position << tab << fit.n()
            << tab << c[0] << tab << error[0] << tab << c[1] << tab << error[1]
            << tab << fit.unexplained() << tab << one.phi;

        for (const vector& v : {one.M, one.W, one.A})
        {
            for (const scalar x : v)
            {
                os  << tab << x;
            }
        }
        os  << nl;
    }
    os.flush();

    return true;
}
