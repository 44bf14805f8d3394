# SPDX-License-Identifier: GPL-3.0-or-later
"""What is read off a run of the drill: shares, spacing, residence times, pressure.

    run = Drill(case)                 # passages after the time of filling
    run.shares()["variation"]         # (value, lower, upper end of 95 %)

All intervals are of 95 %. Those of coefficients of variation are bootstraps of
blocks of 0.25 s, or of twenty blocks in shorter runs: grains that follow each
other have the pulses of the roller and eddies in common.
"""

import benchPlots as bp
import numpy as np
import sensorPlots
from benchPlots import gp
from grainfoam.study import analysis

BLOCK = 0.25            # [s]
DRAWS = 2000


def variation(counts):
    """Coefficient of variation, standard deviation of the sample over mean."""
    return counts.std(ddof=1)/counts.mean()


def chance(total, outlets):
    """Coefficient of variation of grains that choose at random: mean and the
    ends of 95 %."""
    draws = np.random.default_rng(1).multinomial(
        int(total), np.full(outlets, 1/outlets), size=DRAWS)
    values = draws.std(axis=1, ddof=1)/draws.mean(axis=1)
    return (values.mean(), *np.quantile(values, (0.025, 0.975)))


class Drill:
    """Passages of planes: {name: {column: values}}, from the time `start` on."""

    def __init__(self, case):
        self.case, self.bench = case, bp.parameters(case)
        own = self.bench["drill"]
        self.airAlone = own["airAlone"]
        self.start = self.airAlone + own["filling"]
        table = sensorPlots.readPassages(case)
        forward = (table["direction"] > 0) & (table["time"] >= self.start)
        self.planes = {}
        for name in np.unique(table["planeName"]):
            rows = forward & (table["planeName"] == name)
            self.planes[str(name)] = {
                column: values[rows] for column, values in table.items()}
        self.end = max(table["time"], default=self.start)

    def outlets(self):
        """Numbers of the outlets that are open."""
        head = self.bench["head"]
        return [n for n in range(1, head["outlets"] + 1) if n != head["blocked"]]

    def times(self, outlet):
        plane = self.planes.get(f"outlet{outlet}")
        return plane["time"] if plane else np.zeros(0)

    def blocks(self):
        """(blocks, outlets) numbers of grains that have left."""
        number = max(20, int((self.end - self.start)/BLOCK))
        edges = np.linspace(self.start, self.end + 1e-9, number + 1)
        return np.stack([np.histogram(self.times(n), edges)[0]
                         for n in self.outlets()], axis=1)

    def shares(self):
        blocks = self.blocks()
        counts = blocks.sum(axis=0)
        half = len(blocks)//2

        def ofSum(rows):
            return variation(rows.sum(axis=0))

        return {
            "counts": counts,
            "interval": np.array([analysis.share_interval(n, counts.sum())
                                  for n in counts]),
            "variation": analysis.interval(ofSum, blocks, resamples=DRAWS),
            "chance": chance(counts.sum(), len(counts)),
            "halves": (ofSum(blocks[:half]), ofSum(blocks[half:]))}

    def spacing(self):
        """Of each outlet, from its own intervals over their mean: coefficient
        of variation, share of doubles (up to 0.5) and of misses (above 1.5)."""
        rows = []
        for outlet in self.outlets():
            gaps = np.diff(np.sort(self.times(outlet)))
            if len(gaps) < 2:
                rows.append((np.nan, np.nan, np.nan, len(gaps)))
                continue
            gaps = gaps/gaps.mean()
            rows.append((gaps.std(ddof=1), np.mean(gaps <= 0.5),
                         np.mean(gaps > 1.5), len(gaps)))
        return np.array(rows)

    def intervals(self):
        """All intervals over the mean of their outlet."""
        gaps = [np.diff(np.sort(self.times(n))) for n in self.outlets()]
        return np.concatenate([g/g.mean() for g in gaps if len(g) > 1])

    def residence(self):
        """Times from the roller to the end of a tube [s], of the grains that
        entered after the filling began and left after it."""
        entered = {}
        found = []
        for event in gp.readPassage(self.case):
            if event["what"] == "enters":
                entered[event["name"]] = event["time"]
            elif event["time"] >= self.start \
                    and str(event["where"]).startswith("outlet"):
                found.append(event["time"] - entered[event["name"]])
        return np.array(found)

    def windows(self):
        """Times of which means are taken: without grains and, if the run has
        got to where they count, with them."""
        alone = [(0.7*self.airAlone, self.airAlone)]
        return alone + [(self.start, self.end)]*(self.end > self.start)

    def flowRate(self):
        """Air [m3/s] in the windows."""
        time, q = bp.series(self.case, "fanInlet")
        return [-q[(time > a) & (time <= b)].mean() for a, b in self.windows()]

    def impacts(self):
        """Energy that contact takes from one grain on its way [J]."""
        table = gp.tables.run_columns(
            self.case, "energy", "immersedBodyEnergy")
        late = table["time"] >= self.start
        lost = sum(table[c][late][-1] - table[c][late][0]
                   for c in ("dashpots", "friction"))
        entered = sum(e["what"] == "enters" and e["time"] >= self.start
                      for e in gp.readPassage(self.case))
        return lost/entered
