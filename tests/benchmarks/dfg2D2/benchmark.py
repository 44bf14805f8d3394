# SPDX-License-Identifier: GPL-3.0-or-later
"""Forces and frequency of the vortex street of a cylinder in a channel."""

import numpy as np

import dfgChannel
from dfgChannel import DIAMETER
from measure import DEPTH, Run
from peers.bodyFitted import FittedCase

SPEED = 1
ST, C_D_MAX, C_L_RANGE = 0.301841, 3.227393, 2.007871
C_L_MAX, DP = 0.986571, 2.4848

# Of the coarse run that the others start from, of those, of what is measured
DEVELOPMENT, END, MEASURED = 6, 3, 1.4


def develop(folder):
    """A case with the vortex street, developed on a coarse mesh."""
    case, _ = dfgChannel.make(folder, "development", 10, SPEED)
    end = f"{DEVELOPMENT}"
    case.controls(endTime=end, deltaT="0.004", writeInterval=end)
    case.solve()
    return case


def extremum(time, values):
    """Time and value of the largest: parabola through it and its neighbours."""
    i = np.clip(values.argmax(), 1, len(values) - 2)
    part = slice(i - 1, i + 2)
    a, b, c = np.polyfit(time[part] - time[i], values[part], 2)
    return time[i] - 0.5*b/a, c - 0.25*b*b/a


def periods(time, lift):
    """Slices of the periods, and their mean length, by rising lift."""
    rising = lift - 0.5*(lift.max() + lift.min())
    i = np.flatnonzero((rising[:-1] < 0) & (rising[1:] >= 0))
    crossings = time[i] - rising[i]*np.diff(time)[i]/np.diff(rising)[i]
    slices = [slice(a, b) for a, b in zip(i[:-1], i[1:])]
    return slices, np.diff(crossings).mean()


def figures(result, time, drag, lift, dp):
    """Rows of one run from its history per unit depth and density."""
    part = time > time[-1] - MEASURED
    time, dp = time[part], dp[part]
    drag, lift = (2*f[part]/(SPEED**2*DIAMETER) for f in (drag, lift))

    slices, period = periods(time, lift)
    when, highest = np.array([extremum(time[s], lift[s]) for s in slices]).T
    lowest = -np.array([extremum(time[s], -lift[s])[1] for s in slices])
    drags = [extremum(time[s], drag[s])[1] for s in slices]
    opposite = np.interp(when[:-1] + 0.5*period, time, dp)

    yield result.row("St", DIAMETER/(period*SPEED), ST)
    yield result.row("C_D max", np.mean(drags), C_D_MAX)
    yield result.row("C_L range", highest.mean() - lowest.mean(), C_L_RANGE)
    yield result.row("C_L max", highest.mean(), C_L_MAX)
    yield result.row("dp", opposite.mean(), DP)
    yield result.row("change, %", 100*abs(highest[-1]/highest[0] - 1))


def body_fitted(folder, start, quick):
    """Rows of pimpleFoam on a mesh fitted to the cylinder."""
    for n, ms in [(24, 2)] if quick else [(24, 2), (24, 0.5), (48, 1)]:
        case = FittedCase(folder, f"fitted{n}_{ms}ms", n)
        case.transient(SPEED, 0.001*ms, END)
        case.run("mapFields", start.path, "-sourceTime", "latestTime")
        result = case.solve("pimpleFoam", f"time step {ms} ms")
        if result:
            yield from figures(result, *case.history())


def immersed(folder, start, cells, courant):
    """Rows of our solver; Courant number of the mean speed."""
    name = f"D{cells}_Courant{courant}"
    case, n = dfgChannel.make(folder, name, cells, SPEED)
    dt = courant*DIAMETER/cells/SPEED
    case.controls(endTime=f"{END}", deltaT=f"{dt:.6g}")
    case.run(
        "mapFields", start.path, "-consistent", "-sourceTime", "latestTime"
    )
    run = Run(case, f"Courant {courant}", cells, n)
    forces = case.table("forces")
    p = case.read_dat("postProcessing/pressure/0/p")
    yield from figures(
        run, forces["time"], forces["fluidForce_x"]/DEPTH,
        forces["fluidForce_y"]/DEPTH, p[:, 1] - p[:, 2],
    )


def rows(folder, quick):
    start = develop(folder)
    yield from body_fitted(folder, start, quick)
    runs = [(10, 0.2), (10, 0.05), (20, 0.2)]
    if not quick:
        runs += [(20, 0.05), (30, 0.2)]
    for cells, courant in runs:
        yield from immersed(folder, start, cells, courant)
