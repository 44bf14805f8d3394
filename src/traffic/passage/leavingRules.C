// SPDX-License-Identifier: GPL-3.0-or-later

#include "leavingRules.H"
#include "checkKeywords.H"
#include "wallPolyPatch.H"

Foam::leavingRules::leavingRules
(
    const dictionary& dict,
    const polyMesh& mesh
)
:
    rules_
    (
        mesh.boundaryMesh().size(),
        rule{action::stop, false, Zero, false}
    ),
    active_(false)
{
    checkPatches(dict, mesh.boundaryMesh());

    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        const bool own = dict.found(patch.name(), keyType::REGEX);

        if (open(patch) && (own || dict.found("default")))
        {
            rule& r = rules_[patch.index()];

            r = read
            (
                own
              ? dict.subDict(patch.name(), keyType::REGEX)
              : dict.subDict("default")
            );
            active_ = active_ || r.what != action::stop;
            checkPlace(r, dict, mesh.bounds());
        }
    }
}


void Foam::leavingRules::checkPlace
(
    const rule& r,
    const dictionary& dict,
    const boundBox& bounds
)
{
    const bool outside =
        r.shifted
      ? cmptMax(cmptMag(r.to) - bounds.span()) > 0
      : !bounds.contains(r.to);

    if (r.what == action::reinject && outside)
    {
        FatalIOErrorInFunction(dict)
            << "'" << (r.shifted ? "shift " : "position ") << r.to
            << "' of 'type reinject' in '" << dict.dictName()
            << "' leads out of the mesh, whose bounds are " << bounds << nl
            << exit(FatalIOError);
    }
}


bool Foam::leavingRules::open(const polyPatch& patch)
{
    return
        !isA<wallPolyPatch>(patch)
     && !patch.coupled()
     && !polyPatch::constraintType(patch.type());
}


void Foam::leavingRules::checkPatches
(
    const dictionary& dict,
    const polyBoundaryMesh& patches
)
{
    wordList names({"default"});
    dictionary plain(dict);

    for (const polyPatch& patch : patches)
    {
        if (open(patch))
        {
            names.append(patch.name());
        }
    }

    for (const entry& e : dict)
    {
        if (!e.isDict())
        {
            FatalIOErrorInFunction(dict)
                << "'" << e.keyword() << "' in '" << dict.dictName()
                << "' must be a dictionary such as '{ type remove; }'" << nl
                << exit(FatalIOError);
        }
        if (!e.keyword().isPattern())
        {
            continue;
        }

        plain.remove(e.keyword());
        bool met = false;

        for (const word& name : names)
        {
            met = met || e.keyword().match(name);
        }

        if (!met)
        {
            FatalIOErrorInFunction(dict)
                << "\"" << e.keyword() << "\" in '" << dict.dictName()
                << "' matches no patch that bodies can leave through: "
                << flatOutput(names) << nl << exit(FatalIOError);
        }
    }

    keywords::check(plain, names);
}


Foam::leavingRules::rule Foam::leavingRules::read(const dictionary& dict)
{
    const word type
    (
        keywords::choice
        (
            dict, "type", {"stop", "remove", "hold", "reinject"}, word::null
        )
    );

    if (type != "reinject")
    {
        keywords::check(dict, {"type"});

        return rule
        {
            type == "stop" ? action::stop
          : type == "hold" ? action::hold
          : action::remove,
            false, Zero, false
        };
    }

    keywords::check(dict, {"type", "shift", "position", "velocity"});
    const bool shifted = dict.found("shift");

    if (shifted == dict.found("position"))
    {
        FatalIOErrorInFunction(dict)
            << "'type reinject' in '" << dict.dictName() << "' needs exactly"
            << " one of 'shift' and 'position'" << nl << exit(FatalIOError);
    }

    return rule
    {
        action::reinject,
        shifted,
        dict.get<vector>(shifted ? "shift" : "position"),
        keywords::choice(dict, "velocity", {"keep", "ambient"}, "keep")
     == "ambient"
    };
}
