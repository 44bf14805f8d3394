# SPDX-License-Identifier: GPL-3.0-or-later
"""Function objects of a piece: mean pressure at stations, fields on planes,
flow rates of outlets."""

EVERY = "writeControl    timeStep;\n    writeInterval   5;"


def vector(values):
    return "({:.10g} {:.10g} {:.10g})".format(*values)


def plane(point, normal, reach):
    """Entries of a cut plane; reach [m]: only that far from the point."""
    low, high = ([x + s*reach for x in point] for s in (-1, 1))
    return f"""type            plane;
        planeType       pointAndNormal;
        pointAndNormalDict
        {{
            point           {vector(point)};
            normal          {vector(normal)};
        }}
        bounds          {vector(low)} {vector(high)};
        triangulate     false;
        interpolate     false;"""


def station(name, point, normal, reach):
    """Area average of p."""
    return f"""
{name}
{{
    type            surfaceFieldValue;
    libs            (fieldFunctionObjects);
    {EVERY}
    writeFields     no;
    log             no;
    regionType      sampledSurface;
    name            {name};
    sampledSurfaceDict
    {{
        {plane(point, normal, reach)}
    }}
    operation       areaAverage;
    fields          (p);
}}
"""


def flowRate(patch):
    """Volume flow rate through a patch."""
    return f"""
{patch}
{{
    type            surfaceFieldValue;
    libs            (fieldFunctionObjects);
    {EVERY}
    writeFields     no;
    log             no;
    regionType      patch;
    name            {patch};
    operation       sum;
    fields          (phi);
}}
"""


def pictures(planes, fields):
    """Fields on planes [(name, point, normal, reach)], cell by cell."""
    surfaces = "\n".join(f"""        {name}
        {{
        {plane(point, normal, reach)}
        }}""" for name, point, normal, reach in planes)
    return f"""
planes
{{
    type            surfaces;
    libs            (sampling);
    writeControl    writeTime;
    surfaceFormat   vtk;
    formatOptions
    {{
        vtk
        {{
            legacy          yes;
            format          ascii;
        }}
    }}
    fields          ({fields});
    interpolationScheme cell;
    surfaces
    (
{surfaces}
    );
}}
"""


def functionObjects(flow):
    """Text of all; flow: what a piece returns."""
    text = ["// Written by makeMesh.py\n"]
    text += [station(*entry) for entry in flow.get("stations", ())]
    text += [flowRate(patch) for patch in flow.get("outlets", ())]
    if flow.get("planes"):
        text.append(pictures(flow["planes"],
                             flow.get("fields", "U p k omega")))
    return "".join(text)
