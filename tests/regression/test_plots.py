# SPDX-License-Identifier: GPL-3.0-or-later
"""The pictures of the tutorials, from tables that are written here."""

import sys
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT/"tutorials/plotting"))

import animate
import grainPlots
import sensorPlots
import suspensionPlots

PASSAGES = (
    "# time[s]\tplane\tbody\taxial[m/s]\tradius[m]\n"
    "1\t0\t0\t2\t0.1\n2\t0\t1\t1\t0.6\n"
)
SUMMARY = "# Passages\n# plane\tgrains\tname\n0\t6\tlow\n"

# Grains, mean speed, deviation and density over the mean of five parts
PARTS = ((2, 2, 0.1, 0.9), (1, 1.9, "nan", 0.2), (3, 1.7, 0.2, 0.7),
         (0, "nan", "nan", 0), (9, 1, 0.1, 3))
RADII = (
    "# Grains\n# plane\tinner[m]\touter[m]\tgrains\tmeanSpeed[m/s]"
    "\tdeviation[m/s]\tdensityOverMean\n"
    + "".join(f"0\t{i/5}\t{(i + 1)/5}\t" + "\t".join(map(str, part)) + "\n"
              for i, part in enumerate(PARTS))
)
NONE = "# Times\n# plane\tfrom\tto\tnumber\n"


@pytest.fixture
def case(tmp_path):
    for path, text in (
        ("0/passages", PASSAGES), ("2/summary", SUMMARY), ("2/radii", RADII),
        ("2/intervals", NONE),
    ):
        file = tmp_path/f"postProcessing/sensor/{path}.dat"
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
    return tmp_path


@pytest.fixture
def drawn(monkeypatch):
    """The figures in place of their files."""
    figures = []
    monkeypatch.setattr(
        grainPlots, "save", lambda figure, file: figures.append(figure))
    return figures


def bars(ax):
    """Middle and half length of the error bars of a picture."""
    (container,) = ax.containers
    (lines,) = container.lines[2]
    ends = np.array([bar[:, 1] for bar in lines.get_segments() if len(bar)])
    return ends.mean(axis=1), np.ptp(ends, axis=1)/2


def legend_is_clear(figure):
    """No picture is under the legend."""
    figure.draw_without_rendering()
    (legend,) = figure.legends
    box = legend.get_window_extent()
    return not any(box.overlaps(ax.get_window_extent()) for ax in figure.axes)


def test_a_part_with_one_grain_has_no_mean(case, drawn):
    sensorPlots.speedAgainstRadius(case, case/"speed.png")
    grains, mean = drawn[0].axes[0].lines[:2]
    assert len(grains.get_xdata()) == 2
    assert list(np.isnan(mean.get_ydata())) == [
        False, True, False, True, False]
    assert legend_is_clear(drawn[0])


def test_density_has_its_counting_error(case, drawn):
    sensorPlots.radialDensity(case, case/"density.png")
    middle, half = bars(drawn[0].axes[0])
    assert middle == pytest.approx([0.9, 0.2, 0.7, 3])
    assert half == pytest.approx([0.9/2**0.5, 0.2, 0.7/3**0.5, 1])
    assert legend_is_clear(drawn[0])


@pytest.mark.parametrize("way, depth, axes", [
    # A sphere that falls, one in a tube, and discs in a plane
    ((0.01, 0.02, -5), 1, (0, 2)), ((9, 0.2, 0.1), 1, (0, 2)),
    ((0, -5, 0), 0, (0, 1)), ((5, 0, 0), 0, (0, 1)),
    # No surfaces were written
    ((0.01, 0.02, -5), None, (0, 2)), ((0, -5, 0), None, (0, 1)),
])
def test_an_animation_without_a_plane_is_seen_from_the_side(way, depth, axes):
    grain = {f"position_{c}": np.linspace(0, end, 5)
             for c, end in zip("xyz", way)}
    surface = None if depth is None else np.array(
        [(x, y, z*depth) for x in (0, 1) for y in (0, 1) for z in (0, 1)])
    assert animate.longestAxes({"one": grain}, {"one": surface}) == axes


def test_tables_of_a_run_after_a_check_are_found(case):
    """`foamRun -check` has left the first table empty."""
    folder = case/"postProcessing/sensor/0"
    (folder/"passages.dat").rename(folder/"passages_0.dat")
    (folder/"passages.dat").write_text("# Planes\n")
    sensorPlots.drawAll(case)
    assert (case/"plots/sensorSpeed.png").exists()


def stress_tables(case):
    """Tables of two function objects, as they are written."""
    columns = ["viscosity[m2/s]", "contacts", "largestCluster"]
    parts = [f"{part}_xy[m2/s2]" for part in suspensionPlots.PARTS]
    layers = ["position[m]", "bodyFraction", "UFluid_x[m/s]", "UFluid_y[m/s]",
              "UFluid_z[m/s]", "UBodies_x[m/s]"]
    closure = ["drag[1/s]", "errorOf_drag[1/s]", "addedMass[-]",
               "errorOf_addedMass[-]"]
    closure += [f"{name}_{i}[m/s]" for i in "xyz"
                for name in ("interaction", "slip", "slipAcceleration")]
    closure += ["bodyFraction"]
    for path, names, rows in (
        ("stress/0/suspensionStress", [*columns, *parts],
         [[1, 0.6, 2, 3, 0.5, 0.1, 0, 0, 0, 0],
          [2, 0.7, 1, 2, 0.5, 0.2, 0, 0.1, 0, 0]]),
        ("stress/0/suspensionStressMeans",
         ["viscosity[m2/s]", "errorOf_viscosity[m2/s]"],
         [[1, 0.6, "nan"], [2, 0.65, 0.05]]),
        ("averages/0/bodyAverages", layers,
         [[2, -0.5, 0.1, -1, 0, 0, -0.9], [2, 0.5, 0, 1, 0, 0, "nan"]]),
        ("fit/0/closureFit", ["layer", *closure],
         [[time, layer, *values] for time, values in (
             (1, ["nan"]*13 + [0.2]),
             (2, [5, 0.1, 0.5, "nan", 2, 3, 4, 1, 1, 0, 1, 2, 0, 0.2]),
          ) for layer in (0, 1)]),
    ):
        file = case/f"postProcessing/{path}.dat"
        file.parent.mkdir(parents=True, exist_ok=True)
        lines = ["# Title", "\t".join(["# time[s]", *names])]
        lines += ["\t".join(map(str, row)) for row in rows]
        file.write_text("\n".join(lines) + "\n")


def test_parts_of_the_stress_that_are_zero_are_left_out(tmp_path, drawn):
    stress_tables(tmp_path)
    suspensionPlots.parts(tmp_path, None, "stress")
    labels = [line.get_label() for line in drawn[0].axes[0].lines]
    assert labels == ["fluid", "particle", "contact"]


def test_the_fit_is_the_sum_of_drag_and_added_mass(tmp_path, drawn):
    stress_tables(tmp_path)
    suspensionPlots.closure(tmp_path, None, "fit")
    lines = {line.get_label(): line.get_ydata()[-1]
             for line in drawn[0].axes[2].lines}
    assert lines == pytest.approx(
        {"force": 2, "drag": 5*3, "added mass": 0.5*0.2*4, "fit": 15.4})


def test_pictures_of_a_suspension(tmp_path):
    stress_tables(tmp_path)
    suspensionPlots.drawAll(tmp_path, "stress", "averages", "fit")
    assert {file.stem for file in (tmp_path/"plots").iterdir()} == {
        f"suspension{name}"
        for name in (
            "Viscosity", "Parts", "Contacts", "Profiles", "Closure")
    }
