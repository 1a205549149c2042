# SPDX-License-Identifier: GPL-3.0-or-later
"""Bad files and full disks: the status and message of the contract, no partial file, nothing lost."""

import os
import re
import shutil
import struct
import subprocess
import unittest

from command_line import FORMATS, PROGRAM, CommandLine

FACES = [(0, 1, 4, 3), (1, 2, 5, 4), (3, 4, 7, 6), (4, 5, 8, 7)]
POINTS = [(x, y, 0.25 * ((x * 7 + y * 5) % 3)) for y in range(3) for x in range(3)]  # exact in single precision


def fan(polygon):
    return [(polygon[0], polygon[k - 1], polygon[k]) for k in range(2, len(polygon))]


def ply(form, faces, count_type="uchar", index_type="int", extra=False):
    """The points above as PLY: "ascii", "binary_little_endian" or "binary_big_endian"."""
    head = ["ply", f"format {form} 1.0", f"element vertex {len(POINTS)}"]
    head += ["property double weight"] if extra else []
    head += [f"property float {axis}" for axis in "xyz"]
    head += ["property list uchar short notes"] if extra else []
    head += [f"element face {len(faces)}", f"property list {count_type} {index_type} vertex_indices"]
    head += ["property ushort material", "element mark 1", "property float at"] if extra else []
    rows = [([0.5] if extra else []) + list(p) + ([2, 7, 8] if extra else []) for p in POINTS]
    row_format = ("d" if extra else "") + "fff" + ("Bhh" if extra else "")
    letters = {"uchar": "B", "int": "i", "uint": "I", "short": "h"}
    face_rows = [[len(f), *f] + ([3] if extra else []) for f in faces]
    text = "\n".join([*head, "end_header\n"])
    if form == "ascii":
        lines = rows + face_rows + ([[1.5]] if extra else [])
        return (text + "".join(" ".join(map(str, line)) + "\n" for line in lines)).encode()
    order = ">" if form == "binary_big_endian" else "<"
    body = b"".join(struct.pack(order + row_format, *row) for row in rows)
    for face, row in zip(faces, face_rows):
        body += struct.pack(order + letters[count_type] + letters[index_type] * len(face) + ("H" if extra else ""), *row)
    return text.encode() + body + (struct.pack(order + "f", 1.5) if extra else b"")


class Reading(CommandLine):
    def write(self, name, content):
        with open(self.path(name), "wb") as file:
            file.write(content if isinstance(content, bytes) else content.encode())
        return name

    def samples(self):
        """A cube in every format."""
        names = {}
        for kind in FORMATS:
            names[kind] = f"cube.{kind}"
            self.run_tool("generate", "cube", names[kind], "--vertices", "100", "--quiet")
        return names

    def expect_refusal(self, name, *says):
        self.expect_failure("smooth", name, "out.ply", "--quiet", says=(name, *says))

    def expect_done_or_refusal(self, name):
        """For what a reader cannot know to be wrong: a mesh, or the error."""
        before = self.files()
        done = subprocess.run([PROGRAM, "smooth", name, "out.ply", "--quiet"], cwd=self.folder, capture_output=True,
                              text=True, timeout=60)
        self.assertIn(done.returncode, (0, 1), done.stderr)
        if done.returncode == 0:
            os.remove(self.path("out.ply"))
        else:
            self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        self.assertEqual(self.files(), before)
        return done.returncode

    def test_files_that_end_too_early(self):
        for kind, name in self.samples().items():
            whole = self.bytes_of(name)
            outcomes = []
            for part in range(1, 40):
                cut = self.write(f"cut.{kind}", whole[:len(whole) * part // 40])
                outcomes.append(self.expect_done_or_refusal(cut))
            # Text ends where it ends: what is left of an OBJ file may be one, or refer to vertices that are missing.
            if kind != "obj":
                self.assertEqual(set(outcomes), {1}, kind)
            if kind in ("ply", "stl"):
                self.write(f"cut.{kind}", whole[:-1])
                self.expect_refusal(f"cut.{kind}")

    def test_things_that_are_no_files(self):
        for kind in FORMATS:
            self.write(f"empty.{kind}", "")
            self.expect_refusal(f"empty.{kind}", "is empty")
            self.expect_refusal(f"none.{kind}", "does not exist")
            os.mkdir(self.path(f"folder.{kind}"))
            os.symlink("/dev/zero", self.path(f"device.{kind}"))
            os.mkfifo(self.path(f"pipe.{kind}"))
            os.symlink(f"loop.{kind}", self.path(f"loop.{kind}"))
            for name, says in (("folder", "is a folder"), ("device", "is not a regular file"),
                               ("pipe", "is not a regular file"), ("loop", "")):
                done = self.run_tool("smooth", f"{name}.{kind}", "out.ply", status=1)
                self.assertIn(f"{name}.{kind}: {says}", done.stderr)
                self.assertEqual(done.stderr.count("\n"), 1)
                self.assertFalse(os.path.exists(self.path("out.ply")))

    def test_a_material_file_that_is_none_is_only_a_warning(self):
        os.mkfifo(self.path("pipe.mtl"))
        cube = self.bytes_of(self.samples()["obj"])
        for library in ("none.mtl", "pipe.mtl", "/dev/zero", "/dev/tty", "."):
            self.write("cube.obj", f"mtllib {library}\n".encode() + cube)
            done = self.run_tool("smooth", "cube.obj", "out.ply", "--quiet")
            self.assertRegex(done.stderr, "warning: .*cannot be read.*colours and textures are lost")
            done = self.run_tool("smooth", "cube.obj", "out.obj", "--quiet")
            self.assertNotIn("lost", done.stderr)
            self.assertTrue(self.bytes_of("out.obj").startswith(f"mtllib {library}\n".encode()))

    def test_unreadable_files(self):
        if os.geteuid() != 0:
            self.skipTest("needs root, to become somebody else")
        program = shutil.copy(PROGRAM, self.path("program"))
        os.chmod(self.folder, 0o755)
        os.mkdir(self.path("out"))
        os.chmod(self.path("out"), 0o777)
        os.mkdir(self.path("locked"))
        for kind, name in self.samples().items():
            os.chmod(self.path(name), 0o600)
            for source, target, says in ((name, "out/x.ply", "cannot be read: Permission denied"),
                                         (f"out/open.{kind}", f"locked/x.{kind}", "Permission denied")):
                shutil.copy(self.path(name), self.path(f"out/open.{kind}"))
                os.chmod(self.path(f"out/open.{kind}"), 0o644)
                done = subprocess.run([program, "smooth", source, target], cwd=self.folder, capture_output=True,
                                      text=True, timeout=60, user=65534, group=65534, extra_groups=[])
                self.assertEqual(done.returncode, 1, done.stderr)
                self.assertIn(says, done.stderr)
                self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
                os.remove(self.path(f"out/open.{kind}"))
                self.assertEqual(os.listdir(self.path("out")) + os.listdir(self.path("locked")), [])

    def test_wrong_extensions(self):
        samples = self.samples()
        for kind, name in samples.items():
            for other in FORMATS:
                if other != kind:
                    self.write(f"wrong.{other}", self.bytes_of(name))
                    self.expect_refusal(f"wrong.{other}")
            self.write("wrong.txt", self.bytes_of(name))
            self.expect_refusal("wrong.txt", "allowed are .ply, .obj, .off, .stl, .glb and .gltf")

    def test_wrong_counts_in_the_header(self):
        triangles = [t for face in FACES for t in fan(face)]
        for form in ("ascii", "binary_little_endian", "binary_big_endian"):
            good = ply(form, triangles)
            for right, wrong in ((b"vertex 9", b"vertex 10"), (b"vertex 9", b"vertex 8"), (b"face 8", b"face 9"),
                                 (b"vertex 9", b"vertex 2000000000"), (b"face 8", b"face 2000000000"),
                                 (b"vertex 9", b"vertex 99999999999999999999"), (b"vertex 9", b"vertex -1"),
                                 (b"vertex 9", b"vertex 0"), (b"face 8", b"face -1"), (b"vertex 9", b"vertex")):
                self.assertIn(right + b"\n", good)
                self.write("wrong.ply", good.replace(right + b"\n", wrong + b"\n"))
                self.expect_refusal("wrong.ply")
        off = self.bytes_of(self.samples()["off"]).decode()
        head, counts, rest = off.split("\n", 2)
        vertices, faces, _ = map(int, counts.split())
        for wrong in (f"{vertices + 1} {faces} 0", f"{vertices - 1} {faces} 0", f"{vertices} {faces + 1} 0",
                      f"-1 {faces} 0", f"{vertices} -1 0", f"2000000000 {faces} 0", f"{vertices} 2000000000 0",
                      f"99999999999999999999 {faces} 0", f"{vertices}"):
            self.write("wrong.off", "\n".join((head, wrong, rest)))
            self.expect_refusal("wrong.off")
        stl = self.bytes_of("cube.stl")
        count = struct.unpack_from("<I", stl, 80)[0]
        for wrong in (count + 1, 2**31, 2**32 - 1):
            self.write("wrong.stl", stl[:80] + struct.pack("<I", wrong) + stl[84:])
            self.expect_refusal("wrong.stl")
        for wrong in (0, count - 1):  # what is there can be read
            self.write("wrong.stl", stl[:80] + struct.pack("<I", wrong) + stl[84:])
            done = self.run_tool("noise", "wrong.stl", "out.stl", "--level", "0", "--quiet")
            self.assertEqual(done.stderr, f"warning: wrong.stl: its header counts {wrong} facets, and there are {count}; "
                                          "all are read\n")
            self.assertEqual(self.bytes_of("out.stl"), self.bytes_of("wrong.stl"))

    def test_all_ways_to_write_a_mesh_give_the_same_result(self):
        triangles = [t for face in FACES for t in fan(face)]
        self.write("plain.ply", ply("binary_little_endian", triangles))
        self.run_tool("smooth", "plain.ply", "expected.obj", "--boundary", "free", "--quiet")
        self.run_tool("smooth", "plain.ply", "expected.stl", "--boundary", "free", "--quiet")
        expected = [line for line in self.bytes_of("expected.obj").splitlines() if line.startswith(b"v ")]
        lines = ["v %r %r %r\n" % p for p in POINTS]
        polygons = [FACES, [FACES[0], *fan(FACES[1]), *FACES[2:]]]
        files = {"triangles.obj": "".join(lines + ["f %d %d %d\n" % tuple(v + 1 for v in t) for t in triangles]),
                 "quads.obj": "".join(lines + ["f %d// %d// %d// %d//\n" % tuple(v - 9 for v in f) for f in FACES]),
                 "quads.off": "OFF\n9 4 0\n" + "".join("%r %r %r\n" % p for p in POINTS) +
                              "".join("4 %d %d %d %d\n" % f for f in FACES)}
        for form in ("ascii", "binary_little_endian", "binary_big_endian"):
            for extra in (False, True):
                for number, faces in enumerate([triangles, *polygons]):
                    files[f"{form}{number}{extra}.ply"] = ply(form, faces, extra=extra)
                files[f"{form}{extra}types.ply"] = ply(form, FACES, "int", "short", extra)
        for name, content in files.items():
            self.write(name, content)
            done = self.run_tool("smooth", name, "out.obj", "--boundary", "free", "--quiet")
            if name.endswith(".ply"):
                lines = self.bytes_of("out.obj").splitlines()
                self.assertEqual([line for line in lines if line.startswith(b"v ")], expected, name)
                self.assertEqual(len([line for line in lines if line.startswith(b"f ")]),
                                 int(re.search(rb"element face (\d+)", self.bytes_of(name)).group(1)), name)
                kept = "vertex.weight, vertex.notes, face.material, mark"
                self.assertEqual(done.stderr.splitlines(), [f"warning: {name}: these properties are not kept: {kept}"]
                                 if "True" in name else [])
                done = self.run_tool("smooth", name, "same.ply", "--boundary", "free", "--quiet")
                self.assertEqual(done.stderr, "", "nothing is lost")
                self.run_tool("noise", "same.ply", "out.stl", "--level", "0", "--quiet")
                self.assertEqual(self.bytes_of("out.stl"), self.bytes_of("expected.stl"), name)
            else:  # text has no precision of its own
                out = f"out.{name[-3:]}"
                self.run_tool("smooth", name, out, "--boundary", "free", "--quiet")
                self.run_tool("noise", out, "out.stl", "--level", "0", "--quiet")
                self.run_tool("smooth", "triangles.obj", "other.stl", "--boundary", "free", "--quiet")
                self.assertEqual(self.bytes_of("out.stl"), self.bytes_of("other.stl"), name)

    def test_the_output_may_be_the_input(self):
        for kind, name in self.samples().items():
            self.run_tool("smooth", name, f"other.{kind}", "--quiet")
            self.run_tool("smooth", name, name, "--quiet")
            self.assertEqual(self.bytes_of(name), self.bytes_of(f"other.{kind}"))

    def test_places_where_nothing_can_be_written(self):
        self.samples()
        os.symlink("/dev/full", self.path("device.ply"))
        for kind in FORMATS:
            os.mkdir(self.path(f"folder.{kind}"))
            for target, says in ((f"none/x.{kind}", "no folder none"), (f"folder.{kind}", "not a regular file"),
                                 (f"cube.{kind}/x.{kind}", "no folder"), (f"{'x' * 300}.{kind}", "too long")):
                for command in (("smooth", f"cube.{kind}", target), ("noise", f"cube.{kind}", target, "--level", "0.1"),
                                ("generate", "cube", target)):
                    before = self.files()
                    done = self.run_tool(*command, "--quiet", status=1)
                    self.assertIn(target, done.stderr)
                    self.assertIn(says, done.stderr)
                    self.assertEqual(done.stderr.count("\n"), 1)
                    self.assertEqual(self.files(), before)
        done = self.run_tool("geodesic", "cube.ply", "device.ply", "--start-vertex", "0", status=1)
        self.assertIn("not a regular file", done.stderr)


class FullDisk(CommandLine):
    """On a file system of 192 KiB in a mount namespace, so that nothing is left of it whatever happens."""

    SIZE = 192

    def setUp(self):
        super().setUp()
        self.namespace = self.mount_namespace()
        for kind in FORMATS:
            self.run_tool("generate", "cube", f"large.{kind}", "--vertices", "20000", "--quiet")
            self.run_tool("generate", "cube", f"old.{kind}", "--vertices", "100", "--quiet")

    def run_on_small_disk(self, kind, *arguments):
        """Runs the program with an older output in place; returns its status, its words and what is in small/ then."""
        script = ('mount -t tmpfs -o size="$1"k none small && cp "old.$2" "small/out.$2" && shift 2 && '
                  '"$@" 2>errors; echo $?; ls -A small; cmp "small/out.$KIND" "old.$KIND" && echo intact')
        done = subprocess.run([*self.namespace, "sh", "-c", script, "sh", str(self.SIZE), kind, PROGRAM, *arguments],
                              cwd=self.folder, capture_output=True, text=True, timeout=120,
                              env={**os.environ, "KIND": kind})
        status, *rest = done.stdout.split("\n")
        return int(status), self.bytes_of("errors").decode(), rest

    def test_what_was_there_stays(self):
        for kind in FORMATS:
            for command in (("smooth", f"large.{kind}", f"small/out.{kind}", "--quiet"),
                            ("noise", f"large.{kind}", f"small/out.{kind}", "--level", "0.1", "--quiet"),
                            ("generate", "sphere", f"small/out.{kind}", "--vertices", "20000", "--quiet")):
                status, words, rest = self.run_on_small_disk(kind, *command)
                self.assertEqual(status, 1, words)
                self.assertEqual(words, f"anisosmooth: small/out.{kind}: could not be written to its end: "
                                        "No space left on device\n")
                self.assertEqual(rest, [f"out.{kind}", "intact", ""])

    def test_mesh_and_report_appear_together_or_not_at_all(self):
        script = ("mount -t tmpfs -o size=4k none small && head -c 4000 /dev/zero >small/filler && "
                  '{ "$@" 2>errors; echo $?; ls -A small; }')
        arguments = ["smooth", "old.ply", "out.ply", "--report", "small/report.json", "--quiet"]
        done = subprocess.run([*self.namespace, "sh", "-c", script, "sh", PROGRAM, *arguments], cwd=self.folder,
                              capture_output=True, text=True, timeout=60)
        self.assertEqual(done.stdout, "1\nfiller\n", self.bytes_of("errors"))
        self.assertIn(b"small/report.json: could not be written to its end: No space left", self.bytes_of("errors"))
        self.assertFalse(os.path.exists(self.path("out.ply")))

    def test_what_is_printed_is_checked_too(self):
        for arguments in (("measure", "old.ply", "old.ply"), ("measure", "old.ply", "old.ply", "--json")):
            with open("/dev/full", "w") as full:
                done = subprocess.run([PROGRAM, *arguments], cwd=self.folder, stdout=full, stderr=subprocess.PIPE,
                                      text=True, timeout=60)
            self.assertEqual((done.returncode, done.stderr), (1, "anisosmooth: standard output cannot be written\n"))


if __name__ == "__main__":
    unittest.main()
