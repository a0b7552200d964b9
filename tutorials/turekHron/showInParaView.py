# SPDX-License-Identifier: GPL-3.0-or-later
"""Velocity in the fluid and displacement of the flag, in ParaView.

After Allrun, in this folder:

    paraview --script=showInParaView.py     window
    pvpython showInParaView.py              picture only; without a display
                                            after xvfb-run -a

Both write flagInParaView.png. This file must not be named paraview.py: it would
hide ParaView's own module.
"""

import os

from paraview.simple import (
    CellDatatoPointData, ColorBy, CreateView, GetAnimationScene, OpenDataFile,
    Render, SaveScreenshot, Show, WarpByVector
)

CASE = os.getcwd()


def opened(zone):
    """What foamToVTK wrote for a zone, all times; None if there is none."""
    path = os.path.join(CASE, "VTK", zone, zone + ".vtm.series")
    return OpenDataFile(path) if os.path.exists(path) else None


def show(target, source, field):
    """Colour by a vector's magnitude, with its legend."""
    display = Show(source, target)
    display.Representation = "Surface"
    ColorBy(display, ("CELLS", field, "Magnitude"))
    display.RescaleTransferFunctionToDataRange(True)
    display.SetScalarBarVisibility(target, True)


view = CreateView("RenderView")
view.ViewSize = [1200, 500]

fluid, flag = opened("fluid"), opened("flag")

# The last time first, so that the colours span its values
scene = GetAnimationScene()
scene.UpdateAnimationUsingDataTimeSteps()
scene.GoToLast()

if fluid:
    show(view, fluid, "U")

if flag:
    if not fluid:
        # Alone, the mesh stays at rest
        points = CellDatatoPointData(Input=flag)
        points.ProcessAllArrays = True
        points.PassCellData = True
        flag = WarpByVector(Input=points)
        flag.Vectors = ["POINTS", "D"]
    show(view, flag, "D")

# The first Render moves the camera
Render(view)
view.CameraParallelProjection = 1
view.CameraPosition = [0.55, 0.2, 10]
view.CameraFocalPoint = [0.55, 0.2, 0]
view.CameraViewUp = [0, 1, 0]
view.CameraParallelScale = 0.27

Render(view)
SaveScreenshot(os.path.join(CASE, "flagInParaView.png"), view)
