# SPDX-License-Identifier: GPL-3.0-or-later
"""Studies: states and draws, runs side by side that are resumed, their table,
zeros and intervals."""

import csv
import math
import os
import signal
import subprocess
import time
from pathlib import Path

import numpy as np
import pytest

from grainfoam.study import analysis, dictionary, entries, states

ROOT = Path(__file__).resolve().parents[2]

TABLE = """printf '# Time\\tspeed[m/s]\\n0\\t0\\n1\\t%s\\n' $STUDY_x >"""
COMMAND = f"mkdir -p postProcessing/run/0; {TABLE} postProcessing/run/0/a.dat"


@pytest.fixture
def case(tmp_path):
    """A case whose runs write one table, at once."""
    for folder in ("0.orig", "constant", "system"):
        (tmp_path/folder).mkdir()
    (tmp_path/"constant/properties").write_text(
        "// a comment\nnu 1;\nmodel\n{\n    speed 2; // [m/s]\n"
        "    twice #calc \"2*$speed\";\n    list (1 (2 3));\n}\nlast $nu;\n")
    return tmp_path


def write(case, text):
    (case/"system/studyDict").write_text(text)


ENVIRONMENT = {**os.environ, "ECHO": "/bin/echo"}


def study(case, *arguments):
    return subprocess.run(
        [ROOT/"bin/grainFoamStudy", *arguments], cwd=case, text=True,
        capture_output=True, check=False, env=ENVIRONMENT)


def table(case):
    with open(case/"postProcessing/study.csv", newline="") as stream:
        return {row["state"]: row for row in csv.DictReader(stream)}


def all_states(case, text):
    write(case, text)
    return states.states(dictionary.read(case/"system/studyDict"))


RUN = f"""
parameters {{ x {{ file constant/properties; entry model/speed;
                   values (3 4.5 6); }} }}
commands ("{COMMAND}" "$ECHO >>$STUDY/runs.$STUDY_x");
results
{{
    speed {{ table run; column speed; }}
    twice {{ expression "2*speed + 0*x"; }}
}}
plots
{{
    speed {{ type curve; x x; y speed; where {{ twice 9; }} }}
    field {{ type quiver; x x; y x; u speed; v twice; }}
    often {{ type histogram; column speed; }}
}}
"""


def test_table(case):
    """Parameters are set, results are read, a picture is drawn."""
    write(case, RUN)
    done = study(case)
    assert done.returncode == 0, done.stderr
    rows = table(case)
    assert [r["x"] for r in rows.values()] == ["3", "4.5", "6"]
    assert float(rows["x4.5"]["twice"]) == 9
    text = (case/"states/x4.5/constant/properties").read_text()
    old = (case/"constant/properties").read_text()
    assert text == old.replace("speed 2;", "speed 4.5;")
    assert (case/"states/x3/log.echo").exists()
    for plot in "speed", "field", "often":
        assert (case/f"plots/{plot}.png").stat().st_size > 5000
    assert "speed: mean 4.5, 95 % of means between" in done.stdout
    write(case, RUN.replace("twice 9;", "twice 8;"))
    assert "no state is as 'where' says" in study(case).stdout


def test_what_is_there_is_not_run(case):
    """More values, another result: only new states run. Another template: all
    do."""
    write(case, RUN)
    study(case)
    write(case, RUN.replace("(3 4.5 6)", "(6 3 9)")
          .replace("2*speed", "3*speed"))
    done = study(case)
    assert "2 of 3 states are there" in done.stdout
    assert float(table(case)["x3"]["twice"]) == 9
    runs = {f.name: f.read_text().count("\n") for f in case.glob("runs.*")}
    assert runs == {"runs.3": 1, "runs.4.5": 1, "runs.6": 1, "runs.9": 1}
    file = case/"constant/properties"
    file.write_text(file.read_text().replace("nu 1", "nu 2"))
    study(case)
    assert (case/"runs.3").read_text().count("\n") == 2


def test_failures(case):
    """A state that fails is named with its command and the reason; the others
    go on; with -retry it is run again."""
    write(case, RUN.replace(
        '"$ECHO', '"echo FOAM FATAL ERROR; echo too fast;'
        ' test $STUDY_x != 4.5 || test -e $STUDY/mended" "$ECHO'))
    done = study(case)
    assert done.returncode == 1
    assert "x4.5 failed: echo: too fast" in done.stderr
    assert [r["status"] == "finished" for r in table(case).values()] \
        == [True, False, True]
    (case/"mended").touch()
    assert study(case).returncode == 1
    assert study(case, "-retry").returncode == 0
    assert (case/"runs.3").read_text().count("\n") == 1


def test_killed(case):
    """Killed in the middle: what was running ends, what has finished stays."""
    text = RUN.replace("(3 4.5 6)", "(1 2 3 4 5 6 7 8)").replace(
        f'"{COMMAND}"', f'"sleep 0.4; {COMMAND}"')
    write(case, text)
    driver = subprocess.Popen(
        [ROOT/"bin/grainFoamStudy", "-jobs", "2"], cwd=case,
        stdout=subprocess.DEVNULL, env=ENVIRONMENT)
    deadline = time.monotonic() + 30
    while len(list(case.glob("states/*/state.json"))) < 3:
        assert time.monotonic() < deadline
        time.sleep(0.02)
    os.kill(driver.pid, signal.SIGKILL)
    driver.wait()
    before = {f: f.read_bytes() for f in case.glob("states/*/state.json")}
    done = study(case, "-jobs", "2")
    assert done.returncode == 0, done.stderr
    assert f"{len(before)} of 8 states are there" in done.stdout
    assert all(f.read_bytes() == text for f, text in before.items())
    assert [float(r["speed"]) for r in table(case).values()] == [*range(1, 9)]
    for file in before:
        run = case/f"runs.{file.parent.name[1:]}"
        assert run.read_text().count("\n") == 1


def test_one_at_a_time(case):
    """A second driver in the same folder is refused."""
    write(case, RUN.replace(f'"{COMMAND}"', f'"sleep 1; {COMMAND}"'))
    first = subprocess.Popen([ROOT/"bin/grainFoamStudy"], cwd=case,
                             stdout=subprocess.DEVNULL, env=ENVIRONMENT)
    while not list(case.glob("states/*/running.json")):
        time.sleep(0.02)
    second = study(case)
    assert second.returncode == 2
    assert "a study is running here" in second.stderr
    assert first.wait() == 0


def test_draws(case):
    """A draw is the same whatever else is drawn; another seed, another draw."""
    text = "parameters {{ a {{ uniform (0 2); }} {more} }} draws {n}; seed {s};"

    def draw(n, s=1, more=""):
        found = all_states(case, text.format(n=n, s=s, more=more))
        return {state.name.split("_")[-1]: state.parameters["a"]
                for state in found}

    few, many = draw(3), draw(300, more="b { values (1 2); }")
    assert all(many[name] == value for name, value in few.items())
    assert draw(3, s=2) != few
    values = np.array(list(many.values()))
    assert abs(values.mean() - 1) < 4*2/np.sqrt(12*300)
    assert 0 < values.min() < values.max() < 2


def test_combinations(case):
    """Products, pairs, ranges."""
    text = "parameters { a { range (0 1 3); } b { logRange (1 100 3); } }"
    assert [s.name for s in all_states(case, text)] == [
        f"a{a}_b{b}" for a in ("0", "0.5", "1") for b in ("1", "10", "100")]
    zipped = all_states(case, text + " combine zip;")
    assert [s.parameters for s in zipped] == [
        {"a": 0, "b": 1}, {"a": 0.5, "b": 10}, {"a": 1, "b": 100}]


def test_groups_of_parameters(case):
    """Values of a group go together, all of one group with all of another."""
    text = ("parameters { a { values (1 2); } b { values (0 5 7); }"
            " c { values (8 9); } } combine ((a c) b);")
    assert [s.name for s in all_states(case, text)] == [
        f"a{a}_b{b}_c{a + 7}" for a in (1, 2) for b in (0, 5, 7)]


def test_where(case):
    """A part of the states: others are run when they are asked for."""
    write(case, RUN + 'where "x > 4";')
    assert study(case, "-where", "x == 3").returncode == 0
    assert list(table(case)) == ["x3"]
    assert study(case).returncode == 0
    assert list(table(case)) == ["x4.5", "x6"]
    write(case, RUN)
    assert "3 of 3 states are there" in study(case).stdout
    assert (case/"runs.3").read_text().count("\n") == 1


@pytest.mark.parametrize("text, message", [
    ("parameter { }", "the nearest valid one is 'parameters'"),
    ("parameters { x { } }", "needs one of values"),
    ("parameters { x { values (1); range (0 1 2); } }", "values and range"),
    ("parameters { x { range (0 1); } }", "takes (first last number)"),
    ("parameters { x { uniform (0 1); } }", "is random"),
    ("parameters { x { logRange (0 1 3); } }", "above zero"),
    ("parameters { x { values (1 1); } }", "the name x1"),
    ("parameters { x { values (1 2); } y { values (1); } } combine zip;",
     "as many values of each"),
    ("parameters { x { values (1); } } combine zipp;", "one of product zip"),
    ("parameters { x { values (1 2); } y { values (1); } } combine ((x y));",
     "as many values of each"),
    ("parameters { x { values (1); } y { values (1); } } combine (x z);",
     "each of these once: x y"),
    ("parameters { x { values (1); } } where \"x > 1\";",
     "no state is as 'where' says"),
    ("parameters { x { values (1); } } where \"z > 1\";",
     "cannot be evaluated"),
    ("parameters { x { file constant/properties; entry nu2; values (1); } }",
     "has no entry 'nu2'"),
    ("parameters { x { file system/none; entry nu; values (1); } }",
     "there is no file"),
    ("parameters { x { values (1); } } copy (nothing);", "there is no"),
    ("parameters { x { values (1); } } set { s { file constant/properties;"
     " entry nu; value \"{y}\"; } }", "'y' cannot be evaluated"),
    ("parameters { x { values (1); } } results { r { column a; } }",
     "needs either 'table'"),
    ("parameters { x { values (1); } } plots { r { type pie; } }",
     "one of curve quiver histogram"),
    ("parameters { x { values (1 2); }", "the file ends"),
    ("parameters { x { values (1 2; } }", "where a value is needed"),
])
def test_refusals(case, text, message):
    write(case, text)
    done = study(case)
    assert done.returncode == 2
    assert message in done.stderr and "studyDict" in done.stderr
    assert not list(case.glob("states/*/state.json"))


def test_entries_are_set_in_the_text():
    """Also after directives, code and other blocks of the same name."""
    text = ('#include "other"\na { b 1; "x|y" { c (1 {2;}); } }\n'
            'f #{ int i; }; #};\ndiv(phi,U) Gauss linear;\na { b 2; }\n')
    assert entries.replaced(text, "a/b", "3") == text.replace("b 2;", "b 3;")
    assert "linear 1;" in entries.replaced(text, "div(phi,U)", "linear 1")
    assert entries.find(text, "a/c") is None
    other = 'a { #include "x"\n}\nb { "x|y" { c 1; } }'
    assert entries.replaced(other, "b/x|y/c", "2").endswith("{ c 2; } }")


def test_zeros():
    """Of a cubic exactly, in whatever order; with their slopes."""
    x = np.array([0.9, -1.1, 0.3, 1.4, -0.4])
    found = analysis.zeros(x, x**3 - x)
    assert [z.x for z in found] == pytest.approx([-1, 0, 1], abs=1e-12)
    assert [z.slope for z in found] == pytest.approx([2, -1, 2], abs=1e-10)
    assert [z.stability for z in found] == ["unstable", "stable", "unstable"]
    assert [z.x for z in analysis.zeros([0, 1, 2], [0, 1, 0])] == [0, 2]


def test_intervals():
    """The mean lies within its 95 % interval in about 95 % of samples; Wilson's
    interval of 1 in 10 is 0.0179 to 0.4042."""
    source = np.random.default_rng(3)
    inside = 0
    for _ in range(200):
        _, low, high = analysis.mean_interval(source.exponential(size=40),
                                              resamples=400)
        inside += low < 1 < high
    assert 175 <= inside <= 198
    inside = 0
    for _ in range(100):
        _, low, high = analysis.interval(
            np.median, source.exponential(size=60), resamples=400)
        inside += low < math.log(2) < high
    assert 85 <= inside <= 100
    inside = 0
    for _ in range(200):
        x, noise = source.normal(size=(2, 40))
        _, low, high = analysis.correlation_interval(x, 0.6*x + 0.8*noise)
        inside += low < 0.6 < high
    assert 180 <= inside <= 198
    assert analysis.share_interval(1, 10) == pytest.approx(
        (0.0179, 0.4042), abs=1e-4)
