"""matplotlib where there is one."""

import os
import sys


def pyplot():
    """matplotlib.pyplot, or None (and a word about it) where matplotlib is not installed."""
    try:
        import matplotlib
    except ImportError:
        print("(no matplotlib: numbers only)")
        return None
    if not os.environ.get("DISPLAY") and "ipykernel" not in sys.modules:
        matplotlib.use("Agg")
    import matplotlib.pyplot

    return matplotlib.pyplot


def triangles(plt, grid, values, **options):
    """Nodal values over the triangles of a grid, equal scales; the artist, for a colour bar."""
    axes = plt.gca()
    axes.set_aspect("equal")
    return axes.tripcolor(grid.points[:, 0], grid.points[:, 1], grid.triangles, values, shading="gouraud", **options)
