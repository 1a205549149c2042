# SPDX-License-Identifier: GPL-3.0-or-later
"""A locale whose numbers have a comma, de_DE.UTF-8, made for the tests without a change of the system."""

import os
import pathlib
import subprocess
import unittest

NAME = "de_DE.UTF-8"
SOURCE = "/usr/share/i18n/locales/de_DE"  # of Debian's package locales


def environment(folder):
    """What makes a program take the locale, which is put into `folder`; skips the test where its source is missing."""
    if not os.path.exists(SOURCE):
        raise unittest.SkipTest(f"no {SOURCE}: Debian's package locales is missing")
    folder = pathlib.Path(folder).absolute()
    folder.mkdir(parents=True, exist_ok=True)
    if not (folder / NAME).exists():
        subprocess.run(["localedef", "-i", "de_DE", "-f", "UTF-8", folder / NAME], check=True, capture_output=True)
    variables = {"LC_ALL": NAME, "LOCPATH": str(folder)}
    shown = subprocess.run(["locale", "decimal_point"], check=True, capture_output=True, text=True,
                           env={**os.environ, **variables}).stdout
    if shown != ",\n":
        raise AssertionError(f"the locale {NAME} in {folder} is not taken: its decimal point is {shown!r}")
    return variables
