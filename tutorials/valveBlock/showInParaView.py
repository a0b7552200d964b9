# SPDX-License-Identifier: GPL-3.0-or-later
"""Velocity of the water and the bent diaphragm in the steel body, in ParaView.

After Allrun, in this folder:

    paraview --script=showInParaView.py     window
    pvpython showInParaView.py              picture only; without a display
                                            after xvfb-run -a

Both write valveInParaView.png. The diaphragm is warped by 10 times D. This file
must not be named paraview.py: it would hide ParaView's own module.
"""

import os

from paraview.simple import (
    CellDatatoPointData, ColorBy, CreateView, GetAnimationScene, OpenDataFile,
    Render, SaveScreenshot, Show, WarpByVector
)

CASE = os.getcwd()

# Displacements are shown so many times larger
WARP = 10


def opened(zone):
    """What foamToVTK wrote for a zone, all times."""
    return OpenDataFile(
        os.path.join(CASE, "VTK", zone, zone + ".vtm.series")
    )


def show(target, source, where, field, component):
    """Colour by a field, with its legend."""
    display = Show(source, target)
    display.Representation = "Surface"
    ColorBy(display, (where, field, component))
    display.RescaleTransferFunctionToDataRange(True)
    display.SetScalarBarVisibility(target, True)
    return display


view = CreateView("RenderView")
view.ViewSize = [1200, 600]

channel, diaphragm = opened("channel"), opened("diaphragm")

# The last time first, so that the colours span its values
scene = GetAnimationScene()
scene.UpdateAnimationUsingDataTimeSteps()
scene.GoToLast()

body = Show(opened("body"), view)
body.Representation = "Surface With Edges"
body.ColorArrayName = ["POINTS", ""]
body.DiffuseColor = [0.6, 0.6, 0.6]

show(view, channel, "CELLS", "U", "Magnitude")

warped = WarpByVector(Input=CellDatatoPointData(Input=diaphragm))
warped.Vectors = ["POINTS", "D"]
warped.ScaleFactor = WARP
show(view, warped, "POINTS", "D", "Magnitude")

# The first Render moves the camera. Seen from the plane of symmetry
Render(view)
view.CameraParallelProjection = 1
view.CameraPosition = [0.06, -0.1, 0.07]
view.CameraFocalPoint = [0.03, 0.012, 0.008]
view.CameraViewUp = [0, 0, 1]
view.CameraParallelScale = 0.022

Render(view)
SaveScreenshot(os.path.join(CASE, "valveInParaView.png"), view)
