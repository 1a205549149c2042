# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether a program makes its files last: what record_flushes.cpp notes, and what has to be in it."""

import os


def recorded(library, log):
    """What makes a program write its record to `log`."""
    return {"LD_PRELOAD": str(library), "RECORD_FLUSHES": str(log)}


def renamed_files(test, log, folder):
    """The final paths of the files that were renamed, absolute, in their order. `folder` is the program's own. The test
    fails unless each was flushed after the last write and before it was renamed, and its folder afterwards."""
    with open(log) as file:
        events = [line.rstrip("\n").split(" ", 1) for line in file]
    result = []
    for at, (what, paths) in enumerate(events):
        if what != "rename":
            continue
        source, target = (os.path.realpath(os.path.join(folder, path)) for path in paths.split("\t"))
        before = [kind for kind, path in events[:at] if path == source]
        test.assertEqual(before[-1:], ["flush"], f"{source} is renamed to {target}; before: {before}")
        test.assertIn(["flush", os.path.dirname(target)], events[at + 1:], f"the folder of {target}")
        result.append(target)
    return result
