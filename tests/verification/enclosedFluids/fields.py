# SPDX-License-Identifier: GPL-3.0-or-later
"""Cell values and function object data of a case, written in ascii."""

import glob
import os
import re

import numpy as np


def lastTime(case):
    """Name of the last time folder."""
    return max(
        (name for name in os.listdir(case)
         if re.fullmatch(r"[\d.]+(e[+-]?\d+)?", name)), key=float)


def cells(case, name):
    """Cell values of a field at the last time: (cells) or (cells, n)."""
    path = os.path.join(case, lastTime(case), name)
    with open(path, encoding="ascii") as file:
        text = file.read()
    found = re.search(
        r"internalField\s+nonuniform\s+List<\w+>\s+(\d+)\s*\((.*?)\n\)\s*;",
        text, re.DOTALL)
    if not found:
        raise ValueError("no list of cell values in " + path)
    n = int(found[1])
    values = np.array(
        found[2].replace("(", " ").replace(")", " ").split(), float)
    return values.reshape(n, -1) if len(values) > n else values


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
