# SPDX-License-Identifier: GPL-3.0-or-later
"""Pressure in the fluid and displacement of the wall, in ParaView.

After Allrun, in this folder:

    paraview --script=showInParaView.py     window
    pvpython showInParaView.py              picture only; without a display
                                            after xvfb-run -a

Both write tubeParaView.png, at 4 ms. The mesh moves with the wall; the wall
is drawn with its displacement ten times as large. Cell values are shown, as
computed.
"""

import os

from paraview.simple import (
    CellDatatoPointData, ColorBy, CreateView, GetAnimationScene,
    GetColorTransferFunction, OpenDataFile, Render, SaveScreenshot, Show,
    WarpByVector
)

CASE = os.getcwd()
TIME = 0.004


def opened(zone):
    """What foamToVTK wrote for a zone, all times."""
    return OpenDataFile(
        os.path.join(CASE, "VTK", zone, zone + ".vtm.series")
    )


def show(target, source, field, component, limits):
    """Colour by a field's cell values, with its legend."""
    display = Show(source, target)
    display.Representation = "Surface"
    ColorBy(display, ("CELLS", field, component))
    GetColorTransferFunction(field).RescaleTransferFunction(*limits)
    display.SetScalarBarVisibility(target, True)


view = CreateView("RenderView")
view.ViewSize = [1200, 600]

scene = GetAnimationScene()
zones = {zone: opened(zone) for zone in ("fluid", "wall")}
scene.UpdateAnimationUsingDataTimeSteps()
scene.AnimationTime = min(scene.TimeKeeper.TimestepValues,
                          key=lambda time: abs(time - TIME))

# The points have moved by D already
points = CellDatatoPointData(Input=zones["wall"])
points.ProcessAllArrays = True
points.PassCellData = True
warped = WarpByVector(Input=points)
warped.Vectors = ["POINTS", "D"]
warped.ScaleFactor = 9

show(view, zones["fluid"], "p", "", (-400, 1333.2))
show(view, warped, "D", "Magnitude", (0, 1.5e-4))

# The first Render moves the camera
Render(view)
view.CameraParallelProjection = 1
view.CameraPosition = [0.025, -0.06, -0.06]
view.CameraFocalPoint = [0.025, 0.002, 0.002]
view.CameraViewUp = [0, 1, 0]
view.CameraParallelScale = 0.014

Render(view)
SaveScreenshot(os.path.join(CASE, "tubeParaView.png"), view)
