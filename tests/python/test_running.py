# SPDX-License-Identifier: GPL-3.0-or-later
"""While it works: the interpreter goes on, Ctrl+C and progress end it, threads do not change the result."""

import os
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import anisosmooth
from conftest import noisy, torus


@pytest.fixture(scope="module")
def large():
    points, faces = torus(900, 300)
    return noisy(points, 0.002), faces


def test_other_threads_go_on(large):
    done = threading.Event()
    thread = threading.Thread(target=lambda: (anisosmooth.smooth(*large, threads=1), done.set()))
    counted = 0
    thread.start()
    while not done.is_set():
        counted += 1
        time.sleep(0.001)
    thread.join()
    assert counted > 20  # with the interpreter's lock held it would be one or two


def test_two_at_once_give_the_same(mesh):
    expected = anisosmooth.smooth(*mesh[:2], threads=1)
    results = [None] * 4

    def work(i):
        results[i] = anisosmooth.smooth(*mesh[:2], threads=i + 1)

    threads = [threading.Thread(target=work, args=(i,)) for i in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for result in results:
        np.testing.assert_array_equal(result, expected)


def test_progress_rises_to_one(mesh):
    calls = []
    anisosmooth.smooth(*mesh[:2], progress=lambda fraction, stage: calls.append((fraction, stage)))
    fractions = [fraction for fraction, _ in calls]
    assert fractions == sorted(fractions) and fractions[-1] == 1
    assert all(isinstance(stage, str) and stage for _, stage in calls)


@pytest.mark.parametrize("function", ["smooth", "distance", "estimate_noise"])
def test_progress_cancels(function, mesh):
    arguments = (0,) if function == "distance" else ()
    call = getattr(anisosmooth, function)
    with pytest.raises(anisosmooth.Cancelled):
        call(*mesh[:2], *arguments, progress=lambda fraction, stage: False)
    with pytest.raises(ZeroDivisionError):
        call(*mesh[:2], *arguments, progress=lambda fraction, stage: 1 / 0)


@pytest.mark.parametrize("method", ["guided", "paper"])
def test_ctrl_c(method):
    script = (
        "import sys; sys.path.insert(0, sys.argv[1])\n"
        "import signal, time, anisosmooth\n"
        "from conftest import torus\n"
        "signal.signal(signal.SIGINT, signal.default_int_handler)\n"  # a shell's background commands ignore it
        "V, F = torus(2000, 600)\n"
        "print('ready', flush=True)\n"
        "try:\n"
        f"    anisosmooth.smooth(V, F, {method!r}, iterations=50)\n"
        "except KeyboardInterrupt:\n"
        "    print(time.time(), flush=True)\n"
    )
    process = subprocess.Popen(
        [sys.executable, "-c", script, os.path.dirname(__file__)], stdout=subprocess.PIPE, text=True
    )
    assert process.stdout.readline() == "ready\n"
    time.sleep(1.5)
    sent = time.time()
    process.send_signal(signal.SIGINT)
    output, _ = process.communicate(timeout=60)
    assert process.returncode == 0 and output, "it ended before it was interrupted"
    assert float(output) - sent < 2  # 0.2 s, and what a busy machine adds
