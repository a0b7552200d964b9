# SPDX-License-Identifier: GPL-3.0-or-later
"""What checkers read from a run, and how they write tables and pictures."""

import csv
import os
import re


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
