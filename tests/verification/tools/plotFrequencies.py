# SPDX-License-Identifier: GPL-3.0-or-later
"""Plot run/frequencies.csv of the current case to run/frequencies.png."""

import csv
import sys
from pathlib import Path

import results

pyplot = results.pyplot()
if not pyplot:
    sys.exit(0)

from matplotlib import ticker   # noqa: E402

SOURCE = Path("run/frequencies.csv")
if not SOURCE.is_file():
    print("No plot: please run Allrun first.")
    sys.exit(0)

with open(SOURCE, newline="", encoding="ascii") as lines:
    rows = list(csv.DictReader(lines))

figure, axes = pyplot.subplots(1, 2, figsize=(9, 4), sharey=True)
for axis, scheme in zip(axes, ("Euler", "backward")):
    for case in dict.fromkeys(row["case"] for row in rows):
        series = [row for row in rows
                  if row["case"] == case and row["scheme"] == scheme]
        if not series:
            continue
        steps = [float(row["dt"])*float(series[0]["w_r"]) for row in series]
        line, = axis.loglog(
            steps, [float(row["error"]) for row in series], "o", label=case)
        axis.loglog(
            steps, [float(row["err_dt"]) for row in series], "-",
            color=line.get_color(), linewidth=0.8)
    axis.set_title(scheme)
    axis.set_xlabel("w dt")
    axis.xaxis.set_minor_formatter(ticker.NullFormatter())
    axis.grid(True, which="both", linewidth=0.3)
axes[0].set_ylabel("|w - w_exact|/|w_exact|")
axes[0].legend(title="line: time scheme alone")
figure.tight_layout()
figure.savefig("run/frequencies.png", dpi=120)
print("Plot: run/frequencies.png")
