// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluidChoice.H"
#include "testTools.H"

using namespace Foam;
using Catch::Matchers::Contains;
using testTools::dict;
using testTools::messageOf;

TEST_CASE("How the fluid is solved for", "[fluidChoice]")
{
    const fluidChoice usual(dict(""));

    CHECK(!usual.frozen());
    CHECK(!usual.projected());
    CHECK(!usual.dense());
    CHECK(usual.minVoid() == 0.3);

    CHECK(fluidChoice(dict("fluid frozen;")).frozen());
    CHECK(fluidChoice(dict("fluid projected;")).projected());

    const fluidChoice dense
    (
        dict("type unresolved; voidFraction yes; minVoidFraction 0.2;")
    );

    CHECK(dense.dense());
    CHECK(dense.minVoid() == 0.2);
}


TEST_CASE("Wrong choices of the fluid are refused", "[fluidChoice]")
{
    const auto refusal = [](const std::string& entries)
    {
        return messageOf([&]{ fluidChoice(dict(entries)); });
    };
    const std::string dense("voidFraction yes; type unresolved; ");

    CHECK(refusal(dense) == "");
    CHECK_THAT(refusal("voidFraction yes;"),
        Contains("needs 'type unresolved'") && Contains("'resolved'"));
    CHECK_THAT(refusal(dense + "fluid frozen;"),
        Contains("needs 'fluid solved'") && Contains("'frozen'"));
    CHECK_THAT(refusal(dense + "minVoidFraction 1;"),
        Contains("must be less than 1"));
    CHECK_THAT(refusal("fluid still;"),
        Contains("'fluid still'") && Contains("projected"));
}
