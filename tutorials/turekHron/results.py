# SPDX-License-Identifier: GPL-3.0-or-later
"""Read the motion of the flag's tip and the force on cylinder and flag, and
compare them with the reference.

Means and amplitudes are (max + min)/2 and (max - min)/2, as in the reference:
of the last two periods, of CSM3 those of all maxima and minima. Standard
library only.
"""

import csv
import math
import os
import re

NAMES = ("ux", "uy", "drag", "lift")


def case_name(case):
    """CSM1, ..., FSI3, as the dictionaries choose."""
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


def read(case, name, files):
    """Rows of numbers of a function object, by time."""
    folder = os.path.join(case, "postProcessing", name)
    rows = {}
    if os.path.isdir(folder):
        for start in sorted(os.listdir(folder), key=float):
            for file in files:
                path = os.path.join(folder, start, file)
                if os.path.isfile(path):
                    with open(path, encoding="utf-8") as lines:
                        for line in lines:
                            if not line.startswith("#"):
                                values = re.sub("[()]", " ", line).split()
                                rows[float(values[0])] = [
                                    float(v) for v in values[1:]]
    return rows


def history(case):
    """Times [s], and lists of u_x, u_y of the point A [m], drag and lift [N/m]
    by name, of what the case has."""
    tip = read(case, "tip", ("pointDisplacement.dat",))
    load = read(case, "load", ("interfaceForce.dat", "force.dat"))
    times = sorted(tip or load)
    columns = {}
    for names, rows in ((NAMES[:2], tip), (NAMES[2:], load)):
        if rows:
            for i, name in enumerate(names):
                columns[name] = [rows[t][i] for t in times]
    return times, columns


def reference(case):
    """The row of reference/turekHron.csv of the case, by names of columns,
    without those that are empty."""
    path = os.path.join(case, "reference", "turekHron.csv")
    with open(path, encoding="utf-8") as lines:
        for row in csv.DictReader(l for l in lines if l[0] != "#"):
            if row.pop("case") == case_name(case):
                return {name: float(v) for name, v in row.items() if v}
    raise ValueError("no reference of " + str(case_name(case)))


def error(found, expected, name):
    """Of a quantity, over the reference's. Of a mean over the amplitude, if that
    is larger: means of u_y and lift are nearly 0."""
    value = expected[name]
    amplitude = expected.get(name + "Amplitude", 0)
    return (found[name] - value)/(
        value if abs(value) >= amplitude else amplitude)


def extrema(times, values, sign):
    """Times and values of the largest sign*values between two times at which
    values pass their mean, by parabolas through three steps."""
    mean = sum(values)/len(values)
    above = [sign*(v - mean) for v in values]
    found = []
    best = None
    for i in range(1, len(values) - 1):
        if above[i] <= 0:
            best = None
        elif best is None:
            # Not what has begun before
            best = i if above[i - 1] <= 0 else -1
        elif best >= 0 and above[i] > above[best]:
            best = i
        if above[i] > 0 >= above[i + 1] and best >= 0:
            a, b, c = above[best - 1:best + 2]
            bend = a - 2*b + c
            shift = 0.5*(a - c)/bend if bend else 0
            found.append((
                times[best] + shift*(times[best + 1] - times[best]),
                mean + sign*(b - 0.25*(a - c)*shift)
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


def periods(times, values, n):
    """First time of the last n periods, and their frequency."""
    # Of what has grown to its full size
    start = len(times)//2
    low = extrema(times[start:], values[start:], -1)
    if len(low) < n + 1:
        return math.nan, math.nan
    return low[-1 - n][0], n/(low[-1][0] - low[-1 - n][0])


def computed(case):
    """The quantities of the reference."""
    times, columns = history(case)
    wanted = reference(case)
    result = {}

    if "frequency" not in wanted:
        for name, values in columns.items():
            result[name] = values[-1]
    elif "drag" not in wanted:
        for name, values in columns.items():
            result[name], result[name + "Amplitude"], frequency = oscillation(
                times, values)
        result["frequency"] = frequency
    else:
        main = columns["uy" if "uy" in columns else "lift"]
        start, _ = periods(times, main, 2)
        _, result["frequency"] = periods(times, main, 4)
        for name, values in columns.items():
            last = [v for t, v in zip(times, values) if t >= start]
            result[name] = 0.5*(max(last) + min(last)) if last else math.nan
            result[name + "Amplitude"] = (
                0.5*(max(last) - min(last)) if last else math.nan)
    return result
