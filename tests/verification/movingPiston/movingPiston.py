# SPDX-License-Identifier: GPL-3.0-or-later
"""Elastic piston with a moving mesh: refine mesh and time step together,
compare with the exact solution, require second order.

Usage: movingPiston.py [-test]
Run in the case folder; the runs and errors.csv go to run/.
"""

import csv
import math
import re
import shutil
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent/"tools"))

import checks       # noqa: E402
import columnCase   # noqa: E402

HEADER = columnCase.header
END_TIME = 4.0
FIRST_TIME = 2.0            # errors count from here on
N_TIMES = 20                # written in a run

# Cells of the solid and of the fluid, steps per time unit, for q = 1
CELLS = 8
STEPS = 25

LEVELS = {"full": (2, 4, 8, 16), "test": (2, 4, 8)}
ORDER, TOLERANCE = 2, 0.2
QUANTITIES = ("y", "u", "p")


class Piston:
    """A bar -Hs < Y < 0 of linear elastic material, clamped below, under a
    column of incompressible fluid y_I < y < H without viscosity.

        d(Y, t) = F(t + (Y + Hs)/cp) - F(t - (Y + Hs)/cp),   y_I = d(0, t)
        u = y_I',   p = p_I - rho (y - y_I) y_I'',   p_I = -K dd/dY

    F(s) = a sin(2 pi f x) (1 - exp(-(x/r)^4)) for x = s - Hs/cp > 0: a start
    from rest, so smooth that the first step, Euler, does not spoil the order.
    """

    Hs, H, rho, waveSpeed, poissonRatio = 0.5, 1.0, 1.0, 1.0, 0.3
    amplitude, frequency, ramp = 0.1, 0.4, 1.5

    def __init__(self, ratio):
        self.rhoS = ratio*self.rho*self.H/self.Hs
        self.modulus = self.rhoS*self.waveSpeed**2
        nu = self.poissonRatio
        self.youngsModulus = self.modulus*(1 + nu)*(1 - 2*nu)/(1 - nu)

    def wave(self, t, n):
        """n-th derivative of F, n at most 2."""
        x = t - self.Hs/self.waveSpeed
        if x <= 0:
            return 0.0
        w = 2*math.pi*self.frequency
        a = self.amplitude*self.H/(2*math.sin(w*self.Hs/self.waveSpeed))
        sine = [w**i*math.sin(w*x + i*math.pi/2) for i in range(3)]
        r = x/self.ramp
        e = math.exp(-r**4)
        smooth = [1 - e, 4*r**3/self.ramp*e,
                  (12*r**2 - 16*r**6)/self.ramp**2*e]
        return a*sum(math.comb(n, i)*sine[n - i]*smooth[i]
                     for i in range(n + 1))

    def displacement(self, t, y=0.0, n=0):
        """n-th time derivative of d."""
        x = (y + self.Hs)/self.waveSpeed
        return self.wave(t + x, n) - self.wave(t - x, n)

    def interfacePressure(self, t):
        x = self.Hs/self.waveSpeed
        return -self.modulus/self.waveSpeed*(
            self.wave(t + x, 1) + self.wave(t - x, 1))

    def pressure(self, t, y):
        return self.interfacePressure(t) - self.rho*(
            y - self.displacement(t))*self.displacement(t, 0.0, 2)


def fieldFile(name, kind, dimensions, values, patches):
    text = HEADER(f"vol{kind.capitalize()}Field", name)
    text += f"dimensions {dimensions};\ninternalField "
    text += columnCase.nonuniform(kind, values) + ";\nboundaryField\n{\n"
    for patch, condition in patches.items():
        text += f"    {patch} {{ {condition} }}\n"
    return text + ("    sides { type symmetryPlane; }\n"
                   "    frontAndBack { type empty; }\n}\n")


def write(case, piston, q, coupling, scheme):
    """A fresh case folder."""
    shutil.rmtree(case, ignore_errors=True)
    for folder in ("0", "constant", "system"):
        (case/folder).mkdir(parents=True)
    for name in ("fvSchemes", "fvSolution"):
        shutil.copy(columnCase.COMMON/"system"/name, case/"system")

    n = CELLS*q
    dt = 1/(STEPS*q)
    nSteps = round(END_TIME/dt)
    width = piston.H/n

    (case/"system"/"parameters").write_text(
        HEADER("dictionary", "parameters") + f"timeScheme {scheme};\n",
        encoding="ascii")
    (case/"system"/"controlDict").write_text(
        HEADER("dictionary", "controlDict")
      + f"startFrom startTime; startTime 0; stopAt endTime;\n"
        f"endTime {END_TIME}; deltaT {dt:.17g};\n"
        f"writeControl timeStep; writeInterval {nSteps//N_TIMES};\n"
        "writeFormat ascii; writePrecision 16; timePrecision 12;\n",
        encoding="ascii")
    points = "".join(
        f"({x:.17g} {y:.17g} {z:.17g})\n"
        for z in (0, width) for y in (-piston.Hs, 0, piston.H)
        for x in (0, width))
    (case/"system"/"blockMeshDict").write_text(
        HEADER("dictionary", "blockMeshDict")
      + f"vertices\n(\n{points});\n"
        f"blocks\n(\n"
        f"hex (0 1 3 2 6 7 9 8) solid (1 {n} 1) simpleGrading (1 1 1)\n"
        f"hex (2 3 5 4 8 9 11 10) fluid (1 {n} 1) simpleGrading (1 1 1)\n);\n"
        "boundary\n(\n"
        "bottom { type wall; faces ((0 1 7 6)); }\n"
        "top { type patch; faces ((4 10 11 5)); }\n"
        "left { type symmetryPlane; faces ((0 6 8 2) (2 8 10 4)); }\n"
        "right { type symmetryPlane; faces ((1 3 9 7) (3 5 11 9)); }\n"
        "frontAndBack { type empty; faces"
        " ((0 2 3 1) (2 4 5 3) (6 7 9 8) (8 9 11 10)); }\n);\n",
        encoding="ascii")
    (case/"constant"/"materialProperties").write_text(
        HEADER("dictionary", "materialProperties")
      + "fluid { type newtonianFluid; cellZones (fluid);"
        f" rho {piston.rho}; mu 1e-9; }}\n"
        "solid { type linearElastic; cellZones (solid);"
        f" rho {piston.rhoS:.17g}; E {piston.youngsModulus:.17g};"
        f" nu {piston.poissonRatio}; faceStiffness compact; }}\n"
        "kinematics planeStrain;\n",
        encoding="ascii")
    (case/"constant"/"dynamicMeshDict").write_text(
        HEADER("dictionary", "dynamicMeshDict")
      + "dynamicFvMesh dynamicMotionSolverFvMesh;\n"
        "motionSolver displacementLaplacian;\n"
        f"coupling {coupling};\n",
        encoding="ascii")

    hs, hf = piston.Hs/n, piston.H/n
    solid = [-piston.Hs + (j + 0.5)*hs for j in range(n)]
    y = piston.displacement(0)
    fluid = [y + (j + 0.5)*(piston.H - y)/n for j in range(n)]
    top = "".join(
        f"({i*dt:.17g} {piston.pressure(i*dt, piston.H):.17g})\n"
        for i in range(nSteps + 1))
    vector = columnCase.vector
    sides = {"left": "type symmetryPlane;", "right": "type symmetryPlane;"}
    still = "type fixedValue; value uniform (0 0 0);"
    fields = {
        "U": (
            "vector", "[0 1 -1 0 0 0 0]",
            [vector(1, piston.displacement(0, Y, 1)) for Y in solid]
          + [vector(1, piston.displacement(0, 0.0, 1))]*n,
            {"bottom": still, "top": "type zeroGradient;"}),
        "D": (
            "vector", "[0 1 0 0 0 0 0]",
            [vector(1, piston.displacement(0, Y)) for Y in solid]
          + [vector(1, 0)]*n,
            {"bottom": "type calculated; value uniform (0 0 0);",
             "top": "type calculated; value uniform (0 0 0);"}),
        "p": (
            "scalar", "[1 -1 -2 0 0 0 0]",
            ["0"]*n + [f"{piston.pressure(0, x):.17g}" for x in fluid],
            {"bottom": "type zeroGradient;",
             "top": "type uniformFixedValue; uniformValue table\n(\n"
                  + top + ");"}),
    }
    for name, (kind, dimensions, values, patches) in fields.items():
        text = fieldFile(name, kind, dimensions, values, {**patches, **sides})
        text = text.replace("    sides { type symmetryPlane; }\n", "")
        (case/"0"/name).write_text(text, encoding="ascii")


def values(path):
    """All numbers of a list of an ascii file, one tuple for each entry."""
    text = path.read_text(encoding="ascii")
    found = re.search(r"\n(\d+)\s*\n\(\n(.*?)\n\)", text, re.S)
    return [tuple(map(float, line.strip("()").split()))
            for line in found[2].split("\n")]


def measure(case, piston, q):
    """Largest errors over the times that count."""
    n = CELLS*q
    errors = dict.fromkeys(QUANTITIES, 0.0)
    count = 0

    for folder in case.iterdir():
        try:
            t = float(folder.name)
        except ValueError:
            continue
        if t < FIRST_TIME - 1e-9:
            continue
        count += 1
        levels = sorted(p[1] for p in values(folder/"polyMesh"/"points")
                        if abs(p[0]) < 1e-9 and abs(p[2]) < 1e-9)
        if len(levels) != 2*n + 1:
            raise ValueError(f"{len(levels)} levels of points")
        edges = levels[n:]
        u = values(folder/"U")[n:]
        p = values(folder/"p")[n:]
        exact = piston.displacement(t)
        errors["y"] = max(errors["y"], abs(edges[0] - exact))
        for j in range(n):
            y = 0.5*(edges[j] + edges[j + 1])
            errors["u"] = max(
                errors["u"], abs(u[j][1] - piston.displacement(t, 0.0, 1)))
            errors["p"] = max(
                errors["p"], abs(p[j][0] - piston.pressure(t, y)))

    if count < N_TIMES//2:
        raise ValueError(f"{count} times written")
    log = (case/"log.umfsiFoam").read_text(errors="replace")
    picard = [int(i) for i in re.findall(r"  Picard (\d+)", log)]
    sweeps = [int(i) for i in re.findall(r"  sweeps (\d+)", log)]
    return errors, sum(picard)/len(picard), sum(sweeps)/len(sweeps)


def main(arguments):
    if arguments not in ([], ["-test"]):
        sys.exit(__doc__)
    levels = LEVELS["test" if arguments else "full"]
    folder = Path.cwd()/"run"
    folder.mkdir(exist_ok=True)
    counted = checks.Checks()
    rows = []

    for coupling in ("implicit", "explicit"):
        for ratio in (100, 1, 0.01):
            label = f"rho_s/rho_f {ratio} {coupling}"
            results = []
            for q in levels:
                piston = Piston(ratio)
                case = folder/f"{coupling}_{ratio}_{q}"
                write(case, piston, q, coupling, "backward")
                fault = (columnCase.run(case, "blockMesh")
                      or columnCase.run(case, columnCase.SOLVER))
                try:
                    if fault:
                        raise ValueError(fault)
                    results.append(measure(case, piston, q))
                except (OSError, ValueError) as error:
                    counted.check(False, f"{label}: {error}")
                    break
            else:
                steps = [1/q for q in levels]
                for name in QUANTITIES:
                    errors = [r[0][name] for r in results]
                    found = checks.orders(steps, errors)
                    counted.check(
                        checks.orderIs(ORDER, TOLERANCE, steps, errors),
                        f"{label}: order of {name} "
                      + ", ".join(f"{o:.2f}" for o in found)
                      + f", error {errors[-1]:.1e}, Picard iterations"
                        f" {results[-1][1]:.1f}, sweeps {results[-1][2]:.1f}")
                    for q, error in zip(levels, errors):
                        rows.append((coupling, ratio, q, name, error))

    with open(folder/"errors.csv", "w", newline="", encoding="ascii") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(("coupling", "ratio", "q", "quantity", "error"))
        table.writerows(rows)
    return counted.close()


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
