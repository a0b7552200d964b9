# SPDX-License-Identifier: GPL-3.0-or-later
"""Velocity in the fluid and displacement of the flap, in ParaView.

After Allrun, in this folder:

    paraview --script=showInParaView.py     window
    pvpython showInParaView.py              picture only; without a display
                                            after xvfb-run -a

Both write flapInParaView.png. This file must not be named paraview.py: it would
hide ParaView's own module.
"""

import os

from paraview.simple import (
    ColorBy, CreateView, GetAnimationScene, OpenDataFile, Render,
    SaveScreenshot, Show, Slice
)

CASE = os.getcwd()


def opened(zone):
    """What foamToVTK wrote for a zone, all times."""
    return OpenDataFile(
        os.path.join(CASE, "VTK", zone, zone + ".vtm.series")
    )


def show(target, source, field):
    """Colour by a vector's magnitude, with its legend."""
    display = Show(source, target)
    display.Representation = "Surface"
    ColorBy(display, ("CELLS", field, "Magnitude"))
    display.RescaleTransferFunctionToDataRange(True)
    display.SetScalarBarVisibility(target, True)


view = CreateView("RenderView")
view.ViewSize = [1200, 500]

fluid, flap = opened("fluid"), opened("flap")

# The last time first, so that the colours span its values
scene = GetAnimationScene()
scene.UpdateAnimationUsingDataTimeSteps()
scene.GoToLast()

# A plane along the flow: in 3-D beside the plane of symmetry
fluid.UpdatePipeline()
depth = fluid.GetDataInformation().GetBounds()[5]
cut = Slice(Input=fluid)
cut.SliceType.Origin = [3, 1, 0.025*depth]
cut.SliceType.Normal = [0, 0, 1]
show(view, cut, "U")
show(view, flap, "D")

# The first Render moves the camera
Render(view)
view.CameraParallelProjection = 1
view.CameraPosition = [3, 2, 20]
view.CameraFocalPoint = [3, 2, 0]
view.CameraViewUp = [0, 1, 0]
view.CameraParallelScale = 2.1

Render(view)
SaveScreenshot(os.path.join(CASE, "flapInParaView.png"), view)
