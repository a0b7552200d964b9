#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Time the three programs of a case.

Usage: measureSpeed.py <case> <steps> <repetitions> <processes>

The case has the folders umfsiFoam, pimpleFoam and solid (umfsiFoam on the
solids alone), ready to run. Each is run to its last step and to the middle,
in turn: the difference is the cost of a step, the rest that of the start.
Appends a line to run/speed.csv. CPU times of user and system [s]; the parallel
runs' are wall-clock times. The last line is "N passed, N failed".
"""

import csv
import os
import re
import shutil
import statistics
import subprocess
import sys
import time

COLUMNS = (
    "case", "cells", "steps", "sweeps",
    "umfsiFoam_step", "umfsiFoam_start", "pimpleFoam_step",
    "pimpleFoam_start", "solid_step", "solid_start",
    "memory_kB_per_cell", "serial_wall", "parallel_wall", "processes")


def setEntries(case, **entries):
    with open(os.path.join(case, "system/parameters.local"), "a") as f:
        for key, value in entries.items():
            f.write("%s %s;\n" % (key, value))


def run(command, case, log):
    """Seconds of CPU and of the clock, memory [kB]; None if it failed."""
    for name in os.listdir(case):
        if re.fullmatch(r"[0-9.e-]+", name) and name != "0":
            shutil.rmtree(os.path.join(case, name))
    path = os.path.join(case, log)
    start = time.monotonic()
    with open(path, "w") as f:
        process = subprocess.Popen(
            command, cwd=case, stdout=f, stderr=subprocess.STDOUT)
        _, status, usage = os.wait4(process.pid, 0)
    wall = time.monotonic() - start
    with open(path) as f:
        text = f.read()
    if status != 0 or "\nEnd\n" not in text or "not converge" in text:
        return None
    return usage.ru_utime + usage.ru_stime, wall, usage.ru_maxrss


def nCells(case):
    with open(os.path.join(case, "constant/polyMesh/owner"), "rb") as f:
        return int(re.search(rb"nCells: *([0-9]+)", f.read(4000)).group(1))


def sweeps(case, log):
    """Mean of the sweeps of a step."""
    with open(os.path.join(case, log)) as f:
        counts = [int(n) for n in re.findall(
            r"^Time = .*sweeps ([0-9]+)", f.read(), re.M)]
    return sum(counts)/len(counts)


def main():
    case, steps, repetitions = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
    processes = int(sys.argv[4])
    programs = {
        "pimpleFoam": "pimpleFoam", "solid": "umfsiFoam",
        "umfsiFoam": "umfsiFoam"}
    folder = {name: os.path.join(case, name) for name in programs}
    passed = failed = 0
    times = {}
    walls = []
    memory = 0

    def check(ok, what):
        nonlocal passed, failed
        print("pass:" if ok else "FAIL:", what)
        passed += bool(ok)
        failed += not ok

    with open(os.path.join(case, "pimpleFoam/system/parameters.local")) as f:
        deltaT = float(re.search(r"deltaT +(.*);", f.read()).group(1))

    half = steps//2
    for repetition in range(repetitions):
        for n in (half, steps):
            for name, program in programs.items():
                setEntries(folder[name], endTime="%.10g" % (n*deltaT))
                log = "log.%s.%d" % (program, n)
                result = run([program], folder[name], log)
                if result is None:
                    check(False, "%s/%s did not complete" % (
                        folder[name], log))
                    break
                times.setdefault((name, n), []).append(result[0])
                if (name, n) == ("umfsiFoam", steps):
                    walls.append(result[1])
                    memory = result[2]

    complete = len(times) == 6
    check(complete, "all programs completed")
    if complete:
        row = {
            "case": os.path.basename(case), "cells": nCells(
                folder["umfsiFoam"]), "steps": steps,
            "sweeps": "%.2f" % sweeps(
                folder["umfsiFoam"], "log.umfsiFoam.%d" % steps),
            "processes": processes,
            "serial_wall": "%.3f" % statistics.median(walls)}
        for name in programs:
            whole, part = (
                statistics.median(times[name, n]) for n in (steps, half))
            step = (whole - part)/(steps - half)
            row[name + "_step"] = "%.5f" % step
            row[name + "_start"] = "%.3f" % (whole - steps*step)
        row["memory_kB_per_cell"] = "%.2f" % (memory/row["cells"])

        if processes > 1:
            row["parallel_wall"] = parallel(
                folder["umfsiFoam"], processes, repetitions)
            check(row["parallel_wall"], "%d processes" % processes)

        new = not os.path.exists("run/speed.csv")
        with open("run/speed.csv", "a", newline="") as f:
            writer = csv.DictWriter(f, COLUMNS)
            if new:
                writer.writeheader()
            writer.writerow(row)

    print("%d passed, %d failed" % (passed, failed))
    sys.exit(failed > 0)


def parallel(case, processes, repetitions):
    """Median of the wall-clock time on some processes."""
    with open(os.path.join(case, "system/decomposeParDict"), "w") as f:
        f.write(
            "FoamFile { version 2.0; format ascii; class dictionary;"
            " object decomposeParDict; }\n"
            "numberOfSubdomains %d;\nmethod simple;\n"
            "coeffs { n (%d 1 1); }\n" % (processes, processes))
    with open(os.path.join(case, "log.decomposePar"), "w") as f:
        status = subprocess.call(
            ["decomposePar", "-force"], cwd=case, stdout=f, stderr=f)
    if status != 0:
        return None
    walls = []
    for repetition in range(repetitions):
        for i in range(processes):
            folder = os.path.join(case, "processor%d" % i)
            for name in os.listdir(folder):
                if re.fullmatch(r"[0-9.e-]+", name) and name != "0":
                    shutil.rmtree(os.path.join(folder, name))
        result = run(
            ["mpirun", "-np", str(processes), "umfsiFoam", "-parallel"],
            case, "log.umfsiFoam.parallel")
        if result is None:
            return None
        walls.append(result[1])
    return "%.3f" % statistics.median(walls)


if __name__ == "__main__":
    main()
