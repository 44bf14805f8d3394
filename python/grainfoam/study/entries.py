# SPDX-License-Identifier: GPL-3.0-or-later
"""Sets an entry in the text of an OpenFOAM dictionary, and leaves all else as it
is: comments, macros and #directives. foamDictionary expands macros, and with
them what depends on the entry."""

import re

SKIP = re.compile(r"(?:\s+|//[^\n]*|/\*.*?\*/)+", re.DOTALL)
KEYWORD = re.compile(r'"(?:[^"\\]|\\.)*"|[^\s;{}"]+')
CODE = re.compile(r"#\{.*?#\}", re.DOTALL)
STRING = re.compile(r'"(?:[^"\\]|\\.)*"', re.DOTALL)


def _skip(text, at):
    """Past white space and comments."""
    found = SKIP.match(text, at)
    return found.end() if found else at


def _value_end(text, at):
    """Where the value that begins there ends: its `;`, or the end of a block."""
    depth = 0
    while at < len(text):
        for pattern in (SKIP, CODE, STRING):
            found = pattern.match(text, at)
            if found:
                at = found.end()
                break
        else:
            if text[at] == ";" and depth == 0:
                return at
            depth += (text[at] in "([{") - (text[at] in ")]}")
            if depth < 0:
                break
            at += 1
    raise ValueError("an entry has no end")


def entries(text, at=0):
    """Keyword, start and end of the value of all entries of the dictionary whose
    inside begins there, and where that ends. Of a sub-dictionary the value is
    its inside."""
    found = []
    while True:
        at = _skip(text, at)
        if at >= len(text) or text[at] == "}":
            return found, at
        if text[at] == ";":
            at += 1
            continue
        if text[at] == "#":
            # A directive, up to the end of its line
            end = text.find("\n", at)
            at = len(text) if end < 0 else end
            continue
        keyword = KEYWORD.match(text, at)
        start = _skip(text, keyword.end())
        if text[start:start + 1] == "{":
            _, end = entries(text, start + 1)
            found.append((keyword[0].strip('"'), start + 1, end))
        else:
            end = _value_end(text, start)
            found.append((keyword[0].strip('"'), start, end))
        at = end + 1


def find(text, path):
    """Start and end of the value of an entry, a/b/c of the entry c in b in a;
    None if there is none. As in OpenFOAM the last of a name counts."""
    at, end = 0, None
    for name in path.split("/"):
        there = [e for e in entries(text, at)[0] if e[0] == name]
        if not there:
            return None
        _, at, end = there[-1]
    return at, end


def replaced(text, path, value):
    """The text with another value of an entry that is there."""
    start, end = find(text, path)
    return text[:start] + value + text[end:]
