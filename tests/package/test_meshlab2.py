# SPDX-License-Identifier: GPL-3.0-or-later
"""packaging/meshlab2: the files are what scripts/describe_for_meshlab2 makes of the filters' tables, and filters.json has
the form that meshlab2 documents (docs/design/adding_a_filter.md and vocabulary.md there; docs/meshlab2.md here)."""

import json
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ["ANISO_SOURCE"])
FOLDER = SOURCE / "packaging/meshlab2"
FILES = ("filters.json", "anisosmoothfilterplugin.cpp")

# What meshlab2 documents, as far as these filters use it.
IDENTIFIER = re.compile(r"[a-z][a-z0-9_]*")
FILTER_KEYS = {"id", "categories", "name", "pythonName", "shortDescription", "longDescriptionMarkdown", "tags", "inputDomain",
               "outputDomain", "inputRequirements", "outputModifies", "parameters", "selectionScope", "referenceIds"}
PARAMETER_KEYS = {"bool": {"default"}, "int": {"default", "min", "max"}, "enum": {"default", "enumOptions"},
                  "double": {"default", "min", "max", "decimals"}}
COMMON_KEYS = {"id", "label", "help", "group", "type"}
MODIFIES = {"VG", "VN", "VC", "VQ", "VT", "VA", "VS", "FV", "FN", "FC", "FQ", "FA", "FS", "FP", "WT", "TX", "TM"}
PLAIN = re.compile(r"\n|\*|`|\$|\]\(|<[A-Za-z/]")  # what a plain sentence must not have


def problems(descriptor):
    """What does not have the documented form; empty if all is well."""
    found = []

    def require(condition, sentence):
        if not condition:
            found.append(sentence)

    require(re.fullmatch(r"meshlab2\.filter\.\w+", descriptor["pluginId"]), "pluginId")
    references = {reference["id"] for reference in descriptor["references"]}
    for reference in descriptor["references"]:
        require(reference["title"] and reference["issued"]["date-parts"][0][0] > 0, f"reference {reference['id']}")
    names = [filter_["pythonName"] for filter_ in descriptor["filters"]]
    require(len(set(names)) == len(names), "a Python name twice")
    for filter_ in descriptor["filters"]:
        name = filter_["id"]
        require(set(filter_) <= FILTER_KEYS, f"{name}: keys {set(filter_) - FILTER_KEYS}")
        require(IDENTIFIER.fullmatch(name) and IDENTIFIER.fullmatch(filter_["pythonName"]), f"{name}: not an identifier")
        require(filter_["categories"] == ["Geometry/Smoothing"], f"{name}: category")
        require(filter_["name"].split()[0] == "Smooth" and ":" not in filter_["name"], f"{name}: name")
        require(filter_["shortDescription"] and not PLAIN.search(filter_["shortDescription"]), f"{name}: short description")
        require(filter_["inputDomain"] == "SingleMesh" and filter_["outputDomain"] == "ModifyCurrentMesh", f"{name}: domain")
        require(set(filter_["outputModifies"]) <= MODIFIES, f"{name}: outputModifies")
        require(filter_.get("selectionScope", "vertices") == "vertices", f"{name}: selectionScope")
        require(set(filter_.get("referenceIds", [])) <= references, f"{name}: unknown reference")
        ids = [parameter["id"] for parameter in filter_["parameters"]]
        require(len(set(ids)) == len(ids) and "selectedOnly" not in ids, f"{name}: parameters {ids}")
        for parameter in filter_["parameters"]:
            found += [f"{name}: {sentence}" for sentence in parameter_problems(parameter)]
        for text in (filter_["longDescriptionMarkdown"], *(parameter["help"] for parameter in filter_["parameters"])):
            require("\\n" not in text, f"{name}: a literal backslash n")
    return found


def parameter_problems(parameter):
    found = []
    kind, value = parameter["type"], parameter["default"]
    if kind not in PARAMETER_KEYS:
        return [f"{parameter['id']}: type {kind}"]
    if not set(parameter) <= COMMON_KEYS | PARAMETER_KEYS[kind]:
        found.append(f"{parameter['id']}: keys {set(parameter)}")
    if not all(parameter[key].strip() for key in COMMON_KEYS):
        found.append(f"{parameter['id']}: an empty text")
    if kind == "bool" and not isinstance(value, bool):
        found.append(f"{parameter['id']}: default {value}")
    if kind == "enum":
        options = [option["id"] for option in parameter["enumOptions"]]
        if value not in options or len(set(options)) != len(options):
            found.append(f"{parameter['id']}: default {value} among {options}")
        if not all(option["label"] for option in parameter["enumOptions"]):
            found.append(f"{parameter['id']}: a choice without a label")
    if kind in ("int", "double"):
        least, most = parameter["min"], parameter.get("max", float("inf"))
        if not least <= value <= most or not least < most:
            found.append(f"{parameter['id']}: {value} in [{least}, {most}]")
    return found


def run(*options):
    return subprocess.run([SOURCE / "scripts/describe_for_meshlab2", "--program", os.environ["ANISO_DESCRIBE"], *options],
                          check=False, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)


class Files(unittest.TestCase):
    def test_are_current(self):
        done = run("--check")
        self.assertEqual(done.returncode, 0, done.stdout)

    def test_that_are_not_current_are_named_and_mended(self):
        for name in FILES:
            with tempfile.TemporaryDirectory() as folder, self.subTest(name):
                for each in FILES:
                    shutil.copy(FOLDER / each, folder)
                path = pathlib.Path(folder, name)
                path.write_text("stale")
                done = run("--check", "--folder", folder)
                self.assertNotEqual(done.returncode, 0)
                self.assertIn(name, done.stdout)
                self.assertEqual(path.read_text(), "stale")
                self.assertEqual(run("--folder", folder).returncode, 0)
                self.assertEqual(path.read_bytes(), (FOLDER / name).read_bytes())


class Descriptor(unittest.TestCase):
    maxDiff = None

    def setUp(self):
        self.descriptor = json.loads((FOLDER / "filters.json").read_text(encoding="utf-8"))

    def test_has_the_documented_form(self):
        self.assertEqual(problems(self.descriptor), [])

    def test_ids_are_dispatched_in_the_source(self):
        source = (FOLDER / "anisosmoothfilterplugin.cpp").read_text(encoding="utf-8")
        self.assertIn(f'"{self.descriptor["pluginId"]}"', source)
        for filter_ in self.descriptor["filters"]:
            self.assertIn(f'"{filter_["id"]}"', source)

    def test_what_is_not_of_that_form_is_found(self):
        def spoil(change):
            spoilt = json.loads(json.dumps(self.descriptor))
            change(spoilt["filters"][0])
            return problems(spoilt)

        for change in (lambda one: one.update(id="Smooth It"), lambda one: one.update(shortDescription="**bold**"),
                       lambda one: one.update(categories=["Smoothing"]), lambda one: one.update(referenceIds=["nobody2020"]),
                       lambda one: one["parameters"][0].update(default=-1), lambda one: one["parameters"][0].update(help=" "),
                       lambda one: one["parameters"][0].update(type="float"),
                       lambda one: one.update(outputModifies=["VX"])):
            self.assertEqual(len(spoil(change)), 1)


if __name__ == "__main__":
    unittest.main()
