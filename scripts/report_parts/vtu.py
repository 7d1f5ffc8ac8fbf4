# SPDX-License-Identifier: GPL-2.0-or-later
"""Read the fields a run wrote (.pvd, .pvtu, .vtu) with nothing but numpy.

Understood are inline arrays, ascii or base64, with or without zlib, in one or
several pieces: what deal.II writes. Appended data are not.
"""
import base64
import os
import re
import xml.etree.ElementTree as ElementTree
import zlib

import numpy as np

from .safe import LARGEST, finite, read_text

TYPES = {"Float32": "f4", "Float64": "f8", "Int8": "i1", "UInt8": "u1",
         "Int16": "i2", "UInt16": "u2", "Int32": "i4", "UInt32": "u4",
         "Int64": "i8", "UInt64": "u8"}

# Faces of the VTK cell types that are drawn, as local corner numbers. Higher
# order (Lagrange) cells begin with their corners, so these serve them too.
QUADRILATERAL = [(0, 1, 2, 3)]
TRIANGLE = [(0, 1, 2, 2)]
HEXAHEDRON = [(0, 1, 2, 3), (4, 5, 6, 7), (0, 1, 5, 4),
              (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]
TETRAHEDRON = [(0, 1, 2, 2), (0, 1, 3, 3), (1, 2, 3, 3), (0, 2, 3, 3)]
FACES = {5: TRIANGLE, 69: TRIANGLE, 9: QUADRILATERAL, 70: QUADRILATERAL,
         10: TETRAHEDRON, 71: TETRAHEDRON, 12: HEXAHEDRON, 72: HEXAHEDRON}


# a triangle repeats its last corner
N_CORNERS = {kind: 1 + max(max(face) for face in faces)
             for kind, faces in FACES.items()}


class FieldError(Exception):
    """A file of fields that cannot be read; its text is for a person."""


class Fields:
    """One moment: points (n, 3), faces (m, 4), and point data by name.

    A triangle repeats its last corner. In 3-d the faces are the outer ones, and
    cells (k, 8) are those that are hexahedra.
    """

    def __init__(self, points, faces, data, cells=None):
        self.points = points
        self.faces = faces
        self.data = data
        self.cells = np.zeros((0, 8), int) if cells is None else cells


def read_collection(directory):
    """[(time, path)] of fields.pvd, by time, files that exist only."""
    text = read_text(os.path.join(directory, "fields.pvd")) or ""
    entries = {}
    # no XML parser: the collection of a killed run may end anywhere
    for attributes in re.findall(r"<DataSet\b([^>]*)>", text):
        found = dict(re.findall(r'(\w+)\s*=\s*"([^"]*)"', attributes))
        path = os.path.join(directory, found.get("file", ""))
        time = finite(found.get("timestep"))
        if time is not None and os.path.isfile(path):
            entries[time] = path
    return sorted(entries.items())


def decoded(element, header_type, compressed, order):
    """The numbers of one DataArray, flat."""
    kind = element.get("type")
    if kind not in TYPES:
        raise FieldError("data type '%s' is not known" % kind)
    number = np.dtype(order + TYPES[kind])
    layout = element.get("format", "ascii")
    text = element.text or ""
    if layout == "ascii":
        return np.array(text.split(), dtype=float).astype(number)
    if layout != "binary":
        raise FieldError("data format '%s' is not understood" % layout)
    text = re.sub(r"\s+", "", text)
    size = 8 if header_type == "UInt64" else 4
    letter = order + ("Q" if size == 8 else "I")

    def encoded_length(n_bytes):
        return (n_bytes + 2) // 3 * 4

    if not text:
        return np.zeros(0, number)
    if not compressed:
        return np.frombuffer(base64.b64decode(text)[size:], number)
    # header: number of blocks, block size, last block size, compressed sizes
    n_blocks = int(np.frombuffer(base64.b64decode(text[:encoded_length(size)])[:size],
                                 letter)[0])
    header_length = encoded_length((3 + n_blocks) * size)
    header = np.frombuffer(base64.b64decode(text[:header_length]),
                           np.dtype(letter))[3:3 + n_blocks]
    raw = base64.b64decode(text[header_length:])
    blocks, begin = [], 0
    for length in header:
        blocks.append(zlib.decompress(raw[begin:begin + int(length)]))
        begin += int(length)
    return np.frombuffer(b"".join(blocks), number)


def read_piece_file(path, names):
    """[(points, connectivity, offsets, types, data)] of one .vtu."""
    root = ElementTree.parse(path).getroot()
    order = ">" if root.get("byte_order") == "BigEndian" else "<"
    header_type = root.get("header_type", "UInt32")
    compressed = root.get("compressor") is not None

    def array(element):
        values = decoded(element, header_type, compressed, order)
        components = int(element.get("NumberOfComponents", "1"))
        return values.reshape(-1, components) if components > 1 else values

    pieces = []
    for piece in root.iter("Piece"):
        n_points = int(piece.get("NumberOfPoints", "0"))
        if n_points == 0:  # a rank without cells
            continue
        cells = {e.get("Name"): array(e) for e in piece.find("Cells")}
        points = array(piece.find("Points")[0]).reshape(-1, 3)
        data = {e.get("Name"): array(e) for e in piece.iterfind("PointData/*")
                if e.get("Name") in names}
        if len(points) != n_points:
            raise FieldError("it holds fewer points than it says")
        pieces.append((points.astype(float), cells["connectivity"].astype(int),
                       cells["offsets"].astype(int), cells["types"].astype(int),
                       data))
        check_piece(*pieces[-1])
    return pieces


def check_piece(points, connectivity, offsets, types, data):
    """Raises FieldError where drawing would fail, or draw nonsense."""
    if len(offsets) != len(types) or (np.diff(offsets, prepend=0) < 1).any() \
            or (len(offsets) and offsets[-1] != len(connectivity)):
        raise FieldError("its cells do not fit together")
    n_corners = np.array([N_CORNERS.get(kind, 0) for kind in types], int)
    if (np.diff(offsets, prepend=0) < n_corners).any():
        raise FieldError("its cells have too few corners")
    if len(connectivity) and not (0 <= connectivity.min()
                                  and connectivity.max() < len(points)):
        raise FieldError("its cells have corners that are no points of it")
    for name, values in [("points", points)] + sorted(data.items()):
        if len(values) != len(points):
            raise FieldError("%s has %d values for %d points"
                             % (name, len(values), len(points)))
        # also where a value is NaN, which compares with nothing
        if not (np.abs(values) <= LARGEST).all():
            raise FieldError("%s has values that are not finite" % name)
    if data.get("phase_field", np.zeros(0)).ndim != 1 \
            or data.get("displacement", np.zeros((0, 3))).ndim != 2:
        raise FieldError("a field has another number of components")


def faces_of(connectivity, offsets, types):
    """(faces, is_volume): corners of every face of every cell, 4 each."""
    begins = np.concatenate([[0], offsets[:-1]])
    faces, is_volume = [], False
    for kind in sorted(FACES.keys() & set(types)):
        starts = begins[types == kind]
        is_volume = is_volume or len(FACES[kind]) > 1
        faces += [connectivity[starts[:, None] + np.array(corners)]
                  for corners in FACES[kind]]
    return np.concatenate(faces or [np.zeros((0, 4), int)]), is_volume


def hexahedra_of(connectivity, offsets, types):
    """Corners of the hexahedra, 8 each."""
    starts = np.concatenate([[0], offsets[:-1]])[np.isin(types, (12, 72))]
    return connectivity[starts[:, None] + np.arange(8)]


def faces_of_hexahedra(cells):
    return np.concatenate([cells[:, list(corners)] for corners in HEXAHEDRON])


def merged_points(points):
    """For each point the number of its place: equal where points coincide."""
    extent = float(np.ptp(points, axis=0).max()) or 1.
    rounded = np.round((points - points.min(axis=0)) / extent * 1e7).astype(np.int64)
    return np.unique(rounded, axis=0, return_inverse=True)[1].ravel()


def found_at(points, wanted):
    """For each wanted place the number of a point there, or -1."""
    reach = 1e-5 * (float(np.ptp(points, axis=0).max()) or 1.)
    result = np.full(len(wanted), -1)
    for shift in (0.1, 0.6):  # places at the edge of a box are not at both
        boxes = np.floor(np.concatenate([points, wanted]) / reach + shift)
        _, first, inverse = np.unique(boxes.astype(np.int64), axis=0,
                                      return_index=True, return_inverse=True)
        match = first[inverse.ravel()[len(points):]]
        result = np.where((result < 0) & (match < len(points)), match, result)
    return result


def outer_faces(points, faces):
    """The faces that belong to one cell only, without those between a cell and
    its refined neighbour."""
    place = merged_points(points)
    corners = np.sort(place[faces], axis=1)
    _, inverse, count = np.unique(corners, axis=0, return_inverse=True,
                                  return_counts=True)
    faces = faces[count[inverse.ravel()] == 1]
    # a face with a node in its middle is the coarse side: four faces opposite
    used = np.unique(faces)
    middle = found_at(points[used], points[faces].mean(axis=1))
    chosen = (middle >= 0) & (faces[:, 2] != faces[:, 3])
    coarse, middle = faces[chosen], place[used[middle[chosen]]]
    ends = points[coarse]
    halves = found_at(points[used], (0.5 * (ends + np.roll(ends, -1, axis=1)))
                      .reshape(-1, 3))
    halves = np.where(halves >= 0, place[used[halves]], -1).reshape(-1, 4)
    inner = [place[coarse]] + [
        np.stack([place[coarse[:, k]], halves[:, k], middle, halves[:, k - 1]],
                 axis=1) for k in range(4)]
    inner = set(map(tuple, np.sort(np.concatenate(inner), axis=1).tolist()))
    keys = np.sort(place[faces], axis=1).tolist()
    return faces[[tuple(key) not in inner for key in keys]]


def read_fields(path, names):
    """The Fields of a .pvtu or .vtu; raises FieldError with a reason."""
    files = [path]
    try:
        if path.endswith(".pvtu"):
            root = ElementTree.parse(path).getroot()
            folder = os.path.dirname(path)
            files = [os.path.join(folder, piece.get("Source"))
                     for piece in root.iter("Piece")]
        pieces = []
        with np.errstate(all="ignore"):
            for name in files:
                pieces += read_piece_file(name, names)
    except FieldError as error:
        raise FieldError("%s: %s" % (os.path.basename(path), error))
    except (OSError, ElementTree.ParseError, ValueError, LookupError, TypeError,
            AttributeError, ArithmeticError, MemoryError, zlib.error) as error:
        raise FieldError("%s cannot be read (%s)" % (os.path.basename(path), error))
    if not pieces:
        raise FieldError("%s holds no cells" % os.path.basename(path))
    shift, points, faces, cells, volume = 0, [], [], [], False
    for piece_points, connectivity, offsets, types, _ in pieces:
        piece_faces, is_volume = faces_of(connectivity, offsets, types)
        points.append(piece_points)
        faces.append(piece_faces + shift)
        cells.append(hexahedra_of(connectivity, offsets, types) + shift)
        shift += len(piece_points)
        volume = volume or is_volume
    points, faces = np.concatenate(points), np.concatenate(faces)
    data = {name: np.concatenate([piece[4][name] for piece in pieces])
            for name in names if all(name in piece[4] for piece in pieces)}
    if volume:
        faces = outer_faces(points, faces)
    if not len(faces):
        raise FieldError("%s holds no cells that can be drawn"
                         % os.path.basename(path))
    return Fields(points, faces, data, np.concatenate(cells))
