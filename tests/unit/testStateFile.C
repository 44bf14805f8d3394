// SPDX-License-Identifier: GPL-3.0-or-later

#include "testTools.H"
#include "compat.H"
#include "OSspecific.H"
#include "stateFile.H"
#include "Time.H"
#include "uniformState.H"
#include <fstream>

using namespace Foam;
using testTools::dict;
using Catch::Matchers::Contains;

namespace
{

const label nThings = 2300;


//- Write a file with as many entries in its last block, which the master reads
//  for all
void writeFile(const fileName& folder, const label n)
{
    if (!Pstream::master())
    {
        return;
    }

    mkDir(folder);
    std::ofstream os(folder/"things");

    os  << "FoamFile { version 2.0; format ascii; class things; object things;"
        << " }\ntotal 0.1; rules { first (1 2 3); }\nthings\n{\n";
    for (label i = 0; i < n; ++i)
    {
        os  << "thing" << i << " { number " << i << "; size 0.1; }\n";
    }
    os  << "}\n";
}


//- Numbers of all that is read, part by part; and the largest of these
labelList numbersIn(stateFile& file, label& largest)
{
    labelList numbers;
    dictionary part;

    largest = 0;
    while (file.next(part))
    {
        largest = max(largest, part.size());
        for (const entry& e : part)
        {
            numbers.append(e.dict().get<label>("number"));
            CHECK(e.dict().get<scalar>("size") == 0.1);
            CHECK_THAT(e.dict().name(), Contains("uniform/things.thing"));
        }
    }

    return numbers;
}

} // End anonymous namespace


TEST_CASE("A state is read in parts by all ranks", "[stateFile]")
{
    label id = pid();

    compat::broadcast(id);

    const fileName root("/tmp"), name("stateFile" + Foam::name(id));
    const Time time(dict("deltaT 1; writeFrequency 1;"), root, name);
    const fileName folder(time.path()/time.timeName()/"uniform");
    const label n = GENERATE(0, 1, 1000, nThings);

    CHECK(!uniformState::found(time, "things"));
    writeFile(folder, n);
    REQUIRE(uniformState::found(time, "things"));

    stateFile file(time, "things", "things");
    label largest = 0;

    CHECK(file.top().get<scalar>("total") == 0.1);
    CHECK
    (
        file.top().subDict("rules").get<vector>("first") == vector(1, 2, 3)
    );
    CHECK(!file.top().found("things"));
    CHECK(numbersIn(file, largest) == identity(n));
    CHECK((largest < nThings/2 || n == 0));

    // All have opened it
    if (returnReduce(true, andOp<bool>()) && Pstream::master())
    {
        rmDir(root/name);
    }
}
