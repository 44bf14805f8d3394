# SPDX-License-Identifier: GPL-3.0-or-later
"""Changes that a slip of the hand, or of the mind, makes to a dictionary."""

import re

TOKEN = re.compile(r'"[^"\n]*"|[-+]?\d[\w.+-]*|[A-Za-z_][\w.:]*|[{}();\[\]]')
NUMBER = re.compile(r"[-+]?\d+\.?\d*([eE][-+]?\d+)?$")
NUMBERS = ("0", "-1", "1e300", "1e-300", "nan", "1e6", "-1e6", "0.5", "(0 0 0)",
           "word", "1e400", "")
WORDS = ("none", "1", "{}", "(1 0 0)", "fixed", "default", "yes")


def other_number(random, text):
    factor = random.choice((-1, 2, 0.5, 10, 1e3, 1e-3, None, None, None))
    return random.choice(NUMBERS) if factor is None else repr(
        float(text)*factor
    )


def other_word(random, text, words):
    at = random.randrange(len(text))
    return random.choice((
        text[:at] + text[at + 1:], text[:at] + text[at] + text[at:],
        random.choice(words), random.choice(WORDS),
    ))


def mutate(random, text):
    """The text with a change, and what it is."""
    head = text.find("}", text.find("FoamFile")) + 1
    tokens = list(TOKEN.finditer(text, head))
    if not tokens:
        return text, "nothing"
    token = random.choice(tokens)
    old, (start, end) = token.group(), token.span()
    words = [t.group() for t in tokens if t.group()[0].isalpha()]

    if random.random() < 0.08:
        line = text.rfind("\n", 0, start) + 1
        stop = text.find("\n", start)
        return text[:line] + text[stop:], f"without '{text[line:stop].strip()}'"
    if random.random() < 0.02:
        return text[:start], f"cut at '{old}'"
    if NUMBER.match(old):
        new = other_number(random, old)
    elif old[0].isalpha():
        new = other_word(random, old, words)
    else:
        new = random.choice(("", old + old))
    around = text[max(start - 25, 0):start].replace("\n", " ")
    return text[:start] + new + text[end:], f"'{around}[{old} -> {new}]'"
