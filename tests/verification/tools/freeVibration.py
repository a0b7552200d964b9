# SPDX-License-Identifier: GPL-3.0-or-later
"""Free vibration of a fluid column on an elastic solid: refine time step and
mesh, measure the complex frequency, require the order of the time scheme.

Usage: freeVibration.py <addedMassPiston|shearSlab> [-test]
Run in the case folder; the runs, frequencies.csv and the logs go to run/.
"""

import cmath
import csv
import math
import subprocess
import sys
import time
from pathlib import Path

import checks
import columnCase
import exactModes
import modeFit

# scheme: order of |w - w_exact|, tolerance, order of the amplitude loss.
# One mode of the exact scheme: BDF2 errs by (w dt)^2/3 in frequency and by
# (w dt)^3/4 in damping; Euler by (w dt)^2/3 and by (w dt)/2.
SCHEMES = {"Euler": (1, 0.15, 1), "backward": (2, 0.2, 3)}

# (cells per unit length, steps per period). Backward refines both; Euler
# keeps a mesh whose error is far below that of its time steps.
LEVELS = {
    "full": {
        "Euler": ((80, 40), (80, 80), (80, 160), (80, 320)),
        "backward": ((20, 40), (40, 80), (80, 160), (160, 320)),
    },
    "test": {
        "Euler": ((40, 20), (40, 40), (40, 80)),
        "backward": ((16, 20), (32, 40), (64, 80)),
    },
}
PERIODS = 2                 # length of the fitted series
# Of the mode's shape on the finest mesh. The viscous layer decides: phase
# error (kf h)^2/24 kf y = 0.012 at y = 0.25 on 40 cells per unit length
SHAPE_TOLERANCE = 0.02
MISFIT_TOLERANCE = 0.002    # what one mode leaves of the series
# Loss per period beyond the scheme's own: a twentieth of it, and what the
# residual tolerance of 1e-6 may do in a period of steps
LOSS_TOLERANCE = (0.05, 1e-4)
# Of p, relative to the shear stress rho_s c_s U. The residual tolerance 1e-6
# of momentum lets through rho U h/dt 1e-6, on the finest mesh 1e-5 of that
STILL_TOLERANCE = 1e-4

# Name, printed width and format; the last ones go to the csv file only
LAYOUT = (
    ("case", 10, ""), ("scheme", 9, ""), ("h", 8, ".4g"), ("dt", 9, ".4g"),
    ("w_r", 11, ".7f"), ("w_i", 11, ".7f"),
    ("error", 9, ".1e"), ("order", 6, ".2f"),
)
COLUMNS = [name for name, _, _ in LAYOUT] + [
    "err_r", "order_r", "err_i", "order_i", "err_dt", "seconds"]


def startSteps(stepsPerPeriod):
    """Steps left out of the fit: the first step of backward is Euler, which
    excites the scheme's second root, about 1/3 per step.
    """
    return 4 + stepsPerPeriod//10


def simulate(case, template, problem, scheme, level):
    """Run one case. A fault, or the result as a dictionary."""
    cellsPerUnit, stepsPerPeriod = level
    w = problem.frequency
    dt = 2*math.pi/w.real/stepsPerPeriod
    start = startSteps(stepsPerPeriod)
    nSteps = start + PERIODS*stepsPerPeriod
    columnCase.write(
        case, template, problem, cellsPerUnit, scheme, dt, nSteps)
    began = time.monotonic()
    for application in ("blockMesh", columnCase.SOLVER):
        fault = columnCase.run(case, application)
        if fault:
            return fault
    seconds = time.monotonic() - began
    try:
        result = measure(case, problem, level, start, nSteps)
    except (OSError, ValueError, ArithmeticError) as error:
        return f"{case.name}: {error}"
    result.update(h=1/cellsPerUnit, dt=dt, seconds=seconds)
    result["schemeError"] = abs(
        exactModes.schemeFrequency(scheme, w, dt) - w)/abs(w)
    return result


def measure(case, problem, level, start, nSteps):
    """Frequency, shape and pressure of the probes' series."""
    folder = case/"postProcessing"/"probes"/"0"
    times, velocities = modeFit.readProbes(folder/"U")
    _, pressures = modeFit.readProbes(folder/"p")
    if len(times) != nSteps:
        raise ValueError(f"{len(times)} of {nSteps} time steps in the probes")
    inSolid, inFluid = [
        [vector[problem.direction] for vector in series]
        for series in velocities]
    w, solid, misfit = modeFit.fit(times[start:], inSolid[start:], level[1])

    def ratio(series, exact):
        """Amplitude over that of the solid probe, and over the exact one."""
        found = modeFit.amplitude(w, times[start:], series[start:])/solid
        return found/(exact/problem.velocity(below))

    below, above = columnCase.probePoints(problem, level[0])
    shape = {"U": abs(ratio(inFluid, problem.velocity(above)) - 1)}
    if problem.pressure(above) != 0:
        shape["p"] = abs(
            ratio(pressures[1], problem.pressure(above)) - 1)
    return {
        "w": w, "misfit": misfit, "shape": shape,
        "maxP": max(abs(p) for p in pressures[1]),
    }


def relativeErrors(problem, results):
    exact = problem.frequency
    differences = [(r["w"] - exact)/abs(exact) for r in results]
    return {
        "": [abs(d) for d in differences],
        "_r": [abs(d.real) for d in differences],
        "_i": [abs(d.imag) for d in differences],
    }


def tableRows(label, scheme, problem, results):
    """Rows of the printed table and of the csv file."""
    errors = relativeErrors(problem, results)
    steps = [r["dt"] for r in results]
    found = {key: [math.nan] + checks.orders(steps, values)
             for key, values in errors.items()}
    return [
        (label, scheme, r["h"], r["dt"], r["w"].real, r["w"].imag,
         errors[""][i], found[""][i], errors["_r"][i], found["_r"][i],
         errors["_i"][i], found["_i"][i], r["schemeError"], r["seconds"])
        for i, r in enumerate(results)
    ]


def printTable(rows):
    if not rows:
        return
    print("".join(f"{name:>{width}s}" for name, width, _ in LAYOUT))
    for row in rows:
        print("".join(
            f"{'-':>{width}s}" if value != value else f"{value:>{width}{form}}"
            for value, (_, width, form) in zip(row, LAYOUT)))
    sys.stdout.flush()


def judge(counted, label, scheme, problem, results):
    """All requirements on one series of refinements."""
    order, tolerance, lossOrder = SCHEMES[scheme]
    steps = [r["dt"] for r in results]
    errors = relativeErrors(problem, results)
    found = checks.orders(steps, errors[""])
    counted.check(
        checks.orderIs(order, tolerance, steps, errors[""]),
        f"{label} {scheme}: order of |w - w_exact| "
        + ", ".join(f"{o:.2f}" for o in found)
        + f" (finest and mean {order} +- {tolerance})")
    for key, part, theory in (("_r", "frequency", 2),
                              ("_i", "damping", lossOrder)):
        text = f"     {label} {scheme}: order of the {part} " + ", ".join(
            f"{o:.2f}" for o in checks.orders(steps, errors[key]))
        if problem.frequency.imag == 0:
            text += f" (theory {theory})"
        print(text)
    finest = results[-1]
    counted.check(
        finest["misfit"] <= MISFIT_TOLERANCE,
        f"{label} {scheme}: one mode leaves {finest['misfit']:.1e} of the "
        f"series (at most {MISFIT_TOLERANCE})")
    for name, error in finest["shape"].items():
        counted.check(
            error <= SHAPE_TOLERANCE,
            f"{label} {scheme}: amplitude and phase of {name} in the fluid, "
            f"error {error:.1e} (at most {SHAPE_TOLERANCE})")
    if problem.frequency.imag == 0:
        judgeLoss(counted, label, scheme, problem, results)
    if "p" not in finest["shape"]:
        stress = problem.rhoS*problem.waveSpeed*exactModes.INTERFACE_SPEED
        counted.check(
            finest["maxP"] <= STILL_TOLERANCE*stress,
            f"{label} {scheme}: max |p| {finest['maxP']:.1e} Pa, exact 0 "
            f"(at most {STILL_TOLERANCE*stress:.1e})")


def judgeLoss(counted, label, scheme, problem, results):
    """Undamped mode: the loss per period is the time scheme's and no more."""
    def loss(w):
        return 1 - math.exp(-2*math.pi*w.imag/w.real)

    relative, absolute = LOSS_TOLERANCE
    for r in results:
        found = loss(r["w"])
        expected = loss(
            exactModes.schemeFrequency(scheme, problem.frequency, r["dt"]))
        counted.check(
            abs(found - expected) <= relative*expected + absolute,
            f"{label} {scheme}: dt {r['dt']:.4g}: amplitude loss per period "
            f"{found:.3e} (scheme {expected:.3e}, within {relative:.0%} "
            f"+ {absolute})")


def checkRoot(counted, label, problem):
    difference = abs(problem.root - problem.listedRoot)
    root = f"{problem.root:.9g}"
    if cmath.phase(problem.root) != 0:
        root = f"{problem.root.real:.8f}{problem.root.imag:+.8f}i"
    counted.check(
        difference <= problem.listedTolerance,
        f"{label}: exact root {root}, listed number within "
        f"{problem.listedTolerance}")


def main(arguments):
    if not arguments or arguments[0] not in exactModes.PROBLEMS \
            or arguments[1:] not in ([], ["-test"]):
        sys.exit(__doc__)
    problemClass = exactModes.PROBLEMS[arguments[0]]
    levels = LEVELS["test" if arguments[1:] else "full"]
    template = Path.cwd()
    folder = template/"run"
    folder.mkdir(exist_ok=True)
    counted = checks.Checks()
    allRows = []

    for value in problemClass.listed:
        checkRoot(counted, f"{problemClass.symbol} = {value}",
                  problemClass(value))
    for value in problemClass.values:
        problem = problemClass(value)
        label = f"{problemClass.symbol} = {value}"
        for scheme in SCHEMES:
            results = []
            for level in levels[scheme]:
                case = folder/"{}_{}_{}_{}".format(value, scheme, *level)
                result = simulate(case, template, problem, scheme, level)
                if isinstance(result, str):
                    counted.check(False, f"{label} {scheme}: {result}")
                    break
                results.append(result)
            else:
                counted.check(True, f"{label} {scheme}: runs complete")
                judge(counted, label, scheme, problem, results)
            rows = tableRows(
                f"{problemClass.symbol}={value}", scheme, problem, results)
            printTable(rows)
            print(flush=True)
            allRows += rows

    with open(folder/"frequencies.csv", "w", newline="",
              encoding="ascii") as output:
        writer = csv.writer(output)
        writer.writerow(COLUMNS)
        writer.writerows(allRows)
    if allRows and levels is LEVELS["full"]:
        plot = Path(__file__).resolve().parent/"plotFrequencies.py"
        subprocess.run([sys.executable, str(plot)], check=False)
    return counted.close()


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
