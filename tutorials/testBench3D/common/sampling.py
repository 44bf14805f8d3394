# SPDX-License-Identifier: GPL-3.0-or-later
"""Function objects of a piece: mean pressure at stations, or with the total
pressure there and at outlets, fields on planes, flow rates of outlets."""

EVERY = "writeControl    timeStep;\n    writeInterval   5;"
# The same for those that others take their fields of
EXECUTED = ("executeControl  timeStep;\n    executeInterval 5;\n"
            "    writeControl    none;\n    log             no;")


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


def mean(name, region, entries):
    """A mean over a surface; region: what surface, entries: of what."""
    return f"""
{name}
{{
    type            surfaceFieldValue;
    libs            (fieldFunctionObjects);
    {EVERY}
    writeFields     no;
    log             no;
    {region}
    {entries}
}}
"""


def station(name, point, normal, reach):
    """Area average of p."""
    return mean(name, f"""regionType      sampledSurface;
    name            {name};
    sampledSurfaceDict
    {{
        {plane(point, normal, reach)}
    }}""", "operation       areaAverage;\n    fields          (p);")


def weighted(name, kind, surface):
    """Pressure [m2/s2] and total pressure [Pa], means weighted with the flow."""
    return mean(name, f"""regionType      {kind};
    name            {surface};""", """operation       weightedAreaAverage;
    weightField     U;
    fields          (p pTotal);""")


def pressures(planes, patches):
    """Pressure and total pressure on planes, and on patches, PATCHEnd. One
    function object samples the planes: others do not weight what they sample."""
    surfaces = "\n".join(f"""        {name}
        {{
        {plane(*where)}
        }}""" for name, *where in planes)
    return f"""
totalPressure
{{
    type            pressure;
    libs            (fieldFunctionObjects);
    {EXECUTED}
    mode            total;
    rho             rhoInf;
    rhoInf          $:rho;
    result          pTotal;
}}

stations
{{
    type            surfaces;
    libs            (sampling);
    {EXECUTED}
    sampleOnExecute yes;
    store           yes;
    surfaceFormat   none;
    fields          (p pTotal U);
    interpolationScheme cell;
    surfaces
    (
{surfaces}
    );
}}
""" + "".join([
        *(weighted(name, "functionObjectSurface", f"stations.{name}")
          for name, *_ in planes),
        *(weighted(f"{patch}End", "patch", patch) for patch in patches)])


def flowRate(patch):
    """Volume flow rate through a patch."""
    return mean(patch, f"""regionType      patch;
    name            {patch};""", """operation       sum;
    fields          (phi);""")


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
    if flow.get("pressures"):
        text.append(pressures(*flow["pressures"]))
    text += [flowRate(patch) for patch in flow.get("outlets", ())]
    if flow.get("planes"):
        text.append(pictures(flow["planes"],
                             flow.get("fields", "U p k omega")))
    return "".join(text)
