# SPDX-License-Identifier: GPL-3.0-or-later
"""Velocity in the fluid and the bent flap, in ParaView.

After Allrun, in this folder:

    paraview --script=showInParaView.py     window
    pvpython showInParaView.py              picture only; without a display
                                            after xvfb-run -a

Both write flapInParaView.png. The flap is warped by 20 times D. This file
must not be named paraview.py: it would hide ParaView's own module.
"""

import os

from paraview.simple import (
    CellDatatoPointData, ColorBy, CreateView, GetAnimationScene, OpenDataFile,
    Render, SaveScreenshot, Show, Slice, WarpByVector
)

CASE = os.getcwd()

# Displacements are shown so many times larger
WARP = 20


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

fluid, flap = opened("fluid"), opened("flap")

# The last time first, so that the colours span its values
scene = GetAnimationScene()
scene.UpdateAnimationUsingDataTimeSteps()
scene.GoToLast()

# A plane along the flow: in 3-D beside the plane of symmetry
fluid.UpdatePipeline()
depth = fluid.GetDataInformation().GetBounds()[5]
cut = Slice(Input=fluid)
cut.SliceType.Origin = [0.1, 0.02, 0.025*depth]
cut.SliceType.Normal = [0, 0, 1]
show(view, cut, "CELLS", "U", "Magnitude")

warped = WarpByVector(Input=CellDatatoPointData(Input=flap))
warped.Vectors = ["POINTS", "D"]
warped.ScaleFactor = WARP
show(view, warped, "POINTS", "D", "Magnitude")

# The first Render moves the camera
Render(view)
view.CameraParallelProjection = 1
view.CameraPosition = [0.08, 0.02, 5]
view.CameraFocalPoint = [0.08, 0.02, 0]
view.CameraViewUp = [0, 1, 0]
view.CameraParallelScale = 0.045

Render(view)
SaveScreenshot(os.path.join(CASE, "flapInParaView.png"), view)
