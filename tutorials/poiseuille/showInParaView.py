# SPDX-License-Identifier: GPL-3.0-or-later
"""Velocity in the fluid and sigma_xx in the plates, in ParaView.

After Allrun, in this folder:

    paraview --script=showInParaView.py     window
    pvpython showInParaView.py              picture only; without a display
                                            after xvfb-run -a

Both write poiseuilleFields.png. Cell values are shown, as computed. This file
must not be named paraview.py: it would hide ParaView's own module.
"""

import os

from paraview.simple import (
    ColorBy, CreateView, GetAnimationScene, OpenDataFile, Render,
    SaveScreenshot, Show
)

CASE = os.getcwd()


def opened(zone):
    """What foamToVTK wrote for a zone, all times."""
    return OpenDataFile(
        os.path.join(CASE, "VTK", zone, zone + ".vtm.series")
    )


def show(target, source, field, component):
    """Colour by a field's cell values, with its legend."""
    display = Show(source, target)
    display.Representation = "Surface"
    ColorBy(display, ("CELLS", field, component))
    # True: keep the range of the sources already shown
    display.RescaleTransferFunctionToDataRange(True)
    display.SetScalarBarVisibility(target, True)


view = CreateView("RenderView")
view.ViewSize = [1200, 600]

zones = {zone: opened(zone) for zone in ("fluid", "lowerPlate", "upperPlate")}

# The last time first, so that the colours span its values
scene = GetAnimationScene()
scene.UpdateAnimationUsingDataTimeSteps()
scene.GoToLast()

show(view, zones["fluid"], "U", "Magnitude")
show(view, zones["lowerPlate"], "sigma", "XX")
show(view, zones["upperPlate"], "sigma", "XX")

# The first Render moves the camera
Render(view)
view.CameraParallelProjection = 1
view.CameraPosition = [0.17, 0.02, 10]
view.CameraFocalPoint = [0.17, 0.02, 0]
view.CameraViewUp = [0, 1, 0]
view.CameraParallelScale = 0.1

Render(view)
SaveScreenshot(os.path.join(CASE, "poiseuilleFields.png"), view)
