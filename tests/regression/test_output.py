# SPDX-License-Identifier: GPL-3.0-or-later
"""What a run with bodies writes."""

import json
import re
from xml.etree import ElementTree

import numpy as np
import pytest

from bodyCase import BodyCase
from boxMesh import uniform

BODIES = """
    grain
    {
        shape       { type disc; radius 0.25; }
        density     2.4;
        position    (-0.53 -0.3 0);
        velocity    ambient;
    }
    post
    {
        shape       { type disc; radius 0.2; }
        positions   ((0.1 0.3 0) (1.13 0.21 0));
        constraints { translate (0 0 0); rotate (0 0 0); }
    }
"""
COUPLING = "coupling { tolerance 1e-4; nOuterCorrectors 30; }"
SURFACES = """functions
{
    surfaces
    {
        type            immersedBodySurfaces;
        libs            (immersedBodyFunctionObjects);
        writeControl    writeTime;
    }"""

N_BODIES, N_STEPS, N_WRITTEN = 3, 6, 3
RADII = [0.25, 0.2, 0.2]


@pytest.fixture(scope="module")
def meshed(tmp_path_factory):
    """Three discs of ten and eight cells per diameter; fluid of 1.2 kg/m3."""
    case = BodyCase("tube", tmp_path_factory.mktemp("output"))
    case.mesh(uniform(-3, 3, 120), uniform(-1, 1, 40))
    case.bodies(BODIES, f"rho 1.2; {COUPLING}")
    case.replace("system/fvSolution", "0.01", "1e-4")
    case.replace("system/controlDict", "functions\n{", SURFACES)
    case.controls(
        endTime="0.06", deltaT="0.01", writeInterval="0.02",
        writeFormat="ascii", writePrecision="10",
    )
    return case


@pytest.fixture(scope="module", params=[1, 2], ids="ranks{}".format)
def run(request, meshed, tmp_path_factory):
    """The case after a run, with its log, on one and two ranks."""
    case = BodyCase(meshed, tmp_path_factory.mktemp("run"), "case")
    case.log = case.solve(request.param)
    if request.param > 1:
        case.run("reconstructPar")
    return case


def vectors(name, unit):
    return [f"{name}_{i}[{unit}]" for i in "xyz"]


COLUMNS = {
    "motion": [
        *vectors("position", "m"), "q_w", "q_x", "q_y", "q_z",
        *vectors("velocity", "m/s"), *vectors("angularVelocity", "rad/s"),
    ],
    "forces": [
        *vectors("fluidForce", "N"), *vectors("fluidTorque", "Nm"),
        *vectors("contactForce", "N"),
    ],
}


@pytest.mark.parametrize("table", COLUMNS)
def test_tables(table, run):
    (file,) = run.table_files(table)
    assert file.parent.name == "0"
    lines = file.read_text().splitlines()
    header = [line for line in lines if line.startswith("#")]

    # The names of the bodies, then those of the columns
    names = [line.lstrip("# ").split(":") for line in header[1:-1]]
    assert [[part.strip() for part in name] for name in names] == [
        ["0", "grain"], ["1", "post1"], ["2", "post2"]
    ]
    assert header[-1].lstrip("# ").split() == [
        "time[s]", "body", *COLUMNS[table]
    ]

    # One row per body and time
    rows = run.read_dat(file.relative_to(run.path))
    assert rows.shape == (N_STEPS*N_BODIES, 2 + len(COLUMNS[table]))
    times = 0.01*np.arange(1, N_STEPS + 1)
    assert rows[:, 0] == pytest.approx(np.repeat(times, N_BODIES))
    assert list(rows[:, 1]) == list(range(N_BODIES))*N_STEPS


def test_motion_is_consistent(run):
    free, fixed = run.table("motion", 0), run.table("motion", 2)

    # Trapezoidal rule in position and angle, to the tolerance of the coupling
    tolerance = 1e-4*0.01*2
    for i in "xyz":
        x, u = free[f"position_{i}"], free[f"velocity_{i}"]
        assert np.diff(x) == pytest.approx(
            0.005*(u[1:] + u[:-1]), abs=tolerance
        )
    angle = 2*np.arctan2(free["q_z"], free["q_w"])
    spin = free["angularVelocity_z"]
    assert np.diff(angle) == pytest.approx(
        0.005*(spin[1:] + spin[:-1]), abs=tolerance/0.25
    )
    assert np.abs(np.diff(angle)).min() > 1e-4

    # Started with the profile 1.5 (1 - y^2), half its vorticity 1.5 y. After a
    # step beside the other discs it is 3 and 4 % faster.
    assert free["velocity_x"][0] == pytest.approx(1.365, rel=0.06)
    assert spin[0] == pytest.approx(-0.45, rel=0.08)

    assert set(fixed["position_x"]) == {1.13}
    assert not np.any(fixed["velocity_x"])


def test_force_is_mass_times_acceleration(run):
    """Without gravity the fluid's force is all there is."""
    motion, forces = run.table("motion", 0), run.table("forces", 0)
    mass = 2.4*np.pi*0.25**2*0.1

    # Second-order backward differences
    for i in "xy":
        u = motion[f"velocity_{i}"]
        acceleration = (1.5*u[2:] - 2*u[1:-1] + 0.5*u[:-2])/0.01
        force = forces[f"fluidForce_{i}"][2:]
        assert np.abs(force).max() > 1e-6
        assert force == pytest.approx(
            mass*acceleration, abs=0.02*np.abs(force).max()
        )


def test_forces_scale_with_the_density(meshed, tmp_path):
    """Same density ratio, tenfold densities: tenfold forces."""
    forces = []
    for factor in (1, 10):
        case = BodyCase(meshed, tmp_path, f"times{factor}")
        case.bodies(
            BODIES.replace("2.4", f"{2.4*factor}"),
            f"rho {1.2*factor}; {COUPLING}",
        )
        case.controls(endTime="0.02")
        case.solve()
        forces.append(case.table("forces", 1)["fluidForce_x"])

    assert forces[0][-1] > 0.01
    assert forces[1] == pytest.approx(10*forces[0])


def test_surfaces(run):
    folder = run.path / "postProcessing" / "surfaces"
    series = json.loads((folder / "bodies.vtp.series").read_text())["files"]

    # At the start too
    assert len(series) == N_WRITTEN + 1
    assert [entry["time"] for entry in series] == pytest.approx(
        [0, 0.02, 0.04, 0.06]
    )
    assert sorted(entry["name"] for entry in series) == sorted(
        file.name for file in folder.rglob("*.vtp")
    )


def array(piece, section, name):
    """Numbers of a DataArray of a section."""
    (element,) = (
        e for e in piece.find(section) if e.get("Name") == name
    )
    assert element.get("format") == "ascii"
    values = np.array(element.text.split(), dtype=float)
    components = int(element.get("NumberOfComponents", 1))
    return values.reshape(-1, components) if components > 1 else values


def test_surfaces_are_polydata(run):
    motion = [run.table("motion", body) for body in range(N_BODIES)]
    folder = run.path / "postProcessing" / "surfaces"
    series = json.loads((folder / "bodies.vtp.series").read_text())["files"]

    for entry in series:
        root = ElementTree.parse(folder / entry["name"]).getroot()
        assert root.tag == "VTKFile"
        assert root.get("type") == "PolyData"
        (piece,) = root.iter("Piece")

        n_points = int(piece.get("NumberOfPoints"))
        n_polys = int(piece.get("NumberOfPolys"))
        assert int(piece.get("NumberOfVerts")) == N_BODIES
        assert n_polys % N_BODIES == 0 and n_polys >= 24*N_BODIES

        points = array(piece, "Points", "Points")
        assert points.shape == (n_points, 3)
        assert list(array(piece, "Verts", "connectivity")) == [0, 1, 2]
        assert list(array(piece, "Verts", "offsets")) == [1, 2, 3]
        corners = array(piece, "Polys", "connectivity").astype(int)
        ends = array(piece, "Polys", "offsets").astype(int)
        assert len(ends) == n_polys
        assert ends[-1] == len(corners)
        assert corners.min() == N_BODIES and corners.max() == n_points - 1

        body = array(piece, "CellData", "body").astype(int)
        assert len(body) == N_BODIES + n_polys
        radius = array(piece, "CellData", "radius")
        assert radius == pytest.approx([RADII[b] for b in body])
        for name in ("velocity", "angularVelocity", "force"):
            assert array(piece, "CellData", name).shape == (len(body), 3)

        # Centres where the bodies are, surfaces around them. The table has
        # the steps, not the start
        if entry["time"] == 0:
            continue
        step = round(entry["time"]/0.01) - 1
        for b, table in enumerate(motion):
            centre = [table[f"position_{i}"][step] for i in "xyz"]
            assert points[b] == pytest.approx(centre, abs=1e-6)

            polys = np.flatnonzero(body[N_BODIES:] == b)
            starts = np.concatenate([[0], ends[:-1]])
            used = np.unique(np.concatenate(
                [corners[starts[i]:ends[i]] for i in polys]
            ))
            distance = np.linalg.norm(points[used] - centre, axis=1)
            assert distance.max() == pytest.approx(RADII[b], rel=1e-5)

            velocity = array(piece, "CellData", "velocity")[b]
            assert velocity[0] == pytest.approx(
                table["velocity_x"][step], abs=1e-6
            )


def test_body_fraction(run):
    """Its integral is the area of the discs."""
    for time in ("0.02", "0.04", "0.06"):
        fraction = run.field("bodyFraction", time)
        assert fraction.min() == 0 and fraction.max() == 1

        area = np.pi*sum(radius**2 for radius in RADII)
        assert fraction.sum()*0.05**2 == pytest.approx(area, rel=0.01)


def test_progress_is_reported(run):
    progress = re.findall(
        r"^Progress: step (\d+), Courant number ([-+\d.e]+), bodies 3, "
        r"outer iterations (\d+), slip ([-+\d.e]+) m/s, time left (\d+) s$",
        run.log, re.MULTILINE,
    )
    steps, courant, outer, slip, left = zip(*progress, strict=True)

    assert [int(step) for step in steps] == list(range(1, N_STEPS + 1))
    assert all(0.1 < float(c) < 1 for c in courant)
    assert all(1 < int(o) <= 30 for o in outer)
    assert all(0 < float(s) < 0.05 for s in slip)
    assert int(left[-1]) == 0


def test_mass_is_conserved(run):
    """All that flows in flows out, in every time step."""
    local = re.findall(r"continuity errors : sum local = (\S+),", run.log)
    assert len(local) >= N_STEPS
    assert max(map(float, local)) < 1e-6


def test_a_run_stops_at_the_next_write_if_asked_to(meshed, tmp_path):
    case = BodyCase(meshed, tmp_path)
    case.controls(stopAt="nextWrite")
    case.solve()

    assert case.times() == ["0", "0.02"]
    assert (case.path / "0.02/uniform/immersedBodies").exists()


def test_check_stops_before_the_first_step(meshed, tmp_path):
    case = BodyCase(meshed, tmp_path)
    log = case.run("foamRun", "-check")

    assert case.times() == ["0"]
    assert not (case.path / "0/uniform").exists()
    assert "\nTime = " not in log
    assert "Immersed bodies: 3 2D (depth 0.1 m)" in log
    assert "resistance: exponential" in log
    assert re.search(r"cells per width: 8 to 10\b", log)

    for name, cells, ratio in (("grain", 10, 2), ("post1", 8, 1)):
        assert re.search(rf"(?m)^ *{name} +{cells} +{ratio} ", log), name
