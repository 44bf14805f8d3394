# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws what the sensors see: plots/sensor{Speed,Density,Spacing,Misses}.png,
and prints it beside the facts of the bench."""

import os
import pathlib
import sys

here = pathlib.Path(__file__).resolve().parent
sys.dont_write_bytecode = True
root = os.environ.get("GRAINFOAM_DIR", here/"../../..")
sys.path.insert(0, f"{root}/tutorials/plotting")
sys.path.insert(0, str(here.parent/"common"))

import sensorPlots  # source etc/bashrc of grainFoam
from friction import benchValues

values = benchValues(here)
R = values["diameter"]/2
summary = sensorPlots.readStatistics(here, "summary")
radii = sensorPlots.readStatistics(here, "radii")


def means(plane):
    """Mean speed, and number of grains per area over the mean, in the inner
    half of the radius and in the outer fifth."""
    parts = sensorPlots.onePlane(radii, plane)
    middle = (parts["inner"] + parts["outer"])/2

    def mean(column, weight, chosen):
        # Where there is no grain there is no speed
        chosen = chosen & (weight > 0)
        total = weight[chosen].sum()
        return (column[chosen]*weight[chosen]).sum()/total if total else 0

    area = parts["outer"]**2 - parts["inner"]**2
    speed = [mean(parts["meanSpeed"], parts["grains"], chosen)
             for chosen in (middle < 0.5*R, middle > 0.8*R)]
    return [*speed, *(mean(parts["densityOverMean"], area, chosen)
                      for chosen in (middle < 0.5*R, middle > 0.8*R))]


sensorPlots.drawAll(here, unit=1e-3, label="mm")

print(f"Air {values['meanVelocity']:.1f} m/s. The bench: grains of about 6 m/s, "
      "faster in the middle, densest on a ring near the wall")
print("sensor   grains  speed [m/s]  middle  near the wall  "
      "density, middle  near the wall  CV of intervals")
for plane, name in enumerate(summary["name"]):
    inner, outer, dense, denseOuter = means(plane)
    print(f"{name:8} {summary['grains'][plane]:6.0f} "
          f"{summary['meanSpeed'][plane]:12.2f} {inner:7.2f} {outer:14.2f} "
          f"{dense:16.2f} {denseOuter:14.2f} "
          f"{100*summary['variationOfInterval'][plane]:14.0f} %")
