# SPDX-License-Identifier: GPL-3.0-or-later
"""Parameters of the bench: bench.ini, and changes for one piece.

    bench = readBench(["head.blocked=3", "mesh.resolution=2"])
    bench["head"]["diameter"]         # numbers; lists of them if several
"""

import configparser
import difflib
import pathlib

FILE = pathlib.Path(__file__).resolve().parents[1]/"bench.ini"
COUNTS = {"outlets", "blocked", "cells", "across", "rings"}
WORDS = {"seed": ("rapeseed", "wheat", "maize")}
LISTS = {"sensorPlanes"}
MAY_BE_ZERO = {"roughness", "blocked", "bendAngle", "angle", "sensorPlanes",
               "endLength", "restitution", "wallRoughness",
               "rollingFriction"}


class BenchError(SystemExit):
    """A wrong entry, with the file and what is allowed; ends a script."""


def value(name, text):
    """A number, or one of the words of this name."""
    if name in WORDS:
        known(name, text, WORDS[name])
        return text
    kind = int if name in COUNTS else float
    try:
        result = kind(text)
    except ValueError:
        what = "a whole number" if kind is int else "a number"
        raise BenchError(f"{FILE}: {name} = {text}: {what} is wanted") from None
    if result < 0 or (result == 0 and name not in MAY_BE_ZERO):
        raise BenchError(f"{FILE}: {name} = {text}: must be positive")
    return result


def known(what, name, names):
    """Refuse a name that is none of names."""
    if name in names:
        return
    near = difflib.get_close_matches(name, names, n=1)
    hint = f", did you mean {near[0]}?" if near else ""
    raise BenchError(f"{what} '{name}' is not one of {' '.join(names)}{hint}")


def change(texts, argument):
    """Take SECTION.NAME=VALUE."""
    place, equals, text = argument.partition("=")
    section, dot, name = place.partition(".")
    if not (equals and dot):
        raise BenchError(f"'{argument}': SECTION.NAME=VALUE is wanted")
    known("section", section, list(texts))
    known(f"parameter of {section}", name, list(texts[section]))
    texts[section][name] = text


def readBench(changes=(), file=FILE):
    parser = configparser.ConfigParser(inline_comment_prefixes="#")
    parser.optionxform = str
    try:
        parser.read_string(pathlib.Path(file).read_text(), str(file))
    except configparser.Error as error:
        raise BenchError(error) from None
    texts = {name: dict(parser[name]) for name in parser.sections()}
    for argument in changes:
        change(texts, argument)

    bench = {}
    for section, entries in texts.items():
        bench[section] = {}
        for name, text in entries.items():
            words = text.replace(",", " ").split()
            values = [value(name, word) for word in words]
            if name not in LISTS and len(values) != 1:
                raise BenchError(
                    f"{FILE}: {name} = {text}: one value is wanted")
            bench[section][name] = values if name in LISTS else values[0]
    return bench
