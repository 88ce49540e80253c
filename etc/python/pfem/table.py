"""Tables of postProcessing/: probes, sensors, ledgers, forces, energy, lines."""

import re

import numpy as np

DRY = -1e299  # what is dry or outside is written as -1e+300


class Table:
    """One table. `time` (n), `columns`: title -> array (n) or, for vectors, (n, 3). What is dry is nan.

    Probes and sensors have the titles "0", "1", ..., places in `points`, and all of them in `values`: (n, sensors) or
    (n, sensors, 3). A title that a table does not have (a cause of volume that has not occurred) is zero in get().
    """

    def __init__(self, time, columns, points=None):
        self.time = time
        self.columns = columns
        self.points = points

    def __getitem__(self, title):
        try:
            return self.columns[title]
        except KeyError:
            raise KeyError(f"no column '{title}'; there are: {' '.join(self.columns)}") from None

    def get(self, title):
        return self.columns.get(title, np.zeros(len(self.time)))

    def __len__(self):
        return len(self.time)

    @property
    def values(self):
        """All columns side by side."""
        return np.stack(list(self.columns.values()), axis=1)

    def frame(self):
        """A pandas frame with the time as index; vectors as title_x, title_y, title_z."""
        import pandas

        flat = {}
        for title, values in self.columns.items():
            if values.ndim == 1:
                flat[title] = values
            else:
                flat.update({f"{title}_{axis}": values[:, c] for c, axis in enumerate("xyz")})
        return pandas.DataFrame(flat, index=pandas.Index(self.time, name="time"))


def readTable(*files):
    """The table that `files` make together, the folders of one run's restarts in their order: from where a later one
    begins, the earlier one ends."""
    if not files:
        raise ValueError("readTable: no file")
    titles, points, rows = None, None, []
    for file in files:
        newTitles, points, newRows = _parse(file)
        if titles is not None and len(newTitles) != len(titles):
            raise ValueError(f"{file}: {len(newTitles)} columns where the table before it has {len(titles)}")
        titles = newTitles
        if newRows:
            start = _number(newRows[0][0], file)
            rows = [row for row in rows if row[0] < start - 1e-12 * abs(start)]
        rows += [[_number(row[0], file)] + [_value(cell, file) for cell in row[1:]] for row in newRows]
    time = np.array([row[0] for row in rows], dtype=float)
    columns = {title: _column([row[k + 1] for row in rows]) for k, title in enumerate(titles)}
    return Table(time, columns, points)


_CELL = re.compile(r"\([^()]*\)|[^\s()]+")


def _parse(file):
    """Titles without the first, places of sensors or None, rows of text cells."""
    head, rows = [], []
    with open(file) as stream:
        for line in stream:
            text = line.strip()
            if text.startswith("#"):
                head.append(text[1:].strip())
            elif text:
                if not line.endswith("\n"):
                    break  # a row that is just being written
                rows.append(_CELL.findall(text))
    width = len(rows[0]) if rows else None
    for row in rows:
        if len(row) != width:
            raise ValueError(f"{file}: a row has {len(row)} columns, the first one {width}")
    places = [re.match(r"\w+ \d+ \(([^)]*)\)", line) for line in head]
    places = [[float(c) for c in match.group(1).split()] for match in places if match]
    if places:
        return [str(k) for k in range(len(places))], np.array(places), rows
    titles = re.split(r"\s+", head[-1])[1:] if head else []
    if width is not None and len(titles) != width - 1:
        titles = [str(k) for k in range(width - 1)]
    return titles, None, rows


def _number(text, file):
    try:
        return float(text)
    except ValueError:
        raise ValueError(f"{file}: '{text}' is not a number") from None


def _value(text, file):
    if text.startswith("("):
        return [_number(part, file) for part in text[1:-1].split()]
    if re.fullmatch(r"[A-Za-z_]\w*", text):  # the name of a field
        return text
    return _number(text, file)


def _column(cells):
    if any(isinstance(cell, str) for cell in cells):
        return np.array(cells, dtype=str)
    values = np.array(cells, dtype=float)
    return np.where(values <= DRY, np.nan, values)
