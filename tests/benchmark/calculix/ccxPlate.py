# SPDX-License-Identifier: GPL-3.0-or-later
"""A plane body of rectangles under given tractions, solved by CalculiX."""

import os
import re
import subprocess

import numpy as np

# ccx gives an element of unit thickness a plane stress that is none
THICKNESS = 1e-3


def gridLines(start, pieces, refine=1):
    """Coordinates of nodes: pieces (end, number of elements), with middles."""
    lines = [start]
    for end, number in pieces:
        lines.extend(np.linspace(lines[-1], end, 2*number*refine + 1)[1:])
    return np.array(lines)


def faceBounds(start, centres):
    """Ends of the faces with these centres, the first of which starts there."""
    bounds = [start]
    for centre in centres:
        bounds.append(2*centre - bounds[-1])
    return np.array(bounds)


def nodalForces(nodes, centres, traction):
    """Consistent forces per unit depth on nodes along a straight side.

    nodes: coordinates of corner and middle nodes in turn, ascending. The
    traction is constant on each face: this keeps its force and, where it is
    singular, its moment, too.
    """
    bounds = faceBounds(nodes[0], centres)
    if abs(bounds[-1] - nodes[-1]) > 1e-8:
        raise RuntimeError("the faces do not cover the side")
    corners = nodes[::2]
    pieces = np.unique(np.round(np.concatenate(
        (bounds[1:-1], corners)), 9))
    force = np.zeros((len(nodes), traction.shape[1]))
    points, weights = np.polynomial.legendre.leggauss(3)
    half = 0.5*np.diff(pieces)
    middle = pieces[:-1] + half
    element = np.searchsorted(corners, middle) - 1
    face = np.searchsorted(bounds, middle) - 1
    length = corners[element + 1] - corners[element]
    for point, weight in zip(points, weights):
        s = middle + point*half
        xi = 2*(s - corners[element])/length - 1
        shapes = (0.5*xi*(xi - 1), 1 - xi**2, 0.5*xi*(xi + 1))
        for node, shape in enumerate(shapes):
            np.add.at(force, 2*element + node,
                      (weight*half*shape)[:, None]*traction[face])
    return force


class CcxPlate:
    """Eight-node quadrilaterals between the grid lines x and y.

    solid(x, y) tells whether an element with that centre exists.
    """

    def __init__(self, x, y, solid):
        self.x, self.y = x, y
        elements = []
        for i in range(0, len(x) - 1, 2):
            for j in range(0, len(y) - 1, 2):
                if solid(x[i + 1], y[j + 1]):
                    elements.append([self.number(i + a, j + b) for a, b in (
                        (0, 0), (2, 0), (2, 2), (0, 2),
                        (1, 0), (2, 1), (1, 2), (0, 1))])
        self.elements = np.array(elements)
        self.nodes = np.unique(self.elements)
        self.force = {}     # on the node, per unit depth

    def number(self, i, j):
        """Number of the node at x[i], y[j]."""
        return 1 + i*len(self.y) + j

    def points(self, nodes):
        """Coordinates of nodes."""
        i, j = np.divmod(np.asarray(nodes) - 1, len(self.y))
        return np.column_stack((self.x[i], self.y[j]))

    def on(self, axis, value, low=-np.inf, high=np.inf):
        """Nodes with x or y (axis 0, 1) = value, in order along the line."""
        points = self.points(self.nodes)
        along = points[:, 1 - axis]
        return self.nodes[
            (abs(points[:, axis] - value) < 1e-9)
            & (along > low - 1e-9) & (along < high + 1e-9)]

    def addTraction(self, axis, value, low, high, centres, traction):
        """Load the side x or y = value between low and high."""
        nodes = self.on(axis, value, low, high)
        forces = nodalForces(
            self.points(nodes)[:, 1 - axis], centres, traction)
        for node, force in zip(nodes, forces):
            self.force[node] = self.force.get(node, 0) + force

    def fixed(self):
        """Nodes on rollers, for each direction: left and right; bottom."""
        return (np.concatenate((self.on(0, self.x[0]), self.on(0, self.x[-1]))),
                self.on(1, self.y[0]))

    def write(self, path, kinematics, young, poisson):
        """Input file of ccx."""
        element = {"planeStrain": "CPE8", "planeStress": "CPS8"}[kinematics]
        with open(path, "w", encoding="ascii") as file:
            def rows(title, lines):
                file.write(title + "\n")
                file.writelines(line + "\n" for line in lines)

            rows("*NODE, NSET=ALL", (
                f"{n}, {x:.12g}, {y:.12g}, 0"
                for n, (x, y) in zip(self.nodes, self.points(self.nodes))))
            rows(f"*ELEMENT, TYPE={element}, ELSET=PLATE", (
                ", ".join(map(str, [n, *nodes]))
                for n, nodes in enumerate(self.elements, 1)))
            for name, nodes in zip(("SIDES", "BOTTOM"), self.fixed()):
                rows(f"*NSET, NSET={name}", (f"{n}," for n in nodes))
            rows("*MATERIAL, NAME=STEEL", [
                "*ELASTIC", f"{young:.12g}, {poisson:.12g}",
                "*SOLID SECTION, ELSET=PLATE, MATERIAL=STEEL", f"{THICKNESS}",
                "*BOUNDARY", "SIDES, 1", "BOTTOM, 2", "*STEP", "*STATIC"])
            rows("*CLOAD", (
                f"{node}, {axis + 1}, {THICKNESS*force[axis]:.11e}"
                for node, force in self.force.items() for axis in (0, 1)))
            rows("*NODE PRINT, NSET=SIDES, TOTALS=ONLY", ["RF"])
            rows("*NODE PRINT, NSET=BOTTOM, TOTALS=ONLY", ["RF"])
            rows("*EL FILE, OUTPUT=2D", ["S", "*END STEP"])

    def solve(self, folder, kinematics, young, poisson):
        """Returns the force of the rollers per unit depth; keeps stresses."""
        self.write(folder/"plate.inp", kinematics, young, poisson)
        run = subprocess.run(
            ["ccx", "-i", "plate"], cwd=folder, check=False,
            env={**os.environ, "OMP_NUM_THREADS": "1"},
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        log = run.stdout.decode(errors="replace")
        (folder/"log.ccx").write_text(log, encoding="utf-8")
        if run.returncode or "*ERROR" in log:
            raise RuntimeError(f"ccx failed: see {folder}/log.ccx")
        self._readStress(folder/"plate.frd")
        return self._reaction(folder/"plate.dat")

    def _readStress(self, path):
        self.stress = {}    # of the node: xx, yy, xy
        reading = False
        with open(path, encoding="ascii") as file:
            for line in file:
                if line.startswith(" -4"):
                    reading = line.split()[1] == "STRESS"
                elif line.startswith(" -3"):
                    reading = False
                elif reading and line.startswith(" -1"):
                    xx, yy, _, xy = (
                        float(line[k:k + 12]) for k in range(13, 61, 12))
                    self.stress[int(line[3:13])] = (xx, yy, xy)

    def _reaction(self, path):
        # ccx prints the elements' forces on the nodes, which hold the load on
        # these nodes as well
        totals = re.findall(r"total force[^\n]*\n\s*\n([^\n]*)",
                            path.read_text(encoding="ascii"))
        return np.array([
            float(line.split()[axis])/THICKNESS
            - sum(self.force[n][axis] for n in nodes if n in self.force)
            for axis, (line, nodes) in enumerate(zip(totals, self.fixed()))])

    def line(self, axis, value):
        """Coordinates and nodal stresses along the line x or y = value."""
        nodes = self.on(axis, value)
        return (self.points(nodes)[:, 1 - axis],
                np.array([self.stress[n] for n in nodes]))
