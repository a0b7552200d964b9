# SPDX-License-Identifier: GPL-3.0-or-later
"""Errors of refined runs as tables `h dt error order`, as CSV and as a plot.

A run is a case folder with the file errors.dat of the function object
exactSolutionError.
"""

import csv
import glob
import math
import os

from checks import orders
from results import pyplot

QUANTITIES = ["U.fluid", "U.solid", "D", "p", "traction"]


def readHistory(case, start="*"):
    """Errors by column, one dictionary for each time written, of the run that
    began at the time start (of the last run, if several match).
    """
    files = glob.glob(os.path.join(
        case, "postProcessing", "errors", start, "errors.dat"))
    if not files:
        return []

    with open(sorted(files)[-1], encoding="ascii") as f:
        lines = [line.split() for line in f if line.strip()]

    header = [line for line in lines if line[0] == "#"][-1][2:]
    return [dict(zip(header, map(float, line[1:])))
            for line in lines if line[0] != "#"]


def readErrors(case, start="*"):
    """Those of the last time; None if the run left none."""
    history = readHistory(case, start)
    return history[-1] if history else None


class Study:
    """Runs of one kind, refined."""

    def __init__(self, name):
        self.name = name
        self.h, self.dt, self.errors = [], [], []

    def add(self, h, dt, errors):
        self.h.append(h)
        self.dt.append(dt)
        self.errors.append(errors)

    def series(self, column):
        return [e[column] if e else math.nan for e in self.errors]

    def finestOrder(self, column):
        return orders(self.h, self.series(column))[-1]

    def finestOrders(self, column):
        """Of the finest refinement, and of the two finest together."""
        h, errors = self.h[-3::2], self.series(column)[-3::2]
        return [self.finestOrder(column)] + orders(h, errors)

    def show(self, columns):
        print(f"\n{self.name}")
        for column in columns:
            errors = self.series(column)
            found = [math.nan] + orders(self.h, errors)
            print(f"  {column:14s}{'h':>10s}{'dt':>12s}{'error':>12s}{'order':>8s}")
            for h, dt, e, o in zip(self.h, self.dt, errors, found):
                order = f"{o:8.2f}" if math.isfinite(o) else 8*" "
                print(f"  {'':14s}{h:10.5f}{dt:12.4g}{e:12.3e}{order}")

    def rows(self, columns):
        for column in columns:
            errors = self.series(column)
            found = [math.nan] + orders(self.h, errors)
            for h, dt, e, o in zip(self.h, self.dt, errors, found):
                yield [self.name, column, h, dt, e, o]


def writeTable(path, studies, columns):
    with open(path, "w", newline="") as f:
        table = csv.writer(f)
        table.writerow(["study", "quantity", "h", "dt", "error", "order"])
        for study in studies:
            table.writerows(study.rows(columns))


def plot(path, title, studies, columns, order=2):
    """One picture, one panel for each column, errors over h."""
    plots = pyplot()
    if not plots:
        return

    figure, axes = plots.subplots(
        1, len(columns), figsize=(3.6*len(columns), 4), sharex=True,
        squeeze=False)

    for axis, column in zip(axes[0], columns):
        largest = 0
        for study in studies:
            errors = study.series(column)
            axis.loglog(study.h, errors, "o-", ms=3, lw=1, label=study.name)
            largest = max([largest] + [e for e in errors if e == e])
        h = [min(s.h[-1] for s in studies), max(s.h[0] for s in studies)]
        axis.loglog(h, [largest*(x/h[1])**order for x in h], "k--", lw=1,
                    label=f"order {order}")
        axis.set_title(column)
        axis.set_xlabel("h")
    axes[0][0].set_ylabel("relative error")
    axes[0][-1].legend(fontsize=6)
    figure.suptitle(title)
    figure.tight_layout()
    figure.savefig(path, dpi=130)
    plots.close(figure)
