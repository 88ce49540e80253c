"""Results of libpfem as numpy arrays: tables of postProcessing/, time folders, what can be derived from them.

    import pfem
    case = pfem.Case("tutorials/damBreakElasticWall")
    tip = case.table("tip", "D")            # all restarts joined
    plt.plot(tip.time, tip.values[:, 0, 0])  # u_x of the first probe
    step = case.read(0.2)                    # the time folder 0.2
    step.fluid.point["p"].max()

Needs numpy alone. Where they are installed: frame() gives pandas frames, toMeshio() a meshio mesh, toVtk() a VTK grid.
"""

from .case import Case, Step
from .derived import cellAreas, gradient, magnitude, vonMises, vorticity
from .grid import Grid
from .join import join
from .plotting import pyplot, triangles
from .space import cellVolumes
from .table import Table, readTable
from .vtu import readVtu

__all__ = ["Case", "Grid", "Step", "Table", "cellAreas", "cellVolumes", "gradient", "join", "magnitude", "pyplot",
           "readTable", "readVtu", "triangles", "vonMises", "vorticity"]
