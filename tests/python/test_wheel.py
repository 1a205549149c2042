# SPDX-License-Identifier: GPL-3.0-or-later
import importlib.metadata
import pathlib
import sys

import anisosmooth


def test_what_the_wheel_fits():
    """Built by Python 3.12 or later it serves all later ones; before, one Python only."""
    (tag,) = [line.split()[1] for line in importlib.metadata.distribution("anisosmooth").read_text("WHEEL").splitlines()
              if line.startswith("Tag:")][:1]
    kind = tag.split("-")[:2]
    name = pathlib.Path(anisosmooth._core.__file__).name
    if sys.version_info >= (3, 12):
        assert kind == ["cp312", "abi3"] and name == "_core.abi3.so"
    else:
        assert kind == [f"cp3{sys.version_info.minor}"] * 2


def test_versions_agree():
    assert anisosmooth.__version__ == importlib.metadata.version("anisosmooth") == anisosmooth._core.version
