# SPDX-License-Identifier: GPL-3.0-or-later
"""The documents: links, commands, and that the user guide has all there is."""

import re
from pathlib import Path

import pytest

pytestmark = pytest.mark.fast

ROOT = Path(__file__).resolve().parents[2]
NOT_OURS = {
    "platforms", "lnInclude", "postProcessing", "results", "dynamicCode",
    ".git", ".pytest_cache",
}


def files(folder, *suffixes):
    return sorted(
        file for file in (ROOT/folder).rglob("*")
        if file.suffix in suffixes and file.is_file()
        and not NOT_OURS & set(file.relative_to(ROOT).parts)
    )


DOCUMENTS = files(".", ".md")
GUIDE = [ROOT/"doc/userGuide.md", *files("doc/userGuide", ".md")]


def name(file):
    return str(file.relative_to(ROOT))


def code(text):
    """What is code in a document: indented or fenced blocks, `spans`."""
    blocks = re.findall(r"^(?: {4}|\t).*$", text, re.M)
    fenced = re.findall(r"^ *```.*?^ *```", text, re.M | re.S)
    spans = re.findall(r"(?<!`)`([^`\n]+)`(?!`)", text)
    return blocks + fenced + spans


def words(texts):
    return set(re.findall(r"\w+", "\n".join(texts)))


def anchors(file):
    """Places of a document that links may name, as GitHub does."""
    heads = re.findall(r"^#+ +(.+)$", file.read_text(), re.M)
    kept = (re.sub(r"[^\w\- ]", "", head.lower()) for head in heads)
    return {head.replace(" ", "-") for head in kept}


def of_table(table):
    """Entries of a table of Usage in a header: words of the first column."""
    lines = [line for line in table.splitlines() if "|" in line]
    if not lines:
        return set()
    indent = min(len(line) - len(line.lstrip()) for line in lines)
    found = set()
    for line in lines:
        first = line.split("|")[0]
        # Those that are indented go on with the line before
        if len(first) - len(first.lstrip()) == indent:
            parts = re.split(r",| or | \.\.\.", first)
            found |= {part.strip() for part in parts}
    return {w for w in found if re.fullmatch(r"\w+", w)} - {"Property"}


def usage():
    """Pairs of a header and a keyword of its tables."""
    return sorted(
        (name(file), word)
        for file in files("src", ".H")
        for table in re.findall(
            r"\\table\n(.*?)\\endtable", file.read_text(), re.S
        )
        for word in of_table(table)
    )


def checked():
    """Pairs of a source and a keyword that it lets pass."""
    lists = (
        r"keywords::check(?:FunctionObject)?\s*\((.*?)\)\s*;",
        r"[kK]eywords(?:\(\))?(?: const)?\s*\(\{(.*?)\}\)\s*;",
        r"[kK]eywords\(\)(?: const)?\s*\{(.*?)^\}",
        r"valid\.append\s*\((.*?)\)\s*;",
        r"\bours\s*\(\{(.*?)\}\)\s*;",
    )
    return sorted({
        (name(file), word)
        for file in files("src", ".C")
        for pattern in lists
        for found in re.findall(pattern, file.read_text(), re.S | re.M)
        for word in re.findall(r'"(\w+)"', re.sub(r'Dict\("\w+"\)', "", found))
    } - {(name(ROOT/"src/rigidBodies/keywords/checkKeywords.C"), "FoamFile")})


@pytest.fixture(scope="module")
def guide():
    return words(part for file in GUIDE for part in code(file.read_text()))


@pytest.fixture(scope="module")
def messages():
    """Texts of the sources, without what divides them into lines."""
    text = "\n".join(
        file.read_text() for folder in ("src", "applications")
        for file in files(folder, ".C", ".H")
    )
    return re.sub(r'"\s*(?:<<\s*)?"', "", text)


def test_the_parsers_find_what_there_is():
    assert of_table("""
        Property  | Description       | Required | Default
        radius, a | Radius or
                    more | no |
        two words | Goes on           |
        start     | First             | no  | 0
    """) == {"radius", "a", "start"}
    assert len(usage()) > 150
    assert len(checked()) > 150
    assert "radius" in {word for _, word in usage()}
    for word in ("timeSteps", "seed", "slipLength", "nRadii", "rotate"):
        assert word in {word for _, word in checked()}, word


def test_keywords_of_headers_are_in_the_guide(guide):
    assert [pair for pair in usage() if pair[1] not in guide] == []


def test_keywords_of_the_code_are_in_the_guide(guide):
    assert [pair for pair in checked() if pair[1] not in guide] == []


def test_messages_of_the_guide_are_those_of_the_code(messages):
    text = (ROOT/"doc/userGuide/messages.md").read_text()
    rows = re.findall(r"^\| (`.*?) \|", text, re.M)
    assert len(rows) > 40
    wrong = [
        part for row in rows for part in re.findall(r"`([^`]+)`", row)
        if part not in messages
    ]
    assert wrong == []


@pytest.mark.parametrize("document", DOCUMENTS, ids=name)
def test_links_lead_somewhere(document):
    wrong = []
    for link in re.findall(r"\]\(([^)\s]+)\)", document.read_text()):
        if re.match(r"\w+:", link):
            continue
        path, _, place = link.partition("#")
        target = document.parent/path if path else document
        if not target.exists() or (
            place and place not in anchors(target)
        ):
            wrong.append(link)
    assert wrong == []


@pytest.mark.parametrize("document", DOCUMENTS, ids=name)
def test_benchmarks_that_are_named_exist(document):
    folder = ROOT/"tests/benchmarks"
    options = {"NAME", "DIR", "N"}
    wrong = []
    for text in code(document.read_text()):
        for line in re.findall(r"tests/benchmarks/run\b([^\n#]*)", text):
            wrong += [
                word for word in line.split()
                if not word.startswith("-") and not word.isdigit()
                and word not in options
                and not (folder/word/"benchmark.py").exists()
            ]
    assert wrong == []


@pytest.mark.parametrize("document", DOCUMENTS, ids=name)
def test_lines_are_short(document):
    long = [
        line for line in document.read_text().splitlines()
        if len(line) > 100 and "|" not in line and "](" not in line
    ]
    assert long == []


def test_the_front_page_is_one_page():
    lines = (ROOT/"README.md").read_text().splitlines()
    assert len(lines) <= 120


def test_pictures_are_small():
    assert [
        name(file) for file in files("doc/gallery", ".png")
        if file.stat().st_size > 1e5
    ] == []
