# SPDX-License-Identifier: GPL-3.0-or-later
import subprocess

import numpy as np
import pytest

import anisosmooth


@pytest.mark.parametrize("ending", ["ply", "obj", "off", "stl"])
def test_round_trip(ending, mesh, tmp_path):
    V, F = mesh[0].astype(np.float32), mesh[1]
    path = tmp_path / f"mesh.{ending}"
    anisosmooth.write(path, V, F)
    back = anisosmooth.read(path)
    np.testing.assert_array_equal(back.V[back.F], V[F])
    assert back.V.shape == V.shape


def test_the_same_file_with_other_numbers(mesh, tmp_path):
    text = ["# a comment", "o thing", "v 0 0 0", "v 1 0 0", "v 1 1 0", "v 0 1 0", "g side", "f 1 2 3 4", "s off", ""]
    source = tmp_path / "in.obj"
    source.write_text("\n".join(text))
    file = anisosmooth.read(source)
    assert file.V.dtype == np.float64 and file.F.shape == (2, 3)
    anisosmooth.write(tmp_path / "same.obj", file.V, like=file)
    assert (tmp_path / "same.obj").read_bytes() == source.read_bytes()
    moved = file.V.copy()
    moved[2, 2] = 0.5
    anisosmooth.write(tmp_path / "moved.obj", moved, like=file)
    text[4] = "v 1 1 0.5"
    assert (tmp_path / "moved.obj").read_text() == "\n".join(text)
    with pytest.raises(ValueError, match="vertices"):
        anisosmooth.write(tmp_path / "bad.obj", moved[:3], like=file)
    with pytest.raises(ValueError, match="F differs"):
        anisosmooth.write(tmp_path / "bad.obj", moved, file.F[::-1], like=file)
    source.write_text("v 0 0 0\n")
    with pytest.raises(OSError):
        anisosmooth.write(tmp_path / "late.obj", moved, like=file)
    assert not (tmp_path / "bad.obj").exists() and not (tmp_path / "late.obj").exists()


def test_colors_and_scalars(mesh, tmp_path):
    V, F = mesh[0], mesh[1]
    colors = np.random.default_rng(5).integers(0, 256, (len(V), 4), dtype=np.uint8)
    anisosmooth.write(tmp_path / "c.ply", V, F, colors=colors, scalars=V[:, 2])
    back = anisosmooth.read(tmp_path / "c.ply")
    np.testing.assert_array_equal(back.colors, colors)
    np.testing.assert_array_equal(back.scalars, V[:, 2])
    assert back.selected is None and back.warnings == []
    with pytest.warns(UserWarning):
        anisosmooth.write(tmp_path / "c.stl", V, F, scalars=V[:, 2])


def test_edges_of_a_file_are_creases(mesh, tmp_path, command_line):
    """Passed on they give what the command line gives, which takes them by itself."""
    V, F = mesh[0].astype(np.float32), mesh[1]
    assert anisosmooth.read(written(tmp_path / "none.ply", V, F, [])).creases is None
    edges = [(24 * i, 24 * ((i + 1) % 60)) for i in range(60)]  # once around the torus, where it is smooth
    source = written(tmp_path / "creases.ply", V, F, edges)
    file = anisosmooth.read(source)
    assert file.creases.dtype == np.int64
    np.testing.assert_array_equal(file.creases, edges)
    V2 = anisosmooth.smooth(file.V, file.F, creases=file.creases)
    assert not np.array_equal(V2, anisosmooth.smooth(file.V, file.F))
    target = tmp_path / "by_command_line.ply"
    subprocess.run([command_line, "smooth", source, target, "--method", "guided", "--quiet"], check=True)
    np.testing.assert_array_equal(anisosmooth.read(target).V, V2)


def written(path, V, F, edges):
    header = ["ply", "format ascii 1.0", f"element vertex {len(V)}", *(f"property float {axis}" for axis in "xyz"),
              f"element face {len(F)}", "property list uchar int vertex_indices"]
    if edges:
        header += [f"element edge {len(edges)}", "property int vertex1", "property int vertex2"]
    rows = [" ".join(map(repr, map(float, point))) for point in V]
    rows += ["3 " + " ".join(map(str, face)) for face in F]
    rows += [f"{a} {b}" for a, b in edges]
    path.write_text("\n".join([*header, "end_header", *rows, ""]))
    return path


def test_errors_are_sentences(tmp_path, mesh):
    with pytest.raises(OSError, match="does not exist"):
        anisosmooth.read(tmp_path / "none.ply")
    with pytest.raises(OSError):
        anisosmooth.write(tmp_path / "mesh.xyz", *mesh[:2])
    with pytest.raises(ValueError, match="F is missing"):
        anisosmooth.write(tmp_path / "mesh.ply", mesh[0])
    with pytest.raises(ValueError, match="refers to a vertex"):
        anisosmooth.write(tmp_path / "mesh.ply", mesh[0], mesh[1] + 10**6)
