# SPDX-License-Identifier: GPL-3.0-or-later
"""What checkers read from a run, and how they write tables and pictures."""

import csv
import os
import re

import numpy as np

COMPONENTS = {b"scalar": 1, b"vector": 3, b"symmTensor": 6}


def cellValues(path):
    """Values of a field's cells, one row each, from an ascii or binary file."""
    with open(path, "rb") as file:
        data = file.read()
    start = re.search(
        rb"internalField\s+nonuniform\s+List<(\w+)>\s+(\d+)\s*\(", data)
    if not start:
        raise ValueError("no list of cell values in {}".format(path))
    n, size = int(start[2]), COMPONENTS[start[1]]
    if re.search(rb"format\s+binary", data[:start.start()]):
        values = np.frombuffer(data, float, n*size, start.end())
    else:
        text = data[start.end():].translate(None, b"()").split(b";")[0]
        values = np.array(text.split(), float)
    return values.reshape(n, size)


def sweeps(case):
    """Sweeps of each time step, from the log."""
    with open(os.path.join(case, "log.umfsiFoam"), encoding="ascii") as log:
        return [int(n) for n in re.findall(r" sweeps +(\d+)", log.read())]


def writeRows(path, rows):
    """Rows (dictionaries with the same keys) as csv."""
    with open(path, "w", encoding="ascii", newline="") as file:
        writer = csv.DictWriter(file, rows[0].keys(), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def pyplot():
    """Matplotlib without a display; None, and a message, if it is missing."""
    try:
        import matplotlib  # pylint: disable=import-outside-toplevel
        matplotlib.use("Agg")
        # pylint: disable-next=import-outside-toplevel
        from matplotlib import pyplot as plots
        return plots
    except ImportError:
        print("No plot: please install python3-matplotlib to get one.")
        return None
