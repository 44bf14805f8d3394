// SPDX-License-Identifier: GPL-3.0-or-later

#include "stokesTable.H"
#include "compat.H"
#include "OSspecific.H"
#include "Time.H"

namespace
{
    const char axes[] = "xyz";

    //- Digits of numbers in the table
    const int precision = 12;
}


Foam::word Foam::stokesTable::name(const label mode) const
{
    const rigidMotion motion(bodies_.motion(mode));
    word name;

    for (direction cmpt = 0; cmpt < 3; ++cmpt)
    {
        if (motion.U[cmpt] > 0)
        {
            name = word(std::string(1, axes[cmpt]));
        }
        if (motion.omega[cmpt] > 0)
        {
            name = word(std::string("r") + axes[cmpt]);
        }
    }

    return name + Foam::name(motion.body);
}


Foam::string Foam::stokesTable::header() const
{
    const label n = bodies_.nModes();
    string line("# state");

    const auto add = [&](const std::string& column)
    {
        line += "\t" + column;
    };

    for (label bodyi = 0; bodyi < bodies_.size(); ++bodyi)
    {
        for (const char* kind : {"p", "a"})
        {
            for (label i = 0; i < 3 && (*kind == 'p' || states_.turned()); ++i)
            {
                add
                (
                    kind + std::string(1, axes[i]) + Foam::name(bodyi)
                  + (*kind == 'p' ? "[m]" : "[rad]")
                );
            }
        }
    }

    for (const char* quantity : {"V", "V1", "B", "C"})
    {
        for (label i = 0; i < n; ++i)
        {
            add(quantity + ("_" + name(i)));
        }
    }
    for (label i = 0; i < n; ++i)
    {
        for (label j = 0; j < n; ++j)
        {
            add("A_" + name(i) + "_" + name(j));
        }
    }
    add("asymmetry");
    add("leastEigenvalue");
    add("residual");

    return line;
}


Foam::scalarList Foam::stokesTable::poses(const label state) const
{
    DynamicList<scalar> poses;

    forAll(states_.positions(state), bodyi)
    {
        for (direction i = 0; i < 3; ++i)
        {
            poses.append(states_.positions(state)[bodyi][i]);
        }
        for (direction i = 0; i < 3 && states_.turned(); ++i)
        {
            poses.append(states_.angles(state)[bodyi][i]);
        }
    }

    return scalarList(std::move(poses));
}


Foam::stokesTable::stokesTable
(
    const stokesBodies& bodies,
    const stokesStates& states
)
:
    bodies_(bodies),
    states_(states),
    file_
    (
        bodies.mesh().time().globalPath()/"postProcessing/stokesModes"
       /bodies.mesh().time().timeName()/"stokesModes.dat"
    )
{
    if (Pstream::master())
    {
        DynamicList<string> lines;

        if (isFile(file_))
        {
            lines = read();
        }
        if (lines.empty())
        {
            lines.append(header());
        }

        // A row that was not written to its end is left out
        mkDir(file_.path());
        os_.reset(new OFstream(file_));

        for (const string& line : lines)
        {
            os_() << line.c_str() << nl;
        }
        os_().flush();
    }

    // What the master has read
    List<scalarList> rows;
    DynamicList<label> numbers;

    for (const auto& row : rows_)
    {
        numbers.append(row.first);
        rows.append(row.second);
    }
    labelList known(numbers);
    compat::broadcast(known);
    compat::broadcast(rows);

    forAll(known, i)
    {
        rows_[known[i]] = rows[i];
    }
    nFound_ = known.size();
}


Foam::scalarList Foam::stokesTable::row(const stokesModes& modes) const
{
    const label n = bodies_.nModes();
    DynamicList<scalar> values;

    values.append(modes.V);
    values.append(modes.V1);
    values.append(modes.B);
    values.append(modes.C);

    for (label i = 0; i < n*n; ++i)
    {
        values.append(modes.A.v()[i]);
    }
    values.append(modes.asymmetry);
    values.append(modes.eigenvalues[0]);
    values.append(modes.residual);

    return scalarList(std::move(values));
}


void Foam::stokesTable::write(const label state, const scalarList& row)
{
    const label n = bodies_.nModes();

    rows_[state] = row.size()
      ? row
      : scalarList(4*n + n*n + 3, std::numeric_limits<scalar>::quiet_NaN());

    if (!Pstream::master())
    {
        return;
    }

    std::ostream& os = os_().stdStream();

    os.precision(precision);
    os << state;

    for (const scalar value : poses(state))
    {
        os << '\t' << value;
    }
    for (const scalar value : rows_[state])
    {
        os << '\t' << value;
    }
    os << std::endl;
}


void Foam::stokesTable::print(const stokesModes& modes, Ostream& os) const
{
    const label n = bodies_.nModes();

    os  << "    mode  V  V1  B  C  rows of A" << nl;

    for (label i = 0; i < n; ++i)
    {
        os  << "    " << name(i) << "  " << modes.V[i] << "  " << modes.V1[i]
            << "  " << modes.B[i] << "  " << modes.C[i] << " ";

        for (label j = 0; j < n; ++j)
        {
            os  << ' ' << modes.A(i, j);
        }
        os  << nl;
    }

    os  << "    eigenvalues of A " << flatOutput(modes.eigenvalues)
        << ", largest |A - A^T| " << modes.asymmetry << nl
        << "    mobility " << flatOutput(UList<scalar>
           (
               const_cast<scalar*>(modes.mobility.v()), n*n
           ))
        << nl;
}
