"""From and to VTK; needs VTK's Python modules (ParaView has them)."""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData, vtkUnstructuredGrid

from .grid import Grid


def fromVtk(grid):
    """The Grid of a vtkUnstructuredGrid; fields of words are left out."""

    def arrays(data):
        found = [data.GetArray(k) for k in range(data.GetNumberOfArrays())]
        return {array.GetName(): vtk_to_numpy(array) for array in found if array is not None}

    cells = grid.GetCells()
    types = vtk_to_numpy(grid.GetCellTypesArray()) if grid.GetNumberOfCells() else np.empty(0, dtype=np.uint8)
    return Grid(vtk_to_numpy(grid.GetPoints().GetData()), vtk_to_numpy(cells.GetConnectivityArray()),
                vtk_to_numpy(cells.GetOffsetsArray())[1:], types, arrays(grid.GetPointData()),
                arrays(grid.GetCellData()), arrays(grid.GetFieldData()))


def toVtk(grid):
    """The vtkUnstructuredGrid of a Grid."""
    result = vtkUnstructuredGrid()
    result.SetPoints(_points(grid.points))
    result.SetCells(numpy_to_vtk(grid.types.astype(np.uint8), deep=True), _cells(grid.offsets, grid.connectivity))
    _addArrays(result.GetPointData(), grid.point)
    _addArrays(result.GetCellData(), grid.cell)
    return result


def pathsToVtk(points, lengths, fields):
    """Polylines as vtkPolyData: the first lengths[0] points make the first one, and so on."""
    result = vtkPolyData()
    result.SetPoints(_points(points))
    result.SetLines(_cells(np.cumsum(lengths), np.arange(len(points))))
    _addArrays(result.GetPointData(), fields)
    return result


def _points(values):
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(values, dtype=float), deep=True))
    return points


def _cells(ends, connectivity):
    cells = vtkCellArray()
    cells.SetData(numpy_to_vtkIdTypeArray(np.append(0, ends).astype(np.int64), deep=True),
                  numpy_to_vtkIdTypeArray(np.asarray(connectivity, dtype=np.int64), deep=True))
    return cells


def _addArrays(target, fields):
    for name, values in fields.items():
        array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
        array.SetName(name)
        target.AddArray(array)
