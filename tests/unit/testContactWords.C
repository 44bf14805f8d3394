// SPDX-License-Identifier: GPL-3.0-or-later

#include "addToRunTimeSelectionTable.H"
#include "contactTools.H"
#include "springDashpot.H"

using namespace Foam;
using Catch::Contains;
using contactTools::Scene;

namespace
{

//- A law with a word that softSphere reads from the same dictionary
class greedyLaw
:
    public contactLaws::springDashpot
{
public:

    TypeName("greedy");

    greedyLaw(const dictionary& dict, const scalar rho)
    :
        springDashpot(dict, rho)
    {}

    virtual wordList keywords() const
    {
        return wordList({"subSteps"});
    }
};

defineTypeNameAndDebug(greedyLaw, 0);
addToRunTimeSelectionTable(contactLaw, greedyLaw, dictionary);

} // End anonymous namespace


TEST_CASE("A law does not share words with softSphere", "[contact]")
{
    const std::string message
    (
        testTools::messageOf([]{ Scene scene("law greedy;"); })
    );

    CHECK_THAT(message, Contains("'greedy'") && Contains("'subSteps'"));
    CHECK_THAT(message, Contains("largestOverlap"));
}
