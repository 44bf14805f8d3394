# SPDX-License-Identifier: GPL-3.0-or-later
"""Sweeps and ensembles over a case: see bin/grainFoamStudy."""
