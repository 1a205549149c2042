# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads and writes binary little-endian PLY files, field by field and without any interpretation of the values."""

import struct

FORMATS = {"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i", "uint": "I", "float": "f", "double": "d",
           "int8": "b", "uint8": "B", "int16": "h", "uint16": "H", "int32": "i", "uint32": "I", "float32": "f",
           "float64": "d"}


def read(path):
    """Returns {element: {property: [raw bytes of the value, one per item]}}; a list is its values' bytes in a row."""
    data = path.read_bytes()
    end = data.index(b"end_header\n") + len(b"end_header\n")
    header = data[:end].decode("ascii").splitlines()
    if "format binary_little_endian 1.0" not in header:
        raise ValueError(f"{path} is not binary little endian")
    layout = []
    for line in header:
        words = line.split()
        if words[0] == "element":
            layout.append((words[1], int(words[2]), []))
        elif words[0] == "property":
            layout[-1][2].append((words[-1], [FORMATS[word] for word in words[1:-1] if word != "list"]))
    elements = {}
    for element, count, properties in layout:
        columns = {name: [] for name, _ in properties}
        for _ in range(count):
            for name, kinds in properties:
                size = struct.calcsize("<" + kinds[-1])
                if len(kinds) == 2:
                    count_size = struct.calcsize("<" + kinds[0])
                    size *= struct.unpack_from("<" + kinds[0], data, end)[0]
                    end += count_size
                columns[name].append(data[end:end + size])
                end += size
        elements[element] = columns
    if end != len(data):
        raise ValueError(f"{path}: {len(data) - end} bytes after the last element")
    return elements


def positions(path):
    """The vertices as raw bytes: equal only if equal bit for bit."""
    vertex = read(path)["vertex"]
    return list(zip(vertex["x"], vertex["y"], vertex["z"]))


def floats(column):
    return [struct.unpack("<f", value)[0] for value in column]


def triangles(path):
    face = read(path)["face"]
    column = face.get("vertex_indices", face.get("vertex_index"))
    return [struct.unpack("<3i", value) for value in column]


def write(path, elements, comments=()):
    """`elements` is a list of (name, [(property, type or (count type, type))], rows)."""
    lines = ["ply", "format binary_little_endian 1.0", *("comment " + c for c in comments)]
    body = bytearray()
    for name, properties, rows in elements:
        lines.append(f"element {name} {len(rows)}")
        for prop, kind in properties:
            kind_text = f"list {kind[0]} {kind[1]}" if isinstance(kind, tuple) else kind
            lines.append(f"property {kind_text} {prop}")
        for row in rows:
            for (_, kind), value in zip(properties, row):
                if isinstance(kind, tuple):
                    body += struct.pack("<" + FORMATS[kind[0]], len(value))
                    body += struct.pack(f"<{len(value)}{FORMATS[kind[1]]}", *value)
                else:
                    body += struct.pack("<" + FORMATS[kind], value)
    path.write_bytes("\n".join(lines + ["end_header\n"]).encode("ascii") + body)
