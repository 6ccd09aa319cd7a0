"""What share of all limit cycles a sweep finds: ``python -m benchmarks.recall``.

Random cells of a finished sweep are searched by brute force: many independent random starts per cell
(pseudo-random, from a larger box than the sweep's), with no help from neighbours. All cycles of a cell are
those that either found. Counted are cycles that are forward and physical: 0.3 < T <= 3, positive speed,
positive vertical force.
"""

import argparse
from collections.abc import Iterable
from pathlib import Path

import numpy as np
import pandas as pd

import stridemap
from stridemap.solver.cycles.duplicates import DUPLICATE, distinct
from stridemap.solver.cycles.orbits import Orbits
from stridemap.solver.cycles.search import merged
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.model.loading import load
from stridemap.solver.model.model import Model
from stridemap.sweeps.config import SweepConfig, load_config

WIDER = 2.0
"""The brute force's box of starts, in terms of the sweep's."""


def random_starts(model: Model, config: SweepConfig, n: int, rng: np.random.Generator) -> np.ndarray:
    """Pseudo-random starts, shape (n, nz + 1): half of them evenly over the box, half around its middle."""
    box = np.array([model.spec.search_box[name] for name in model.section])
    unit = rng.uniform(-1, 1, (n, len(box)))
    unit[::2] **= 3
    period = rng.uniform(config.search.period_min, config.search.period_max, (n, 1))
    return np.hstack([box[:, 0] + WIDER * box[:, 1] * unit, period])


def brute_force(
    solver: Solver, point: np.ndarray, guesses: np.ndarray, period_range: tuple[float, float]
) -> Orbits:
    """All cycles that Newton's method reaches at one point from the guesses."""
    points = np.broadcast_to(point, (len(guesses), len(point)))
    u, closed = solver.search(guesses, points)
    _, u = distinct(np.zeros(closed.sum(), dtype=np.int64), u[closed])
    orbits = solver.converge(u, points[: len(u)], period_range)
    return merged(np.zeros(len(orbits), dtype=np.int64), orbits)[1]


def _match(one: np.ndarray, others: Iterable[np.ndarray]) -> bool:
    return any(np.abs(one - other).max() <= DUPLICATE for other in others)


def measure(
    config: SweepConfig, orbits: pd.DataFrame, cells: pd.DataFrame, n: int, starts: int, seed: int
) -> pd.DataFrame:
    """Compare sweep and brute force on `n` random cells.

    Returns
    -------
    pandas.DataFrame
        One row per cell: parameters, `sweep`, `brute`, `all` (numbers of cycles) and `missed` (periods).
    """
    model = load(config.model)
    solver = Solver.for_model(model)
    rng = np.random.default_rng(seed)
    columns = [*model.section, "period"]
    physical = orbits[(orbits["min_vertical_force"] > 0) & (orbits["speed"] > 0)]
    period_range = (config.search.period_min, config.search.period_max)
    rows = []
    for cell in rng.choice(len(cells), size=min(n, len(cells)), replace=False):
        point = cells.loc[cell, list(model.preset)].to_numpy(dtype=float)
        found = list(physical.loc[physical["cell"] == cell, columns].to_numpy())
        guesses = random_starts(model, config, starts, rng)
        orbits_here = brute_force(solver, point, guesses, period_range)
        brute = list(orbits_here.u[(orbits_here.min_vertical_force > 0) & (orbits_here.speed > 0)])
        missed = [u for u in brute if not _match(u, found)]
        rows.append(
            {
                "cell": cell,
                **dict(zip(model.preset, point, strict=True)),
                "sweep": len(found),
                "brute": len(brute),
                "all": len(found) + len(missed),
                "missed": [float(u[-1]) for u in missed],
            }
        )
    return pd.DataFrame(rows)


def main() -> None:
    """Print the share found, and every cycle that was missed."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--config", default="sweeps/paper.toml")
    parser.add_argument(
        "--sweep", default="results/paper", help="folder of the finished sweep; swept first if there is none"
    )
    parser.add_argument("--cells", type=int, default=150)
    parser.add_argument("--starts", type=int, default=600)
    parser.add_argument("--seed", type=int, default=0)
    options = parser.parse_args()
    config = load_config(options.config)
    if not Path(options.sweep, "cells.parquet").exists():
        print(f"No finished sweep in {options.sweep}: sweeping {options.config} first ...", flush=True)
        stridemap.sweep(config, options.sweep, resume=True)
    orbits, cells = stridemap.read_orbits(options.sweep), stridemap.read_cells(options.sweep)
    table = measure(config, orbits, cells, options.cells, options.starts, options.seed)
    missed = table[table["missed"].map(len) > 0]
    for _, row in missed.iterrows():
        where = ", ".join(f"{name} = {row[name]:.6g}" for name in config.grid)
        print(f"missed at {where}: periods {', '.join(f'{t:.6f}' for t in row['missed'])}")
    total, swept, brute = int(table["all"].sum()), int(table["sweep"].sum()), int(table["brute"].sum())
    print(f"{len(table)} random cells, {options.starts} random starts each (seed {options.seed})")
    print(f"cycles: {total} in all, {swept} found by the sweep, {brute} by brute force")
    share = 100 / max(total, 1)
    print(f"recall of the sweep: {share * swept:.2f} %, of brute force: {share * brute:.2f} %")


if __name__ == "__main__":
    main()
