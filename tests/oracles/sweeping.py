"""What the tests of the command line and of running sweeps share."""

import hashlib
import os
import pickle
import subprocess
import sys
import time
from concurrent.futures import Executor, Future
from typing import ClassVar

from stridemap.sweeps.config import parse_config
from stridemap.sweeps.run import sweep

K, ALPHA = (0.5, 2.0, 6.0, 22.5), (0.2, 0.25)
CONFIG = parse_config(
    {
        "model": "wobbling",
        "grid": {"k": K, "alpha": ALPHA},
        "search": {"starts": 8, "subgrid": 2},
        "continuation": {"max_steps": 10},  # finds what the default does, in half the time
    }
)
"""Eight cells; alpha = 0.25 with the preset is where the reference orbits are."""

SMALL = 'model = "compass"\n[grid]\nomega = [2.5, 3.0]\n[search]\nstarts = 16\n'

LARGER = """model = "compass"
[grid]
omega = { start = 2.4, stop = 3.6, num = 12 }
gamma = [0.18, 0.2]
[search]
starts = 16
subgrid = 1
"""
"""Enough pieces that a sweep of it can be stopped between two of them."""

STRIDEMAP = [sys.executable, "-m", "stridemap"]

IN_PIECES = """
import os, signal, sys, time
signal.signal(signal.SIGINT, signal.default_int_handler)  # not so where the tests run in the background
import stridemap.sweeps.run as run
from stridemap.cli.app import main
sys.argv += ["--tile-cells", "2"]
write = run.Store.write_part
def write_and_rest(*args):
    write(*args)
    time.sleep(float(os.environ["REST"]))
run.Store.write_part = write_and_rest
main()
"""
"""The command line with a sweep in small pieces and a rest after each, so that it can be stopped between."""


class Inline(Executor):
    """Computes a task where it is submitted, and remembers it."""

    def __init__(self):
        self.tasks = []

    def submit(self, fn, /, *args, **kwargs):
        self.tasks.append(args[0])
        future = Future()
        try:
            future.set_result(self.result(fn, *args, **kwargs))
        except BaseException as error:
            future.set_exception(error)
        return future

    def result(self, fn, *args, **kwargs):
        return fn(*args, **kwargs)

    @property
    def pieces(self):
        """Round and tile of what was computed."""
        return [(task.round, task.tile) for task in self.tasks]


class Remembering(Inline):
    """Computes a task where it is submitted, unless one of the same bytes was computed in this process.

    For tests of who hands out what, and in which order. That other processes and threads compute the same
    is tested without it.
    """

    known: ClassVar[dict[str, bytes]] = {}

    def result(self, fn, *args, **kwargs):
        key = hashlib.sha256(pickle.dumps((fn, args, kwargs))).hexdigest()
        if key not in self.known:
            self.known[key] = pickle.dumps(fn(*args, **kwargs))
        return pickle.loads(self.known[key])


def uninterrupted(folder):
    """The sweep of CONFIG in tiles of 2: its folder, summary, progress, and the pieces that were computed."""
    seen, executor = [], Remembering()
    summary = sweep(CONFIG, folder, executor=executor, tile_cells=2, progress=seen.append)
    return folder, summary, seen, executor.pieces


def content(folder):
    """Bytes of every file below a folder."""
    return {str(p.relative_to(folder)): p.read_bytes() for p in sorted(folder.rglob("*")) if p.is_file()}


def tables(folder):
    """Bytes of the tables of a finished sweep, which has no other files."""
    found = content(folder)
    assert set(found) == {"orbits.parquet", "cells.parquet", "special.parquet"}
    return found


def parts(folder):
    """Finished pieces of an unfinished sweep."""
    return sorted((folder / "parts").glob("round-*.parquet"))


def piece(part):
    """Round and tile of a part file."""
    _, round_, _, tile = part.stem.split("-")
    return int(round_), int(tile)


def start(command, **environment):
    """Start a command in a process group of its own."""
    return subprocess.Popen(
        command, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
        start_new_session=True, env={**os.environ, **environment},
    )  # fmt: skip


def ended(process, timeout=120):
    """Exit status, standard output and standard error of a process, once it has ended."""
    out, err = process.communicate(timeout=timeout)
    return process.returncode, out, err


def wait_for(condition, process, timeout=120):
    """Wait until something is so, while a process runs."""
    limit = time.monotonic() + timeout
    while not condition():
        assert process.poll() is None, process.communicate()
        assert time.monotonic() < limit
        time.sleep(0.005)
