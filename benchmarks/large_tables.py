"""Memory of large tables: ``python -m benchmarks.large_tables [--cells 1000000]``.

A sweep of so many cells with made-up tiles, of three limit cycles in most cells, is written and read. Each
row says how much more memory a process took at most than it had after importing what it needs, its
processor time, and the size of what it wrote.
"""

import argparse
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import stridemap
from stridemap.solver.model.loading import load
from stridemap.sweeps.config import SweepConfig, parse_config
from tests.oracles.made_up_tiles import MadeUp

WHERE = "stable and k < 10 and speed > 1.5"


def config(cells: int) -> SweepConfig:
    """A grid of about so many cells."""
    n = round(cells ** (1 / 3))
    grid = {
        "k": {"start": 0.5, "stop": 60.0, "num": n},
        "alpha": {"start": 0.05, "stop": 0.9, "num": n},
        "omega": {"start": 2.0, "stop": 4.0, "num": n},
    }
    return parse_config({"model": "wobbling", "grid": grid, "special_points": False})


def write(folder: Path, cells: int) -> Path:
    """Run a sweep of made-up tiles."""
    stridemap.sweep(config(cells), folder / "sweep", executor=MadeUp())
    return folder / "sweep" / "orbits.parquet"


def read(folder: Path, _: int) -> None:
    """Read all limit cycles."""
    stridemap.read_table(folder / "sweep")


def select(folder: Path, _: int) -> None:
    """Read three columns of those rows for which a condition holds."""
    stridemap.read_table(folder / "sweep", columns=["k", "alpha", "cot"], where=WHERE)


def batches(folder: Path, _: int) -> None:
    """Go through all limit cycles batch by batch."""
    for _table in stridemap.read_batches(folder / "sweep"):
        pass


def command(*words: str) -> None:
    """A command in this process."""
    from stridemap.cli.app import app

    app([*words, "--quiet"], standalone_mode=False)


def export_csv(folder: Path, _: int) -> Path:
    """``stridemap export --to csv``."""
    command("export", str(folder / "sweep"), "--out", str(folder / "o.csv"))
    return folder / "o.csv"


def export_parquet(folder: Path, _: int) -> Path:
    """``stridemap export --where``."""
    command("export", str(folder / "sweep"), "--out", str(folder / "o.parquet"), "--where", WHERE)
    return folder / "o.parquet"


def plot(folder: Path, _: int) -> Path:
    """``stridemap plot --where``."""
    words = ("--x", "k", "--y", "cot", "--colour", "spectral_radius", "--where", WHERE)
    command("plot", str(folder / "sweep"), *words, "--out", str(folder / "p.png"))
    return folder / "p.png"


def report(folder: Path, _: int) -> Path:
    """``stridemap report``."""
    command("report", str(folder / "sweep"), "--out", str(folder / "report.html"))
    return folder / "report.html"


STEPS: dict[str, Callable[[Path, int], Path | None]] = {
    one.__name__: one for one in (write, read, select, batches, export_csv, export_parquet, plot, report)
}


def memory(key: str) -> float:
    """MB of this process: now (VmRSS), or at most (VmHWM)."""
    lines = Path("/proc/self/status").read_text().splitlines()
    return next(int(line.split()[1]) for line in lines if line.startswith(key)) / 1024


def one_step(name: str, folder: Path, cells: int) -> str:
    """Run one step in this process and say what it took."""
    import matplotlib.figure  # noqa: F401
    import scipy.sparse  # noqa: F401

    import stridemap.cli.app
    import stridemap.sweeps.run
    import stridemap.views  # noqa: F401

    load("wobbling")
    before, start = memory("VmRSS"), time.process_time()
    written = STEPS[name](folder, cells)
    seconds, most = time.process_time() - start, memory("VmHWM")
    size = "" if written is None else f"{os.path.getsize(written) / 1e6:10,.1f} MB"
    return f"{name:15}{before:10,.0f} MB{most - before:10,.0f} MB{seconds:8,.1f} s{size}"


def main() -> None:
    """Run the steps, each in a process of its own."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--cells", type=int, default=1_000_000)
    parser.add_argument("--only", nargs="*", default=list(STEPS), choices=list(STEPS))
    parser.add_argument("--folder", type=Path, help="keep the files there")
    parser.add_argument("--step", help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.step:
        print(one_step(options.step, options.folder, options.cells))
        return
    with tempfile.TemporaryDirectory() as temporary:
        folder = options.folder or Path(temporary)
        print(f"{'':15}{'at first':>13}{'more':>13}{'time':>10}{'size':>13}", flush=True)
        for name in options.only:
            words = ["--step", name, "--folder", str(folder), "--cells", str(options.cells)]
            subprocess.run([sys.executable, "-m", "benchmarks.large_tables", *words], check=True)


if __name__ == "__main__":
    main()
