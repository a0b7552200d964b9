# SPDX-License-Identifier: GPL-3.0-or-later
"""Results of a finished case of tutorials/cavity, for plot and for the tests.

Reads what foamToVTK wrote for the zones cavity and container (cell values,
base64 inline) and postProcessing. The cells of both zones are rectangles and
lie in rows and columns, of any grading. Values of the two zones are never
mixed. SI units; energies, volumes and the stream function per metre of depth.
"""

import base64
import csv
import glob
import json
import os
import re
import xml.etree.ElementTree

import numpy as np

REFERENCE = os.path.join(
    os.path.dirname(os.path.abspath(__file__)), "reference"
)

LENGTH = 0.07
DENSITY = 1000.0

# Order of VTK
COMPONENTS = {"xx": 0, "yy": 1, "zz": 2, "xy": 3, "x": 0, "y": 1}

TYPES = {
    "Float32": "<f4", "Float64": "<f8", "Int32": "<i4", "Int64": "<i8",
    "UInt8": "u1"
}


class Missing(Exception):
    """A file or a value is not there."""


# Reading

def parameters(case):
    """Entries of system/parameters, replaced by those of parameters.local."""
    values = {}
    for name in ("parameters", "parameters.local"):
        path = os.path.join(case, "system", name)
        if os.path.exists(path):
            with open(path, encoding="ascii") as file:
                values.update(re.findall(
                    r"^(\w+)\s+([^\s;]+)\s*;", file.read(), re.MULTILINE
                ))
    for key in ("lid", "kinematics", "endTime"):
        if key not in values:
            raise Missing("no " + key + " in system/parameters of " + case)
    return values


def series(case, zone):
    """{time: file} of a zone."""
    folder = os.path.join(case, "VTK", zone)
    path = os.path.join(folder, zone + ".vtm.series")
    if not os.path.exists(path):
        raise Missing("no " + path)
    with open(path, encoding="ascii") as file:
        return {
            entry["time"]: os.path.join(
                folder, os.path.splitext(entry["name"])[0], "internal.vtu"
            )
            for entry in json.load(file)["files"]
        }


def times(case):
    """Written times."""
    return sorted(series(case, "cavity"))


def array(element):
    """Values of a DataArray."""
    data = base64.b64decode(element.text)
    size = int(np.frombuffer(data, "<u8", 1)[0])
    kind = np.dtype(TYPES[element.get("type")])
    values = np.frombuffer(data, kind, size//kind.itemsize, 8)
    n = int(element.get("NumberOfComponents", "1"))
    return values.reshape(-1, n) if n > 1 else values


class Grid:
    """Cell values of a zone at a time, by row (y) and column (x).

    x, y are the cells' centres, xEdges, yEdges their sides; inside tells
    which cells of the grid are in the zone. The others have the value nan.
    """

    def __init__(self, case, zone, time):
        files = [
            path for t, path in series(case, zone).items()
            if abs(t - time) < 1e-4
        ]
        if not files or not os.path.exists(files[0]):
            raise Missing("no time {:g} of {} in {}".format(time, zone, case))
        root = xml.etree.ElementTree.parse(files[0]).getroot()
        if root.get("header_type") != "UInt64":
            raise Missing("unexpected header of " + files[0])
        piece = root.find("UnstructuredGrid/Piece")
        points = array(piece.find("Points/DataArray")).astype(float)
        corners = next(
            array(element) for element in piece.findall("Cells/DataArray")
            if element.get("Name") == "connectivity"
        ).reshape(-1, 8)
        centres = points[corners].mean(axis=1)

        self.xEdges, self.yEdges = (distinct(points[:, i]) for i in (0, 1))
        self.x, self.y = (
            (edges[1:] + edges[:-1])/2 for edges in (self.xEdges, self.yEdges)
        )
        column = np.searchsorted(self.xEdges, centres[:, 0]) - 1
        row = np.searchsorted(self.yEdges, centres[:, 1]) - 1
        self.inside = np.full((len(self.y), len(self.x)), False)
        self.inside[row, column] = True
        self.values = {}
        for element in piece.findall("CellData/DataArray"):
            values = array(element).astype(float)
            field = np.full(
                (len(self.y), len(self.x)) + values.shape[1:], np.nan
            )
            field[row, column] = values
            self.values[element.get("Name")] = field

    def field(self, name, component=None):
        """Values of a field or of one of its components."""
        if name not in self.values:
            raise Missing("no field " + name)
        values = self.values[name]
        return values if component is None else (
            values[..., COMPONENTS[component]]
        )

    def areas(self):
        """Areas of the cells."""
        return np.outer(np.diff(self.yEdges), np.diff(self.xEdges))


def distinct(coordinates):
    """Sorted coordinates, one of each; the files have single precision."""
    ordered = np.sort(coordinates)
    return ordered[np.diff(ordered, prepend=-np.inf) > 1e-6]


def reference(name, folder=REFERENCE):
    """Columns of a reference file; texts where they are no numbers."""
    path = os.path.join(folder, name)
    if not os.path.exists(path):
        raise Missing("no " + path)
    with open(path, encoding="ascii") as file:
        rows = list(csv.DictReader(file))
    columns = {}
    for key in rows[0]:
        column = [row[key] for row in rows]
        try:
            columns[key] = np.array([float(value) for value in column])
        except ValueError:
            columns[key] = np.array(column)
    return columns


# Lines

def between(x, inside, values, at):
    """Values at x from the nearest columns: (in the zone?, values).

    inside[:, i] and values[:, i] belong to x[i]. Linear in the columns on
    either side; where they are not both in the zone, in the two next to x on
    one side of it.
    """
    found = np.full(len(values), False)
    result = np.full(len(values), np.nan)
    after = int(np.searchsorted(x, at))
    for i in (after - 1, after, after - 2):
        if 0 <= i and i + 1 < len(x):
            weight = (at - x[i])/(x[i + 1] - x[i])
            line = (1 - weight)*values[:, i] + weight*values[:, i + 1]
            new = inside[:, i] & inside[:, i + 1] & ~found
            result[new] = line[new]
            found |= new
    return found, result


def along(grid, line, name, component=None):
    """Coordinates and values on a line "x=..." or "y=...", at its cells."""
    values = grid.field(name, component)
    axis, at = line.split("=")
    if axis == "x":
        coordinates = grid.y
        found, profile = between(grid.x, grid.inside, values, float(at))
    else:
        coordinates = grid.x
        found, profile = between(grid.y, grid.inside.T, values.T, float(at))
    return coordinates[found], profile[found]


def centrelines(cavity):
    """(y, u at x = L/2) and (x, v at y = L/2)."""
    line = "{:g}".format(LENGTH/2)
    return (
        along(cavity, "x=" + line, "U", "x"),
        along(cavity, "y=" + line, "U", "y")
    )


def extrapolated(x, values, at):
    """Values at the end of rows, on the parabola through three cells."""
    return sum(
        values[..., i]*np.prod([
            (at - x[j])/(x[i] - x[j]) for j in range(3) if j != i
        ]) for i in range(3)
    )


def wallPressure(cavity):
    """{wall: (coordinate, pressure)}, from the three cells at the wall.

    Two are not enough near the lid, where p is like 1/distance.
    """
    p = cavity.field("p")
    return {
        "left": (cavity.y, extrapolated(cavity.x, p, 0)),
        "bottom": (cavity.x, extrapolated(cavity.y, p.T, 0)),
        "right": (
            cavity.y, extrapolated(cavity.x[::-1], p[:, ::-1], LENGTH)
        )
    }


def cubic(x, y, at):
    """Cubic through the four points of a table nearest to each value."""
    x, y, at = (np.asarray(values, dtype=float) for values in (x, y, at))
    first = np.clip(np.searchsorted(x, at) - 2, 0, len(x) - 4)
    total = np.zeros(len(at))
    for i in range(4):
        weight = np.ones(len(at))
        for j in range(4):
            if j != i:
                weight *= (at - x[first + j])/(x[first + i] - x[first + j])
        total += weight*y[first + i]
    return total


# Flow

def streamFunction(cavity):
    """psi at the cells' x and the rows' yEdges; u = d psi/dy, psi = 0 on walls.

    The little that cell values do not conserve is spread over the column.
    """
    u = cavity.field("U", "x")
    steps = np.diff(cavity.yEdges)[:, np.newaxis]
    psi = np.vstack([np.zeros(u.shape[1]), np.cumsum(u*steps, axis=0)])
    height = cavity.yEdges - cavity.yEdges[0]
    return psi - np.outer(height/height[-1], psi[-1])


def vortex(cavity):
    """x, y of the vortex's centre and psi there: parabola through 3 x 3."""
    psi = streamFunction(cavity)
    x, y = cavity.x, cavity.yEdges
    if not np.all(np.isfinite(psi)):
        return 3*(np.nan,)
    j, i = np.unravel_index(np.argmin(psi), psi.shape)
    j = min(max(j, 1), len(y) - 2)
    i = min(max(i, 1), len(x) - 2)
    dx, dy = (
        part.ravel() for part in np.meshgrid(
            x[i - 1:i + 2] - x[i], y[j - 1:j + 2] - y[j]
        )
    )
    h = x[i + 1] - x[i]
    dx, dy = dx/h, dy/h
    a, b, c, d, e, f = np.linalg.lstsq(
        np.column_stack([dx*dx, dx*dy, dy*dy, dx, dy, np.ones(9)]),
        psi[j - 1:j + 2, i - 1:i + 2].ravel(), rcond=None
    )[0]
    if 4*a*c - b*b <= 0:
        return x[i], y[j], psi[j, i]
    sx, sy = np.linalg.solve([[2*a, b], [b, 2*c]], [-d, -e])
    return x[i] + h*sx, y[j] + h*sy, f + (d*sx + e*sy)/2


def kineticEnergy(cavity):
    """Of the fluid, from the cells' velocities [J/m]."""
    velocity = cavity.field("U")
    return DENSITY/2*np.sum(
        cavity.areas()*np.sum(velocity**2, axis=2)
    )


# Histories

def history(case, name, columns):
    """Times and columns of postProcessing/<name>/<start>/*.dat.

    After a restart the later file counts.
    """
    rows = {}
    for path in sorted(
        glob.glob(os.path.join(case, "postProcessing", name, "*", "*.dat")),
        key=lambda path: float(os.path.basename(os.path.dirname(path)))
    ):
        with open(path, encoding="ascii") as file:
            for line in file:
                words = line.lstrip("#").split()
                if words and words[0] == "Time":
                    wanted = [words.index(column) for column in columns]
                elif words and line[0] != "#":
                    rows[float(words[0])] = [float(words[i]) for i in wanted]
    if not rows:
        raise Missing("no postProcessing/" + name + " in " + case)
    times = sorted(rows)
    return np.array(times), *np.array([rows[t] for t in times]).T


def energyHistory(case):
    """Times and kinetic energy of the fluid [J/m]."""
    return history(case, "energy", ["kineticFluid"])


def levelHistory(case):
    """Times, error of the pressure level [Pa], mean pressure [Pa].

    The error is the volume that the container makes way for, divided by its
    compliance; the fluid is incompressible.
    """
    times, displaced, compliance, mean = history(
        case, "level", ["displaced0", "compliance0", "p0"]
    )
    return times, displaced/compliance, mean
