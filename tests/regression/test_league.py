# SPDX-License-Identifier: GPL-3.0-or-later
"""The benchmark `league`: programs that are given or not, its scenes."""

import subprocess
import sys

import numpy as np
import pytest
from leagueCase import BENCHMARKS, CROWD, league, scenes, stand_in
from peers import cans, given
from report import Report
from settlingBox import random_centres

pytestmark = pytest.mark.fast


def test_what_is_given_must_be_executable(tmp_path):
    file = tmp_path/"cans"
    with pytest.raises(given.NotExecutable, match="--cans: .* not exist"):
        given.program("--cans", file)
    file.write_text("")
    message = f"LEAGUE_CANS: '{file}' is not an executable file"
    with pytest.raises(given.NotExecutable, match=message):
        given.program("LEAGUE_CANS", file)
    with pytest.raises(given.NotExecutable, match="not an executable file"):
        given.program("--cans", tmp_path)
    file.chmod(0o755)
    assert given.program("--cans", file) == file


def test_a_wrong_path_stops_the_command(tmp_path):
    done = subprocess.run(
        [sys.executable, BENCHMARKS/"league/benchmark.py", "--cp3d",
         "no/such/file", "--results", tmp_path/"results"],
        capture_output=True, text=True, check=False,
    )
    assert done.returncode == 2
    assert "--cp3d: 'no/such/file' does not exist" in done.stderr
    assert not (tmp_path/"results").exists()


def test_results_go_to_a_folder_that_is_made_first(tmp_path):
    report = Report("league", tmp_path/"new"/"results")
    report.write(draw=lambda rows, file: None)
    assert (tmp_path/"new"/"results"/"league.csv").exists()


def test_results_that_cannot_be_written_stop_the_command(
    tmp_path, monkeypatch, capsys
):
    (tmp_path/"file").write_text("")
    folder = tmp_path/"file"/"results"
    monkeypatch.setattr(sys, "argv", ["benchmark", "--results", str(folder)])
    monkeypatch.setattr(league.shutil, "which", lambda name: "foamRun")
    with pytest.raises(SystemExit) as stopped:
        league.main()
    assert stopped.value.code == 2
    assert f"--results {folder}: Not a directory" in capsys.readouterr().err


def test_what_is_not_given_is_said(tmp_path, capsys):
    program = stand_in(tmp_path, "")
    found = league.programs({"--cans": None, "LEAGUE_CANS": str(program)})
    assert found == [(cans, program)]
    assert capsys.readouterr().out.splitlines() == [
        f"{name} left out: neither --{name.lower()} nor LEAGUE_"
        f"{name.upper()} names its program" for name in ("CP3d", "waLBerla")
    ]


def test_what_a_code_lacks_is_said(tmp_path, capsys):
    assert list(league.rows_of(cans, "crowd", None, tmp_path)) == []
    assert capsys.readouterr().out == "CaNS, crowd: left out, no bodies\n"
    for peer in league.PEERS:
        for task in league.TASKS:
            assert hasattr(peer, task) != (task in peer.MISSING)


def test_a_failed_run_is_a_row(tmp_path, capsys):
    program = stand_in(tmp_path, "print('too hot'); raise SystemExit(3)")
    row, = league.rows_of(
        cans, "fluid", program, tmp_path, scenes.Fluid(8, 4)
    )
    assert (row["solver"], row["quantity"]) == ("CaNS", "diverged at step")
    assert "CaNS ended with code 3:\ntoo hot" in capsys.readouterr().out


def test_compilers_are_read_from_programs(tmp_path):
    file = tmp_path/"program"
    file.write_bytes(
        b"\x7fELF\0GCC: (Debian 12.2.0-14) 12.2.0\0clang version 17.0.1 (x)\0"
        b"GCC: (Debian 12.2.0-14) 12.2.0\0"
    )
    assert given.compiler(file) == "gcc 12.2.0, clang 17.0.1"
    file.write_bytes(b"#!/bin/sh")
    assert given.compiler(file) == "compiler unknown"


def test_programs_keep_the_memory_that_they_free(tmp_path):
    program = stand_in(tmp_path, """
        import os
        for name in ("MMAP_MAX", "TRIM_THRESHOLD"):
            print(name, os.environ[f"MALLOC_{name}_"])
    """)
    assert given.run([program], tmp_path).log.splitlines() == [
        "MMAP_MAX 0", f"TRIM_THRESHOLD {1 << 40}",
    ]


def test_the_start_of_a_program_does_not_count():
    def timed(steps):
        return given.Done(100 + 0.5*steps, "", 0), steps

    step, (_, steps) = given.late_step(timed, 21)
    assert (step, steps) == (pytest.approx(0.5), 21)


def test_crowds_are_clear_of_two_sides():
    scene = scenes.crowd(CROWD, 60, 48, 8, 20)
    y = scene.centres[:, 1]
    assert y.min() > 0.75 and y.max() < scene.side - 0.75
    fine = scenes.crowd(CROWD, 60, 48, 8, 20, refined=2)
    assert (fine.centres == scene.centres).all() and fine.side == scene.side
    assert fine.steps*fine.dt == pytest.approx(scene.steps*scene.dt)
    free = random_centres(200, 8, 0.05, 1)[:, 1]
    assert free.min() < 0.5 and free.max() > 7.5


def test_crowds_are_compared_on_whole_numbers_of_cells():
    assert scenes.fineness(64, 8, 20) == [2, 1, 0.75, 0.5]
    assert scenes.fineness(64, 8, 18) == [2, 1, 0.5]
    assert scenes.fineness(64, 6, 20) == [2, 1]
    coarse = scenes.crowd(CROWD, 60, 48, 8, 20, refined=0.75)
    assert (coarse.box, coarse.cells, coarse.steps) == (36, 6, 15)
    assert coarse.dt == pytest.approx(1/6)


def test_rows_of_a_crowd():
    result = league.Result("crowd", 8, 1000)
    rows = league.crowd_rows(
        result, 0.2, 0.1, np.array([1.0, 3.0]), np.array([1.0, 1.0])
    )
    assert {row["quantity"]: row["value"] for row in rows} == {
        "s per step, second half": 0.2, "ns per cell and step": 2e5,
        "that over one fixed sphere": 2, "mean velocity": 2,
        "rms error of a sphere, %": pytest.approx(100*2**0.5),
    }


def test_choices_of_the_command_line(capsys):
    def chosen(line):
        return league.chosen(league.parse(line.split())[1])

    assert chosen("") == league.Choice()
    assert chosen("--quick") == league.QUICK
    one = chosen("--only crowd --spheres 253 --box 96 --cells 10 --steps 8")
    assert one.tasks == ("crowd",) and one.compared == ()
    assert (one.crowds, one.steps) == (((253, 96, 10),), 8)
    one = chosen("--spheres 148 --box 64 --compare --cases E1 --fluid 32")
    assert (one.crowds, one.compared) == ((), ((148, 64, 8),))
    assert (one.cases, one.fluids) == (("E1",), (32,))
    for wrong in ("--steps 0", "--cases E5", "--only wake"):
        with pytest.raises(SystemExit):
            chosen(wrong)
    assert "argument --steps: 0 is less than 4" in capsys.readouterr().err
