"""Points, cells and their fields."""

import numpy as np

from . import space

VERTEX, LINE, TRIANGLE, TETRAHEDRON = 1, 3, 5, 10  # VTK's cell types


class Grid:
    """One part of a time folder.

    points     (n, 3) positions [m]
    triangles  (m, 3), tetrahedra (m, 4), lines (k, 2), vertices (j): indices into points; vertices are isolated particles
    point      name -> nodal values: id U p D sigma X h ... ; tensors are XX YY ZZ XY YZ XZ
    cell       name -> values per cell in the file's order; cellsOf(...) picks those of one kind
    field      name -> values of the whole file: TimeValue, materials, patchNames
    """

    def __init__(self, points, connectivity, offsets, types, point, cell, field):
        self.points, self.types, self.offsets, self.connectivity = points, types, offsets, connectivity
        self.point, self.cell, self.field = point, cell, field
        if len(connectivity) and not (0 <= connectivity.min() and connectivity.max() < len(points)):
            raise ValueError("a cell refers to a point that is not there")

    def _cells(self, kind, size):
        ends = self.offsets[self.types == kind]
        if len(ends) == 0:
            return np.empty((0, size), dtype=np.int64)
        return self.connectivity[ends[:, None] + np.arange(-size, 0)]

    @property
    def triangles(self):
        return self._cells(TRIANGLE, 3)

    @property
    def tetrahedra(self):
        return self._cells(TETRAHEDRON, 4)

    @property
    def lines(self):
        return self._cells(LINE, 2)

    @property
    def vertices(self):
        return self._cells(VERTEX, 1)[:, 0]

    def cellsOf(self, name, kind=None):
        """Cell values of the tetrahedra, in the plane of the triangles (or of another kind of cells) only."""
        if kind is None:
            kind = TETRAHEDRON if (self.types == TETRAHEDRON).any() else TRIANGLE
        return self.cell[name][self.types == kind]

    @property
    def time(self):
        return float(self.field["TimeValue"][0])

    def index(self, ids):
        """Where the nodes with these ids are in this grid; -1: not there. (Files hold ids in ascending order.)"""
        ids = np.asarray(ids)
        own = self.point["id"]
        at = np.searchsorted(own, ids)
        at[at == len(own)] = 0
        return np.where(own[at] == ids, at, -1) if len(own) else np.full(ids.shape, -1)

    def sample(self, places, name):
        """Field `name` at places (x, y[, z]), linear in the cells; nan where there is none."""
        places = np.atleast_2d(np.asarray(places, dtype=float))
        field = self.point[name]
        if (self.types == TETRAHEDRON).any():
            return space.sample(self, places, field)
        places = places[:, :2]
        result = np.full((len(places),) + field.shape[1:], np.nan)
        triangles = self.triangles
        corner = self.points[triangles][:, :, :2]
        low, high = corner.min(axis=1), corner.max(axis=1)
        slack = 1e-9 * (high - low)
        a, u, w = corner[:, 0], corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0]
        twice = u[:, 0] * w[:, 1] - u[:, 1] * w[:, 0]
        for k, x in enumerate(places):
            near = np.flatnonzero(((low - slack <= x) & (x <= high + slack)).all(axis=1) & (twice > 0))
            d = x - a[near]
            l1 = (d[:, 0] * w[near, 1] - d[:, 1] * w[near, 0]) / twice[near]
            l2 = (u[near, 0] * d[:, 1] - u[near, 1] * d[:, 0]) / twice[near]
            weights = np.stack([1 - l1 - l2, l1, l2], axis=1)
            if len(near) == 0:
                continue
            best = weights.min(axis=1).argmax()
            if weights[best].min() >= -1e-9:
                result[k] = np.tensordot(weights[best], field[triangles[near[best]]], axes=1)
        return result

    def frame(self):
        """A pandas frame of the nodes with the id as index; vectors as U_x ..., tensors as sigma_xx ..."""
        import pandas

        flat = {axis: self.points[:, c] for c, axis in enumerate("xyz")}
        for name, values in self.point.items():
            if values.ndim == 1:
                flat[name] = values
            else:
                axes = "xyz" if values.shape[1] == 3 else ("xx", "yy", "zz", "xy", "yz", "xz")
                flat.update({f"{name}_{axis}": values[:, c] for c, axis in enumerate(axes)})
        return pandas.DataFrame(flat).set_index("id")

    def toMeshio(self):
        import meshio

        kinds = [(name, kind, cells) for name, kind, cells in (
            ("vertex", VERTEX, self.vertices[:, None]), ("line", LINE, self.lines),
            ("triangle", TRIANGLE, self.triangles), ("tetra", TETRAHEDRON, self.tetrahedra)) if len(cells)]
        return meshio.Mesh(self.points, [(name, cells) for name, _, cells in kinds], point_data=dict(self.point),
                           cell_data={name: [values[self.types == kind] for _, kind, _ in kinds]
                                      for name, values in self.cell.items()})

    def toVtk(self):
        from .vtk import toVtk

        return toVtk(self)
