# SPDX-License-Identifier: GPL-3.0-or-later
import pathlib

import anisosmooth
from anisosmooth import _stub


def test_stub_is_current():
    """Else: python -m anisosmooth._stub > python/anisosmooth/__init__.pyi"""
    assert pathlib.Path(anisosmooth.__file__).with_name("__init__.pyi").read_text() == _stub.stub()


def test_help_names_every_parameter():
    for method, entry in anisosmooth._smooth.CATALOGUE.items():
        for row in anisosmooth._smooth.parameters_of(method):
            assert f"{row['name']} : " in anisosmooth.smooth.__doc__
            assert row["help"] in anisosmooth.smooth.__doc__
