# SPDX-License-Identifier: GPL-3.0-or-later
"""Names, parameters, kinds, choices, defaults and ranges of every filter, what it declares to change and what it reports,
are those of filters.json: users' scripts hold on to them. Who changes one on purpose runs

    build/bin/describe_plugin build/plugins/libfilter_anisotropic_smooth.so >tests/plugin/filters.json

for a MeshLab since 2021: 2020.09 knows neither Python names nor reports."""

import ast
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

from description import describe
from environment import PLUGIN, SOURCE

SNAPSHOT = pathlib.Path(__file__).with_name("filters.json")
SINCE_2021 = ("python_name", "report", "changes_by_default", "changes_when_switched")
IN_PYTHON = {"int", "double", "float", "bool"}  # the scalar types of a report that PyMeshLab hands on


def without(names, value):
    if isinstance(value, dict):
        return {key: without(names, item) for key, item in value.items() if key not in names}
    if isinstance(value, list):
        return [without(names, item) for item in value]
    return value


class Snapshot(unittest.TestCase):
    maxDiff = None

    def test_filters_are_as_released(self):
        found = describe(os.environ["ANISO_DESCRIBE"], PLUGIN)
        released = json.loads(SNAPSHOT.read_text())
        if not any("python_name" in description for description in found):
            released = without(SINCE_2021, released)
        self.assertEqual([description["name"] for description in found],
                         [description["name"] for description in released])
        for description, expected in zip(found, released):
            with self.subTest(filter=expected["name"]):
                self.assertEqual(description, expected)

    def test_defaults_are_those_of_the_core(self):
        """As the command line reports them, which takes them from the core's table of methods."""
        methods = {"Anisotropic Feature-Preserving Smoothing": "paper", "Bilateral Mesh Denoising": "bmd",
                   "Non-Iterative Feature-Preserving Smoothing": "jones", "Guided Anisotropic Smoothing": "guided"}
        compared = 0
        for description in describe(os.environ["ANISO_DESCRIBE"], PLUGIN):
            if description["name"] not in methods:
                continue
            with tempfile.TemporaryDirectory() as folder, self.subTest(filter=description["name"]):
                mesh = pathlib.Path(folder, "cube.ply")
                report = pathlib.Path(folder, "report.json")
                tool = os.environ["ANISO_TOOL"]
                subprocess.run([tool, "generate", "cube", mesh, "--quiet"], check=True)
                subprocess.run([tool, "smooth", mesh, pathlib.Path(folder, "out.ply"), "--quiet", "--report", report,
                                "--method", methods[description["name"]]], check=True)
                defaults = json.loads(report.read_text())["parameters"]
                for parameter in description["parameters"]:
                    value = parameter["default"]
                    if "choices" in parameter:
                        value = parameter["choices"][value]
                    self.assertEqual(value, defaults[parameter["name"]], parameter["name"])
                    compared += 1
        self.assertEqual(compared, 7 + 5 + 4 + 6)

    def test_colour_is_declared_only_where_it_can_change(self):
        (guided,) = [one for one in json.loads(SNAPSHOT.read_text()) if one["name"].startswith("Guided")]
        colours = {"VERTCOLOR", "VERTQUALITY"}
        self.assertFalse(colours & set(guided["changes_by_default"]))
        for parameter in guided["parameters"]:
            if parameter["name"] == "smooth_color":
                self.assertEqual(set(parameter["changes_when_switched"]), set(guided["can_change"]))
                self.assertLessEqual(colours, set(guided["can_change"]))
            elif parameter["kind"] == "RichBool":
                self.assertFalse(colours & set(parameter["changes_when_switched"]), parameter["name"])

    def test_reports_are_of_types_that_pymeshlab_hands_on(self):
        for description in json.loads(SNAPSHOT.read_text()):
            self.assertLessEqual(set(description["report"].values()), IN_PYTHON, description["name"])

    def test_documented_pymeshlab_example_uses_released_names(self):
        tree = ast.parse((SOURCE / "docs/pymeshlab_example.py").read_text())
        (call,) = [node for node in ast.walk(tree) if isinstance(node, ast.Call) and
                   getattr(node.func, "attr", "") == "apply_filter"]
        (description,) = [one for one in json.loads(SNAPSHOT.read_text()) if one["python_name"] == call.args[0].value]
        self.assertEqual([keyword.arg for keyword in call.keywords],
                         [parameter["python_name"] for parameter in description["parameters"]])
        for keyword, parameter in zip(call.keywords, description["parameters"]):
            default = parameter["default"]
            if "choices" in parameter:
                default = parameter["choices"][default]
            self.assertEqual(keyword.value.value, default, keyword.arg)
        used = {node.slice.value for node in ast.walk(tree) if isinstance(node, ast.Subscript) and
                getattr(node.value, "id", "") == "report"}
        self.assertTrue(used)
        self.assertLessEqual(used, set(description["report"]))


if __name__ == "__main__":
    unittest.main()
