# SPDX-License-Identifier: GPL-3.0-or-later
"""Stresses and interface tractions of an umfsiFoam case with one cell in z."""

import re
import sys
from pathlib import Path

import numpy as np

sys.path.insert(
    0, str(Path(__file__).resolve().parents[2]/"verification/tools"))

from results import cellValues                                  # noqa: E402


def cellSet(path):
    """Labels of an ascii cellSet."""
    text = re.sub(r"(?s)/\*.*?\*/|//[^\n]*|FoamFile.*?\}", "",
                  Path(path).read_text(encoding="ascii"))
    return np.array(text[text.index("(") + 1:text.index(")")].split(), int)


class FoamResults:
    """Results at one time, after topoSet and postProcess of Allrun."""

    def __init__(self, case, time):
        self.case, self.time = Path(case), time
        cells = cellSet(self.case/"constant/polyMesh/sets/solid")
        self.centres = cellValues(self.case/time/"C")[cells, :2]
        # xx, yy, xy
        self.sigma = cellValues(self.case/time/"sigma")[cells][:, [0, 3, 1]]

    def _load(self, pattern):
        folder = self.case/"postProcessing/interfaceLoad"
        return next(folder.rglob(pattern))

    def traction(self):
        """Face centres of the interface and tractions on the solid [Pa]."""
        rows = np.loadtxt(self._load("*.raw"))
        return rows[:, :2], rows[:, 3:5]

    def resultant(self):
        """Force on the solid [N/m], integrated by OpenFOAM."""
        text = self._load("surfaceFieldValue.dat").read_text(encoding="ascii")
        last = text.splitlines()[-1]
        return np.array(last[last.index("(") + 1:-1].split()[:2], float)

    def line(self, axis, value):
        """Stresses at the cells along the line x or y (axis 0, 1) = value.

        Returns the coordinate along the line and the stresses, linear between
        the centres of the rows of cells on both sides; cells of the solid
        only. The rows must be parallel to the line.
        """
        across = np.round(self.centres[:, axis], 9)
        rows = np.unique(across)
        upper = np.searchsorted(rows, value)
        pair = []
        for row in rows[upper - 1:upper + 1]:
            cells = np.flatnonzero(across == row)
            cells = cells[np.argsort(self.centres[cells, 1 - axis])]
            pair.append(cells)
        below, above = pair
        along = self.centres[below, 1 - axis]
        if len(below) != len(above) or not np.allclose(
                along, self.centres[above, 1 - axis], rtol=0, atol=1e-9):
            raise RuntimeError(f"no rows of cells next to {value}")
        weight = (value - rows[upper - 1])/(rows[upper] - rows[upper - 1])
        return along, (1 - weight)*self.sigma[below] + weight*self.sigma[above]
