"""Fluid and solid as one grid, with what the files do not hold."""

import numpy as np

from .derived import magnitude, vonMises, vorticity
from .grid import Grid


def join(fluid, solid):
    """One Grid of both parts; nodes of the interface are one. Added: nodal magU, magD (lengths), vonMises (of the solid),
    vorticity (of the fluid, in the solid its own) and `fluid` (1: node of the fluid); per cell `part` (0: fluid, 1: solid)."""
    ids = np.union1d(fluid.point["id"], solid.point["id"])
    at = [np.searchsorted(ids, part.point["id"]) for part in (fluid, solid)]
    point = {}
    for part, index in ((solid, at[1]), (fluid, at[0])):
        for name, values in part.point.items():
            if name not in point:
                point[name] = np.zeros((len(ids),) + values.shape[1:], dtype=values.dtype)
            if name != "sigma" or part is solid or "sigma" not in solid.point:
                point[name][index] = values
    points = np.zeros((len(ids), 3))
    for part, index in ((solid, at[1]), (fluid, at[0])):
        points[index] = part.points
    cell = {name: np.concatenate([fluid.cell[name], solid.cell[name]]) for name in fluid.cell if name in solid.cell}
    cell["part"] = np.repeat(np.array([0, 1], dtype=np.int32), [len(fluid.types), len(solid.types)])
    last = fluid.offsets[-1] if len(fluid.offsets) else 0
    joined = Grid(points, np.concatenate([at[0][fluid.connectivity], at[1][solid.connectivity]]),
                  np.concatenate([fluid.offsets, solid.offsets + last]), np.concatenate([fluid.types, solid.types]),
                  point, cell, dict(fluid.field))
    point["magU"], point["magD"] = magnitude(point["U"]), magnitude(point["D"])
    point["vonMises"] = vonMises(point["sigma"]) if "sigma" in point else np.zeros(len(ids))
    point["vorticity"] = np.zeros((len(ids), 3) if len(joined.tetrahedra) else len(ids))
    for part, index in ((solid, at[1]), (fluid, at[0])):
        if len(part.tetrahedra) or len(part.triangles):
            point["vorticity"][index] = vorticity(part)
    point["fluid"] = np.zeros(len(ids), dtype=np.uint8)
    point["fluid"][at[0]] = 1
    return joined
