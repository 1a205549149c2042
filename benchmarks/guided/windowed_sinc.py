#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""windowed_sinc.py IN OUT: smooths an OBJ file by VTK's vtkWindowedSincPolyDataFilter (Taubin, Zhang, Golub 1996), which
is what users of label maps take. 20 iterations and pass band 0.01, as in its users' examples for label maps;
feature edges are not kept, borders move. With --check: whether VTK is there. For scripts/guided_benchmark."""

import sys

from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkWindowedSincPolyDataFilter

ITERATIONS = 20
PASS_BAND = 0.01


def read(path):
    """Positions, and faces as indices; polygons of three corners."""
    positions, faces = [], []
    with open(path) as file:
        for line in file:
            words = line.split()
            if words[:1] == ["v"]:
                positions.append([float(word) for word in words[1:4]])
            elif words[:1] == ["f"]:
                faces.append([int(word.split("/")[0]) - 1 for word in words[1:4]])
    return positions, faces


def write(path, positions, faces):
    with open(path, "w") as file:
        file.writelines("v %.9g %.9g %.9g\n" % tuple(p) for p in positions)
        file.writelines("f %d %d %d\n" % tuple(v + 1 for v in f) for f in faces)


def smoothed(positions, faces):
    points = vtkPoints()
    points.SetDataTypeToDouble()
    for position in positions:
        points.InsertNextPoint(position)
    cells = vtkCellArray()
    for face in faces:
        cells.InsertNextCell(3, face)
    surface = vtkPolyData()
    surface.SetPoints(points)
    surface.SetPolys(cells)
    sinc = vtkWindowedSincPolyDataFilter()
    sinc.SetInputData(surface)
    sinc.SetNumberOfIterations(ITERATIONS)
    sinc.SetPassBand(PASS_BAND)
    sinc.NormalizeCoordinatesOn()
    sinc.FeatureEdgeSmoothingOff()
    sinc.BoundarySmoothingOn()
    sinc.Update()
    result = sinc.GetOutput().GetPoints()
    return [result.GetPoint(v) for v in range(result.GetNumberOfPoints())]


def main():
    if sys.argv[1:] == ["--check"]:
        return
    source, target = sys.argv[1:]
    positions, faces = read(source)
    write(target, smoothed(positions, faces), faces)


if __name__ == "__main__":
    main()
