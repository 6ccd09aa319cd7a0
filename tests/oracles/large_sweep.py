"""A sweep of a hundred thousand cycles that nobody computed, for the size and the speed of the page."""

import numpy as np
import pandas as pd

from stridemap.solver.model.loading import load
from stridemap.sweeps.tables import FORMAT
from stridemap.views.report.shown import Shown

OMEGAS = 5


def large_sweep(cycle, cycles=100_000, seed=1):
    """What `read_shown` gives, made up from one computed cycle of the walker: all of its digits are random.

    Parameters
    ----------
    cycle : Series
        A row of ``orbits.parquet`` from which every row is made, within a few per cent; so they can be drawn.
    cycles : int
        How many; two in each cell.
    """
    model, rng = load("wobbling"), np.random.default_rng(seed)
    n_cells = cycles // 2
    n_alpha = 50
    n_k = n_cells // (n_alpha * OMEGAS)
    grid = {
        "k": np.linspace(60 / n_k, 60, n_k).round(6).tolist(),
        "alpha": np.linspace(0.02, 0.96, n_alpha).round(6).tolist(),
        "omega": np.linspace(2.0, 3.0, OMEGAS).tolist(),
    }
    points = np.stack(np.meshgrid(*grid.values(), indexing="ij"), -1).reshape(-1, 3)
    cell = np.repeat(np.arange(n_cells), 2)
    columns = {"cell": cell, **dict(zip(grid, points[cell].T, strict=True))}
    for name, value in cycle.items():
        if name in columns:
            continue
        number = isinstance(value, float | np.floating)
        same = name in model.preset or not number
        columns[name] = np.full(cycles, value) if same else value * rng.uniform(0.97, 1.03, cycles)
    orbits = pd.DataFrame(columns)
    radius = rng.uniform(0.3, 1.7, cycles)
    orbits["spectral_radius"], orbits["stable"] = radius, radius < 1
    orbits.loc[radius > 1, "cot"] *= 10
    orbits["branch"] = rng.integers(0, 300, cycles)
    orbits["group"] = rng.choice(list("ABCDEFGH"), cycles)
    for i in range(len(model.section)):
        orbits[f"multiplier_{i}_re"] = rng.uniform(-1, 1, cycles)
        orbits[f"multiplier_{i}_im"] = rng.uniform(-1, 1, cycles) if i < 4 else 0.0
    cells = pd.DataFrame(dict(zip(grid, points.T, strict=True)) | {"status": "found", "reason": None})
    fixed = {name: value for name, value in model.preset.items() if name not in grid}
    configuration = {"model": "wobbling", "grid": grid, "params": fixed, "search": {}}
    provenance = {
        "configuration": configuration, "versions": {}, "format": FORMAT, "model": "wobbling",
        "model_hash": model.hash, "configuration_hash": "0" * 64, "commit": None, "compiler": None,
        "arithmetic": None,
    }  # fmt: skip
    return Shown(model, provenance, grid, orbits, cells, len(orbits), len(cells))
