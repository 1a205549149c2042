"""What the plugin's tests share: where things are, a private MeshLab with our plugin, a display of its own."""

import os
import pathlib
import shutil
import subprocess
import time

PLUGIN = pathlib.Path(os.environ["ANISO_PLUGIN"]) if "ANISO_PLUGIN" in os.environ else None
TOOL = pathlib.Path(os.environ["ANISO_TOOL"])
SOURCE = pathlib.Path(os.environ["ANISO_SOURCE"])
WORK = pathlib.Path(os.environ["ANISO_WORK"])
LIBRARY = pathlib.Path(os.environ["ANISO_MESHLAB_LIBRARY"]) if PLUGIN else None


def fresh_work_folder():
    """Empties and returns the folder of this test; screenshots and meshes stay there afterwards."""
    shutil.rmtree(WORK, ignore_errors=True)
    WORK.mkdir(parents=True)
    return WORK


def run_tool(*arguments):
    """Runs our command line and returns its standard output."""
    done = subprocess.run([TOOL, *map(str, arguments)], check=False, capture_output=True, text=True, timeout=120)
    if done.returncode != 0:
        raise AssertionError(f"anisosmooth {arguments}: status {done.returncode}\n{done.stderr}")
    return done.stdout


class PrivateMeshLab:
    """MeshLab with our plugin in a prefix of its own (see scripts/private_meshlab), and a home folder of its own."""

    def __init__(self, folder):
        self.prefix = folder / "prefix"
        self.home = folder / "home"
        self.home.mkdir(parents=True)
        subprocess.run([SOURCE / "scripts/private_meshlab", self.prefix, PLUGIN, LIBRARY], check=True)

    def environment(self, display):
        """No setting of the user is read or written; texts and numbers as in the C locale."""
        runtime = self.home / "runtime"
        runtime.mkdir(mode=0o700, exist_ok=True)
        return {**os.environ, "DISPLAY": display, "HOME": str(self.home), "XDG_RUNTIME_DIR": str(runtime),
                "XDG_CONFIG_HOME": str(self.home / "config"), "XDG_DATA_HOME": str(self.home / "data"),
                "LC_ALL": "C.UTF-8", "LIBGL_ALWAYS_SOFTWARE": "1", "QT_LOGGING_RULES": ""}

    def server(self, display, *arguments, timeout=60, preexec_fn=None):
        """Runs meshlabserver; returns the finished process with what it printed on both streams in `stdout`."""
        command = [self.prefix / "bin/meshlabserver", *map(str, arguments)]
        return subprocess.run(command, env=self.environment(display), stdout=subprocess.PIPE, check=False,
                              stderr=subprocess.STDOUT, text=True, errors="replace", timeout=timeout,
                              preexec_fn=preexec_fn)


class Display:
    """A virtual X display that chooses a free number itself and is ready when __enter__ returns; if wanted, with a
    window manager, without which windows get no keyboard focus."""

    def __init__(self, window_manager=False):
        self.window_manager = window_manager
        self.manager = None

    def __enter__(self):
        reader, writer = os.pipe()
        self.process = subprocess.Popen(
            ["Xvfb", "-displayfd", str(writer), "-screen", "0", "1400x900x24", "+extension", "GLX", "-nolisten", "tcp"],
            pass_fds=[writer], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(writer)
        with os.fdopen(reader) as pipe:
            number = pipe.readline().strip()
        if not number:
            raise RuntimeError("Xvfb did not start")
        self.name = ":" + number
        if self.window_manager:
            self._start_window_manager()
        return self

    def _start_window_manager(self):
        environment = {**os.environ, "DISPLAY": self.name}
        self.manager = subprocess.Popen(["openbox"], env=environment, stdout=subprocess.DEVNULL,
                                        stderr=subprocess.DEVNULL)
        deadline = time.monotonic() + 30
        while time.monotonic() < deadline:
            answer = subprocess.run(["xprop", "-root", "_NET_SUPPORTING_WM_CHECK"], env=environment, check=False,
                                    capture_output=True, text=True, timeout=30).stdout
            if "window id" in answer:
                return
            time.sleep(0.05)
        raise RuntimeError("openbox did not start")

    def __exit__(self, *_):
        if self.manager:
            self.manager.terminate()
            self.manager.wait(timeout=20)
        self.process.terminate()
        self.process.wait(timeout=20)
