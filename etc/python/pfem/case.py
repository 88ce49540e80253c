"""A case folder: its tables and its times."""

import math
import pathlib

import numpy as np

from .table import readTable
from .vtu import readVtu

PARTS = ("fluid", "solid", "boundary")


class Step:
    """One time folder. Its parts `fluid`, `solid`, `boundary` are read when they are first asked for."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.name = self.folder.name
        self._parts = {}

    def __getattr__(self, part):
        if part not in PARTS:
            raise AttributeError(part)
        if part not in self._parts:
            self._parts[part] = readVtu(self.folder / f"{part}.vtu")
        return self._parts[part]

    @property
    def time(self):
        return self.boundary.time

    def sample(self, places, name):
        """As pfemProbe: p in the fluid, sigma in the solid, others in the fluid or, where there is none, in the solid;
        nan elsewhere. (Tensors: XX YY ZZ XY YZ XZ as in the files; pfemProbe prints OpenFOAM's xx xy xz yy yz zz.)"""
        parts = {"p": ("fluid",), "sigma": ("solid",)}.get(name, ("fluid", "solid"))
        values = [getattr(self, part).sample(places, name) for part in parts]
        for other in values[1:]:
            values[0] = np.where(np.isnan(values[0]), other, values[0])
        return values[0]


class Case:
    def __init__(self, root="."):
        self.root = pathlib.Path(root)
        if not self.root.is_dir():
            raise FileNotFoundError(f"no case folder '{root}'")

    @property
    def times(self):
        """Names of the complete time folders, by their time. Written anew by a run that goes on: ask again."""
        names = [folder.name for folder in self.root.iterdir()
                 if _asTime(folder.name) is not None and (folder / "uniform" / "time").is_file()
                 and all((folder / f"{part}.vtu").is_file() for part in PARTS)]
        return sorted(names, key=float)

    def read(self, time):
        """The Step at `time`: a folder's name, a number (the nearest time), or "latest"."""
        times = self.times
        if not times:
            raise FileNotFoundError(f"no time folder in '{self.root}'")
        if time == "latest":
            return Step(self.root / times[-1])
        if isinstance(time, str):
            if time not in times:
                raise FileNotFoundError(f"no time '{time}' in '{self.root}'; there are: {' '.join(times)}")
            return Step(self.root / time)
        return Step(self.root / min(times, key=lambda name: abs(float(name) - time)))

    def steps(self, first=-math.inf, last=math.inf):
        """All times from `first` to `last`, one after the other."""
        return (Step(self.root / name) for name in self.times if first <= float(name) <= last)

    def table(self, function, file):
        """The table postProcessing/<function>/<startTime>/<file> over all restarts, as pfemHistory gives it."""
        folder = self.root / "postProcessing" / function
        starts = sorted((item.name for item in folder.iterdir() if _asTime(item.name) is not None),
                        key=float) if folder.is_dir() else []
        files = [folder / start / file for start in starts if (folder / start / file).is_file()]
        if not files:
            raise FileNotFoundError(f"no postProcessing/{function}/<startTime>/{file} in '{self.root}'")
        return readTable(*files)

    def trace(self, ids, part="fluid", field=None):
        """Time (n) and positions (n, ids, 3) of the nodes with these ids, or their values of `field`; nan where a node
        is not there (removed, or not yet inserted)."""
        time, values = [], []
        for step in self.steps():
            grid = getattr(step, part)
            at = grid.index(ids)
            source = grid.points if field is None else grid.point[field]
            row = np.full((len(at),) + source.shape[1:], np.nan)
            row[at >= 0] = source[at[at >= 0]]
            time.append(grid.time)
            values.append(row)
        return np.array(time), np.array(values)


def _asTime(name):
    try:
        value = float(name)
    except ValueError:
        return None
    return value if math.isfinite(value) and name[0] in "-.0123456789" and "_" not in name else None
