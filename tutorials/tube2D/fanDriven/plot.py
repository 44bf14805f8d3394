# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the runs with F = 0.5 to 4: plots/{start,speed}.png"""

import os
import pathlib
import sys

import numpy as np

here = pathlib.Path(__file__).resolve().parent
sys.dont_write_bytecode = True
root = os.environ.get("GRAINFOAM_DIR", here/"../../..")
sys.path.insert(0, f"{root}/tutorials/plotting")

import grainPlots as gp  # source etc/bashrc of grainFoam
from grainPlots import plt

forces = (0.5, 1, 2, 4)

# V_x/F by body-fitted finite elements
reference = 0.08608


def main():
    grains = {}
    for F in forces:
        grains[F], = gp.readMotion(here/f"states/F{F}").values()

    figure, ax = plt.subplots(figsize=(6, 4))
    for F, grain in grains.items():
        ax.plot(grain["time"], grain["velocity_x"]/F, label=f"F = {F} / s")
    ax.axhline(reference, color="k", linestyle="--", linewidth=1,
               label="finite elements, steady")
    ax.set(xlabel="time [s]", ylabel="speed over force [m]",
           title="The fan is switched on")
    ax.legend()
    gp.save(figure, here/"plots/start.png")

    figure, ax = plt.subplots(figsize=(6, 4))
    F = np.array([0, *forces])
    ax.plot(F, reference*F, "k--", linewidth=1, label="finite elements")
    ax.plot(forces, [g["velocity_x"][-1] for g in grains.values()], "o",
            label="grain at the end")
    ax.set(xlabel="force over viscosity [1/s]", ylabel="speed [m/s]")
    ax.legend()
    gp.save(figure, here/"plots/speed.png")

    for F, grain in grains.items():
        print(f"F = {F}: speed/F {grain['velocity_x'][-1]/F:.5f}")


main()
