# SPDX-License-Identifier: GPL-3.0-or-later
"""What the plugin's tests share: where things are, a private MeshLab with our plugin, a display of its own."""

import contextlib
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

PLUGIN = pathlib.Path(os.environ["ANISO_PLUGIN"]) if "ANISO_PLUGIN" in os.environ else None
TOOL = pathlib.Path(os.environ["ANISO_TOOL"])
SOURCE = pathlib.Path(os.environ["ANISO_SOURCE"])
WORK = pathlib.Path(os.environ["ANISO_WORK"])
LIBRARY = pathlib.Path(os.environ["ANISO_MESHLAB_LIBRARY"]) if PLUGIN else None
APPLY_MLX = os.environ.get("ANISO_APPLY_MLX")  # built for MeshLab since 2021 only


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


class MeshLab:
    """The MeshLab that the plugin was built for, with a home folder of its own. What differs between its versions is in
    the two classes below."""

    def __init__(self, folder):
        self.home = folder / "home"
        self.home.mkdir(parents=True)
        self.locale = {"LC_ALL": "C.UTF-8"}

    def environment(self, display):
        """No setting of the user is read or written; texts and numbers as in the C locale, unless a test asks for another."""
        runtime = self.home / "runtime"
        runtime.mkdir(mode=0o700, exist_ok=True)
        return {**os.environ, "DISPLAY": display, "HOME": str(self.home), "XDG_RUNTIME_DIR": str(runtime),
                "XDG_CONFIG_HOME": str(self.home / "config"), "XDG_DATA_HOME": str(self.home / "data"),
                "LIBGL_ALWAYS_SOFTWARE": "1", "QT_LOGGING_RULES": "", **self.locale}

    @contextlib.contextmanager
    def in_locale(self, variables):
        before, self.locale = self.locale, variables
        try:
            yield
        finally:
            self.locale = before

    def _run(self, command, display, timeout=60, preexec_fn=None, cwd=None, **variables):
        """The finished process, with what it printed on both streams in `stdout`."""
        return subprocess.run([str(word) for word in command], env={**self.environment(display), **variables}, cwd=cwd,
                              stdout=subprocess.PIPE, check=False, stderr=subprocess.STDOUT, text=True, errors="replace",
                              timeout=timeout, preexec_fn=preexec_fn)


class PrivateMeshLab(MeshLab):
    """MeshLab 2020.09 with our plugin in a prefix of its own (see scripts/private_meshlab), and its meshlabserver."""

    failure_status = 255
    cleans_what_it_opens = False
    mesh_region = "350x450+560+200"  # of the screen: holds a part of the mesh and no dialog

    def __init__(self, folder):
        super().__init__(folder)
        self.prefix = folder / "prefix"
        self.program = self.prefix / "bin/meshlab"
        subprocess.run([SOURCE / "scripts/private_meshlab", self.prefix, PLUGIN, LIBRARY], check=True)

    def server(self, display, *arguments, timeout=60, preexec_fn=None):
        return self._run([self.prefix / "bin/meshlabserver", *arguments], display, timeout, preexec_fn)

    def apply(self, display, script, source, target, save=()):
        """Applies a script to a file; `save` is what meshlabserver is told to write besides positions."""
        return self.server(display, *(("-i", source) if source else ()), "-o", target, *save, "-s", script)

    def dialog_stops(self, fields):
        """Where Tab takes the keyboard in a filter's dialog, beginning with what has it at first."""
        return ["Apply", "Default", "Preview", *fields]

    def errors(self, done):
        """What the user is told. meshlabserver prints progress without line ends, so the message may follow it on the
        same line; it also prints every message to stderr, behind "LOG: 2"."""
        return re.findall(r"(?<!LOG: 2 )Error: .*", done.stdout)


class InstalledMeshLab(MeshLab):
    """MeshLab since 2021 as it is installed, with our plugin where it looks for a user's own, and our apply_mlx."""

    failure_status = 1
    cleans_what_it_opens = True  # degenerate faces and vertices that are not finite
    mesh_region = "225x380+245+240"
    shows_python = os.environ.get("ANISO_MESHLAB_VERSION", "") >= "2023"  # a filter's dialog: its call in PyMeshLab

    def __init__(self, folder):
        super().__init__(folder)
        self.program = pathlib.Path("/usr/bin/meshlab")
        plugins = self.home / "data/VCG/MeshLab_64bit_fp/MeshLabExtraPlugins" / os.environ["ANISO_MESHLAB_VERSION"]
        plugins.mkdir(parents=True)
        shutil.copy(PLUGIN, plugins)

    def apply_mlx(self, *arguments, cwd=None, **variables):
        return self._run([APPLY_MLX, *arguments], display="", cwd=cwd, **variables)

    def apply(self, _display, script, source, target, _save=()):
        """Applies a script to a file, without a display; attributes are written if the mesh has them."""
        return self.apply_mlx("-i", source, "-o", target, "-s", script, "--plugin", PLUGIN)

    def dialog_stops(self, fields):
        return ["Apply", *(("text", "Copy PyMeshLab call") if self.shows_python else ()), *fields]

    def preview_place(self):
        """Where the check box is that no key reaches: pixels from the left and from the bottom of the dialog."""
        return (16, 169) if self.shows_python else (16, 79)

    def errors(self, done):
        return done.stdout.splitlines()


def make_meshlab(folder):
    """The MeshLab to test in; says which."""
    print(f"MeshLab {os.environ['ANISO_MESHLAB_VERSION']}, package {installed_package()}", file=sys.stderr)
    return InstalledMeshLab(folder) if APPLY_MLX else PrivateMeshLab(folder)


def installed_package():
    found = subprocess.run(["dpkg-query", "-W", "-f", "${Version}", "meshlab"], check=False, capture_output=True, text=True)
    return found.stdout if found.returncode == 0 else "unknown"


class Display:
    """A virtual X display that chooses a free number itself and is ready when __enter__ returns; if wanted, with a
    window manager, without which windows get no keyboard focus."""

    def __init__(self, window_manager=False):
        self.window_manager = window_manager
        self.manager = None

    def __enter__(self):
        reader, writer = os.pipe()
        # -noreset: else the server starts anew when its last client leaves, and throws out one that comes meanwhile.
        self.process = subprocess.Popen(
            ["Xvfb", "-displayfd", str(writer), "-screen", "0", "1400x900x24", "+extension", "GLX", "-nolisten", "tcp",
             "-noreset"], pass_fds=[writer], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
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
        deadline = time.monotonic() + 120
        while time.monotonic() < deadline and self.manager.poll() is None:
            answer = subprocess.run(["xprop", "-root", "_NET_SUPPORTING_WM_CHECK"], env=environment, check=False,
                                    capture_output=True, text=True, timeout=30).stdout
            if "window id" in answer:
                return
            time.sleep(0.05)
        raise RuntimeError(f"openbox did not start; exit status {self.manager.poll()}")

    def __exit__(self, *_):
        if self.manager:
            self.manager.terminate()
            self.manager.wait(timeout=20)
        self.process.terminate()
        self.process.wait(timeout=20)
