# SPDX-License-Identifier: GPL-3.0-or-later
"""What grainFoam writes, for python: see grainfoam.tables."""
