"""The pictures of a case in ParaView: used by tutorials/*/pictures.py, which say what is coloured how.

    pfemPictures.show(times=[0.2], box=((0, 0), (0.6, 0.4)), fluid=("magU", (0, 2)), solid=("vonMises", None))

In ParaView's window (Tools > Start Trace is not needed: File > Run Script) the view is made and stays; pvbatch writes
paraview_<time>.png for each time. `fluid` and `solid`: a nodal field of "pfem: Join Parts" with its range, None: of the data.
"""

import os
import pathlib

import loadPlugin
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


def show(times, box, fluid=("magU", None), solid=("vonMises", None), case=".", paths="", width=1200):
    """Set the view up; returns the pictures' names (pvbatch)."""
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
    (left, bottom), (right, top) = box
    view.ViewSize = [width, int(width * (top - bottom) / (right - left))]
    view.InteractionMode = "2D"
    view.CameraParallelProjection = 1
    view.CameraPosition = [(left + right) / 2, (bottom + top) / 2, 10]
    view.CameraFocalPoint = [(left + right) / 2, (bottom + top) / 2, 0]
    view.CameraParallelScale = (top - bottom) / 2
    view.OrientationAxesVisibility = 0
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
