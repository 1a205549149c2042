# SPDX-License-Identifier: GPL-3.0-or-later
"""What describe_plugin says of a plugin."""

import json
import subprocess


def describe(program, plugin):
    """The plugin's filters, each a dictionary. What MeshLab prints itself, before them and on stderr, is passed over."""
    printed = subprocess.run([program, plugin], check=True, stdout=subprocess.PIPE, text=True, timeout=100).stdout
    return json.loads(printed[printed.index("[\n"):])
