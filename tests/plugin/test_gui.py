# SPDX-License-Identifier: GPL-3.0-or-later
"""The plugin in MeshLab's window on a virtual display. Screenshots stay in the test's folder below the build folder."""

import re
import unittest

import ply
import scripts
from environment import Display, fresh_work_folder, make_meshlab, run_tool
from gui import Gui, share_of_pixels_that_differ


def setUpModule():
    global work, meshlab, display, noisy
    work = fresh_work_folder()
    meshlab = make_meshlab(work)
    display = Display(window_manager=True).__enter__()
    run_tool("generate", "cad_part", work / "clean.ply", "--vertices", 8000)
    noisy = work / "noisy.ply"
    run_tool("noise", work / "clean.ply", noisy, "--level", "0.2")


def tearDownModule():
    display.__exit__()


def by_script(source, name, filter_name=scripts.SMOOTHING, save=(), **values):
    script = scripts.write(work / f"{name}.mlx", filter_name, **values)
    target = work / f"{name}.ply"
    done = meshlab.apply(display.name, script, source, target, save)
    if done.returncode != 0:
        raise AssertionError(done.stdout)
    return target


class Dialog(unittest.TestCase):
    def assert_same_picture(self, one, other):
        self.assertLess(share_of_pixels_that_differ(one, other), 0.005)

    def start(self, mesh, name):
        folder = work / name
        folder.mkdir()
        gui = Gui(meshlab, display, mesh, folder)
        self.addCleanup(gui.close)
        return gui

    def test_preview_apply_and_export(self):
        gui = self.start(noisy, "smoothing")
        gui.open_filter(scripts.SMOOTHING)

        gui.toggle_preview()
        gui.wait_for_log("Applied filter")
        shown = gui.settled_picture("preview_on")
        gui.toggle_preview()
        hidden = gui.settled_picture("preview_off", unlike=shown)
        gui.toggle_preview()
        self.assert_same_picture(gui.settled_picture("preview_on_again", unlike=hidden), shown)
        gui.toggle_preview()
        self.assert_same_picture(gui.settled_picture("preview_off_again", unlike=shown), hidden)
        self.assertEqual(ply.positions(gui.export(work / "after_preview.ply")), ply.positions(noisy))

        gui.open_filter(scripts.SMOOTHING)  # anew: where the keyboard is after saving differs between MeshLabs
        gui.set_field("sigma_n", "0.2")
        applied = gui.applied()
        gui.press("Apply")
        gui.wait_for_log("Applied filter", applied + 1)
        gui.settled_picture("applied", unlike=hidden)
        result = gui.export(work / "applied.ply")
        self.assertEqual(ply.positions(result), ply.positions(by_script(noisy, "by_script", sigma_n="0.2")))
        self.assertRegex(gui.log(), r"moved \d+ of \d+ vertices")
        self.assertRegex(gui.log(), r"average edge length")

    def test_bad_value_is_explained_in_a_box_and_changes_nothing(self):
        gui = self.start(noisy, "failure")
        dialog = gui.open_filter(scripts.SMOOTHING)
        gui.set_field("sigma_c", "-1")
        gui.press("Apply")
        gui.window("Filter Failure")
        gui.settled_picture("failure_box")
        gui.keys("Return")
        gui.gone("Filter Failure")
        self.assertIn("sigma_c is -1; it must be", gui.log())
        self.assertEqual(ply.positions(gui.export(work / "after_failure.ply")), ply.positions(noisy))
        gui.focus(dialog)

    def test_a_selection_is_taken_up_by_the_dialog(self):
        source = work / "selected.ply"
        vertex = ply.read(noisy)["vertex"]
        x, y, z = (ply.floats(vertex[name]) for name in "xyz")
        ply.write(source, [("vertex", [("x", "float"), ("y", "float"), ("z", "float"), ("flags", "int")],
                            [(x[i], y[i], z[i], 0x20 if i % 2 else 0) for i in range(len(x))]),
                           ("face", [("vertex_indices", ("uchar", "int"))], [(t,) for t in ply.triangles(noisy)])])
        gui = self.start(source, "selection")
        gui.open_filter(scripts.SMOOTHING)
        gui.press("Apply")
        gui.wait_for_log("Applied filter")
        result = ply.positions(gui.export(work / "selection_applied.ply"))
        self.assertEqual(result, ply.positions(by_script(source, "selection_script", selected="true")))
        before = ply.positions(noisy)
        self.assertEqual(result[::2], before[::2])
        self.assertNotEqual(result, before)

    def test_second_start_while_running_is_refused(self):
        large = work / "large.ply"
        run_tool("generate", "sphere", work / "large_clean.ply", "--vertices", 60000)
        run_tool("noise", work / "large_clean.ply", large, "--level", "0.2")
        gui = self.start(large, "busy")
        dialog = gui.open_filter(scripts.SMOOTHING)
        gui.set_field("sigma_c", "5")
        gui.press("Apply")
        gui.focus(dialog)
        gui.press("Apply")
        gui.window("Filter Failure")
        gui.picture("still_running")
        self.assertEqual(gui.applied(), 0)
        gui.keys("Return")
        gui.wait_for_log("Applied filter")
        self.assertEqual(len(re.findall("failed: a filter of this plugin is still running", gui.log())), 1)
        result = gui.export(work / "busy.ply")
        self.assertEqual(ply.positions(result), ply.positions(by_script(large, "busy_script", sigma_c="5")))

    def test_geodesic_distance_is_shown_in_colour_and_restored(self):
        gui = self.start(noisy, "geodesic")
        gui.open_filter(scripts.GEODESIC)
        gui.toggle_preview()
        gui.wait_for_log("Applied filter")
        shown = gui.settled_picture("preview_on")
        gui.toggle_preview()
        hidden = gui.settled_picture("preview_off", unlike=shown)
        gui.open_filter(scripts.GEODESIC)
        gui.press("Apply")
        gui.wait_for_log("Applied filter", 2)
        self.assert_same_picture(gui.settled_picture("applied", unlike=hidden), shown)
        result = ply.read(gui.export(work / "geodesic.ply"))["vertex"]
        expected = ply.read(by_script(noisy, "geodesic_script", scripts.GEODESIC, ("-m", "vc", "vq")))["vertex"]
        for name in ("x", "y", "z", "red", "green", "blue", "quality"):
            self.assertEqual(result[name], expected[name], name)


if __name__ == "__main__":
    unittest.main()
