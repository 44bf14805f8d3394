# SPDX-License-Identifier: GPL-3.0-or-later
"""CaNS (github.com/CaNS-World/CaNS): Runge-Kutta 3 and FFT, no bodies.

The input is the file input.nml of the folder that it runs in; results are read
from what it prints. Format: docs/INFO_INPUT.md of its sources, August 2026."""

import re

from measure import Result
from peers.given import PeerError, late_step, run

SOLVER = "CaNS"
VARIABLE = "LEAGUE_CANS"
MISSING = {"tenCate": "no bodies", "crowd": "no bodies"}

INPUT = """&dns
ng(1:3) = {n}, {n}, {n}
l(1:3) = {n}., {n}., {n}.
gtype = 1, gr = 0.
cfl = 0.95, dtmax = 1.e5, dt_f = {dt:.12g}
visci = {visci:.12g}
inivel = 'tgv'
is_wallturb = F
nstep = {steps}, time_max = 1.e9, tw_max = 1.e9
stop_type(1:3) = T, F, F
restart = F, is_overwrite_save = T, nsaves_max = 0
icheck = {steps}, iout0d = {never}, iout1d = {never}
iout2d = {never}, iout3d = {never}, isave = {never}
cbcvel(0:1,1:3,1) = 'D','D', 'D','D', 'D','D'
cbcvel(0:1,1:3,2) = 'D','D', 'D','D', 'D','D'
cbcvel(0:1,1:3,3) = 'D','D', 'D','D', 'D','D'
cbcpre(0:1,1:3) = 'N','N', 'N','N', 'N','N'
bcvel(0:1,1:3,1) = 0.,0., 0.,0., 0.,0.
bcvel(0:1,1:3,2) = 0.,0., 0.,0., 0.,0.
bcvel(0:1,1:3,3) = 0.,0., 0.,0., 0.,0.
bcpre(0:1,1:3) = 0.,0., 0.,0., 0.,0.
bforce(1:3) = 0., 0., 0.
is_forced(1:3) = F, F, F
velf(1:3) = 0., 0., 0.
dims(1:2) = 1, 1, ipencil_axis = 1
/
&other_options
is_debug = F, is_timing = F
/
"""


def write_fluid(folder, scene, steps):
    """Vortices in a closed cube, cells of size 1."""
    (folder/"data").mkdir(parents=True)
    (folder/"input.nml").write_text(INPUT.format(
        n=scene.n, dt=scene.dt, visci=1/scene.nu, steps=steps,
        never=1000*steps,
    ))


def read_steps(log):
    """Number of the last time step that it printed, with a sound end."""
    found = re.findall(r"Time step #\s+(\d+)", log)
    if not found or "*** Fim ***" not in log:
        raise PeerError(f"{SOLVER} did not come to its end")
    divergence = re.findall(r"Maximum =\s+(\S+)", log)
    if divergence and not abs(float(divergence[-1])) < 1e-6:
        raise PeerError(f"{SOLVER} ended with divergence {divergence[-1]}")
    return int(found[-1])


def fluid(program, folder, scene):
    """Rows of fluid alone."""
    def timed(steps):
        place = folder/f"{SOLVER}_{scene.n}_{steps}"
        write_fluid(place, scene, steps)
        done = run([program], place).check(SOLVER)
        return done, read_steps(done.log)

    step, (done, steps) = late_step(timed, scene.steps)
    result = Result(
        f"fluid alone, {scene.n}^3, RK3", None, scene.n**3, steps, done.cpu,
        SOLVER,
    )
    yield result.row("s per step", step)
    yield result.row("ns per cell and step", 1e9*step/result.cells)
