# SPDX-License-Identifier: GPL-3.0-or-later
"""The methods that are compared: this project's, and its peers where they are installed."""

import shlex
import shutil
import subprocess

from .runs import ROOT, WORK, run

OWN = ("taubin", "paper", "guided")

# The best of Taubin's results, as if one knew the truth: no peer, but what correlated noise and scans are held against.
BEST_TAUBIN = "taubin, best of 5, 10, 20, 40"
TAUBIN_ITERATIONS = (5, 10, 20, 40)

# MeshDenoiser's own defaults (10, 1, 1, 1) destroy the shape. This is the best of four sets that were tried on a cube and
# a CAD part, AliceVision's defaults (2, 1.5, 1.5, 0.3) among them.
MESH_DENOISER = {"Lambda": 1, "Eta": 2, "Mu": 1.5, "Nu": 0.35, "OuterIterations": 5}

# A peer of its own in the summary: much better on some kinds of shape, much worse on others.
LATER_PEER = "MeshDenoiser"

# What users of label maps take: VTK's vtkWindowedSincPolyDataFilter.
WINDOWED_SINC = "windowed sinc"
WINDOWED_SINC_PROGRAM = ROOT / "benchmarks" / "guided" / "windowed_sinc.py"
SYSTEM_PYTHON = "/usr/bin/python3"  # the one that Debian's python3-vtk9 is for


def has_vtk():
    return subprocess.run([SYSTEM_PYTHON, WINDOWED_SINC_PROGRAM, "--check"], capture_output=True).returncode == 0


class Methods:
    """All by name; each reads a file and writes another."""

    def __init__(self, tool, peers):
        """@param peers  commands with {in} and {out}, by name"""
        self.tool = tool
        self.peers = peers
        denoiser = [LATER_PEER] if shutil.which("MeshDenoiser") else []
        sinc = [WINDOWED_SINC] if has_vtk() else []
        self.names = ["taubin", BEST_TAUBIN, *peers, *denoiser, *sinc, "paper", "guided"]
        self.missing = [name for name in (LATER_PEER, WINDOWED_SINC) if name not in self.names]

    def own(self, method, source, target, *options):
        return run(self.tool, "smooth", source, target, "--method", method, "--threads", 1, "--quiet", *options)

    def results(self, name, source, target):
        """Smooths by the method of that name: yields processor seconds for each result, once it is in the target."""
        if name == BEST_TAUBIN:
            for iterations in TAUBIN_ITERATIONS:
                yield self.own("taubin", source, target, "--iterations", iterations)
        elif name in OWN:
            yield self.own(name, source, target)
        elif name == LATER_PEER:
            options = WORK / "mesh_denoiser.txt"
            options.write_text("".join(f"{key} {value}\n" for key, value in MESH_DENOISER.items()))
            yield run("MeshDenoiser", options, source, target, env={"OMP_NUM_THREADS": "1"})
        elif name == WINDOWED_SINC:
            yield run(SYSTEM_PYTHON, WINDOWED_SINC_PROGRAM, source, target)
        else:
            words = [word.replace("{in}", str(source)).replace("{out}", str(target))
                     for word in shlex.split(self.peers[name])]
            yield run(*words)


def rivals_of(names):
    """Those that stand for the best peer: the ones that the benchmark began with."""
    return [name for name in names if name not in ("paper", "guided", LATER_PEER, WINDOWED_SINC, BEST_TAUBIN)]
