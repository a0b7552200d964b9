# SPDX-License-Identifier: GPL-3.0-or-later
"""Velocity in the channels and von Mises stress of the block, in ParaView.

After Allrun, in this folder:

    paraview --script=showInParaView.py     window
    pvpython showInParaView.py              picture only; without a display
                                            after xvfb-run -a

Both write teeInParaView.png. The block is warped by 30 times D. This file
must not be named paraview.py: it would hide ParaView's own module.
"""

import os

from paraview.simple import (
    CellDatatoPointData, ColorBy, CreateView, GetAnimationScene, OpenDataFile,
    Render, SaveScreenshot, Show, WarpByVector
)

CASE = os.getcwd()

# Displacements are shown so many times larger
WARP = 30


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

fluid, block = opened("fluid"), opened("block")

# The last time first, so that the colours span its values
scene = GetAnimationScene()
scene.UpdateAnimationUsingDataTimeSteps()
scene.GoToLast()

show(view, fluid, "CELLS", "U", "Magnitude")

warped = WarpByVector(Input=CellDatatoPointData(Input=block))
warped.Vectors = ["POINTS", "D"]
warped.ScaleFactor = WARP
show(view, warped, "POINTS", "sigmaEq", "")

# The first Render moves the camera
Render(view)
view.CameraParallelProjection = 1
view.CameraPosition = [0.052, 0.016, 1]
view.CameraFocalPoint = [0.052, 0.016, 0]
view.CameraViewUp = [0, 1, 0]
view.CameraParallelScale = 0.034

Render(view)
SaveScreenshot(os.path.join(CASE, "teeInParaView.png"), view)
