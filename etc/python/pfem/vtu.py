"""A .vtu file in the form that libpfem writes (appended raw, zlib, 64 bit heads, little endian), read without VTK."""

import struct
import xml.etree.ElementTree as ElementTree
import zlib

import numpy as np

from .grid import Grid

_TYPES = {"Float64": "<f8", "Float32": "<f4", "Int64": "<i8", "Int32": "<i4", "UInt8": "u1", "Int8": "i1"}


def readVtu(file):
    """The Grid in `file`. ValueError with the file's name when it is damaged or of another form."""
    with open(file, "rb") as stream:
        data = stream.read()
    try:
        return _read(data)
    except (KeyError, IndexError, TypeError, AttributeError, ValueError, struct.error, zlib.error,
            ElementTree.ParseError) as error:
        raise ValueError(f"{file}: truncated, corrupt or not a file of libpfem ({error})") from None


def _read(data):
    at = data.index(b"<AppendedData")
    start = data.index(b"_", data.index(b">", at)) + 1
    root = ElementTree.fromstring(data[:at] + b"</VTKFile>")
    if (root.get("compressor"), root.get("header_type"), root.get("byte_order")) != (
            "vtkZLibDataCompressor", "UInt64", "LittleEndian"):
        raise ValueError("another compression, head or byte order")
    piece = root.find("UnstructuredGrid/Piece")
    nPoints, nCells = int(piece.get("NumberOfPoints")), int(piece.get("NumberOfCells"))

    def arrays(element, tuples=None):
        found = {}
        for item in element if element is not None else ():
            values = _array(item, data, start)
            if tuples is not None and len(values) != tuples:
                raise ValueError(f"{item.get('Name')} has {len(values)} values, not {tuples}")
            found[item.get("Name")] = values
        return found

    cells = arrays(piece.find("Cells"))
    (points,) = arrays(piece.find("Points"), nPoints).values()
    if len(cells["types"]) != nCells or len(cells["offsets"]) != nCells:
        raise ValueError("its cells contradict each other")
    return Grid(points, cells["connectivity"], cells["offsets"], cells["types"],
                arrays(piece.find("PointData"), nPoints), arrays(piece.find("CellData"), nCells),
                arrays(root.find("UnstructuredGrid/FieldData")))


def _array(item, data, start):
    if item.get("format") != "appended":
        raise ValueError(f"{item.get('Name')} is not appended")
    text = _unpacked(data, start + int(item.get("offset")))
    if item.get("type") == "String":
        return [word.decode() for word in text.split(b"\0")[:-1]]
    values = np.frombuffer(text, dtype=_TYPES[item.get("type")])
    components = int(item.get("NumberOfComponents", "1"))
    return values.reshape(-1, components) if components > 1 else values


def _unpacked(data, at):
    """Head: number of blocks, size of a block, size of the last one (0: whole), compressed sizes."""
    blocks, size, last = struct.unpack_from("<3Q", data, at) if data[at:at + 8] != bytes(8) else (0, 0, 0)
    sizes = struct.unpack_from(f"<{blocks}Q", data, at + 24) if blocks < len(data) else None
    at += 24 + 8 * blocks
    parts = []
    for k, compressed in enumerate(sizes):
        part = zlib.decompress(data[at:at + compressed])
        if len(part) != (last if last and k + 1 == blocks else size):
            raise ValueError("a block has a wrong size")
        parts.append(part)
        at += compressed
    return b"".join(parts)
