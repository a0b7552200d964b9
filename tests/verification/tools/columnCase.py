# SPDX-License-Identifier: GPL-3.0-or-later
"""Case folder of one run: one column of cells, solid below, fluid above."""

import re
import shutil
import subprocess
from pathlib import Path

SOLVER = "umfsiFoam"
COMMON = Path(__file__).resolve().parent/"columnTemplate"
UNCONVERGED = re.compile(
    r"unconverged (?!0;)|(not|no|n't|without)\s+(yet\s+)?(fully\s+)?converge",
    re.I)


def centres(problem, cellsPerUnit):
    """Cell centres in blockMesh order: solid from below, then fluid."""
    h = 1/cellsPerUnit
    nSolid = round(problem.Hs*cellsPerUnit)
    nFluid = round(problem.H*cellsPerUnit)
    return (
        [-problem.Hs + (j + 0.5)*h for j in range(nSolid)],
        [(j + 0.5)*h for j in range(nFluid)],
    )


def header(kind, name):
    return (
        "FoamFile { version 2.0; format ascii; class " + kind
      + "; object " + name + "; }\n"
    )


def vector(direction, value):
    parts = ["0", "0", "0"]
    parts[direction] = f"{value:.17g}"
    return "(" + " ".join(parts) + ")"


def nonuniform(kind, values):
    return (
        f"nonuniform List<{kind}>\n{len(values)}\n(\n"
      + "\n".join(values) + "\n)"
    )


def fieldText(name, kind, dimensions, values, patches):
    text = header(f"vol{kind.capitalize()}Field", name)
    text += f"dimensions {dimensions};\n"
    text += "internalField " + nonuniform(kind, values) + ";\n"
    text += "boundaryField\n{\n"
    for patch, condition in patches.items():
        text += f"    {patch} {{ {condition} }}\n"
    return text + "    frontAndBack { type empty; }\n}\n"


def fieldPatches(conditions):
    """The dictionary of `sides`, `bottom`, `top` for the patches."""
    return {
        "left": conditions["sides"], "right": conditions["sides"],
        "bottom": conditions["bottom"], "top": conditions["top"],
    }


def initialFields(problem, cellsPerUnit):
    """Texts of 0/U, 0/D and 0/p: the mode's real part at t = 0."""
    solid, fluid = centres(problem, cellsPerUnit)
    axis = problem.direction
    velocity = [vector(axis, problem.velocity(y).real) for y in solid + fluid]
    pressure = [f"{problem.pressure(y).real:.17g}" for y in solid + fluid]
    displacement = (
        [vector(axis, problem.displacement(y).real) for y in solid]
      + [vector(axis, 0)]*len(fluid)
    )
    # One side face per cell, in the cells' order
    dSides = "type " + problem.dSides + ";"
    if problem.dSides == "calculated":
        dSides += " value " + nonuniform("vector", displacement) + ";"
    still = "type calculated; value uniform (0 0 0);"
    return {
        "U": fieldText(
            "U", "vector", "[0 1 -1 0 0 0 0]", velocity,
            fieldPatches(problem.patches["U"])),
        "D": fieldText(
            "D", "vector", "[0 1 0 0 0 0 0]", displacement,
            fieldPatches({"sides": dSides, "bottom": still, "top": still})),
        "p": fieldText(
            "p", "scalar", "[1 -1 -2 0 0 0 0]", pressure,
            fieldPatches(problem.patches["p"])),
    }


def probePoints(problem, cellsPerUnit):
    """Centres of a solid cell, where higher modes of a light solid have
    their node, at the interface, and of a fluid cell, a quarter up.
    """
    solid, fluid = centres(problem, cellsPerUnit)
    return solid[-1], fluid[len(fluid)//4]


def write(case, template, problem, cellsPerUnit, scheme, dt, nSteps):
    """A fresh case folder from the common and the problem's own files."""
    shutil.rmtree(case, ignore_errors=True)
    for source in (COMMON, template):
        for folder in ("constant", "system"):
            (case/folder).mkdir(parents=True, exist_ok=True)
            for path in (source/folder).glob("*"):
                shutil.copy(path, case/folder)
    solid, fluid = centres(problem, cellsPerUnit)
    h = 1/cellsPerUnit
    below, above = probePoints(problem, cellsPerUnit)
    (case/"system"/"parameters").write_text(
        header("dictionary", "parameters")
      + f"nSolidCells {len(solid)};\n"
      + f"nFluidCells {len(fluid)};\n"
      + f"bottom -{len(solid)};      // in cells, as in blockMeshDict\n"
      + f"cellSize {h:.17g};\n"
      + f"timeScheme {scheme};\n"
      + f"timeStep {dt:.17g};\n"
      + f"lastTime {nSteps*dt:.17g};\n"
      + f"probeInSolid ({h/2:.17g} {below:.17g} {h/2:.17g});\n"
      + f"probeInFluid ({h/2:.17g} {above:.17g} {h/2:.17g});\n",
        encoding="ascii")
    (case/"constant"/"solidProperties").write_text(
        f"rho {problem.rhoS:.17g};\n"
      + f"E {problem.youngsModulus:.17g};\n"
      + f"nu {problem.poissonRatio:.17g};\n",
        encoding="ascii")
    (case/"0").mkdir()
    for name, text in initialFields(problem, cellsPerUnit).items():
        (case/"0"/name).write_text(text, encoding="ascii")


def logFault(text, status):
    """Why a run counts as incomplete; empty if it is complete."""
    if status != 0:
        return f"exit status {status}"
    if "FOAM FATAL" in text:
        return "FOAM FATAL in the log"
    if not re.search(r"^End\s*$", text, re.M):
        return "no End in the log"
    if UNCONVERGED.search(text):
        return "unconverged time steps"
    return ""


def run(case, application):
    """Run an application in the case; the fault found, or nothing."""
    log = case/("log." + application)
    with open(log, "w", encoding="ascii") as output:
        try:
            status = subprocess.run(
                [application], cwd=case, stdout=output, check=False,
                stderr=subprocess.STDOUT, timeout=1800).returncode
        except OSError as error:
            return f"{application}: {error.strerror}"
        except subprocess.TimeoutExpired:
            return f"{application}: no end after 1800 s"
    fault = logFault(log.read_text(errors="replace"), status)
    return f"{application}: {fault} ({log})" if fault else ""
