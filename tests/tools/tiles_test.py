# SPDX-License-Identifier: GPL-3.0-or-later
"""Smoothing in pieces: the same result as in one, whatever happens to the workers and the files."""

import json
import os
import shutil
import signal
import struct
import subprocess
import time
import unittest

from command_line import PROGRAM, CommandLine
from ply_numbers import Ply, distance


class Tiles(CommandLine):
    nearly_equal_counts = ("moved_vertices",)  # where a vertex stays by rounding alone

    def plan(self, mesh="noisy.ply", plan="plan", tile_vertices="2000", *options):
        return self.run_tool("tiles", "plan", mesh, plan, "--tile-vertices", tile_vertices, *options)

    def in_pieces(self, mesh, out, tile_vertices, *options):
        shutil.rmtree(self.path("plan"), ignore_errors=True)
        self.plan(mesh, "plan", tile_vertices, *options)
        self.run_tool("tiles", "run", "plan", "--all")
        self.run_tool("tiles", "finish", "plan", out, "--report", "pieces.json")

    def pieces(self):
        return [name for name in os.listdir(self.path("plan")) if name.startswith("bucket_")]

    def json(self, name):
        with open(self.path(name), encoding="utf-8") as file:
            return json.load(file)

    def expect_nearly_equal(self, whole, pieces, tolerance):
        """At 99.99 % of the vertices; the tolerance in |e|."""
        a, b = Ply.read(self.path(whole)), Ply.read(self.path(pieces))
        self.assertEqual(a.faces, b.faces)
        limit = tolerance * a.average_edge_length()
        far = [i for i, (p, q) in enumerate(zip(a.vertices, b.vertices)) if not distance(p, q) <= limit]
        self.assertLessEqual(len(far), len(a.vertices) // 10000, f"{whole}: {far[:5]}")

    def expect_same_report(self):
        whole, pieces = self.json("whole.json"), self.json("pieces.json")
        self.assertEqual(list(whole), list(pieces))
        for name, value in whole.items():
            if isinstance(value, float):
                self.assertAlmostEqual(pieces[name], value, delta=1e-4 * abs(value) + 1e-9, msg=name)
            elif name in self.nearly_equal_counts:
                self.assertAlmostEqual(pieces[name], value, delta=3, msg=name)
            else:
                self.assertEqual(pieces[name], value, name)

    def expect_by_workers(self, expected):
        """The plan's result where half of the pieces are run side by side, last first, and then the others."""
        workers = [subprocess.Popen([PROGRAM, "tiles", "run", "plan", "--tile", str(tile), "--threads", str(1 + tile % 3),
                                     "--quiet"], cwd=self.folder) for tile in reversed(range(0, len(self.pieces()), 2))]
        self.assertEqual({worker.wait() for worker in workers}, {0})
        self.run_tool("tiles", "run", "plan", "--all")
        self.run_tool("tiles", "finish", "plan", "by_workers.ply")
        self.assertEqual(self.bytes_of("by_workers.ply"), self.bytes_of(expected))


class SameResult(Tiles):
    def check(self, shape, vertices, *options):
        self.noisy(shape, str(vertices))
        self.run_tool("smooth", "noisy.ply", "whole.ply", "--report", "whole.json", *options)
        for pieces in (2, 16, 200):
            with self.subTest(shape=shape, pieces=pieces):
                self.in_pieces("noisy.ply", "pieces.ply", str(vertices // pieces), *options)
                self.assertGreaterEqual(len(self.pieces()), pieces // 2)
                self.expect_nearly_equal("whole.ply", "pieces.ply", 1e-4)
                self.expect_same_report()

    def test_edges_and_holes(self):
        self.check("cad_part", 24000)

    def test_thin_parts(self):
        self.check("thin_plate", 20000)

    def test_uneven_edges(self):
        self.check("graded_cube", 20000)

    def test_borders(self):
        self.check("plane_delaunay", 20000, "--boundary", "free")

    def test_two_passes_and_a_limit(self):
        self.check("torus", 20000, "--iterations", "2", "--max-displacement", "0.002")

    def test_shuffled_order(self):
        self.noisy("cad_part", "24000")
        mesh, order = Ply.read(self.path("noisy.ply")).shuffled()
        mesh.write(self.path("shuffled.ply"))
        self.run_tool("smooth", "noisy.ply", "whole.ply")
        self.in_pieces("shuffled.ply", "pieces.ply", "1500")
        whole, pieces = Ply.read(self.path("whole.ply")), Ply.read(self.path("pieces.ply"))
        limit = 1e-4 * whole.average_edge_length()
        far = [i for i, old in enumerate(order) if distance(whole.vertices[old], pieces.vertices[i]) > limit]
        self.assertLessEqual(len(far), len(order) // 10000)

    def test_double_precision_far_from_the_origin(self):
        self.noisy("torus", "12000", "--double")
        mesh = Ply.read(self.path("noisy.ply"))
        mesh.vertices = [(x + 1e5, y - 3e6, z) for x, y, z in mesh.vertices]
        mesh.write(self.path("far.ply"))
        self.run_tool("smooth", "far.ply", "whole.ply")
        self.in_pieces("far.ply", "pieces.ply", "1000")
        self.expect_nearly_equal("whole.ply", "pieces.ply", 1e-4)

    def test_stl(self):
        self.noisy("cad_part", "12000")
        self.run_tool("noise", "noisy.ply", "noisy.stl", "--level", "0")
        self.run_tool("smooth", "noisy.stl", "whole.stl", "--report", "whole.json")
        self.in_pieces("noisy.stl", "pieces.stl", "6000")
        self.assertGreater(len(self.pieces()), 5)
        self.run_tool("noise", "whole.stl", "whole.ply", "--level", "0")
        self.run_tool("noise", "pieces.stl", "pieces.ply", "--level", "0")
        self.expect_nearly_equal("whole.ply", "pieces.ply", 1e-4)
        # The normals follow: those of the facets as they lie.
        a, b = self.bytes_of("whole.stl"), self.bytes_of("pieces.stl")
        self.assertEqual(len(a), len(b))
        self.assertEqual(a[:84], b[:84])

    def test_other_properties_stay(self):
        self.noisy("torus", "6000")
        self.run_tool("geodesic", "noisy.ply", "colored.ply", "--start-vertex", "0")
        self.run_tool("smooth", "colored.ply", "whole.ply")
        self.in_pieces("colored.ply", "pieces.ply", "700")
        a, b = self.bytes_of("whole.ply"), self.bytes_of("pieces.ply")
        self.assertEqual(len(a), len(b))
        differing = sum(p != q for p, q in zip(a, b))
        self.assertLess(differing, 6000 * 3)  # the last digits of coordinates at most, no colour and no face

    def test_normals_follow(self):
        self.noisy("cad_part", "6000")
        mesh = Ply.read(self.path("noisy.ply"))
        header = ["ply", "format binary_little_endian 1.0", f"element vertex {len(mesh.vertices)}",
                  *(f"property float {name}" for name in ("x", "y", "z", "nx", "ny", "nz")),
                  f"element face {len(mesh.faces)}", "property list uchar int vertex_indices", "end_header", ""]
        with open(self.path("normals.ply"), "wb") as file:
            file.write("\n".join(header).encode())
            file.write(b"".join(struct.pack("<6f", *place, 0, 0, 1) for place in mesh.vertices))
            file.write(b"".join(struct.pack("<B3i", 3, *corners) for corners in mesh.faces))

        def normals(name):
            data = self.bytes_of(name).split(b"end_header\n", 1)[1][:24 * len(mesh.vertices)]
            return [row[3:] for row in struct.iter_unpack("<6f", data)]

        self.run_tool("smooth", "normals.ply", "whole.ply")
        self.in_pieces("normals.ply", "pieces.ply", "500")
        whole, pieces = normals("whole.ply"), normals("pieces.ply")
        self.assertLess(sum(normal == (0, 0, 1) for normal in whole), len(whole) // 10)
        far = [i for i, (a, b) in enumerate(zip(whole, pieces)) if distance(a, b) > 1e-3]
        self.assertLessEqual(len(far), len(whole) // 1000)

    def test_memory_limit_makes_pieces(self):
        self.noisy("torus", "400000")
        self.run_tool("smooth", "noisy.ply", "whole.ply", "--report", "whole.json")
        done = self.run_tool("smooth", "noisy.ply", "pieces.ply", "--memory", "200M", "--report", "pieces.json")
        self.assertIn("in pieces", done.stderr)
        self.expect_nearly_equal("whole.ply", "pieces.ply", 1e-4)
        self.expect_same_report()
        self.run_tool("smooth", "noisy.ply", "one.ply", "--memory", "1G")  # large enough: in one
        self.assertEqual(self.bytes_of("whole.ply"), self.bytes_of("one.ply"))
        self.assertFalse([name for name in os.listdir(self.folder) if name.startswith(".")])


class Determinism(Tiles):
    def test_order_workers_and_restart_make_no_difference(self):
        self.noisy("cad_part", "12000")
        self.in_pieces("noisy.ply", "first.ply", "1500")
        shutil.rmtree(self.path("plan"))
        self.plan("noisy.ply", "plan", "1500")
        self.expect_by_workers("first.ply")


class Mishaps(Tiles):
    def setUp(self):
        super().setUp()
        self.noisy("cad_part", "12000")
        self.plan("noisy.ply", "plan", "1500")

    def expect_result(self):
        """What is not done is done, and the result is that of an undisturbed run."""
        self.run_tool("tiles", "run", "plan", "--all")
        self.run_tool("tiles", "finish", "plan", "out.ply")
        os.rename(self.path("plan"), self.path("disturbed"))
        self.in_pieces("noisy.ply", "undisturbed.ply", "1500")
        self.assertEqual(self.bytes_of("out.ply"), self.bytes_of("undisturbed.ply"))

    def test_worker_killed_at_any_moment(self):
        for delay in (0.0, 0.02, 0.05, 0.1, 0.2, 0.3):
            worker = subprocess.Popen([PROGRAM, "tiles", "run", "plan", "--all"], cwd=self.folder,
                                      stdout=subprocess.PIPE)
            time.sleep(delay)
            worker.send_signal(signal.SIGKILL)
            worker.communicate()
        self.expect_result()

    def test_interrupted(self):
        worker = subprocess.Popen([PROGRAM, "tiles", "run", "plan", "--all"], cwd=self.folder, stdout=subprocess.PIPE,
                                  text=True)
        worker.stdout.readline()
        worker.send_signal(signal.SIGTERM)
        worker.communicate()
        self.assertEqual(worker.returncode, 130)
        self.assertFalse([name for name in os.listdir(self.path("plan")) if name.endswith(".part")])
        self.expect_result()

    def test_run_twice(self):
        self.assertIn("piece 1: done\n", self.run_tool("tiles", "run", "plan", "--tile", "1").stdout)
        before = os.stat(self.path("plan/result_1"))
        self.assertIn("piece 1: was done already\n", self.run_tool("tiles", "run", "plan", "--tile", "1").stdout)
        self.assertEqual(os.stat(self.path("plan/result_1")).st_ino, before.st_ino)
        done = self.run_tool("tiles", "run", "plan", "--all").stdout
        self.assertEqual(done.count("was done already"), 1)

    def test_run_by_two_at_once(self):
        workers = [subprocess.Popen([PROGRAM, "tiles", "run", "plan", "--all", "--quiet"], cwd=self.folder)
                   for _ in range(2)]
        self.assertEqual([worker.wait() for worker in workers], [0, 0])
        self.expect_result()

    def test_finish_before_all_is_done(self):
        count = len(self.pieces())
        for done in range(2):
            self.expect_failure("tiles", "finish", "plan", "out.ply",
                                says=f"{count - done} of {count} pieces are missing, the first is {done}")
            self.run_tool("tiles", "run", "plan", "--tile", str(done))

    def test_result_cut_off(self):
        self.run_tool("tiles", "run", "plan", "--all")
        for damage in ("shorter", "empty", "other bytes"):
            with open(self.path("plan/result_2"), "r+b") as file:
                size = os.path.getsize(file.name)
                if damage == "other bytes":
                    file.seek(size - 5)
                    byte = file.read(1)[0]
                    file.seek(size - 5)
                    file.write(bytes([byte ^ 1]))
                else:
                    file.truncate(size // 2 if damage == "shorter" else 0)
            self.expect_failure("tiles", "finish", "plan", "out.ply", says="result_2: is cut off")
            again = self.run_tool("tiles", "run", "plan", "--all")
            self.assertIn("result_2: is cut off; it is made again", again.stderr)
            self.assertEqual(again.stdout.count(": done"), 1)
        self.expect_result()

    def test_result_of_another_plan(self):
        self.plan("noisy.ply", "other", "1500", "--sigma-s", "2")
        self.run_tool("tiles", "run", "other", "--tile", "2")
        self.run_tool("tiles", "run", "plan", "--all")
        shutil.copy(self.path("other/result_2"), self.path("plan/result_2"))
        self.expect_failure("tiles", "finish", "plan", "out.ply", says="result_2: belongs to another plan")
        self.assertIn("belongs to another plan", self.run_tool("tiles", "run", "plan", "--all").stderr)
        self.expect_result()

    def test_input_changed(self):
        original = self.bytes_of("noisy.ply")
        state = os.stat(self.path("noisy.ply"))
        changes = {"another size": original + b"x", "written to": original,
                   "other contents": original[:1000] + bytes([original[1000] ^ 1]) + original[1001:]}
        for says, content in changes.items():
            with open(self.path("noisy.ply"), "wb") as file:
                file.write(content)
            if says == "other contents":
                os.utime(self.path("noisy.ply"), ns=(state.st_atime_ns, state.st_mtime_ns))
            self.expect_failure("tiles", "run", "plan", "--tile", "0", says=says)
            self.expect_failure("tiles", "finish", "plan", "out.ply", says=says)
        os.unlink(self.path("noisy.ply"))
        self.expect_failure("tiles", "run", "plan", "--all", says="noisy.ply: cannot be read: No such file")

    def test_damaged_plan(self):
        text = self.bytes_of("plan/plan.json")
        for damaged in (text[:len(text) // 2], text.replace(b'"faces": 2', b'"faces": 3')):
            with open(self.path("plan/plan.json"), "wb") as file:
                file.write(damaged)
            self.expect_failure("tiles", "run", "plan", "--all", says="plan.json: is damaged")
        with open(self.path("plan/plan.json"), "wb") as file:
            file.write(text)
        with open(self.path("plan/bucket_3"), "r+b") as file:
            file.truncate(1000)
        self.expect_failure("tiles", "run", "plan", "--tile", "3", says=("bucket_3: is ", "make the plan again"))

    def test_full_disk(self):
        def no_space():
            import resource
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (10000, 10000))
        for arguments in (["tiles", "plan", "noisy.ply", "another"], ["tiles", "run", "plan", "--tile", "0"]):
            before = self.files()
            done = subprocess.run([PROGRAM, *arguments, "--quiet"], cwd=self.folder, capture_output=True, text=True,
                                  preexec_fn=no_space)
            self.assertEqual(done.returncode, 1)
            self.assertIn("could not be written to its end: File too large", done.stderr)
            self.assertEqual(done.stderr.count("\n"), 1)
            self.assertEqual(self.files(), before)
            self.assertFalse([name for name in os.listdir(self.folder) if name.startswith(".")])
        self.expect_result()

    def test_planning_killed(self):
        worker = subprocess.Popen([PROGRAM, "tiles", "plan", "noisy.ply", "another", "--quiet"], cwd=self.folder)
        time.sleep(0.01)
        worker.kill()
        worker.wait()
        if not os.path.exists(self.path("another")):
            self.plan("noisy.ply", "another")
        self.run_tool("tiles", "run", "another", "--all")


class FullDisk(Tiles):
    """On small file systems, in a mount namespace, so that nothing is left of them whatever happens."""

    FILL = "cat /dev/zero >small/filler 2>/dev/null"

    def setUp(self):
        super().setUp()
        self.namespace = self.mount_namespace()
        self.noisy("cad_part", "12000")

    def run_script(self, size, *lines):
        """Lines of shell, in which `tool` is the program and small/ a file system of that size; what they print."""
        script = "\n".join([f"mount -t tmpfs -o size={size} none small", 'tool() { "$PROGRAM" "$@" --quiet; }', *lines])
        return subprocess.run([*self.namespace, "sh", "-c", script], cwd=self.folder, capture_output=True, text=True,
                              timeout=60, env={**os.environ, "PROGRAM": PROGRAM})

    def test_is_found_before_work_starts(self):
        done = self.run_script("500k", "tool tiles plan noisy.ply small/plan; echo $?; ls -A small")
        self.assertEqual(done.stdout, "1\n")
        self.assertRegex(done.stderr, "^anisosmooth: small/plan: needs .* of disk space, and .* are free\n$")

    def test_goes_on_when_there_is_room_again(self):
        self.plan("noisy.ply", "plan", "1500")
        done = self.run_script(
            "4m", "cp -r plan small/plan", "tool tiles run small/plan --tile 0", self.FILL,
            "tool tiles run small/plan --tile 1; echo $?; ls -A small/plan | grep -v bucket_",
            "rm small/filler", "tool tiles run small/plan --all", self.FILL,
            "tool tiles finish small/plan small/out.ply; echo $?; ls -A small",
            "rm small/filler", "tool tiles finish small/plan out.ply; echo $?")
        self.assertEqual(done.stdout, "1\nplan.json\nresult_0\n1\nfiller\nplan\n0\n")
        run, finish = done.stderr.splitlines()
        self.assertIn("result_1: could not be written to its end: No space left on device", run)
        self.assertRegex(finish, "small/out.ply: needs .* of disk space, and .* are free")
        self.in_pieces("noisy.ply", "undisturbed.ply", "1500")
        self.assertEqual(self.bytes_of("out.ply"), self.bytes_of("undisturbed.ply"))


class InOneCommand(Tiles):
    def test_interrupted_leaves_nothing(self):
        self.noisy("torus", "400000")
        before = set(os.listdir(self.folder))
        for wanted in ("bucket_", "result_"):  # while it plans, and while it smooths
            process = subprocess.Popen([PROGRAM, "smooth", "noisy.ply", "out.ply", "--memory", "200M", "--quiet"],
                                       cwd=self.folder, stderr=subprocess.PIPE)
            while not any(name.startswith(wanted) for _, _, names in os.walk(self.folder) for name in names):
                self.assertIsNone(process.poll())
                time.sleep(0.001)
            process.send_signal(signal.SIGINT)
            words = process.communicate(timeout=60)[1]
            self.assertEqual(process.returncode, 130, words)
            self.assertEqual(set(os.listdir(self.folder)), before)


class Refusals(Tiles):
    def test_what_cannot_be_cut(self):
        self.noisy("cube", "1000")
        self.run_tool("noise", "noisy.ply", "noisy.obj", "--level", "0")
        self.run_tool("noise", "noisy.ply", "noisy.stl", "--level", "0")
        with open(self.path("text.ply"), "w", encoding="utf-8") as file:
            file.write("ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nend_header\n")
        with open(self.path("text.stl"), "w", encoding="utf-8") as file:
            file.write("solid\nendsolid\n")
        mesh = Ply.read(self.path("noisy.ply"))
        mesh.vertices[7] = (float("nan"), 0, 0)
        mesh.write(self.path("nan.ply"))
        mesh.vertices[7], mesh.faces[5] = (0, 0, 0), (0, 1, 100000)
        mesh.write(self.path("index.ply"))
        for name, says in {"noisy.obj": "binary .ply and .stl files can", "text.ply": "is text",
                           "text.stl": "is no binary STL file", "missing.ply": "cannot be read",
                           "nan.ply": "1 vertex has a coordinate that is not a finite number, the first is vertex 7",
                           "index.ply": "face 5 has vertex index 100000; allowed are 0 to "}.items():
            self.expect_failure("tiles", "plan", name, "plan", "--quiet", says=says)
        self.expect_failure("tiles", "plan", "noisy.ply", "plan", "--method", "hc", says="method hc cannot be run in pieces")
        self.expect_failure("tiles", "plan", "noisy.ply", "plan", "--method", "guided", "--smooth-color", "--quiet",
                            says="smooth_color cannot be done in pieces")
        self.expect_failure("tiles", "plan", "noisy.ply", "plan", "--tile-vertices", "5", says="tile_vertices is 5")
        self.expect_failure("tiles", "plan", "noisy.ply", "plan", "--rho", "-1", says="rho is -1")
        self.expect_failure("tiles", "run", "plan", "--all", says="holds no plan")
        self.expect_failure("tiles", "run", "plan", status=2, says="")
        self.plan()
        self.expect_failure("tiles", "plan", "noisy.ply", "plan", "--quiet", says="is there already, and not empty")
        self.expect_failure("tiles", "run", "plan", "--tile", "99", says="tile is 99; allowed are 0 to 0")
        self.run_tool("tiles", "run", "plan", "--all")
        self.expect_failure("tiles", "finish", "plan", "out.stl", says="its pieces are those of a .ply file")

    def test_points_and_one_place(self):
        """Tiles without any face, and a mesh whose vertices all lie in a few cells of its box."""
        self.noisy("torus", "3000")
        mesh = Ply.read(self.path("noisy.ply"))
        mesh.vertices += [(50.0 + i, 0.0, 0.0) for i in range(300)]
        mesh.write(self.path("points.ply"))
        self.run_tool("smooth", "points.ply", "whole.ply", "--report", "whole.json")
        self.in_pieces("points.ply", "pieces.ply", "200")
        self.expect_nearly_equal("whole.ply", "pieces.ply", 1e-4)
        self.expect_same_report()


if __name__ == "__main__":
    unittest.main()
