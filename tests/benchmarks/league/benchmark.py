# SPDX-License-Identifier: GPL-3.0-or-later
"""A league: grainFoam beside CP3d, waLBerla and CaNS, which the user has built.

On its own, with etc/bashrc sourced:

    benchmark.py --cp3d PATH --walberla PATH --cans PATH
    benchmark.py --cp3d PATH --only crowd --spheres 500 --box 96 --cells 8
"""

import argparse
import math
import os
import shutil
import sys
import tempfile
from pathlib import Path
from typing import NamedTuple

HERE = Path(__file__).resolve().parent
sys.path[:0] = [
    str(HERE), str(HERE.parent), str(HERE.parents[1]/"regression"),
]

import ours  # noqa: E402
import leagueScenes as scenes  # noqa: E402
from measure import Result  # noqa: E402
from peers import cans, cp3d, given, walberla  # noqa: E402
from report import Report  # noqa: E402

PEERS = (cp3d, walberla, cans)


class Choice(NamedTuple):
    """What is run: cases and cells per diameter of ten Cate; crowds (spheres,
    cells per side and per diameter) with a number of steps; those compared,
    on finer and coarser cells, with ours on the finest; sides of the box of
    fluid alone."""

    cases: tuple = ("E1", "E2", "E3", "E4")
    cells: int = 10
    crowds: tuple = ((500, 96, 8),)
    steps: int = 20
    compared: tuple = ((148, 64, 8),)
    fluids: tuple = (64, 128)
    tasks: tuple = ("tenCate", "crowd", "fluid")
    quick: bool = False


QUICK = Choice(
    ("E4",), 8, ((62, 48, 8),), compared=(), fluids=(64,), quick=True
)


def programs(paths):
    """(peer, path of its program) of those that are given; a line for each of
    the others. paths: by name of the option or variable."""
    found = []
    for peer in PEERS:
        option = f"--{peer.SOLVER.lower()}"
        name = option if paths.get(option) else peer.VARIABLE
        if paths.get(name):
            found.append((peer, given.program(name, paths[name])))
        else:
            print(
                f"{peer.SOLVER} left out: neither {option} nor "
                f"{peer.VARIABLE} names its program", flush=True,
            )
    return found


def rows_of(peer, task, *arguments):
    """What a peer yields for a task; a line if it cannot, and a row
    "diverged" if its run failed."""
    if not hasattr(peer, task):
        print(f"{peer.SOLVER}, {task}: left out, {peer.MISSING[task]}")
        return
    try:
        yield from getattr(peer, task)(*arguments)
    except given.PeerError as error:
        print(error, flush=True)
        yield Result(task, None, None, solver=peer.SOLVER).diverged()


def tenCate(folder, players, choice):
    """A sphere in a closed box."""
    module = Report.load(HERE.parent/"tenCate")
    for name in choice.cases:
        scene = scenes.settling(module, name, choice.cells)
        for peer, program in players:
            yield from rows_of(
                peer, "tenCate", program, folder, scene, choice.quick
            )


def crowd_rows(result, step, one, speed, reference=None):
    """Of a crowd; reference: velocities of the same spheres."""
    yield result.row("s per step, second half", step)
    yield result.row("ns per cell and step", 1e9*step/result.cells)
    yield result.row("that over one fixed sphere", step/one)
    mean = None if reference is None else reference.mean()
    yield result.row("mean velocity", speed.mean(), mean)
    if reference is not None:
        error = math.sqrt(((speed - reference)**2).mean())
        yield result.row("rms error of a sphere, %", 100*error/abs(mean))


def crowd(folder, players, choice):
    """Spheres that begin to settle in a periodic cube."""
    module = Report.load(HERE.parent/"crowd")
    for size in (*choice.crowds, *choice.compared):
        number, *mesh = size
        reference = None
        compared = size in choice.compared
        meshes = scenes.fineness(*mesh, choice.steps) if compared else [1]
        for refined in meshes:
            scene = scenes.crowd(module, *size, choice.steps, refined)
            fixed = scenes.crowd(module, 1, *mesh, 10, refined)
            for peer, program in players:
                for found in rows_of(
                    peer, "crowd", program, folder, scene, fixed
                ):
                    if isinstance(found, dict):
                        yield found
                        continue
                    yield from crowd_rows(*found, reference)
                    if compared and refined == meshes[0] and peer is ours:
                        reference = found[-1]


def fluid(folder, players, choice):
    """Vortices in a closed box."""
    for n in choice.fluids:
        scene = scenes.Fluid(n, choice.steps)
        for peer, program in players:
            yield from rows_of(peer, "fluid", program, folder, scene)


TASKS = {"tenCate": tenCate, "crowd": crowd, "fluid": fluid}


def league(folder, peers, choice):
    """All rows; peers: as of programs()."""
    players = [(ours, shutil.which("foamRun")), *peers]
    for peer, program in players:
        yield Result(
            f"{given.machine()}; {given.compiler(program)}", None, None,
            solver=peer.SOLVER,
        ).row("machine, compiler", None)
    for task in choice.tasks:
        yield from TASKS[task](folder, players, choice)


def rows(folder, quick):
    peers = programs(os.environ)
    if not peers:
        print("nothing to compare with")
        return
    yield from league(folder, peers, QUICK if quick else Choice())


def at_least(least):
    """A type of an argument: an integer."""
    def number(text):
        if int(text) < least:
            raise argparse.ArgumentTypeError(f"{text} is less than {least}")
        return int(text)

    return number


def parse(words=None):
    """The parser and what it makes of a command line."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    for peer in PEERS:
        parser.add_argument(
            f"--{peer.SOLVER.lower()}", metavar="PATH",
            help=f"its program; or the variable {peer.VARIABLE}",
        )
    parser.add_argument("--quick", action="store_true", help="coarse only")
    parser.add_argument("--only", nargs="+", choices=TASKS)
    parser.add_argument("--cases", nargs="+", choices=Choice().cases)
    parser.add_argument("--cells", type=at_least(4), help="per diameter")
    parser.add_argument(
        "--spheres", type=at_least(1), help="of the one crowd"
    )
    parser.add_argument(
        "--box", type=at_least(16), default=96, help="its cells per side"
    )
    parser.add_argument("--steps", type=at_least(4), default=20)
    parser.add_argument(
        "--compare", action="store_true",
        help="the crowd on finer and coarser cells with ours on the finest",
    )
    parser.add_argument("--fluid", type=at_least(8), nargs="+", metavar="N")
    parser.add_argument("--results", default=HERE.parent/"results")
    return parser, parser.parse_args(words)


def chosen(args):
    """The choice of a command line."""
    choice = QUICK if args.quick else Choice()
    changes = {
        "tasks": args.only, "cases": args.cases, "cells": args.cells,
        "fluids": args.fluid, "steps": args.steps,
    }
    if args.spheres:
        crowds = ((args.spheres, args.box, args.cells or 8),)
        changes.update(
            crowds=() if args.compare else crowds,
            compared=crowds if args.compare else (),
        )
    return choice._replace(**{
        key: tuple(value) if isinstance(value, list) else value
        for key, value in changes.items() if value is not None
    })


def main():
    parser, args = parse()
    paths = dict(os.environ)
    paths.update({
        f"--{peer.SOLVER.lower()}": getattr(args, peer.SOLVER.lower())
        for peer in PEERS
    })
    try:
        peers = programs(paths)
    except given.NotExecutable as error:
        parser.error(str(error))
    if not shutil.which("foamRun"):
        parser.error("foamRun is not on PATH: source etc/bashrc first")
    try:
        report = Report("league", Path(args.results))
    except OSError as error:
        parser.error(f"--results {args.results}: {error.strerror}")
    with tempfile.TemporaryDirectory() as scratch:
        try:
            for row in league(Path(scratch), peers, chosen(args)):
                report.add(row)
        finally:
            report.write()
    return 1 if report.diverged() else 0


if __name__ == "__main__":
    sys.exit(main())
