"""Cycles between the points of the grid, where a measure is smallest.

The smallest value of a measure over a group mostly lies where the grid has no point: at the fold that bounds
the group, or where two multipliers pass each other in modulus. It is approached from the grid's smallest by
looking at springs around it, again and again, each time more closely around the best so far.
"""

from collections.abc import Iterator

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from stridemap.solver.branches.main_branch import LINK, walks
from stridemap.solver.cycles.search import offer, section_point
from stridemap.solver.model.model import Model
from stridemap.sweeps.tables import orbit_row

Floats = NDArray[np.float64]

SMALLEST = ("spectral_radius", "d_max", "cot", "cot_per_speed")
"""Measures whose smallest values the statements speak of."""

LOOKS, ASIDE = 6, 4
"""How often it is looked, and at how many springs on either side. A spacing of 0.1 becomes 3e-5."""


def between(model: Model, lines: pd.DataFrame, grid: Floats) -> pd.DataFrame:
    """Cycles around the smallest value of each measure, for stable cycles and the main branch of each group.

    Parameters
    ----------
    model : Model
    lines : DataFrame
        Cycles that count, at pairs of alpha and omega, with the column ``main``.
    grid : ndarray, shape (n,)
        Every value of `k` that was searched, ascending.

    Returns
    -------
    DataFrame
        Rows as of `lines`, without the columns of time profiles, and with -1 for their cell.
    """
    starts = list(_starts(lines))
    columns = [*orbit_columns(lines, model), "main"]
    if not starts or len(grid) < 2:
        return lines.loc[[], columns]
    best = pd.DataFrame([row for row, _, _ in starts]).reset_index(drop=True)
    measure, must_be_stable = [name for _, name, _ in starts], np.array([only for _, _, only in starts])
    reach, found = float(np.diff(grid).max()), [best.iloc[:0]]
    for _ in range(LOOKS):
        reach /= ASIDE
        aside = reach * np.array([i for i in range(-ASIDE, ASIDE + 1) if i])
        trial = best.loc[best.index.repeat(len(aside))]
        k = (best["k"].to_numpy()[:, None] + aside).ravel()
        inside = (k >= grid[0]) & (k <= grid[-1])
        trial, k, owner = trial[inside], k[inside], np.repeat(np.arange(len(best)), len(aside))[inside]
        rows, owner = _solved(model, trial.assign(k=k), owner, must_be_stable)
        found.append(rows)
        best = _best(best, rows, owner, measure)
    every = pd.concat(found, ignore_index=True)[columns]
    return every.drop_duplicates(["k", "alpha", "omega", "period"], ignore_index=True)


def orbit_columns(lines: pd.DataFrame, model: Model) -> list[str]:
    """Those columns of a table of cycles that a sweep gives it."""
    names = [parameter.name for parameter in model.parameters]
    last = lines.columns.get_loc("integration_error")
    return ["cell", *names, *[c for c in lines.columns[: last + 1] if c not in ("cell", *names)]]


def _starts(lines: pd.DataFrame) -> Iterator[tuple[pd.Series, str, bool]]:
    """The grid's smallest of each measure: its row, the measure, and whether it is one of stable cycles."""
    for _, group in lines.groupby(["alpha", "omega", "group"]):
        for keep, only_stable in (("stable", True), ("main", False)):
            rows = group[group[keep].astype(bool)]
            if len(rows):
                for measure in SMALLEST:
                    yield rows.loc[rows[measure].idxmin()], measure, only_stable


def _solved(
    model: Model, trial: pd.DataFrame, owner: NDArray[np.int64], must_be_stable: NDArray[np.bool_]
) -> tuple[pd.DataFrame, NDArray[np.int64]]:
    """Cycles at other springs that continue those of a table, and whose they are."""
    points = trial[[parameter.name for parameter in model.parameters]].to_numpy(dtype=np.float64)
    guesses = trial[[*model.section, "period"]].to_numpy(dtype=np.float64)
    rows, owners = [], []
    before = zip(trial["group"], trial["main"], guesses, owner.tolist(), strict=True)
    for orbit, (group, main, guess, i) in zip(offer(model, points, guesses), before, strict=True):
        if not walks(orbit) or orbit.group != group or (must_be_stable[i] and not orbit.stable):
            continue
        if np.abs(np.array(section_point(orbit)) - guess).max() < LINK:
            rows.append({**orbit_row(-1, orbit), "main": main})
            owners.append(i)
    return pd.DataFrame(rows, columns=trial.columns), np.array(owners, dtype=np.int64)


def _best(
    best: pd.DataFrame, rows: pd.DataFrame, owner: NDArray[np.int64], measure: list[str]
) -> pd.DataFrame:
    """For each start the smallest so far."""
    out = []
    for i, name in enumerate(measure):
        mine = rows[owner == i]
        better = len(mine) and mine[name].min() < best[name].iloc[i]
        out.append(mine.loc[mine[name].astype(float).idxmin()] if better else best.iloc[i])
    return pd.DataFrame(out).reset_index(drop=True)
