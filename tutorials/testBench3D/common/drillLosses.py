# SPDX-License-Identifier: GPL-3.0-or-later
"""What published losses give for the parts of the drill: for air alone, and
what seeds add. Ranges, (least, greatest), in Pa, between the stations."""

import math
import re

import numpy as np
from drillPiece import drillPipe, drillStations
from drillStations import ALL, legs
from friction import blasius, colebrook
from losses import (PROFILE, bendWithSolids, contraction, expansion, idelchik,
                    ito, lift, momentum, solidsFriction)


def distances(run):
    """{station: distance from the fan [m]}: along the axis of the feed pipe, up
    half the head, out to its wall and along a tube."""
    bench = drillPipe(run.bench)
    tube = bench["outletTubes"]
    wall = (bench["feedPipe"]["length"] + 0.5*bench["head"]["height"]
            + 0.5*bench["head"]["diameter"])
    found = {}
    for s in drillStations(run.bench):
        if s.name.startswith("inTube"):
            found["inTubes"] = wall + s.distance
        else:
            found[s.name] = s.distance
    return {**found, "ends": wall + tube["diameter"] + tube["shortLength"]}


def withAll(parts):
    """With their sum."""
    return {**parts, ALL: sum(parts.values())}


class Air:
    """The air of one state of the run, without seeds or with them: its flow,
    and published losses for it."""

    def __init__(self, run, flow):
        self.bench = bench = drillPipe(run.bench)
        self.own, self.head = bench["drill"], bench["head"]
        rho = bench["air"]["density"]
        nu = bench["air"]["viscosity"]/rho
        self.D, self.d = (bench[x]["diameter"]
                          for x in ("feedPipe", "outletTubes"))
        self.tubes = len(run.outlets())
        self.U = flow/(0.25*math.pi*self.D**2)
        self.u = flow/(0.25*math.pi*self.d**2*self.tubes)
        self.Re, self.re = self.U*self.D/nu, self.u*self.d/nu
        self.q, self.qTubes = 0.5*rho*self.U**2, 0.5*rho*self.u**2
        self.mass, self.roughness = rho*flow, bench["walls"]["roughness"]
        self.at = distances(run)

    def friction(self, length, tube=False):
        """Least and greatest by Blasius and Colebrook; rough: the latter."""
        Re, D, q = ((self.re, self.d, self.qTubes) if tube
                    else (self.Re, self.D, self.q))
        found = [colebrook(Re, self.roughness/D)]
        found += [] if self.roughness else [blasius(Re)]
        return np.array([min(found), max(found)])*length/D*q

    def bend(self):
        """Ito and Idelchik, friction along it included."""
        R, f = self.own["bendRadius"], colebrook(self.Re, self.roughness/self.D)
        found = [idelchik(f, R/self.D), ito(self.Re, 2*R/self.D, 90)]
        found = [zeta for zeta in found if zeta]
        return np.array([min(found), max(found)])*self.q

    def headLoss(self):
        """No published loss is for such a head. Least: the flow widens to the
        section at its rim and narrows into the tubes; greatest: all that it
        brings is lost, and tubes begin at a wall without a flow along it."""
        rim = math.pi*self.head["diameter"]*self.head["height"]
        pipe, tube = (0.25*math.pi*x**2 for x in (self.D, self.d))
        least = (expansion(min(pipe/rim, 1))*self.q
                 + contraction(min(tube*self.tubes/rim, 1))*self.qTubes)
        return np.array([least, PROFILE*self.q + contraction(0)*self.qTubes])

    def published(self):
        """{part: (least, greatest)}, between the stations."""
        at, ends = self.at, legs(self.bench)
        start, end = ends["bend"]
        length = ends["riser"][1]
        wall = at["ends"] - (self.bench["outletTubes"]["shortLength"] + self.d)
        return withAll({
            "feed pipe": self.friction(at["beforeBend"] - at["fan"]),
            "bend": self.bend() + self.friction(
                start - at["beforeBend"] + at["afterBend"] - end),
            "riser": self.friction(at["underHead"] - at["afterBend"]),
            "head": self.headLoss() + self.friction(length - at["underHead"])
            + self.friction(at["inTubes"] - wall, True),
            "tubes": self.friction(at["ends"] - at["inTubes"], True),
            "exit": np.array([1, PROFILE])*self.qTubes})


class Seeds:
    """The seeds of a run: their mass through a section, and what published
    formulas let them add to the losses of the air."""

    def __init__(self, run, air):
        self.run, self.air = run, air
        self.pipe, self.tube = (0.25*math.pi*x**2 for x in (air.D, air.d))
        self.tube *= air.tubes
        self.mass = seedMass(run.case)
        self.flow = self.mass*self.rate("afterBend")

    def passages(self, name):
        """Axial speeds at a plane; inTube, outlet: of all tubes."""
        return np.concatenate([p["axial"] for n, p in self.run.planes.items()
                               if n.rstrip("0123456789") == name])

    def rate(self, name):
        return len(self.passages(name))/(self.run.end - self.run.start)

    def carried(self, name, area):
        """Momentum through a plane [Pa], on the way out only: those that come
        back and pass again take it up again."""
        return momentum(self.mass*self.rate(name)/area,
                        self.passages(name).mean())

    def published(self, bendLoss):
        """{part: (least, greatest)}; {} if no seed has come to the tubes.
        bendLoss: of the air alone at this flow."""
        planes = "beforeBend", "afterBend", "underHead", "inTube", "outlet"
        if not all(any(n.startswith(name) for n in self.run.planes)
                   for name in planes):
            return {}
        u = {name: self.passages(name).mean() for name in planes}
        before, behind, under = (self.carried(x, self.pipe) for x in planes[:3])
        into, out = (self.carried(name, self.tube) for name in planes[3:])
        air, at, G = self.air, self.air.at, self.flow/self.pipe
        end = legs(air.bench)["bend"][1]
        riser, tube = (at[b] - at[a] for a, b in (
            ("afterBend", "underHead"), ("inTubes", "ends")))
        slow = 0.5*(u["beforeBend"] + u["afterBend"])
        fast = 0.5*(u["afterBend"] + u["underHead"])
        bend = (behind - before + lift(G, slow, air.own["bendRadius"])
                + lift(G, fast, at["afterBend"] - end))
        # In the head seeds come to rest; where they are taken up again the air
        # has a section between those of the rim and of the tubes
        rim = math.pi*air.head["diameter"]*air.head["height"]
        return withAll({
            "feed pipe": before + self.friction(
                G, u["beforeBend"], at["beforeBend"] - at["fan"]),
            "bend": bend + np.array([0, bendWithSolids(
                bendLoss, self.flow/air.mass)]),
            "riser": under - behind + lift(G, fast, riser)
            + self.friction(G, fast, riser),
            "head": np.sort([into*self.tube/rim, into]),
            "tubes": out - into + self.friction(
                self.flow/self.tube, 0.5*(u["inTube"] + u["outlet"]), tube,
                True),
            "exit": np.zeros(2)})

    def friction(self, G, u, length, tube=False):
        return np.array(solidsFriction(
            G, u, length, self.air.d if tube else self.air.D))


def seedMass(case):
    """Mean mass of the seeds of the last state [kg]."""
    states = [f for f in case.glob("*/uniform/immersedBodies")]
    text = max(states, key=lambda f: float(f.parts[-3])).read_text()
    volume, ratio = (np.array(re.findall(rf"\s{name}\s+(\S+);", text), float)
                     for name in ("volume", "densityRatio"))
    rho = float(re.search(r"rho\s+(\S+);", (
        case/"constant/seedValues").read_text())[1])
    return rho*(volume*ratio).mean()
