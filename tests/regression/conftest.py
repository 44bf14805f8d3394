# SPDX-License-Identifier: GPL-3.0-or-later
"""Which tests run, and how several processes (pytest-xdist) share them.

Marks:
    nightly     takes long and another test shows nearly the same: run by
                tests/Allrun -nightly only
    fast        refusals and documents: all that tests/Allrun -fast runs
"""

import pytest

import foamCase


def pytest_addoption(parser):
    parser.addoption(
        "--nightly", action="store_true", help="tests marked nightly as well"
    )


def pytest_configure(config):
    for line in (
        "nightly: long, run with --nightly only",
        "fast: refusals and documents",
    ):
        config.addinivalue_line("markers", line)


def shares(item):
    """Has the test something that others of its file need as well?"""
    return any(
        fixture.scope == "module"
        for fixtures in item._fixtureinfo.name2fixturedefs.values()
        for fixture in fixtures
    )


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(config, items):
    if not config.getoption("nightly"):
        nightly = [i for i in items if i.get_closest_marker("nightly")]
        config.hook.pytest_deselected(items=nightly)
        items[:] = [item for item in items if item not in nightly]

    if not config.pluginmanager.hasplugin("xdist"):
        return
    # In one process what is made once per file, and these first: the others
    # fill up the ends
    for item in items:
        if shares(item):
            item.add_marker(pytest.mark.xdist_group(item.path.stem))
    items.sort(key=lambda item: not shares(item))


@pytest.fixture(scope="session", autouse=True)
def one_at_a_time(request, tmp_path_factory):
    """While one of the processes of this run has a solver on several ranks, no
    other one runs any, see foamCase.place_for."""
    if hasattr(request.config, "workerinput"):
        folder = tmp_path_factory.getbasetemp().parent
        foamCase.ranks_lock = folder / "ranks.lock"
