# SPDX-License-Identifier: GPL-3.0-or-later
"""The reader of tables, on tables that are written here."""

import sys

import numpy as np
import pytest

from foamCase import tables

pytestmark = pytest.mark.fast

MOTION = """# Bodies, by number:
# time[s]       \tbody\tposition_x[m]\tq_w
# 0             : grain1
"""


def write(case, path, text):
    file = case/"postProcessing"/path
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text)
    return file


def rows(*times, x=0, body=0):
    return "".join(f"{t}\t{body}\t{x}\t1\n" for t in times)


def test_names_of_bodies_may_come_between_the_rows(tmp_path):
    text = MOTION + rows(1) + "# 7 : grain2\n" + rows(2, x=-3e-1, body=7)
    columns = tables.read_columns(write(tmp_path, "motion/0/m.dat", text))
    assert list(columns) == ["time", "body", "position_x", "q_w", "name"]
    assert columns["body"].dtype == int
    assert list(columns["name"]) == ["grain1", "grain2"]
    assert list(columns["position_x"]) == [0, -0.3]


def test_a_restart_replaces_what_is_after_its_start(tmp_path):
    write(tmp_path, "motion/0/m.dat", MOTION + rows(1, 2, 3, 4))
    write(tmp_path, "motion/2/m.dat", MOTION + rows(3, x=1))
    write(tmp_path, "motion/10/m.dat", MOTION + rows(11, x=2))
    columns = tables.run_columns(tmp_path, "motion")
    assert list(columns["time"]) == [1, 2, 3, 11]
    assert list(columns["position_x"]) == [0, 0, 1, 2]


def test_of_a_part_that_was_begun_twice_the_later_has_rows(tmp_path):
    """OpenFOAM writes to name_<start>.dat where name.dat exists."""
    write(tmp_path, "motion/0/m.dat", MOTION)
    write(tmp_path, "motion/0/m_0.dat", MOTION + rows(1, x=1))
    assert list(tables.run_columns(tmp_path, "motion")["position_x"]) == [1]
    write(tmp_path, "motion/0/m.dat", MOTION + rows(1, 2))
    assert list(tables.run_columns(tmp_path, "motion", "m")["time"]) == [1]
    write(tmp_path, "motion/0/m_0.dat", MOTION)
    assert list(tables.run_columns(tmp_path, "motion")["time"]) == [1, 2]


def test_words_and_nan(tmp_path):
    file = write(tmp_path, "sensor/1/summary.dat", (
        "# Passages\n# plane \tgrains\tspeed[m/s]\tname\n"
        "0\t2\tnan\tlow\n1\t0\t1.5\thigh\n"
    ))
    columns = tables.read_columns(file)
    assert list(columns["name"]) == ["low", "high"]
    assert np.isnan(columns["speed"][0]) and columns["speed"][1] == 1.5


def test_tables_of_openfoam(tmp_path):
    file = write(tmp_path, "rate/0/surfaceFieldValue.dat", (
        "# Region type : patch outlet\n# Faces : 40\n"
        "# Time        \tsum(phi)\tareaAverage(U)\n"
        "0.1 \t2\t(1 -2e-3 0)\n0.2\t3\t(4 5 6)\n"
    ))
    columns = tables.read_columns(file)
    assert list(columns) == ["time", "sum(phi)", *(
        f"areaAverage(U)_{k}" for k in "xyz")]
    assert list(columns["areaAverage(U)_y"]) == [-2e-3, 5]


def test_no_rows(tmp_path):
    file = write(tmp_path, "motion/0/m.dat", MOTION)
    assert all(len(v) == 0 for v in tables.read_columns(file).values())
    assert len(tables.read_tables(tmp_path, "motion")) == 0


@pytest.mark.parametrize("arguments, message", [
    (("motion",), "which table? It has m n"),
    (("motion", "o"), "has no table o"),
    (("motions",), "motions is not there; of function objects there are"),
])
def test_missing_tables_are_named(tmp_path, arguments, message):
    for name in "mn":
        write(tmp_path, f"motion/0/{name}.dat", MOTION)
    with pytest.raises(tables.TableError) as error:
        tables.run_columns(tmp_path, *arguments)
    assert message in str(error.value)


def test_a_row_that_does_not_fit_the_header_is_refused(tmp_path):
    file = write(tmp_path, "motion/0/m.dat", MOTION + "1 2\n")
    with pytest.raises(tables.TableError, match="4 columns in the header, 2"):
        tables.read_table(file)


def test_structured_array_without_pandas(tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "pandas", None)
    write(tmp_path, "motion/0/m.dat", MOTION + rows(1, 2))
    table = tables.read_tables(tmp_path, "motion")
    assert table.dtype.names == ("time", "body", "position_x", "q_w", "name")
    assert list(table[table["name"] == "grain1"]["time"]) == [1, 2]


def test_frame_with_pandas(tmp_path):
    pandas = pytest.importorskip("pandas")
    write(tmp_path, "motion/0/m.dat", MOTION + rows(1, 2))
    table = tables.read_tables(tmp_path, "motion")
    assert isinstance(table, pandas.DataFrame)
    assert table[table.name == "grain1"].time.tolist() == [1, 2]
    assert table.attrs["units"] == {"time": "s", "position_x": "m"}


def test_a_folder_that_is_not_there_is_answered_with_those_that_are(tmp_path):
    write(tmp_path, "motion/0/m.dat", MOTION + rows(1))
    with pytest.raises(tables.TableError, match="there are: motion"):
        tables.run_columns(tmp_path, "bodies")
