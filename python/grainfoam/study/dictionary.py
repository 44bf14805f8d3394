# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads dictionaries in OpenFOAM's format, as far as studies need it: entries,
sub-dictionaries, lists, strings, comments; no macros and no #directives."""

import difflib
import pathlib
import re

TOKEN = re.compile(
    r"""//[^\n]* | /\*.*?\*/ | (?P<token>"(?:[^"\\]|\\.)*" | [{}();]
        | [^\s{}();"]+)""",
    re.VERBOSE | re.DOTALL,
)


class StudyError(Exception):
    """Something that the user wrote is wrong; the message says where."""


def number(word):
    """A number if the word is one, an int where it can be."""
    for kind in (int, float):
        try:
            return kind(word)
        except ValueError:
            pass
    return word


class Dictionary:
    """Entries by keyword: a word or number, a list of the words up to the `;`,
    or a Dictionary. Remembers the file, for messages."""

    def __init__(self, file, name, entries):
        self.file, self.name, self.entries = file, name, entries

    def error(self, message):
        where = f" in '{self.name}'" if self.name else ""
        return StudyError(f"{self.file}{where}: {message}")

    def check(self, valid):
        """Refuse keywords that are not valid."""
        for key in self.entries:
            if key not in valid:
                near = difflib.get_close_matches(key, valid, 1)
                raise self.error(
                    f"unknown keyword '{key}'"
                    + (f"; the nearest valid one is '{near[0]}'" if near else "")
                    + f". Valid are: {' '.join(sorted(valid))}")

    def __contains__(self, key):
        return key in self.entries

    def get(self, key, default=None):
        """The value, which has to be there if there is no default."""
        if key in self.entries:
            return self.entries[key]
        if default is None:
            near = difflib.get_close_matches(key, self.entries, 1)
            raise self.error(f"needs an entry '{key}'"
                             + (f", and has '{near[0]}'" if near else ""))
        return default

    def number(self, key, default=None, least=None):
        """A number, not less than `least`."""
        value = self.get(key, default)
        if not isinstance(value, (int, float)) or (
                least is not None and value < least):
            raise self.error(f"'{key}' has to be a number"
                             + (f" of at least {least:g}" if least is not None
                                else "") + f", and is {shown(value)}")
        return value

    def whole(self, key, default=None, least=None):
        value = self.number(key, default, least)
        if value != int(value):
            raise self.error(f"'{key}' has to be a whole number, and is"
                             f" {shown(value)}")
        return int(value)

    def list(self, key, default=None):
        value = self.get(key, default)
        if not isinstance(value, list):
            raise self.error(f"'{key}' has to be a list in brackets, and is"
                             f" {shown(value)}")
        return value

    def words(self, key, default=None):
        """A list whose members are words, such as names of files."""
        return [str(word) for word in self.list(key, default)]

    def choice(self, key, valid, default=None):
        value = self.get(key, default)
        if value not in valid:
            raise self.error(f"'{key}' has to be one of {' '.join(valid)}, and"
                             f" is {shown(value)}")
        return value

    def dictionaries(self, key):
        """{name: Dictionary} of the entries of a sub-dictionary; {} if it is
        not there."""
        block = self.entries.get(key, Dictionary(self.file, key, {}))
        if not isinstance(block, Dictionary):
            raise self.error(f"'{key}' has to be a dictionary")
        for name, value in block.entries.items():
            if not isinstance(value, Dictionary):
                raise block.error(f"'{name}' has to be a dictionary")
        return block.entries


def shown(value):
    """A value as it stands in a dictionary."""
    if isinstance(value, list):
        return "(" + " ".join(shown(v) for v in value) + ")"
    if isinstance(value, Dictionary):
        return "a dictionary"
    return f"{value:.12g}" if isinstance(value, float) else str(value)


class Reader:
    """Goes through the tokens of a file."""

    def __init__(self, file):
        self.file = file
        try:
            text = pathlib.Path(file).read_text()
        except OSError as error:
            raise StudyError(f"{file}: cannot be read: {error.strerror}")
        self.tokens = [
            (m["token"], text.count("\n", 0, m.start()) + 1)
            for m in TOKEN.finditer(text) if m["token"]
        ]
        self.at = 0

    def fail(self, message):
        line = self.tokens[min(self.at, len(self.tokens)) - 1][1] \
            if self.tokens else 1
        raise StudyError(f"{self.file}, line {line}: {message}")

    def next(self, what):
        if self.at == len(self.tokens):
            self.fail(f"the file ends before {what}")
        self.at += 1
        return self.tokens[self.at - 1][0]

    def list(self):
        values = []
        while True:
            token = self.next("')'")
            if token == ")":
                return values
            values.append(self.list() if token == "(" else self.word(token))

    def word(self, token):
        if token in "{};":
            self.fail(f"'{token}' where a value is needed")
        return token[1:-1] if token[0] == '"' else number(token)

    def value(self):
        values = []
        while True:
            token = self.next("';'")
            if token == ";":
                break
            values.append(self.list() if token == "(" else self.word(token))
        return values[0] if len(values) == 1 else values

    def dictionary(self, name, end):
        entries = {}
        while True:
            if end is None and self.at == len(self.tokens):
                break
            token = self.next("'}'")
            if token == end:
                break
            key = str(self.word(token)) if token not in "()" else token
            if key in ("(", ")") or key.startswith(("#", "$")):
                self.fail(f"'{key}' where a keyword is needed")
            if self.at < len(self.tokens) and self.tokens[self.at][0] == "{":
                self.at += 1
                entries[key] = self.dictionary(
                    f"{name}/{key}" if name else key, "}")
            else:
                entries[key] = self.value()
        return Dictionary(self.file, name, entries)


def read(file):
    """The Dictionary of a file, without its header."""
    content = Reader(file).dictionary("", None)
    content.entries.pop("FoamFile", None)
    return content
