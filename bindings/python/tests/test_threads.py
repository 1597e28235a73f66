"""Other threads, signals, processes."""

from __future__ import annotations

import multiprocessing
import os
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import plateau_patches as pp

# Seconds of work: the films of a long, wavy loop.
LONG = """
import numpy as np, plateau_patches as pp
t = np.linspace(0, 2 * np.pi, 400, endpoint=False)
loop = np.stack([np.cos(t), np.sin(t), 0.5 * np.cos(9 * t)], axis=1)
"""


def test_other_threads_go_on(wave: np.ndarray) -> None:
    ticks, stop = [0], threading.Event()

    def tick() -> None:
        while not stop.wait(0.001):
            ticks[0] += 1

    thread = threading.Thread(target=tick)
    thread.start()
    film = pp.fill([wave], degree=12)
    stop.set()
    thread.join()
    assert ticks[0] > 5 and film.area > 0.0


def test_two_threads_compute_the_same(wave: np.ndarray) -> None:
    found: list[pp.Surface] = []
    threads = [threading.Thread(target=lambda: found.append(pp.fill([wave], degree=6))) for _ in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(found) == 2 and all((a == b).all() for a, b in zip(found[0].nets, found[1].nets))


@pytest.mark.skipif(os.name != "posix", reason="signals are sent as POSIX has them")
def test_ctrl_c_ends_the_work() -> None:
    code = LONG + "print('go', flush=True)\npp.fill([loop], degree=14)\nprint('ended by itself')\n"
    child = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    assert child.stdout is not None and child.stdout.readline() == "go\n"
    time.sleep(0.5)
    child.send_signal(signal.SIGINT)
    out, err = child.communicate(timeout=60)
    assert "KeyboardInterrupt" in err and "ended by itself" not in out
    assert child.returncode == -signal.SIGINT or child.returncode == 130


@pytest.mark.skipif(os.name != "posix", reason="signals are sent as POSIX has them")
def test_work_that_was_left_does_not_hinder_the_next() -> None:
    # A bound of degree 24 is one long step, during which nobody asks; the surface before it takes as long as the timer or less.
    code = """
import os, signal, threading, numpy as np, plateau_patches as pp
square = [[0, 0, 0], [1, 0, 0], [1, 1, 1], [0, 1, 0]]
threading.Timer(0.4, os.kill, (os.getpid(), signal.SIGINT)).start()
try:
    pp.fill(square, degree=24, bound=True)
    print("ended by itself")
except KeyboardInterrupt:
    print("interrupted", f"{pp.fill(square, degree=6).area:.6f}", flush=True)
os._exit(0)
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=60)
    assert done.stdout == "interrupted 1.279262\n"


def test_progress_is_told_and_may_end_the_work() -> None:
    class Enough(Exception):
        pass

    told: list[tuple[str, int, int | None]] = []

    def progress(what: str, done: int, of: int | None) -> None:
        told.append((what, done, of))
        raise Enough

    t = np.linspace(0.0, 2.0 * np.pi, 300, endpoint=False)
    sides = [[[0, 0, 0], [2, 0, 2], [4, 0, -2], [6, 0, 0]], [[0, 6, 0], [2, 6, 2], [4, 6, -2], [6, 6, 0]]]
    sides += [[[0, 0, 0], [0, 2, 2], [0, 4, -2], [0, 6, 0]], [[6, 0, 0], [6, 2, 2], [6, 4, -2], [6, 6, 0]]]
    with pytest.raises(Enough):
        pp.gt(*sides, degree=9, runs=200, iterations=400, progress=progress)
    assert len(told) == 1 and told[0][0]
    told.clear()
    loop = np.stack([np.cos(t), np.sin(t), 0.5 * np.cos(9.0 * t)], axis=1)
    with pytest.raises(Enough):
        pp.fill(loop, degree=14, name="rim", progress=progress)
    assert [what for what, *_ in told] == ["filling of rim"]


def _area(degree: int) -> float:
    return pp.fill([[[0, 0, 0], [1, 0, 0], [1, 1, 1], [0, 1, 0]]], degree=degree).area


@pytest.mark.skipif(sys.platform != "linux", reason="other systems do not fork")
@pytest.mark.filterwarnings("ignore:.*fork.*:DeprecationWarning")
def test_forked_processes_compute() -> None:
    expected = [_area(degree) for degree in (3, 4)]
    with multiprocessing.get_context("fork").Pool(2) as pool:
        assert pool.map(_area, (3, 4)) == expected


def test_processes_take_and_give_surfaces(wave: np.ndarray) -> None:
    film = pp.fill(wave, degree=4)
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        assert pool.apply(_same, (film,)) == film


def _same(film: pp.Surface) -> pp.Surface:
    return film
