#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The cases whose cost is measured.

Usage: speedCases.py names [-quick]
       speedCases.py parameters <case>

names       names of all cases, or of the small ones
parameters  entries of system/parameters.local of a case
"""

import os
import sys

sys.path.append(os.path.join(
    os.path.dirname(os.path.abspath(__file__)),
    "../../verification/robustness"))
import sweepCases

# The tutorial poiseuille: as many cells along as across, a third in each layer
PLATES = dict(
    shape="channel", length=0.3, height=0.04, yBottom=-0.04, yTop=0.08,
    depth=1, nz=1, sides="empty", rhoFluid=1000, mu=0.02, rhoSolid=7860,
    E=2.03e11, nu=0.33, ends="slip", outer="slip", pInlet=30, pOutlet=1,
    deltaT=0.05, nSteps=60)


def plates(n, **other):
    """n cells along, n/3 in each layer."""
    return dict(PLATES, nx=n, nyFluid=n//3, nyPlate=n//3, **other)


def plates3D(n, nSteps=10):
    """2 n cells along, n in each layer, n across."""
    return dict(
        PLATES, nx=2*n, nyFluid=n, nyPlate=n, nz=n, depth=0.04,
        sides="symmetryPlane", nSteps=nSteps)


def robustness(name, **other):
    """A case of the robustness table, with more steps or cells."""
    entries = dict(sweepCases.entries(name), depth=1, nz=1, sides="empty",
                   pInlet=1, pOutlet=0, ends="fixedValue",
                   outer="solidTraction", mu=0.01)
    entries["nyPlate"] = entries.get("nyWall", 0)
    return dict(entries, **other)


# In the order of their cost
CASES = {
    "poiseuille50": plates(50, nSteps=200),
    "plates10k": plates3D(12, nSteps=40),
    "flap": robustness("flap AR10 rs10 dt0.01", nSteps=200),
    "poiseuille100": plates(100),
    "lightWall": robustness(
        "channel t0.1 rs1 dt0.03 nu0.3", nx=160, nyFluid=64, nyPlate=12,
        nSteps=60),
    # Longer steps do not keep pimpleFoam with one outer corrector stable
    "thinPlates": dict(
        PLATES, nx=200, nyFluid=180, nyPlate=10, yBottom=-0.002, yTop=0.042,
        deltaT=0.005),
    "cavity": dict(
        shape="cavity", sides="empty", deltaT=0.0125, nSteps=20, mu=0.006,
        rhoFluid=1000, pInlet=0, pOutlet=0, nz=1),
    "poiseuille200": plates(200),
    "plates74k": plates3D(23),
    "poiseuille400": plates(400),
    "plates590k": plates3D(46),
}
SMALL = list(CASES)[:3]

# Zones of a shape's fluid and solids
ZONES = {"cavity": ("cavity", "container")}


def parameters(name):
    """Entries of system/parameters.local."""
    values = dict(CASES[name])
    values["endTime"] = values["deltaT"]*values["nSteps"]
    values["writeInterval"] = 1000*values["endTime"]
    values["nuFluid"] = values["mu"]/values["rhoFluid"]
    for p in "pInlet", "pOutlet":
        values[p + "OverRho"] = values[p]/values["rhoFluid"]
    values["nOuterCorrectors"] = 1
    values["fluidZone"], values["solidZone"] = ZONES.get(
        values["shape"], ("fluid", "solid"))
    values["fluidMaterial"] = (
        "liquid" if values["shape"] == "cavity" else "fluid")
    return values


def main():
    if sys.argv[1:] == ["names"]:
        print(*CASES, sep="\n")
    elif sys.argv[1:] == ["names", "-quick"]:
        print(*SMALL, sep="\n")
    elif len(sys.argv) == 3 and sys.argv[1] == "parameters":
        for key, value in parameters(sys.argv[2]).items():
            print("%-16s%s;" % (key + " ", value))
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main()
