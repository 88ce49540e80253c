# In pvbatch: the plugin's output against the Python module. Argument: the project's folder.

import os
import sys

import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

sys.path[:0] = [os.path.join(sys.argv[1], "etc", folder) for folder in ("paraview", "python")]
import loadPlugin
import pfem

loadPlugin.load(globals())

file = os.path.abspath("case.pvd")
case = pfem.Case()
reader = simple.PVDReader(FileName=file)
joined = pfemJoinParts(Input=reader)
for name in (case.times[0], case.times[-1]):
    step = case.read(name)
    wanted = pfem.join(step.fluid, step.solid)
    joined.UpdatePipeline(float(name))
    data = servermanager.Fetch(joined)
    assert data.GetNumberOfPoints() == len(wanted.points), (data.GetNumberOfPoints(), len(wanted.points))
    assert data.GetNumberOfCells() == len(wanted.types)
    for field in ("id", "U", "p", "D", "magU", "magD", "vonMises", "vorticity"):
        found = vtk_to_numpy(data.GetPointData().GetArray(field))
        assert np.array_equal(found, wanted.point[field]), field
    assert np.array_equal(vtk_to_numpy(data.GetCellData().GetArray("part")), wanted.cell["part"])
    print(name, len(wanted.points), "points, largest von Mises stress", wanted.point["vonMises"].max())
assert wanted.point["vonMises"].max() > 0 and wanted.point["vorticity"].any()

# paths: of two nodes of the wall's interface (which live for ever) until a time in the middle, then until the end
ids = np.intersect1d(step.fluid.point["id"], step.solid.point["id"])[:2]
paths = pfemParticlePaths(FileName=file, Ids=" ".join(str(i) for i in ids))
paths.UpdatePipelineInformation()
assert list(paths.TimestepValues) == [float(name) for name in case.times]
time, x = case.trace(ids)
for now in (time[len(time) // 2], time[-1]):
    paths.UpdatePipeline(now)
    data = servermanager.Fetch(paths)
    assert data.GetNumberOfLines() == 2, data.GetNumberOfLines()
    points = vtk_to_numpy(data.GetPoints().GetData())
    until = (time <= now + 1e-12) & np.isfinite(x[:, 0, 0])
    first = vtk_to_numpy(data.GetPointData().GetArray("id")) == ids[0]
    assert np.allclose(points[first], x[until, 0]), "path"
    assert np.allclose(vtk_to_numpy(data.GetPointData().GetArray("time"))[first], time[until])
print("plugin ok")
