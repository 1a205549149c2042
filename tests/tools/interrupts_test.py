# SPDX-License-Identifier: GPL-3.0-or-later
"""SIGINT, SIGTERM and SIGHUP at many moments of every subcommand: status 130, nothing half written, nothing lost."""

import os
import re
import signal
import subprocess
import time
import unittest

from command_line import PROGRAM, CommandLine

MOMENTS = 10
COMMANDS = {
    "paper": ["smooth", "noisy.ply", "out.ply", "--sigma-c", "3", "--report", "report.json"],
    "text": ["smooth", "noisy.obj", "out.obj", "--method", "taubin"],
    "guided": ["smooth", "noisy.ply", "out.ply", "--method", "guided"],
    "jones": ["smooth", "noisy.ply", "out.ply", "--method", "jones"],
    "geodesic": ["geodesic", "noisy.ply", "out.ply", "--start-vertex", "0"],
    "noise": ["noise", "swapped.ply", "out.off", "--level", "0.1"],
    "generate": ["generate", "plane_delaunay", "out.stl", "--vertices", "20000"],
    "measure": ["measure", "noisy.ply", "clean.ply"],
    "compare": ["compare", "noisy.ply", "clean.ply", "--out", "results", "--no-pictures"],
}


def catches_signals(process):
    """Whether the program has come to the point where it handles signals; before that the system ends it."""
    with open(f"/proc/{process.pid}/status") as file:
        caught = re.search(r"SigCgt:\s*([0-9a-f]+)", file.read())
    return bool(int(caught.group(1), 16) >> (signal.SIGHUP - 1) & 1)  # the last one that it asks for


class Interrupts(CommandLine):
    def setUp(self):
        super().setUp()
        self.noisy("cad_part", "6000")
        self.run_tool("noise", "noisy.ply", "noisy.obj", "--level", "0")
        data = self.bytes_of("noisy.ply")
        head, body = data.split(b"end_header\n", 1)
        vertices = int(re.search(rb"element vertex (\d+)", head).group(1))
        with open(self.path("swapped.ply"), "wb") as file:  # the other byte order takes another way
            file.write(head.replace(b"little", b"big") + b"end_header\n")
            words = memoryview(body[:12 * vertices]).cast("I").tolist()
            file.write(b"".join(word.to_bytes(4, "big") for word in words))
            faces = body[12 * vertices:]
            for at in range(0, len(faces), 13):
                file.write(faces[at:at + 1] + b"".join(faces[at + k:at + k + 4][::-1] for k in (1, 5, 9)))
        os.mkdir(self.path("temporary"))

    def start(self, arguments):
        process = subprocess.Popen([PROGRAM, *arguments], cwd=self.folder, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.PIPE, env={**os.environ, "TMPDIR": self.path("temporary")},
                                   preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_DFL))  # not as by nohup
        while process.poll() is None and not catches_signals(process):
            time.sleep(0.001)
        return process

    def interrupt(self, arguments, delay, number):
        """Sends the signal after `delay` seconds; returns the status."""
        process = self.start(arguments)
        try:
            process.wait(timeout=delay)
        except subprocess.TimeoutExpired:
            process.send_signal(number)
        words = process.communicate(timeout=60)[1]
        self.assertIn(process.returncode, (0, 130), words)
        return process.returncode

    def check(self, arguments):
        """The program runs to its end once, which gives the results and the time; then it is interrupted."""
        inputs = self.files()
        start = time.monotonic()
        process = self.start(arguments)
        self.assertEqual(process.wait(timeout=120), 0, process.stderr.read())
        process.communicate()
        duration = time.monotonic() - start
        results = {name: content for name, content in self.files().items() if name not in inputs}
        old = {name: b"precious" for name in results}
        interrupted = 0
        for moment in range(MOMENTS):
            for name in results:
                with open(self.path(name), "wb") as file:
                    file.write(old[name])
            number = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)[moment % 3]
            status = self.interrupt(arguments, duration * moment / MOMENTS, number)
            interrupted += status == 130
            found = self.files()
            self.assertEqual(set(found), set(inputs) | set(results), "no file more, none less")
            for name, content in found.items():
                if name in inputs:
                    self.assertEqual(content, inputs[name], name)
                elif arguments[0] == "compare":  # file by file; its reports hold times
                    self.assertTrue(name.startswith("results/report.") or content in (old[name], results[name]), name)
                    self.assertTrue(content == old[name] or len(content) > 100, name)
                else:
                    self.assertEqual(content, results[name] if status == 0 else old[name], name)
        self.assertGreater(interrupted, 0, "the signals came too late")


for label, command in COMMANDS.items():
    setattr(Interrupts, "test_" + label, lambda self, command=command: self.check(command))


if __name__ == "__main__":
    unittest.main()
