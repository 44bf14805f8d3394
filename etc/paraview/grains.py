# SPDX-License-Identifier: GPL-3.0-or-later
"""A case with grains in ParaView: the speed of the fluid on a plane through the
middle of the mesh, and the bodies of all series that immersedBodySurfaces has
written, in time with each other.

    paraview --script=$GRAINFOAM_DIR/etc/paraview/grains.py    # in the case
    pvpython $GRAINFOAM_DIR/etc/paraview/grains.py CASE PICTURE.png

The second writes a picture of the last time, and the state that it shows to
PICTURE.pvsm. Needs ParaView 5.6 or later; there is none where this was written:
what finds the files is tested, the calls of ParaView (show) have not been run.
"""

import pathlib
import sys


def series(case):
    """The lists of files of bodies."""
    return sorted(pathlib.Path(case).glob("postProcessing/*/bodies.vtp.series"))


def is_time(folder):
    try:
        return float(folder.name) > 0 and folder.is_dir()
    except ValueError:
        return False


def decomposed(case):
    """Are the fields in processor folders only?"""
    case = pathlib.Path(case)
    return (case/"processor0").is_dir() and not any(
        is_time(folder) for folder in case.iterdir())


def foam_file(case):
    """The empty file that ParaView's reader wants; made if it is not there."""
    file = pathlib.Path(case)/"case.foam"
    file.touch()
    return file


def show_fluid(simple, case):
    fluid = simple.OpenFOAMReader(FileName=str(foam_file(case)))
    fluid.CaseType = ("Decomposed Case" if decomposed(case)
                      else "Reconstructed Case")
    fluid.MeshRegions = ["internalMesh"]
    fluid.UpdatePipelineInformation()
    simple.GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
    simple.GetAnimationScene().GoToLast()
    fluid.UpdatePipeline()

    # Normal to the thinner of y and z: of a plane mesh that is its plane
    x0, x1, y0, y1, z0, z1 = fluid.GetDataInformation().GetBounds()
    plane = simple.Slice(Input=fluid)
    plane.SliceType.Origin = [(x0 + x1)/2, (y0 + y1)/2, (z0 + z1)/2]
    plane.SliceType.Normal = [0, 0, 1] if z1 - z0 < y1 - y0 else [0, 1, 0]
    display = simple.Show(plane)
    simple.ColorBy(display, ("CELLS", "U", "Magnitude"))
    display.RescaleTransferFunctionToDataRange(True)
    display.SetScalarBarVisibility(simple.GetActiveView(), True)

    outline = simple.Show(fluid)
    outline.SetRepresentationType("Outline")


def show_bodies(simple, case):
    for file in series(case):
        bodies = simple.OpenDataFile(str(file))
        display = simple.Show(bodies)
        display.SetRepresentationType("Surface With Edges")
        simple.ColorBy(display, None)
        display.DiffuseColor = [0.9, 0.9, 0.9]


def show(case, picture=None):
    from paraview import simple

    show_fluid(simple, case)
    show_bodies(simple, case)
    simple.ResetCamera()
    simple.Render()
    if picture:
        simple.SaveScreenshot(picture, ImageResolution=[1600, 900])
        simple.SaveState(str(pathlib.Path(picture).with_suffix(".pvsm")))


def main(arguments):
    case = arguments[0] if arguments else "."
    if not (pathlib.Path(case)/"system/controlDict").exists():
        raise SystemExit(f"{case} is not a case\n\n{__doc__}")
    if not series(case):
        print(f"{case} has no bodies.vtp.series: add `#includeFunc"
              " immersedBodySurfaces` to its functions")
    show(case, *arguments[1:2])


# ParaView's --script has another name than __main__ in some versions
if __name__ in ("__main__", "__vtkconsole__"):
    main([word for word in sys.argv[1:] if not word.startswith("-")])
