# SPDX-License-Identifier: GPL-3.0-or-later
"""Too little memory inside MeshLab's own meshlabserver: the filter's error, no crash, no output, the input intact."""

import resource
import subprocess
import time
import unittest

import scripts
from environment import Display, PrivateMeshLab, fresh_work_folder, run_tool

MIB = 1 << 20
SPARE = 32 * MIB  # what MeshLab itself needs one time more than another
STEPS = 3


def setUpModule():
    global work, meshlab, display, noisy
    work = fresh_work_folder()
    meshlab = PrivateMeshLab(work)
    display = Display().__enter__()
    noisy = work / "noisy.ply"
    run_tool("generate", "sphere", work / "clean.ply", "--vertices", 150000)
    run_tool("noise", work / "clean.ply", noisy, "--level", "0.2")


def tearDownModule():
    display.__exit__()


def serve(limit, *arguments):
    """Runs meshlabserver in an address space of `limit` bytes; returns the process and what it wrote, if anything."""
    def restrict():
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        resource.setrlimit(resource.RLIMIT_AS, (limit, limit))
    target = work / "out.ply"
    target.unlink(missing_ok=True)
    done = meshlab.server(display.name, "-i", noisy, "-o", target, *arguments, timeout=300, preexec_fn=restrict)
    return done, target.read_bytes() if target.exists() else None


def peak(*arguments):
    """The largest address space, in bytes, that meshlabserver has while it reads, works and writes; and its output."""
    target = work / "out.ply"
    target.unlink(missing_ok=True)
    command = [meshlab.prefix / "bin/meshlabserver", "-i", noisy, "-o", target, *arguments]
    process = subprocess.Popen(command, env=meshlab.environment(display.name), stdout=subprocess.DEVNULL,
                               stderr=subprocess.DEVNULL)
    largest = 0
    while process.poll() is None:
        with open(f"/proc/{process.pid}/status") as status:
            for line in status:
                if line.startswith("VmPeak:"):
                    largest = max(largest, 1024 * int(line.split()[1]))
        time.sleep(0.01)
    return largest, target.read_bytes()


class Memory(unittest.TestCase):
    def test_every_filter_refuses_or_finishes(self):
        source = noisy.read_bytes()
        start = peak()[0] + SPARE
        refused = 0
        for filter_name in (scripts.SMOOTHING, scripts.GUIDED, scripts.NON_ITERATIVE, scripts.GEODESIC):
            script = scripts.write(work / "script.mlx", filter_name)
            end, expected = peak("-s", script)
            for step in range(STEPS):
                limit = start + max(0, end - start) * step // STEPS
                done, result = serve(limit, "-s", script)
                self.assertEqual(noisy.read_bytes(), source)
                if done.returncode == 0:
                    self.assertEqual(result, expected, f"{filter_name} within {limit // MIB} MiB")
                    continue
                if "Starting Script" not in done.stdout:
                    continue  # not enough for MeshLab's own start
                refused += 1
                self.assertEqual(done.returncode, 255, f"{filter_name} within {limit // MIB} MiB: {done.stdout}")
                self.assertIn("not enough memory; nothing was changed", done.stdout)
                self.assertIsNone(result)
        self.assertGreater(refused, 0, "no limit was too low")


if __name__ == "__main__":
    unittest.main()
