# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables between marks in the document."""

import re
import sys

from .runs import DOCUMENT


def replace(document, name, text):
    marks = re.compile(rf"(<!-- scripts/guided_benchmark: {name} -->\n).*?(<!-- end -->)", re.DOTALL)
    if not marks.search(document):
        sys.exit(f"guided_benchmark: {DOCUMENT} has lost its marks for {name}")
    return marks.sub(lambda m: m.group(1) + "\n" + text + "\n" + m.group(2), document)
