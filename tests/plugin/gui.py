# SPDX-License-Identifier: GPL-3.0-or-later
"""Drives MeshLab's window on a virtual display by keys, and by the mouse what no key reaches. Every wait is for something
that can be seen: a window, a line of the log."""

import re
import subprocess
import time

import scripts

WAIT = 120  # seconds; reached only when something is wrong


def share_of_pixels_that_differ(one, other):
    """By more than what the last bit of an antialiased line may do."""
    differing = sum(abs(a - b) > 8 for a, b in zip(one[::3], other[::3]))
    return differing / (len(one) // 3)


class Gui:
    def __init__(self, meshlab, display, mesh, folder):
        self.meshlab = meshlab
        self.folder = folder
        self.environment = meshlab.environment(display.name)
        self.log_path = folder / "meshlab.log"
        self.pictures = 0
        with open(self.log_path, "w", encoding="utf-8") as log:
            self.process = subprocess.Popen([meshlab.program, mesh], env=self.environment, cwd=folder,
                                            stdout=subprocess.DEVNULL, stderr=log)
        try:
            self.wait_for_log("All files opened")
            self.main = self.window("^MeshLab 2")
        except BaseException:
            self.close()
            raise

    def close(self):
        self.process.kill()
        self.process.wait(timeout=20)

    def _output(self, *command):
        return subprocess.run(command, env=self.environment, check=False, capture_output=True, text=True,
                              timeout=WAIT).stdout

    def _wait(self, condition, what):
        deadline = time.monotonic() + WAIT
        while time.monotonic() < deadline:
            result = condition()
            if result:
                return result
            time.sleep(0.05)
        self.picture("timeout")
        raise AssertionError(f"waited {WAIT} s for {what}; log:\n{self.log()}")

    def log(self):
        return self.log_path.read_text(encoding="utf-8", errors="replace") if self.log_path.exists() else ""

    def wait_for_log(self, pattern, times=1):
        self._wait(lambda: len(re.findall(pattern, self.log())) >= times, f"{times} x '{pattern}' in the log")

    def find(self, title):
        """The window of this title (a pattern) that is on the screen, or None."""
        found = self._output("xdotool", "search", "--onlyvisible", "--name", title).split()
        return found[-1] if found else None

    def window(self, title):
        """Waits for a window and gives it the keyboard."""
        found = self._wait(lambda: self.find(title), f"window '{title}'")
        self.focus(found)
        return found

    def focus(self, window):
        def focused():
            self._output("xdotool", "windowfocus", window)
            return self._output("xdotool", "getwindowfocus").strip() == window
        self._wait(focused, "the keyboard's focus")

    def gone(self, title):
        self._wait(lambda: not self.find(title), f"the end of window '{title}'")

    def keys(self, *keys):
        self._output("xdotool", "key", "--clearmodifiers", "--delay", "40", *keys)

    def type(self, text):
        self._output("xdotool", "type", "--delay", "8", "--", str(text))

    def picture(self, name):
        self.pictures += 1
        path = self.folder / f"{self.pictures:02}_{name}.png"
        self._output("import", "-window", "root", str(path))
        return path

    def settled_picture(self, name, unlike=None, region=None):
        """A picture that two looks in a row agree on: drawing has finished. It waits for one other than `unlike`."""
        if unlike is not None:
            self._wait(lambda: share_of_pixels_that_differ(self.pixels(region), unlike) > 0.01, f"'{name}'")
        previous = None

        def settled():
            nonlocal previous
            now = self.pixels(region)
            same, previous = now == previous, now
            time.sleep(0.2)
            return same
        self._wait(settled, "a still picture")
        self.picture(name)
        return previous

    def pixels(self, region=None):
        """What a part of the screen shows: the one with the mesh and no dialog unless told."""
        region = region or self.meshlab.mesh_region
        return subprocess.run(["import", "-window", "root", "-crop", region, "-depth", "8", "rgb:-"], check=False,
                              env=self.environment, capture_output=True, timeout=WAIT).stdout

    # MeshLab's ways

    def open_filter(self, name):
        """Finds a filter by the search box and opens its dialog, anew if it is open."""
        title = "^" + re.escape(name)
        old = self.find(title)
        self.focus(self.main)
        before = self.pixels("480x160+905+82")
        self.keys("ctrl+f")
        self.type(name)
        self._wait(lambda: self.pixels("480x160+905+82") != before, "the search box")
        self.settled_picture("search", region="480x160+905+82")
        self.keys("Down", "Return")
        dialog = self._wait(lambda: self.find(title) not in (None, old) and self.find(title), f"window '{title}'")
        self.focus(dialog)
        self.stops = self.meshlab.dialog_stops(list(scripts.DEFAULTS[name]))
        self.stop = 0
        self.dialog = dialog
        self.settled_picture("dialog")
        return dialog

    def go_to(self, stop):
        """Gives the keyboard to a field or button of the open dialog."""
        steps = self.stops.index(stop) - self.stop
        self.stop += steps
        if steps:
            self.keys(*["Tab" if steps > 0 else "shift+Tab"] * abs(steps))

    def press(self, button):
        self.go_to(button)
        self.keys("space")

    def toggle_preview(self):
        if "Preview" in self.stops:
            self.press("Preview")
            return
        left, bottom = self.meshlab.preview_place()
        shape = dict(line.split("=") for line in
                     self._output("xdotool", "getwindowgeometry", "--shell", self.dialog).splitlines())
        self._output("xdotool", "mousemove", "--window", self.dialog, str(left), str(int(shape["HEIGHT"]) - bottom),
                     "click", "1")

    def set_field(self, name, value):
        self.go_to(name)
        self.keys("ctrl+a")
        self.type(value)

    def applied(self):
        return len(re.findall("Applied filter", self.log()))

    def export(self, path):
        """Saves the layer as binary PLY."""
        self.focus(self.main)
        self.keys("ctrl+shift+e")
        self.window('^Save ".*" Layer')
        self.type(path)
        self.keys("Return")
        self.window("^Choose Saving Options")
        self.keys("Return")
        self.wait_for_log(f"Saved Mesh {re.escape(str(path))}")
        return path
