"""What follows from the fields."""

import numpy as np

from . import space


def magnitude(vectors):
    return np.linalg.norm(vectors, axis=-1)


def vonMises(sigma):
    """Von Mises stress of tensors XX YY ZZ XY YZ XZ."""
    xx, yy, zz, xy, yz, xz = np.moveaxis(np.asarray(sigma), -1, 0)
    return np.sqrt(0.5 * ((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2) + 3 * (xy ** 2 + yz ** 2 + xz ** 2))


def cellAreas(grid):
    """Areas of the triangles [m2]; their sum over the fluid is pfemMassCheck's volume but for isolated drops."""
    a, b, c = (grid.points[grid.triangles[:, k], :2] for k in range(3))
    u, w = b - a, c - a
    return 0.5 * (u[:, 0] * w[:, 1] - u[:, 1] * w[:, 0])


def gradient(grid, values):
    """Nodal gradient of nodal `values` (n) or (n, c): the mean of the triangles around the node, weighted by area, as
    the nodal patches of the solver take it. Shape (n, 2) or (n, c, 2), of tetrahedra 3; zero where there is no cell."""
    if len(grid.tetrahedra):
        return space.gradient(grid, values)
    values = np.asarray(values, dtype=float)
    triangles, area = grid.triangles, cellAreas(grid)
    x = grid.points[triangles][:, :, :2]
    total = np.zeros(len(grid.points))
    result = np.zeros((len(grid.points),) + values.shape[1:] + (2,))
    for k in range(3):
        p, q = x[:, (k + 1) % 3], x[:, (k + 2) % 3]
        weighted = 0.5 * np.stack([p[:, 1] - q[:, 1], q[:, 0] - p[:, 0]], axis=1)  # area times the gradient of N_k
        part = values[triangles[:, k]][..., None] * weighted.reshape((-1,) + (1,) * (values.ndim - 1) + (2,))
        for corner in range(3):
            np.add.at(result, triangles[:, corner], part)
    for corner in range(3):
        np.add.at(total, triangles[:, corner], area)
    total[total == 0] = 1
    return result / total.reshape((-1,) + (1,) * (result.ndim - 1))


def vorticity(grid, name="U"):
    """dv/dx - du/dy at the nodes [1/s]; in tetrahedra the vector rot U."""
    if len(grid.tetrahedra):
        return space.curl(grid, name)
    g = gradient(grid, grid.point[name][:, :2])
    return g[:, 1, 0] - g[:, 0, 1]
