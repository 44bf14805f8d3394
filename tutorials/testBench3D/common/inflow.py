# SPDX-License-Identifier: GPL-3.0-or-later
"""constant/boundaryData/fanInlet from the run of a periodic tube.

    inflow.py FOLDER
"""

import pathlib
import sys

sys.dont_write_bytecode = True

from benchPlots import Plane

FIELDS = ("U", "k", "omega")


def writeList(file, values):
    rows = (f"{row:.8g}" if values.ndim == 1
            else "({:.8g} {:.8g} {:.8g})".format(*row) for row in values)
    file.write_text("(\n" + "\n".join(rows) + "\n)\n")


def main():
    section = Plane(sys.argv[1], "section")
    target = pathlib.Path("constant/boundaryData/fanInlet")
    (target/"0").mkdir(parents=True, exist_ok=True)

    for field in FIELDS:
        writeList(target/"0"/field, section.fields[field])
    writeList(target/"points", section.centres*(1, 1, 0))


if __name__ == "__main__":
    main()
