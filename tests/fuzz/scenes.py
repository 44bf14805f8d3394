# SPDX-License-Identifier: GPL-3.0-or-later
"""Small valid cases that the fuzz begins from."""

from bodyCase import BodyCase
from boxMesh import uniform

FUNCTIONS = """
    sensor
    {
        type            opticalSensor;
        libs            (immersedBodyFunctionObjects);
        planes          { middle { point (0 0 0); normal (1 0 0); } }
    }
    surfaces
    {
        type            immersedBodySurfaces;
        libs            (immersedBodyFunctionObjects);
        writeControl    writeTime;
    }
    energy
    {
        type            immersedBodyEnergy;
        libs            (immersedBodyFunctionObjects);
        writeControl    timeStep;
    }
"""

GRAINS = """
    one
    {
        shape           { type disc; radius 0.25; }
        density         2;
        position        (-1 -0.3 0);
        velocity        ambient;
    }
    two
    {
        shape           { type ellipse; semiAxes (0.3 0.2); }
        density         2;
        position        (0 0.3 0);
        velocity        (1 0 0);
        angularVelocity (0 0 0.5);
        orientation     { type axisAngle; axis (0 0 1); angle 20; }
        constraints     { translate (1 0 0); rotate (0 0 1); }
        material        glass;
    }
"""
CONTACT = """
rho             1;
resistance      { type exponential; steepness 1.1; }
coupling        { nOuterCorrectors 20; tolerance 1e-4; }
contact
{
    type            softSphere;
    restitution     0.8;
    friction        0.3;
    timeSteps       4;
    pairs           { glass-steel { restitution 0.6; friction 0.3; } }
    walls           { walls steel; }
}
lubrication     { type leadingOrder; roughness 1e-3; }
leaving         { outlet { type remove; } inlet { type hold; } }
"""

DRIVEN = """
    pillar
    {
        shape           { type box; size (0.4 0.6 1); }
        position        (0.8 -0.7 0);
        motion          { type fixed; }
    }
    paddle
    {
        shape           { type superellipse; semiAxes (0.3 0.2); exponent 4; }
        position        (-0.8 0 0);
        motion
        {
            type            prescribed;
            velocity        table ((0 (0 0 0)) (1 (0.5 0 0)));
            angularVelocity (0 0 1);
        }
    }
"""

SPHERES = """
    seed
    {
        shape           { type sphere; radius 0.02; }
        densityRatio    1000;
        positions       ((0 0 0.2) (0.2 0 0.3));
        velocity        (0 0 -0.1);
    }
"""
UNRESOLVED = """
rho             1;
coupling
{
    type            auto;
    resolvedFrom    4;
    dragModel       { type Clift; }
    lift            { type (SaffmanMei); }
}
contact         { type softSphere; restitution 0.5; friction 0.2; }
sleep           { speed 1e-3; }
injection
{
    seeds
    {
        shape           { type sphere; radius 0.02; }
        densityRatio    1000;
        size
        {
            type            uniform;
            uniformDistribution { minValue 0.9; maxValue 1.1; }
        }
        position        (-0.4 0.1 0.4);
        times           (0.005);
        seed            1;
    }
}
"""


def tube(folder, name, bodies, before):
    case = BodyCase("tube", folder, name)
    case.controls(writeFormat="ascii", deltaT="0.02", endTime="0.06",
                  writeControl="timeStep", writeInterval="3")
    case.mesh(uniform(-2, 2, 40), uniform(-1, 1, 20))
    case.bodies(bodies, before)
    case.gravity(0, -1, 0)
    case.replace("system/controlDict", "functions\n{",
                 f"functions\n{{{FUNCTIONS}")
    return case


def box(folder, name):
    case = BodyCase("box", folder, name)
    case.controls(writeFormat="ascii", deltaT="0.005", endTime="0.015",
                  writeControl="timeStep", writeInterval="3")
    case.mesh(*3*[uniform(-0.5, 0.5, 8)])
    case.bodies(SPHERES, UNRESOLVED)
    case.gravity(0, 0, -9.81)
    return case


def make(folder):
    """The cases, meshed."""
    return [
        tube(folder, "grains", GRAINS, CONTACT),
        tube(folder, "driven", DRIVEN, ""),
        box(folder, "unresolved"),
    ]
