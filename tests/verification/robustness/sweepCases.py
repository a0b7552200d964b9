#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The cases of the robustness table.

Usage: sweepCases.py names [-short | -moving] [case ...]
       sweepCases.py parameters <case>

names       names of all cases, of those of Alltest (-short), of those with a
            mesh that follows (-moving), or of those given; a name that is not
            known is an error
parameters  entries of system/parameters of a case, one in a line
"""

import sys

CHANNEL = dict(
    shape="channel", length=5, height=1, nx=40, nyFluid=16)
THESIS = dict(
    shape="channel", length=0.3, height=0.04, nx=60, nyFluid=12,
    wall=0.04, nyWall=10, pInlet=30, pOutlet=1, ends="slip",
    rhoFluid=1000, mu=0.02, rhoSolid=7860, E=2.03e11, nu=0.33, deltaT=0.05)
FLAP = dict(shape="flap", E=1e4)
CAVITY = dict(shape="cavity", wall=0.25, nWall=4, nFluid=16)

# Thickness of the channel's walls, cells in it, E
WALLS = ((1, 10, 100), (0.1, 4, 1e3), (0.02, 3, 5e3))

# Slenderness of the flap, cells through its thickness
FLAPS = ((10, 4), (20, 3))

# Frame: E, rhoSolid, deltaT
FRAMES = ((100, 1, 0.01), (100, 1, 0.1), (100, 1e-3, 0.01), (1e8, 7.8, 0.05))


def table():
    """Parameters of all cases by name; fluid: rho = 1, mu = 0.01."""
    cases = {
        "thesis rollers": dict(THESIS, outer="slip"),
        "thesis free": dict(THESIS, outer="solidTraction")}

    for walls, densities, ratios in (
            (WALLS, (10, 1, 0.1, 1e-3), (0.3,)),
            (WALLS[:2], (1, 1e-3), (0.45,))):
        for nu in ratios:
            for wall, nyWall, E in walls:
                for rhoSolid in densities:
                    for deltaT in (1e-3, 0.03, 1):
                        name = "channel t{:g} rs{:g} dt{:g} nu{:g}".format(
                            wall, rhoSolid, deltaT, nu)
                        cases[name] = dict(
                            CHANNEL, wall=wall, nyWall=nyWall, E=E, nu=nu,
                            rhoSolid=rhoSolid, deltaT=deltaT)

    for slenderness, nxFlap in FLAPS:
        for rhoSolid in (10, 1):
            for deltaT in (1e-3, 0.01, 0.1):
                name = "flap AR{:g} rs{:g} dt{:g}".format(
                    slenderness, rhoSolid, deltaT)
                cases[name] = dict(
                    FLAP, wall=0.6/slenderness, nxFlap=nxFlap,
                    rhoSolid=rhoSolid, deltaT=deltaT)

    for E, rhoSolid, deltaT in FRAMES:
        name = "cavity E{:g} rs{:g} dt{:g}".format(E, rhoSolid, deltaT)
        cases[name] = dict(CAVITY, E=E, rhoSolid=rhoSolid, deltaT=deltaT)

    return cases


CASES = table()

# Light and thin with a mesh that follows, several steps: Allmoving
MOVING = {
    f"flap AR10 rs0.001 dt{deltaT:g}": dict(
        FLAP, wall=0.06, nxFlap=4, rhoSolid=1e-3, deltaT=deltaT,
        endTime=10*deltaT)
    for deltaT in (1e-3, 0.01, 0.1)}
MOVING.update({
    f"cavity E100 rs0.001 dt{deltaT:g}": dict(
        CAVITY, E=100, rhoSolid=1e-3, deltaT=deltaT,
        endTime=10*deltaT)
    for deltaT in (0.01, 0.1)})

# The hardest ones: light and thin walls, flaps, enclosed fluids
SHORT = (
    "thesis free",
    "channel t1 rs0.001 dt1 nu0.3",
    "channel t0.1 rs0.001 dt0.03 nu0.3",
    "channel t0.1 rs0.001 dt0.001 nu0.45",
    "channel t0.02 rs0.1 dt0.001 nu0.3",
    "channel t0.02 rs0.1 dt0.03 nu0.3",
    "channel t0.02 rs0.001 dt0.001 nu0.3",
    "flap AR10 rs1 dt0.1",
    "flap AR20 rs1 dt0.001",
    "flap AR20 rs1 dt0.1",
    "cavity E100 rs0.001 dt0.01",
    "cavity E1e+08 rs7.8 dt0.05")


def expansion(first, n, length):
    """Last cell over first of n cells that fill a length."""
    lower, upper = 1 + 1e-9, 3.0
    for _ in range(100):
        ratio = (lower + upper)/2
        if first*(ratio**n - 1)/(ratio - 1) < length:
            lower = ratio
        else:
            upper = ratio
    return ratio**(n - 1)


def line(name, start, end):
    """Entries of a sampled line at half depth, from wall to wall."""
    inside = 1e-3       # of its length, so that the ends are in a cell
    ends = {"Start": inside, "End": 1 - inside}
    return {
        name + key: "({:g} {:g} 0.5)".format(
            *(a + part*(b - a) for a, b in zip(start, end)))
        for key, part in ends.items()}


def entries(case):
    """Entries of system/parameters. The lines pass inside of cells."""
    values = {"nu": 0.3, "rhoFluid": 1, **{**CASES, **MOVING}[case]}
    wall = values["wall"]

    if values["shape"] == "channel":
        length, height = values["length"], values["height"]
        values.update(
            yBottom=-wall, yTop=height + wall,
            **line("fluid", (0, 0.47*height), (length, 0.47*height)),
            **line("solid", (0, -0.05*wall), (length, -0.05*wall)))
    elif values["shape"] == "cavity":
        values.update(
            start=-wall, end=1 + wall,
            **line("fluid", (0.53, 0), (0.53, 1)),
            **line("solid", (-0.4*wall, -wall), (-0.4*wall, 1 + wall)))
    else:
        # Two cells of the flap's size before and behind it, then growing
        length, front = 4, 1.5
        h = wall/values["nxFlap"]
        before = front - 2*h
        behind = front + wall + 2*h
        values.update(
            length=length, height=1, hFlap=0.6, nyFlap=18, nyAbove=12,
            xBefore=before, xFront=front, xBack=front + wall,
            xBehind=behind,
            gradeBefore=1/expansion(h, 14, before),
            gradeBehind=expansion(h, 18, length - behind),
            **line("fluid", (0, 0.81), (length, 0.81)),
            **line("solid", (front + 0.4*wall, 0), (front + 0.4*wall, 0.6)))

    return values


def main():
    arguments = sys.argv[1:]
    if arguments[:1] == ["parameters"] and len(arguments) == 2:
        for key, value in entries(arguments[1]).items():
            print(key, value)
    elif arguments[:1] == ["names"]:
        names = arguments[1:]
        if names[:1] == ["-short"]:
            names[:1] = SHORT
        elif names[:1] == ["-moving"]:
            names[:1] = MOVING
        unknown = [name for name in names if name not in {**CASES, **MOVING}]
        if unknown:
            sys.exit("No such case: " + ", ".join(unknown))
        print(*names or CASES, sep="\n")
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main()
