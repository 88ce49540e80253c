"""What tetrahedra have instead of triangles."""

import numpy as np


def _edges(grid):
    """Per tetrahedron its first corner and the edges from there as columns."""
    corner = grid.points[grid.tetrahedra]
    return corner[:, 0], np.swapaxes(corner[:, 1:] - corner[:, :1], 1, 2)


def cellVolumes(grid):
    """Volumes of the tetrahedra [m3]; their sum over the fluid is pfemMassCheck's volume but for isolated drops."""
    return np.linalg.det(_edges(grid)[1]) / 6


def gradient(grid, values):
    """As derived.gradient, of shape (n, 3) or (n, c, 3)."""
    values = np.asarray(values, dtype=float)
    cells, volume = grid.tetrahedra, cellVolumes(grid)
    a = grid.points[cells]
    result = np.zeros((len(grid.points),) + values.shape[1:] + (3,))
    total = np.zeros(len(grid.points))
    # volume times the gradient of N_k is a third of the inward area of the face opposite
    faces = [(1, 3, 2), (0, 2, 3), (0, 3, 1), (0, 1, 2)]
    for k, (p, q, r) in enumerate(faces):
        weighted = np.cross(a[:, q] - a[:, p], a[:, r] - a[:, p]) / 6
        part = values[cells[:, k]][..., None] * weighted.reshape((-1,) + (1,) * (values.ndim - 1) + (3,))
        for corner in range(4):
            np.add.at(result, cells[:, corner], part)
    for corner in range(4):
        np.add.at(total, cells[:, corner], volume)
    total[total == 0] = 1
    return result / total.reshape((-1,) + (1,) * (result.ndim - 1))


def curl(grid, name="U"):
    g = gradient(grid, grid.point[name])
    return np.stack([g[:, 2, 1] - g[:, 1, 2], g[:, 0, 2] - g[:, 2, 0], g[:, 1, 0] - g[:, 0, 1]], axis=1)


def sample(grid, places, values):
    """Nodal values at places (k, 3), linear in the tetrahedra; nan where there is none."""
    result = np.full((len(places),) + values.shape[1:], np.nan)
    cells = grid.tetrahedra
    corner = grid.points[cells]
    low, high = corner.min(axis=1), corner.max(axis=1)
    slack = 1e-9 * (high - low)
    origin, edges = _edges(grid)
    whole = np.linalg.det(edges) > 0
    for k, x in enumerate(places):
        near = np.flatnonzero(((low - slack <= x) & (x <= high + slack)).all(axis=1) & whole)
        if len(near) == 0:
            continue
        rest = np.linalg.solve(edges[near], (x - origin[near])[..., None])[..., 0]
        weights = np.column_stack([1 - rest.sum(axis=1), rest])
        best = weights.min(axis=1).argmax()
        if weights[best].min() >= -1e-9:
            result[k] = np.tensordot(weights[best], values[cells[near[best]]], axes=1)
    return result
