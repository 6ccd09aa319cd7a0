"""How the cost of a sweep grows with its cells: ``python -m benchmarks.cells [--cells 10000 1000000]``.

Swept is the compass gait on a slope, over its three parameters where it walks. Each sweep runs in processes
of its own. A row says how many cells and limit cycles it had, the processor time of all processes, that time
per cell, and the most memory that the sweeping process and any of its workers took.
"""

import argparse
import resource
import subprocess
import sys
import tempfile

import stridemap
from benchmarks.large_tables import memory

MODEL = "goswami_compass"
RANGES = {"mu": (1.0, 4.0), "beta": (0.5, 2.0), "slope": (0.02, 0.08)}


def grid(cells: int) -> dict[str, dict[str, float | int]]:
    """About so many cells."""
    n = round(cells ** (1 / 3))
    return {name: {"start": low, "stop": high, "num": n} for name, (low, high) in RANGES.items()}


def one_sweep(cells: int, workers: int) -> str:
    """Sweep in this process and its workers, and say what it took."""
    config = {
        "model": MODEL,
        "grid": grid(cells),
        "search": {"starts": 24, "subgrid": 4},
        "special_points": False,
    }
    with tempfile.TemporaryDirectory() as folder:
        done = stridemap.sweep(config, f"{folder}/out", workers=workers)
    own, others = (resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    seconds = sum(one.ru_utime + one.ru_stime for one in (own, others))
    most = f"{memory('VmHWM'):10,.0f} MB{others.ru_maxrss / 1024:10,.0f} MB"
    return f"{done.cells:12,}{done.orbits:12,}{seconds:10,.1f} s{1000 * seconds / done.cells:8.2f} ms{most}"


def main() -> None:
    """Run the sweeps, the smallest first."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--cells", type=int, nargs="+", default=[10_000, 100_000, 1_000_000])
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--one", type=int, help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.one:
        print(one_sweep(options.one, options.workers))
        return
    stridemap.find_orbits(MODEL)  # so that no sweep compiles
    print(f"{'cells':>12}{'cycles':>12}{'time':>12}{'per cell':>11}{'sweep':>13}{'worker':>13}", flush=True)
    for cells in options.cells:
        words = ["--one", str(cells), "--workers", str(options.workers)]
        subprocess.run([sys.executable, "-m", "benchmarks.cells", *words], check=True)


if __name__ == "__main__":
    main()
