# SPDX-License-Identifier: GPL-3.0-or-later
"""A Slurm of our own on this machine: munged, a controller and one node, with keys, ports and files in one folder."""

import os
import pathlib
import pwd
import signal
import socket
import subprocess
import time

CONFIGURATION = """
ClusterName=private
SlurmctldHost={name}(127.0.0.1)
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
# A job that is requeued waits until the credentials of its first run have expired; by default two minutes.
AuthInfo=socket={folder}/munge.socket,cred_expire=5
SlurmctldPort={controller_port}
SlurmdPort={node_port}
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/controller.pid
SlurmdPidFile={folder}/node.pid
SlurmctldLogFile={folder}/controller.log
SlurmdLogFile={folder}/node.log
# Control groups may not be ours to change.
ProctrackType=proctrack/pgid
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=batch_sched_delay=0,sched_interval=1
SlurmdParameters=config_overrides
NodeName={name} NodeAddr=127.0.0.1 CPUs={jobs}
PartitionName=pieces Nodes=ALL Default=YES
"""


def free_port():
    with socket.socket() as listening:
        listening.bind(("127.0.0.1", 0))
        return listening.getsockname()[1]


class PrivateSlurm:
    """To be stopped by stop(), also when start() has thrown."""

    NEEDS = ("munged", "slurmctld", "slurmd", "sbatch", "scancel", "scontrol", "sinfo", "squeue")

    def __init__(self, folder, environment, jobs):
        """`jobs` run at once."""
        self.folder = pathlib.Path(folder)
        self.processes = []
        self.environment = {**environment, "SLURM_CONF": str(self.folder / "slurm.conf")}
        self.jobs = jobs

    def start(self):
        for name in ("state", "spool"):
            (self.folder / name).mkdir()
        key = self.folder / "munge.key"
        key.write_bytes(os.urandom(1024))
        key.chmod(0o400)
        (self.folder / "slurm.conf").write_text(CONFIGURATION.format(
            name=socket.gethostname().split(".")[0], user=pwd.getpwuid(os.geteuid()).pw_name, folder=self.folder,
            jobs=self.jobs, controller_port=free_port(), node_port=free_port()), encoding="utf-8")
        self._serve("munged", "--foreground", "--force", f"--key-file={key}", f"--socket={self.folder}/munge.socket",
                    f"--pid-file={self.folder}/munge.pid", f"--log-file={self.folder}/munge.log",
                    f"--seed-file={self.folder}/munge.seed")
        self._wait_for((self.folder / "munge.socket").exists)
        self._serve("slurmctld", "-D", "-i")
        self._serve("slurmd", "-D")
        self._wait_for(lambda: self.succeeds("scontrol", "ping"))
        self._wait_for(lambda: "idle" in self.run("sinfo", "--noheader", "--format=%T"))

    def stop(self):
        if self.succeeds("scancel", "--partition=pieces"):
            self._wait_for(lambda: not self.run("squeue", "--noheader"))
        for process in reversed(self.processes):  # each needs those before it
            process.send_signal(signal.SIGTERM)
            try:
                process.wait(timeout=20)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()

    def run(self, *command, folder=None):
        """What one of Slurm's commands prints, as they all do in a moment."""
        return subprocess.run(command, cwd=folder, env=self.environment, check=True, timeout=60,
                              stdout=subprocess.PIPE, text=True).stdout.strip()

    def succeeds(self, *command):
        done = subprocess.run(command, env=self.environment, check=False, timeout=60, capture_output=True)
        return done.returncode == 0

    def _serve(self, *command):
        with open(self.folder / f"{command[0]}.output", "wb") as output:
            self.processes.append(subprocess.Popen(command, env=self.environment, stdin=subprocess.DEVNULL,
                                                   stdout=output, stderr=output, start_new_session=True))

    def _wait_for(self, condition, seconds=60):
        end = time.monotonic() + seconds
        while not condition():
            if time.monotonic() > end or any(process.poll() is not None for process in self.processes):
                raise RuntimeError("Slurm does not answer: " + self._words())
            time.sleep(0.05)

    def _words(self):
        logs = [*self.folder.glob("*.log"), *self.folder.glob("*.output")]
        return "\n".join(f"{log.name}: {log.read_text(errors='replace')[-1500:]}" for log in logs)
