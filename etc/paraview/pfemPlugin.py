"""ParaView plugin: the filter "pfem: Join Parts" and the source "pfem: Particle Paths".

In ParaView: File > Run Script: loadPlugin.py beside this file; or Tools > Manage Plugins > Load New: this file (not with Debian
12's ParaView, whose loader fails). In pvbatch and in scripts, with this folder in sys.path:

    import loadPlugin
    loadPlugin.load(globals())
"""

import os
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(os.path.realpath(__file__)).parent.parent / "python"))

import numpy as np
from paraview.util.vtkAlgorithm import VTKPythonAlgorithmBase, smdomain, smhint, smproperty, smproxy
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkUnstructuredGrid
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline

import pfem
from pfem.vtk import fromVtk, pathsToVtk, toVtk


def parts(data):
    """Fluid and solid of what PVDReader gives for case.pvd, in the order in which the file names them."""
    iterator = data.NewIterator()
    iterator.SkipEmptyNodesOff()
    found = []
    iterator.InitTraversal()
    while not iterator.IsDoneWithTraversal():
        grid = iterator.GetCurrentDataObject()
        if isinstance(grid, vtkUnstructuredGrid):
            found.append(grid)
        iterator.GoToNextItem()
    found = [grid for grid in found if grid.GetCellData().GetArray("patch") is None]
    if len(found) != 2:
        raise RuntimeError("pfem: Join Parts needs fluid and solid: open case.pvd of a case")
    return found


@smproxy.filter(name="PfemJoinParts", label="pfem: Join Parts")
@smproperty.input(name="Input", port_index=0)
@smdomain.datatype(dataTypes=["vtkMultiBlockDataSet", "vtkPartitionedDataSetCollection"], composite_data_supported=True)
class PfemJoinParts(VTKPythonAlgorithmBase):
    """Fluid and solid of case.pvd as one grid, nodes of the interface once. Adds the nodal fields magU, magD, vonMises,
    vorticity (in space a vector) and the cell field part (0: fluid, 1: solid)."""

    def __init__(self):
        super().__init__(nInputPorts=1, nOutputPorts=1, outputType="vtkUnstructuredGrid")

    def FillInputPortInformation(self, port, info):
        info.Set(self.INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet")
        return 1

    def RequestData(self, request, inInfo, outInfo):
        data = self.GetInputData(inInfo, 0, 0)
        fluid, solid = (fromVtk(grid) for grid in parts(data))
        vtkUnstructuredGrid.GetData(outInfo, 0).ShallowCopy(toVtk(pfem.join(fluid, solid)))
        return 1


@smproxy.source(name="PfemParticlePaths", label="pfem: Particle Paths")
class PfemParticlePaths(VTKPythonAlgorithmBase):
    """Where particles have been until the present time: a line for each, with their id, time, U and p.

    Ids: numbers apart by blanks, or `every N` for each N-th node of the fluid's first time. A particle that a remeshing
    has removed keeps the path that it had."""

    def __init__(self):
        super().__init__(nInputPorts=0, nOutputPorts=1, outputType="vtkPolyData")
        self._file, self._ids, self._paths = "", "every 20", None

    @smproperty.stringvector(name="FileName")
    @smdomain.filelist()
    @smhint.filechooser(extensions="pvd", file_description="case.pvd of a case")
    def SetFileName(self, name):
        if name != self._file:
            self._file, self._paths = name or "", None
            self.Modified()

    @smproperty.stringvector(name="Ids", default_values="every 20")
    def SetIds(self, text):
        if text != self._ids:
            self._ids, self._paths = text or "", None
            self.Modified()

    @smproperty.doublevector(name="TimestepValues", information_only="1", si_class="vtkSITimeStepsProperty")
    def GetTimestepValues(self):
        return None if not self._file else [float(name) for name in self._case().times]

    def _case(self):
        return pfem.Case(pathlib.Path(self._file).parent)

    def _chosen(self, case):
        words = self._ids.split()
        if len(words) == 2 and words[0] == "every" and words[1].isdigit() and int(words[1]) > 0:
            return case.read(case.times[0]).fluid.point["id"][:: int(words[1])]
        if not words or not all(word.isdigit() for word in words):
            raise RuntimeError(f"pfem: Particle Paths: '{self._ids}' is neither a list of ids nor `every N`")
        return np.array([int(word) for word in words])

    def RequestInformation(self, request, inInfo, outInfo):
        if self._file:
            info = outInfo.GetInformationObject(0)
            times = self.GetTimestepValues()
            info.Remove(Pipeline.TIME_STEPS())
            for time in times:
                info.Append(Pipeline.TIME_STEPS(), time)
            info.Set(Pipeline.TIME_RANGE(), [times[0], times[-1]] if times else [0.0, 0.0], 2)
        return 1

    def RequestData(self, request, inInfo, outInfo):
        if not self._file:
            return 1
        case = self._case()
        if self._paths is None or len(self._paths[1]) != len(case.times):  # a run that goes on has written more
            ids = self._chosen(case)
            time, x = case.trace(ids)
            self._paths = (ids, time, x, case.trace(ids, field="U")[1], case.trace(ids, field="p")[1])
        ids, time, x, velocity, pressure = self._paths
        info = outInfo.GetInformationObject(0)
        now = info.Get(Pipeline.UPDATE_TIME_STEP()) if info.Has(Pipeline.UPDATE_TIME_STEP()) else time[-1]
        # particle by particle, the times until now at which it is there
        there = (np.isfinite(x[:, :, 0]) & (time[:, None] <= now + 1e-12 * abs(now))).T
        fields = {"id": np.broadcast_to(ids[:, None], there.shape)[there],
                  "time": np.broadcast_to(time, there.shape)[there],
                  "U": velocity.transpose(1, 0, 2)[there], "p": pressure.T[there]}
        vtkPolyData.GetData(outInfo, 0).ShallowCopy(pathsToVtk(x.transpose(1, 0, 2)[there], there.sum(axis=1), fields))
        return 1
