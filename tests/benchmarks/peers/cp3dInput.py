# SPDX-License-Identifier: GPL-3.0-or-later
"""The input of CP3d: two files of Fortran namelists and a binary one.

Where the input has a choice it is that of its own Input/CFDACM, March 2024:
full implicit viscous terms, two more forcings, markers drawn in by 0.2 cells,
contact and lubrication."""

import math
from pathlib import Path

import numpy as np

SCHEMES = {"AB2": 1, "RK3": 3}
RETRACTION = 0.2
# Steps of the spheres in one of the fluid: a multiple of 15 for RK3
SUBSTEPS = 30


def fortran(value):
    """A value as namelists have it."""
    if isinstance(value, bool):
        return "T" if value else "F"
    if isinstance(value, str):
        return f'"{value}"'
    if isinstance(value, (list, tuple)):
        return ", ".join(fortran(part) for part in value)
    return f"{value:.15g}" if isinstance(value, float) else str(value)


def namelist(name, **entries):
    """A Fortran namelist."""
    lines = [f"  {key} = {fortran(value)}" for key, value in entries.items()]
    return "\n".join([f"&{name}", *lines, "/", ""])


def fft_size(wanted):
    """Nearest even number of cells with small prime factors."""
    def small(n):
        for prime in (2, 3, 5, 7, 11):
            while n % prime == 0:
                n //= prime
        return n == 1

    low = max(4, round(wanted/2))
    choices = [n for n in range(low, round(2*wanted) + 8) if small(n)]
    return min(
        (n for n in choices if n % 2 == 0), key=lambda n: abs(n - wanted)
    )


def markers(cells):
    """Number of markers of a sphere: one per cell of its surface (Uhlmann
    2005, J. Comput. Phys. 209, 448)."""
    radius = cells/2 - RETRACTION
    return round(math.pi/3*(12*radius**2 + 1))


def fluid_input(
    sides, cells, nu, rho, dt, steps, scheme, periodic, every
):
    """The first file. periodic: in all directions, without net flux along x;
    every: steps between outputs of the spheres."""
    zero = [0.0]*6
    never = 10*steps
    return "\n".join((
        namelist(
            "BasicParam", RestartFlag=False, IsUxConst=periodic, ubulk=0.0,
            FlowType=5, xlx=sides[0], yly=sides[1], zlz=sides[2],
            nxc=cells[0], nyc=cells[1], nzc=cells[2], xnu=nu,
            gravity=[0.0]*3, FluidDensity=rho, dtMax=dt, iCFL=2, CFLc=1.4,
            ifirst=1, ilast=steps, ischeme=SCHEMES[scheme], IsImplicit=2,
            FFTW_plan_type=1, BcOption=[0 if periodic else -1]*6,
            uxBcValue=zero, uyBcValue=zero, uzBcValue=zero, ivstats=never,
            saveStat=never, SaveVisu=every,
            BackupFreq=never, RunName="fluid", ResultsDir="./CFD/",
            RestartDir="./CFD/", Cmd_LFile_Freq=max(1, steps//10),
            LF_file_lvl=5, LF_cmdw_lvl=3, p_row=1, p_col=1,
            vel_limit=1e3, div_limit=1e3,
        ),
        namelist("MeshSection", nSection=1),
        namelist(
            "MeshOptions", SectionLength=1.0, nycSection=cells[1],
            StretType=0, StretOption=1, SectioncStret=1.0,
        ),
        namelist(
            "IO_Options", iskip=1, jskip=1, kskip=1, save_ux=False,
            save_uy=False, save_uz=False, save_wx=False, save_wy=False,
            save_wz=False, save_wMag=False, save_pr=False,
            save_Q_vor=False, save_lamda2=False, WriteHistOld=False,
            ReadHistOld=False,
        ),
    ))


def contact(kind):
    """Friction and restitution of pairs, PP, or with walls, PW."""
    return {
        f"FrictionCoe_s_{kind}": 0.0, f"FrictionCoe_k_{kind}": 0.0,
        f"RestitutionCoe_n_{kind}": 0.97,
    }


def floor_namelists(floor):
    """A wall at the bottom, or none."""
    return (
        namelist("GeometryMakingNumPlane", nplane=int(floor)),
        namelist(
            "GeometryMakingParam", user_id=1, wall_Type=1, bothSide=False,
            IsInfinite=True, Point1=[0.0, 0.0, 0.0], Point2=[0.0, 0.0, 1.0],
            Point3=[1.0, 0.0, 1.0], Point4=[1.0, 0.0, 0.0],
            TraVel=[0.0, 0.0, 0.0],
        ) if floor else namelist("GeometryMakingParam"),
    )


def spheres_input(number, diameter, cells, rho, gravity, floor, fixed):
    """The second file. cells: per diameter; gravity: a vector; floor: is
    there a wall at the bottom?"""
    return "\n".join((
        namelist(
            "DEMOptions", RestartFlag=False, numPrtcl=number, numPrtclFix=0,
            gravity=gravity, Prtcl_cs_ratio=1.0, CS_Method=1, CF_Type=3,
            PI_Method=2, PRI_Method=2, numPrtcl_Type=1, numWall_type=1,
            ncvAllowed=12, CntctList_Size=10, CS_numlvls=0,
            Wall_max_update_iter=100, Wall_neighbor_ratio=2.0,
            RunName="spheres", ResultsDir="./ACM/", RestartDir="./ACM/",
            Cmd_LFile_Freq=1000000, LF_file_lvl=5, LF_cmdw_lvl=3,
            GeometrySource=1, Geom_Dir="none",
        ),
        namelist(
            "ParticleIBMProperty", nPartition=markers(cells),
            RetractionRatio=RETRACTION,
        ),
        namelist(
            "ParticlePhysicalProperty", Bin_Divided=1, Density=rho,
            Diameter=diameter, YoungsModulus_P=1e7, PoissonRatio_P=0.3,
            **contact("PP"),
        ),
        namelist(
            "WallPhysicalProperty", YoungsModulus_W=1e7, PoissonRatio_W=0.3,
            **contact("PW"),
        ),
        *floor_namelists(floor),
        namelist(
            "PrtclVisuOption", saveXDMFOnce=True, save_ID=True,
            save_LinVel=True, **{f"save_{name}": False for name in (
                "Diameter", "UsrMark", "RotVel", "CntctForce", "Type",
                "LinAcc", "Theta", "RotAcc", "Torque", "HighSt",
            )},
        ),
        namelist("ParticleStatisticOption", nslab=1),
        namelist(
            "DumpPrtclOptions", DumpPrtclFlag=False, ResetDumpFlag=True,
            yDump=0.0, DumpPrtclFreq=100, mDumpPrtclSize=500000,
            DumpPrtclDir="./ACM/",
        ),
        namelist(
            "CFDACMCoupling", UpdateACMflag=not fixed,
            IsAddFluidPressureGradient=False, IBM_Scheme=1, icouple=SUBSTEPS,
            nForcingExtra=2, Klub_pp=90.0, Klub_pw=90.0, Lub_ratio=1.0,
            Ndt_coll=8.0, IsDryColl=True, St_Crit=5.0,
        ),
    ))


def write_places(folder, centres, diameter):
    """The binary file: place, diameter and kind of each sphere."""
    (Path(folder)/"ACM").mkdir(parents=True)
    table = np.ones((len(centres), 5))
    table[:, :3] = centres
    table[:, 3] = diameter
    table.astype(float).tofile(Path(folder)/"ACM/SpheresCoord.dat")
