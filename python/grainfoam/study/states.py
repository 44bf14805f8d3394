# SPDX-License-Identifier: GPL-3.0-or-later
"""The states of a study: values of its parameters, and what they set in the
files of the case."""

import dataclasses
import itertools
import math
import random
import re

from .dictionary import Dictionary, StudyError, shown

KINDS = ("values", "range", "logRange", "uniform", "normal")
RANDOM = ("uniform", "normal")
WORD = re.compile(r"[A-Za-z_]\w*")
FUNCTIONS = {name: value for name, value in vars(math).items()
             if not name.startswith("_")}
FUNCTIONS.update(abs=abs, min=min, max=max, round=round)


def evaluate(expression, names, where):
    """Value of an expression of parameters, with the functions of math."""
    try:
        return eval(expression, {"__builtins__": {}, **FUNCTIONS}, dict(names))
    except Exception as error:
        raise where.error(
            f"'{expression}' cannot be evaluated: {error}. Names are:"
            f" {' '.join(names)}, and those of python's math") from None


def filled(text, names, where):
    """The text with the values of expressions in {braces}."""
    return re.sub(
        r"\{([^{}]*)\}",
        lambda m: shown(evaluate(m[1], names, where)), str(text))


@dataclasses.dataclass
class Parameter:
    """A parameter of a study: values one after the other, or random."""

    name: str
    kind: str
    numbers: list
    where: Dictionary

    @property
    def is_random(self):
        return self.kind in RANDOM

    def values(self):
        """All values, of a parameter that is not random."""
        if self.kind == "values":
            return self.numbers
        first, last, n = self.numbers
        if n == 1:
            return [first]
        steps = [i/(n - 1) for i in range(n)]
        if self.kind == "logRange":
            return [first*(last/first)**s for s in steps]
        values = [first + (last - first)*s for s in steps]
        whole = all(v == round(v) for v in values) and isinstance(first, int)
        return [round(v) for v in values] if whole else values

    def draw(self, seed, number):
        """Value of a random one: the same whatever else is drawn."""
        source = random.Random(f"{seed} {self.name} {number}")
        a, b = self.numbers
        return source.uniform(a, b) if self.kind == "uniform" \
            else source.gauss(a, b)


def parameter(name, content):
    """The Parameter of an entry of `parameters`."""
    if not WORD.fullmatch(name):
        raise content.error("the name of a parameter is a word of letters,"
                            " digits and _")
    content.check({*KINDS, "file", "entry"})
    kinds = [kind for kind in KINDS if kind in content]
    if len(kinds) != 1:
        raise content.error(f"needs one of {', '.join(KINDS)}, and has"
                            f" {' and '.join(kinds) or 'none'}")
    (kind,) = kinds
    numbers = content.list(kind)
    if kind != "values":
        n = 2 if kind in RANDOM else 3
        if len(numbers) != n or any(isinstance(v, (str, list)) for v in numbers):
            names = {"range": "first last number", "logRange": "first last number",
                     "uniform": "least most", "normal": "mean deviation"}
            raise content.error(f"'{kind}' takes ({names[kind]}), not"
                                f" {shown(numbers)}")
        if n == 3 and (numbers[2] != int(numbers[2]) or numbers[2] < 1):
            raise content.error(f"'{kind}': the number of values has to be a"
                                f" whole number of at least 1")
        if kind == "logRange" and min(numbers[:2]) <= 0:
            raise content.error("'logRange' has to be above zero")
    elif not numbers:
        raise content.error("'values' is empty")
    return Parameter(name, kind, numbers, content)


@dataclasses.dataclass
class State:
    """One state: its name, and its parameters by name."""

    name: str
    parameters: dict


def state_name(values):
    """From names and values; one that is long is cut, with a checksum."""
    words = [f"{n}{shown(float(f'{v:.6g}')) if isinstance(v, float) else v}"
             for n, v in values.items()]
    return re.sub(r"[^\w.+-]", "", "_".join(words))


def groups(study, names):
    """Names of parameters by `combine`: values of one group go together, all
    of a group with all of another."""
    combine = study.get("combine", "product")
    if isinstance(combine, list):
        found = [g if isinstance(g, list) else [g] for g in combine]
        if sorted(map(str, sum(found, []))) != sorted(names):
            raise study.error("'combine' has to name each of these once:"
                              f" {' '.join(names)}; and is {shown(combine)}")
        return found
    if study.choice("combine", ("product", "zip"), "product") == "zip":
        return [names] if names else []
    return [[name] for name in names]


def combinations(study, parameters):
    """{name: value} of parameters that are not random, for each state."""
    values = {p.name: p.values() for p in parameters}
    together = []
    for names in groups(study, list(values)):
        columns = [values[name] for name in names]
        lengths = {len(column) for column in columns}
        if len(lengths) > 1:
            raise study.error("'combine' needs as many values of each of"
                              f" {' '.join(names)}, and there are"
                              f" {sorted(lengths)}")
        together.append([dict(zip(names, row)) for row in zip(*columns)])
    for parts in itertools.product(*together):
        found = {name: v for part in parts for name, v in part.items()}
        yield {name: found[name] for name in values}


def states(study):
    """All states that `where` wants, in the order of the study's file."""
    block = study.dictionaries("parameters")
    if not block and "draws" not in study:
        raise study.error("needs an entry 'parameters' with at least one, or"
                          " 'draws'")
    parameters = [parameter(*item) for item in block.items()]
    ordered = [p for p in parameters if not p.is_random]
    drawn = [p for p in parameters if p.is_random]

    if drawn and "draws" not in study:
        raise drawn[0].where.error(
            f"is random, and {study.file} has no 'draws', their number")
    draws = range(1, study.whole("draws", 1, 1) + 1) if "draws" in study \
        else [None]
    seed = study.whole("seed", 1)

    found = []
    for values in combinations(study, ordered):
        for draw in draws:
            names = dict(values)
            label = dict(names)
            if draw is not None:
                label["draw"] = draw
                names["draw"] = draw
                names.update((p.name, p.draw(seed, draw)) for p in drawn)
            found.append(State(state_name(label), names))

    seen = {}
    for state in found:
        if state.name in seen:
            raise StudyError(f"{study.file}: two states have the name"
                             f" {state.name}: {seen[state.name].parameters} and"
                             f" {state.parameters}")
        seen[state.name] = state

    if "where" in study:
        wanted = study.get("where")
        found = [s for s in found if evaluate(wanted, s.parameters, study)]
        if not found:
            raise study.error(f"no state is as 'where' says: {shown(wanted)}")
    return found


@dataclasses.dataclass
class Setting:
    """An entry of a file that a study sets."""

    file: str
    entry: str
    value: str
    where: Dictionary

    def text(self, state):
        return filled(self.value, state.parameters, self.where)


def settings(study):
    """What states set: entries of parameters, and of `set`."""
    found = []
    for name, content in study.dictionaries("parameters").items():
        if ("file" in content) != ("entry" in content):
            raise content.error("'file' and 'entry' go together")
        if "file" in content:
            found.append(Setting(content.get("file"), content.get("entry"),
                                 f"{{{name}}}", content))
    for content in study.dictionaries("set").values():
        content.check({"file", "entry", "value"})
        value = content.get("value")
        found.append(Setting(
            content.get("file"), content.get("entry"),
            value if isinstance(value, str) else shown(value), content))
    return found
