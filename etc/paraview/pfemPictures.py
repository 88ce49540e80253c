"""The pictures of a case in ParaView: used by tutorials/*/pictures.py, which say what is coloured how.

    pfemPictures.show(times=[0.2], box=((0, 0), (0.6, 0.4)), fluid=("magU", (0, 2)), solid=("vonMises", None))

In space the box has corners with z, and `view` is the direction to the eye, z upwards:

    pfemPictures.show(times=[0.2], box=((0, 0, 0), (1.2, 0.3, 0.6)), view=(0.5, -1, 0.45))

In ParaView's window (Tools > Start Trace is not needed: File > Run Script) the view is made and stays; pvbatch writes
paraview_<time>.png for each time. `fluid` and `solid`: a nodal field of "pfem: Join Parts" with its range, None: of the data.
"""

import itertools
import os
import pathlib

import loadPlugin
import numpy as np
from paraview import simple
from paraview.modules.vtkRemotingCore import vtkProcessModule


def _part(joined, number, view, colouring, title):
    part = simple.Threshold(Input=joined)
    part.Scalars = ["CELLS", "part"]
    part.LowerThreshold = part.UpperThreshold = number
    field, limits = colouring
    field, *component = field.split(":")  # sigma:XX
    display = simple.Show(part, view)
    simple.ColorBy(display, ("POINTS", field, *component))
    table = simple.GetColorTransferFunction(field)
    if number:
        table.ApplyPreset("Inferno (matplotlib)", True)
    if limits:
        table.RescaleTransferFunction(*limits)
    else:
        display.RescaleTransferFunctionToDataRange(False, True)
    bar = simple.GetScalarBar(table, view)
    bar.Title, bar.ComponentTitle = f"{title}: {field}", component[0] if component else ""
    bar.TitleColor = bar.LabelColor = [0, 0, 0]
    bar.Orientation, bar.WindowLocation, bar.HorizontalTitle = "Horizontal", "Any Location", 1
    bar.Position, bar.ScalarBarLength = [0.58 if number else 0.05, 0.04], 0.35
    display.SetScalarBarVisibility(view, True)
    return display


def _lookAt(view, box, direction, width):
    """Parallel rays; the box fills the picture. Without a direction: the plane x, y."""
    corners = np.array([list(corner) + [0] * (3 - len(corner)) for corner in itertools.product(*zip(*box))], dtype=float)
    back = np.array([0, 0, 1] if direction is None else direction, dtype=float)
    back /= np.linalg.norm(back)
    up = np.array([0, 1, 0] if abs(back[2]) > 0.999 else [0, 0, 1])
    right = np.cross(up, back)
    axes = np.array([right / np.linalg.norm(right), np.cross(back, right) / np.linalg.norm(right)])
    seen = corners @ axes.T
    size, centre = np.ptp(seen, axis=0), (corners.min(axis=0) + corners.max(axis=0)) / 2
    view.ViewSize = [width, int(width * size[1] / size[0])]
    view.InteractionMode = "2D" if direction is None else "3D"
    view.CameraParallelProjection = 1
    view.CameraFocalPoint = list(centre)
    view.CameraPosition = list(centre + (10 if direction is None else 10 * np.linalg.norm(size)) * back)
    view.CameraViewUp = list(axes[1])
    view.CameraParallelScale = size[1] / 2
    view.OrientationAxesVisibility = 0 if direction is None else 1


def show(times, box, fluid=("magU", None), solid=("vonMises", None), case=".", paths="", width=1200, view=None):
    """Set the view up; returns the pictures' names (pvbatch)."""
    direction = view
    simple._DisableFirstRenderCameraReset()
    loadPlugin.load(globals())
    file = str(pathlib.Path(case).resolve() / "case.pvd")
    if not os.path.exists(file):
        raise SystemExit(f"no {file}: run the case first")
    reader = simple.PVDReader(FileName=file)
    joined = globals()["pfemJoinParts"](Input=reader)
    view = simple.GetActiveViewOrCreate("RenderView")
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    _lookAt(view, box, direction, width)
    view.ViewTime = times[0]
    simple.UpdatePipeline(times[0], joined)
    for number, (colouring, title) in enumerate(((fluid, "fluid"), (solid, "solid"))):
        if colouring:
            _part(joined, number, view, colouring, title)
    if paths:
        lines = globals()["pfemParticlePaths"](FileName=file, Ids=paths)
        display = simple.Show(lines, view)
        display.ColorArrayName = ["POINTS", ""]  # of one colour
        display.AmbientColor = display.DiffuseColor = [1, 0.8, 0]
        display.LineWidth = 2
    if vtkProcessModule.GetProcessType() != vtkProcessModule.PROCESS_BATCH:
        simple.Render(view)
        return []
    pictures = []
    for time in times:
        view.ViewTime = time
        simple.Render(view)
        pictures.append(str(pathlib.Path(case).resolve() / f"paraview_{time:g}.png"))
        simple.SaveScreenshot(pictures[-1], view, ImageResolution=list(view.ViewSize))
    return pictures
