# SPDX-License-Identifier: GPL-3.0-or-later
"""Cell values and function object data of a case, written in ascii."""

import glob
import os
import re
import sys

import numpy as np

sys.path.insert(0, os.path.join(
    os.path.dirname(os.path.abspath(__file__)), os.pardir, "tools"))

from results import cellValues                                  # noqa: E402


def lastTime(case):
    """Name of the last time folder."""
    return max(
        (name for name in os.listdir(case)
         if re.fullmatch(r"[\d.]+(e[+-]?\d+)?", name)), key=float)


def cells(case, name):
    """Cell values of a field at the last time: (cells) or (cells, n)."""
    values = cellValues(os.path.join(case, lastTime(case), name))
    return values[:, 0] if values.shape[1] == 1 else values


def levels(case):
    """Rows of enclosedFluids.dat: times, then displaced, compliance and p, each
    with one column for each region.
    """
    files = glob.glob(os.path.join(
        case, "postProcessing", "level", "*", "enclosedFluids.dat"))
    rows = np.concatenate([
        np.loadtxt(path, ndmin=2)
        for path in sorted(files, key=lambda path: float(path.split("/")[-2]))])
    return rows[:, 0], rows[:, 1::3], rows[:, 2::3], rows[:, 3::3]


def log(case):
    with open(os.path.join(case, "log.umfsiFoam"), encoding="utf-8") as file:
        return file.read()
