# SPDX-License-Identifier: GPL-3.0-or-later
"""Where things are, and how programs are run and their processor time is taken."""

import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
WORK = ROOT / "build" / "guided_benchmark"
DOCUMENT = ROOT / "docs" / "guided.md"
DATA = pathlib.Path(os.environ.get("ANISO_TEST_DATA", ROOT.parent / "shared" / "data"))


def say(text):
    print(f"guided_benchmark: {text}", flush=True)


def run(*command, env=None):
    """Runs a command; its processor seconds."""
    before = os.times()
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True,
                          env={**os.environ, **(env or {})})
    if done.returncode != 0:
        sys.exit(f"guided_benchmark: {' '.join(map(str, command))}: {(done.stderr or done.stdout).strip()}")
    after = os.times()
    return after.children_user - before.children_user + after.children_system - before.children_system


def build():
    """The programs, up to date; their folder."""
    subprocess.run([ROOT / "scripts" / "build", "-DANISO_BUILD_BENCHMARKS=ON", "-DANISO_BUILD_TESTS=ON", "--",
                    "anisosmooth", "guided_variant", "write_clean_shapes"], check=True)
    return ROOT / "build" / "bin"
