# SPDX-License-Identifier: GPL-3.0-or-later
"""The recipes of docs/large-meshes.md, each run by the engine that it is for on a mesh in twelve pieces, with a worker, a
run or a job lost in the middle: the same bits as one process gives. An engine that is not installed is skipped by
name. ANISO_ENGINE_VERTICES sets the size of the mesh."""

import contextlib
import os
import pathlib
import re
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

from command_line import PROGRAM
from private_slurm import PrivateSlurm, free_port

SOURCE = pathlib.Path(os.environ["ANISO_SOURCE"])
DEFAULT = "200000" if os.environ.get("ANISO_SANITIZE") else "2000000"
VERTICES = int(os.environ.get("ANISO_ENGINE_VERTICES", DEFAULT))
PIECES = 12


def recipe(engine):
    text = (SOURCE / "docs/large-meshes.md").read_text(encoding="utf-8")
    return re.search(rf"<!-- engine {engine} -->\n```\w+\n(.*?)```", text, re.DOTALL).group(1)


def interpreter_of(script):
    """Of a Python program that is installed: the one that has its modules."""
    with open(shutil.which(script), encoding="utf-8") as file:
        return file.readline()[2:].split()


def processes_of(started, name=None):
    """Numbers of the processes in the session of one that start() has started, all or those of a name."""
    found = []
    for folder in pathlib.Path("/proc").glob("[0-9]*"):
        with contextlib.suppress(OSError):  # it has ended meanwhile
            if os.getsid(int(folder.name)) == started.pid and name in (None, (folder / "comm").read_text().strip()):
                found.append(int(folder.name))
    return found


def send(number, *processes):
    for process in processes:
        with contextlib.suppress(ProcessLookupError):
            os.kill(process, number)


class Engines(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        """A mesh, its plan, and what one process makes of it."""
        cls.folder = pathlib.Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        cls.run_tool("generate", "torus", "clean.ply", "--vertices", str(VERTICES))
        cls.run_tool("noise", "clean.ply", "mesh.ply", "--level", "0.2")
        cls.run_tool("tiles", "plan", "mesh.ply", "plan", "--tile-vertices", str(VERTICES // PIECES + 1))
        shutil.copytree(cls.folder / "plan", cls.folder / "alone")
        cls.run_tool("tiles", "run", "alone", "--all")
        cls.run_tool("tiles", "finish", "alone", "alone.ply")

    @classmethod
    def run_tool(cls, *arguments):
        subprocess.run([PROGRAM, *arguments, "--quiet"], cwd=cls.folder, check=True, timeout=600)

    def setUp(self):
        """Where the recipe runs: a folder of its own with the plan, the program within reach."""
        self.work = pathlib.Path(tempfile.mkdtemp(dir=self.folder))
        shutil.copytree(self.folder / "plan", self.work / "PLAN", copy_function=os.link)
        self.environment = {**os.environ, "HOME": str(self.work), "PYTHONWARNINGS": "ignore",
                            "PATH": f"{os.path.dirname(PROGRAM)}:{os.environ['PATH']}"}
        self.assertGreaterEqual(len(self.named("bucket_")), PIECES)

    def need(self, *programs):
        for program in programs:
            if shutil.which(program) is None:
                self.skipTest(f"{program} is not installed")

    def named(self, prefix):
        return [path.name for path in (self.work / "PLAN").glob(f"{prefix}*")]

    def start(self, *command):
        output = (self.work / f"output_{pathlib.Path(command[0]).name}_{len(list(self.work.iterdir()))}").open("w+b")
        process = subprocess.Popen(command, cwd=self.work, env=self.environment, stdin=subprocess.DEVNULL,
                                   stdout=output, stderr=subprocess.STDOUT, start_new_session=True)
        process.output = output
        self.addCleanup(self.stop, process)
        return process

    @staticmethod
    def stop(process):
        send(signal.SIGKILL, *processes_of(process))
        process.wait()
        process.output.close()

    def expect_done(self, process):
        status = process.wait(timeout=600)
        process.output.seek(0)
        self.assertEqual(status, 0, process.output.read().decode(errors="replace"))

    def expect_result(self):
        self.assertEqual(len(self.named("result_")), len(self.named("bucket_")))
        if not (self.work / "smooth.ply").exists():
            self.run_tool("tiles", "finish", str(self.work / "PLAN"), str(self.work / "smooth.ply"))
        self.assertEqual((self.work / "smooth.ply").read_bytes(), (self.folder / "alone.ply").read_bytes())

    def wait_for(self, condition, seconds=120):
        """What the condition gives when it is not false any more."""
        end = time.monotonic() + seconds
        while not (found := condition()):
            self.assertLess(time.monotonic(), end)
            time.sleep(0.01)
        return found

    def lose_in_the_middle(self, lose):
        """Calls lose() when some pieces are done and some are not; it says whether it has found something to lose."""
        self.wait_for(lambda: self.named("result_"))
        self.wait_for(lose)
        self.assertLess(len(self.named("result_")), len(self.named("bucket_")))

    def kill_run(self, started, with_all=False):
        """Kills a run of a piece that has no result yet, and all other processes of the session with it if asked to."""
        for run in processes_of(started, "anisosmooth"):
            send(signal.SIGSTOP, run)
            with contextlib.suppress(OSError, ValueError):  # it has ended meanwhile
                folder = pathlib.Path(f"/proc/{run}")
                while (folder / "stat").read_text().rsplit(") ")[1][0] not in "TZ":
                    time.sleep(0.001)
                words = (folder / "cmdline").read_text().split("\0")
                if f"result_{words[words.index('--tile') + 1]}" not in self.named("result_"):
                    send(signal.SIGKILL, run, *(processes_of(started) if with_all else []))
                    return True
            send(signal.SIGCONT, run)
        return False

    def test_parallel_with_a_run_that_is_killed(self):
        self.need("parallel")
        process = self.start("sh", "-c", recipe("parallel"))

        self.lose_in_the_middle(lambda: self.kill_run(process))
        self.expect_done(process)
        self.expect_result()

    def test_snakemake_with_a_run_that_is_killed(self):
        self.need("snakemake")
        (self.work / "Snakefile").write_text(recipe("snakemake"), encoding="utf-8")
        process = self.start("snakemake", "--cores", "3", "--retries", "3")
        self.lose_in_the_middle(lambda: self.kill_run(process))
        self.expect_done(process)
        self.expect_result()

    def test_dask_with_a_worker_that_is_killed(self):
        self.need("dask-scheduler", "dask-worker")
        (self.work / "tiles.py").write_text(recipe("dask"), encoding="utf-8")
        port = str(free_port())
        address = f"tcp://127.0.0.1:{port}"
        self.start("dask-scheduler", "--host", "127.0.0.1", "--port", port, "--no-dashboard")
        workers = [self.start("dask-worker", address, "--nthreads", "1", "--no-nanny", "--no-dashboard")
                   for _ in range(3)]
        client = self.start(*interpreter_of("dask-worker"), "tiles.py", address, "PLAN")
        self.lose_in_the_middle(lambda: any(self.kill_run(worker, with_all=True) for worker in workers))
        self.expect_done(client)
        self.expect_result()

    def test_slurm_with_a_job_requeued(self):
        self.need(*PrivateSlurm.NEEDS)
        folder = self.work / "slurm"
        folder.mkdir()
        slurm = PrivateSlurm(folder, self.environment, jobs=3)
        self.addCleanup(slurm.stop)
        slurm.start()
        (self.work / "tile.sh").write_text(recipe("slurm"), encoding="utf-8")
        last = len(self.named("bucket_")) - 1
        job = slurm.run("sbatch", "--parsable", f"--array=0-{last}", "tile.sh", "PLAN", folder=self.work)
        running = ("squeue", "--noheader", "--array", "--states=RUNNING", "--format=%F_%K")
        self.lose_in_the_middle(lambda: any(slurm.succeeds("scontrol", "requeue", task)
                                            for task in slurm.run(*running).split()[:1]))
        self.wait_for(lambda: not slurm.run("squeue", "--noheader"))
        self.assertEqual(slurm.run("scontrol", "show", "job", job).count(" Restarts=1 "), 1)
        self.expect_result()


if __name__ == "__main__":
    unittest.main()
