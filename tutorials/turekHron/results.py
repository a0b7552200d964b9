# SPDX-License-Identifier: GPL-3.0-or-later
"""Read the motion of the flag's tip and compare it with the reference.

Standard library only.
"""

import math
import os
import re

STEADY = ("CSM1", "CSM2")


def case_name(case):
    """CSM1, CSM2 or CSM3, as the dictionaries choose."""
    name = None
    for file in ("parameters", "case.local"):
        path = os.path.join(case, "system", file)
        if os.path.isfile(path):
            with open(path, encoding="utf-8") as lines:
                for line in lines:
                    found = re.match(r"case\s+(\w+);", line)
                    if found:
                        name = found.group(1)
    return name


def history(case):
    """Lists of time, u_x, u_y of the point A, in s and m."""
    folder = os.path.join(case, "postProcessing", "tip")
    rows = {}
    for start in sorted(os.listdir(folder), key=float):
        path = os.path.join(folder, start, "surfaceFieldValue.dat")
        with open(path, encoding="utf-8") as lines:
            for line in lines:
                if not line.startswith("#"):
                    values = line.replace("(", " ").replace(")", " ").split()
                    rows[float(values[0])] = [float(v) for v in values[1:3]]
    times = sorted(rows)
    return times, [rows[t][0] for t in times], [rows[t][1] for t in times]


def reference(case):
    """The row of reference/tip.csv of the case, by names of columns."""
    path = os.path.join(case, "reference", "tip.csv")
    with open(path, encoding="utf-8") as lines:
        rows = [line.strip().split(",") for line in lines if line[0] != "#"]
    for row in rows[1:]:
        if row[0] == case_name(case):
            return dict(zip(rows[0][1:], (float(v) for v in row[1:])))
    raise ValueError("no reference of " + str(case_name(case)))


def extrema(times, values, sign):
    """Times and values of the maxima of sign*values, by parabolas through
    three steps, of those that are larger than the mean."""
    mean = sum(values)/len(values)
    found = []
    for i in range(1, len(values) - 1):
        a, b, c = (sign*v for v in values[i - 1:i + 2])
        if a < b >= c and b > sign*mean:
            shift = 0.5*(a - c)/(a - 2*b + c)
            found.append((
                times[i] + shift*(times[i + 1] - times[i]),
                sign*(b - 0.25*(a - c)*shift)
            ))
    return found


def oscillation(times, values):
    """Mean, amplitude and frequency: means of all maxima and minima, as the
    second mode swings along."""
    high = extrema(times, values, 1)
    low = extrema(times, values, -1)
    if len(high) < 2 or len(low) < 2:
        return math.nan, math.nan, math.nan
    top = sum(value for _, value in high)/len(high)
    bottom = sum(value for _, value in low)/len(low)
    n = len(low) - 1
    return 0.5*(top + bottom), 0.5*(top - bottom), n/(low[n][0] - low[0][0])


def computed(case):
    """The quantities of the reference."""
    times, ux, uy = history(case)
    if case_name(case) in STEADY:
        return {"ux": ux[-1], "uxAmplitude": 0, "uy": uy[-1],
                "uyAmplitude": 0, "frequency": 0}
    x = oscillation(times, ux)
    y = oscillation(times, uy)
    return {"ux": x[0], "uxAmplitude": x[1], "uy": y[0],
            "uyAmplitude": y[1], "frequency": y[2]}
