# SPDX-License-Identifier: GPL-3.0-or-later
"""Velocity in the fluid and sigma_yy in the container, in ParaView.

After Allrun, in this folder:

    paraview --script=showInParaView.py     window
    pvpython showInParaView.py              picture only; without a display
                                            after xvfb-run -a

Both write cavityParaView.png. Cell values are shown, as computed.
"""

import os

from paraview.simple import (
    ColorBy, CreateView, GetAnimationScene, GetColorTransferFunction,
    OpenDataFile, Render, SaveScreenshot, Show
)

CASE = os.getcwd()


def opened(zone):
    """What foamToVTK wrote for a zone, all times."""
    return OpenDataFile(
        os.path.join(CASE, "VTK", zone, zone + ".vtm.series")
    )


def show(target, source, field, component, limits):
    """Colour by a field's cell values, with its legend.

    Between limits: at the corners of the lid the values are singular.
    """
    display = Show(source, target)
    display.Representation = "Surface"
    ColorBy(display, ("CELLS", field, component))
    GetColorTransferFunction(field).RescaleTransferFunction(*limits)
    display.SetScalarBarVisibility(target, True)


view = CreateView("RenderView")
view.ViewSize = [1000, 800]

scene = GetAnimationScene()
zones = {zone: opened(zone) for zone in ("cavity", "container")}
scene.UpdateAnimationUsingDataTimeSteps()
scene.GoToLast()

show(view, zones["cavity"], "U", "Magnitude", (0, 0.03))
show(view, zones["container"], "sigma", "YY", (-0.15, 0.15))

# The first Render moves the camera
Render(view)
view.CameraParallelProjection = 1
view.CameraPosition = [0.035, 0, 10]
view.CameraFocalPoint = [0.035, 0, 0]
view.CameraViewUp = [0, 1, 0]
view.CameraParallelScale = 0.08

Render(view)
SaveScreenshot(os.path.join(CASE, "cavityParaView.png"), view)
