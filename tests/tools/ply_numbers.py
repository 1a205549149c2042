# SPDX-License-Identifier: GPL-3.0-or-later
"""Vertices and faces of the binary PLY files that anisosmooth writes for bare meshes, without any library."""

import random
import struct


class Ply:
    """vertices: a list of (x, y, z); faces: a list of three indices."""

    def __init__(self, vertices, faces, real="f"):
        self.vertices, self.faces, self.real = vertices, faces, real

    @classmethod
    def read(cls, path):
        with open(path, "rb") as file:
            header, data = file.read().split(b"end_header\n", 1)
        lines = header.decode().split("\n")
        assert "format binary_little_endian 1.0" in lines, lines
        real = "d" if "property double x" in lines else "f"
        count = {line.split()[1]: int(line.split()[2]) for line in lines if line.startswith("element")}
        row = struct.Struct(f"<3{real}")
        body = count["vertex"] * row.size
        vertices = list(row.iter_unpack(data[:body]))
        faces = [face[1:] for face in struct.iter_unpack("<B3i", data[body:body + 13 * count["face"]])]
        return cls(vertices, faces, real)

    def write(self, path):
        real = {"f": "float", "d": "double"}[self.real]
        header = ["ply", "format binary_little_endian 1.0", f"element vertex {len(self.vertices)}",
                  *(f"property {real} {axis}" for axis in "xyz"), f"element face {len(self.faces)}",
                  "property list uchar int vertex_indices", "end_header", ""]
        row, face = struct.Struct(f"<3{self.real}"), struct.Struct("<B3i")
        with open(path, "wb") as file:
            file.write("\n".join(header).encode())
            file.write(b"".join(row.pack(*vertex) for vertex in self.vertices))
            file.write(b"".join(face.pack(3, *corners) for corners in self.faces))

    def shuffled(self, seed=1):
        """The same mesh, its vertices and faces in any order; and the old index of each vertex."""
        random.seed(seed)
        order = list(range(len(self.vertices)))
        random.shuffle(order)
        place = [0] * len(order)
        for new, old in enumerate(order):
            place[old] = new
        faces = [tuple(place[v] for v in face) for face in self.faces]
        random.shuffle(faces)
        return Ply([self.vertices[old] for old in order], faces, self.real), order

    def average_edge_length(self):
        edges = {(min(face[k - 1], face[k]), max(face[k - 1], face[k])) for face in self.faces for k in range(3)}
        return sum(distance(self.vertices[a], self.vertices[b]) for a, b in edges) / len(edges)


def distance(p, q):
    return sum((a - b) ** 2 for a, b in zip(p, q)) ** 0.5
