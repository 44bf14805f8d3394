// SPDX-License-Identifier: GPL-3.0-or-later

#include "testTools.H"
#include "checkKeywords.H"

using namespace Foam;
using testTools::dict;
using testTools::messageOf;
using Catch::Matchers::Contains;

TEST_CASE("nearest takes the fewest edits", "[keywords]")
{
    const wordList valid({"density", "densityRatio", "velocity", "shape"});

    CHECK(keywords::nearest("desnity", valid) == "density");
    CHECK(keywords::nearest("densityratio", valid) == "densityRatio");
    CHECK(keywords::nearest("velocities", valid) == "velocity");
    CHECK(keywords::nearest("sape", valid) == "shape");
    CHECK(keywords::nearest("shape", valid) == "shape");
    CHECK(keywords::nearest("anything", wordList()) == "");

    // kitten -> sitting takes 3 edits, kitten -> mitt takes 3: first one wins;
    // kitten -> bitten takes one
    CHECK(keywords::nearest("kitten", {"sitting", "mitt"}) == "sitting");
    CHECK(keywords::nearest("kitten", {"sitting", "bitten"}) == "bitten");
}


TEST_CASE("check refuses unknown keywords", "[keywords]")
{
    const wordList valid({"type", "radius"});

    CHECK_NOTHROW(keywords::check(dict("type disc; radius 1;"), valid));
    CHECK_NOTHROW(keywords::check(dict(""), valid));
    CHECK_NOTHROW(keywords::check(dict("FoamFile { version 2; }"), valid));

    const std::string message = messageOf
    (
        [&]{ keywords::check(dict("type disc; raduis 1;"), valid); }
    );

    CHECK_THAT(message, Contains("'raduis'"));
    CHECK_THAT(message, Contains("nearest valid one is 'radius'"));
    CHECK_THAT(message, Contains("type radius"));
}


TEST_CASE("choice gives the value, the default, or an error", "[keywords]")
{
    const wordList valid({"none", "softSphere"});

    CHECK(keywords::choice(dict("t softSphere;"), "t", valid, "none")
        == "softSphere");
    CHECK(keywords::choice(dict(""), "t", valid, "none") == "none");

    const std::string message = messageOf
    (
        [&]{ keywords::choice(dict("t softsphere;"), "t", valid, "none"); }
    );

    CHECK_THAT(message, Contains("'t softsphere'"));
    CHECK_THAT(message, Contains("nearest valid one is 'softSphere'"));
    CHECK_THAT(message, Contains("none softSphere"));
}


TEST_CASE("positive numbers are those above zero", "[keywords]")
{
    CHECK(keywords::positive(dict("rho 0.5;"), "rho") == 0.5);
    CHECK(keywords::positiveOr(dict("rho 0.5;"), "rho", 2) == 0.5);
    CHECK(keywords::positiveOr(dict(""), "rho", 2) == 2);

    for (const std::string value : {"0", "-1", "-1e-300"})
    {
        const dictionary d(dict("rho " + value + ";"));

        CHECK_THAT
        (
            messageOf([&]{ keywords::positive(d, "rho"); }),
            Contains("'rho ") && Contains("greater than 0")
        );
        CHECK_THAT
        (
            messageOf([&]{ keywords::positiveOr(d, "rho", 2); }),
            Contains("greater than 0")
        );
    }

    CHECK_THAT
    (
        messageOf([&]{ keywords::positive(dict(""), "rho"); }),
        Contains("no entry 'rho'")
    );
    CHECK_THAT
    (
        messageOf([&]{ keywords::positive(dict("roh 1; g 2;"), "rho"); }),
        Contains("nearest there is 'roh'")
    );
}
