# SPDX-License-Identifier: GPL-3.0-or-later
"""A few starts of tests/fuzz: wrong dictionaries end with a message."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]/"fuzz"))

from fuzz import fuzz


def test_changed_dictionaries_run_or_are_refused(tmp_path):
    outcomes = list(fuzz(tmp_path, n=24, seed=1))

    bad = [o for o in outcomes if not o.good]
    assert [(o.number, o.verdict, o.change) for o in bad] == []
    assert {o.verdict for o in outcomes} == {"runs", "refused"}
