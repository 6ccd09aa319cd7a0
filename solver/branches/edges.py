"""Where stable cycles begin and end in `k`: runs on the grid, with ends bisected between its points."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from stridemap.solver.branches.main_branch import walks
from stridemap.solver.cycles.orbit import Orbit
from stridemap.solver.cycles.search import offer
from stridemap.solver.model.model import Model

Floats = NDArray[np.float64]

BISECTIONS = 8
"""A spacing of 0.1 becomes 0.0004."""

COLUMNS = ("alpha", "omega", "group", "k_grid", "side", "k")
"""Columns of a table of edges: the last grid point with a stable cycle, the side of it on which the edge is
(-1 or 1), and the edge."""


@dataclass(frozen=True)
class Run:
    """A range of `k` with stable cycles of one group.

    Parameters
    ----------
    low, high : float
        The first and the last grid point with one.
    opens, closes : float
        Their edges, as near as they are known.
    cut_low, cut_high : bool
        Whether it reaches the end of what was swept, so that it may go on beyond.
    """

    low: float
    high: float
    opens: float
    closes: float
    cut_low: bool
    cut_high: bool

    @property
    def width(self) -> float:
        """Length of the range."""
        return self.closes - self.opens


def runs(grid: Floats, stable: Floats) -> list[tuple[int, int]]:
    """First and last index in `grid` of each run of consecutive values that are all among `stable`."""
    inside = np.isin(grid, stable).astype(int)
    step = np.diff(np.concatenate([[0], inside, [0]]))
    first, last = np.flatnonzero(step > 0), np.flatnonzero(step < 0) - 1
    return list(zip(first.tolist(), last.tolist(), strict=True))


def stable_runs(orbits: pd.DataFrame, grid: Floats, edges: pd.DataFrame) -> list[Run]:
    """The ranges with stable cycles among `orbits`, which are of one group at one alpha and omega.

    Parameters
    ----------
    orbits : DataFrame
    grid : ndarray
        Every value of `k` that was searched, ascending.
    edges : DataFrame
        Bisected edges of that group, as from `bisected`; where one is missing, the grid point stands for it.
    """
    known = {(row.k_grid, row.side): row.k for row in edges.itertuples()}
    out = []
    for i, j in runs(grid, orbits["k"][orbits["stable"]].to_numpy()):
        low, high = float(grid[i]), float(grid[j])
        opens, closes = known.get((low, -1), low), known.get((high, 1), high)
        out.append(Run(low, high, opens, closes, i == 0, j == len(grid) - 1))
    return out


def bisected(model: Model, orbits: pd.DataFrame, grid: Floats) -> pd.DataFrame:
    """Every edge of stable cycles between two points of a grid of `k`, by bisection.

    From the cycle at the edge's grid point one is sought half way to the next grid point: if it is there,
    stable and of the same group, the edge is beyond, and so on. Whether the cycle turns unstable there or
    ends in a fold makes no difference. Where there are two such cycles, the one that reaches further counts.

    Parameters
    ----------
    model : Model
    orbits : DataFrame
        Cycles that count, at pairs of alpha and omega.
    grid : ndarray
        Every value of `k` that was searched, ascending.
    """
    stable = orbits[orbits["stable"]]
    starts: list[pd.DataFrame] = []
    for _, cycles in stable.groupby(["alpha", "omega", "group"]):
        for i, j in runs(grid, cycles["k"].to_numpy()):
            for index, side in ((i, -1), (j, 1)):
                if 0 <= index + side < len(grid):
                    here = cycles[cycles["k"] == grid[index]]
                    starts.append(here.assign(side=side, outside=grid[index + side]))
    if not starts:
        return pd.DataFrame({name: [] for name in COLUMNS})
    table = pd.concat(starts, ignore_index=True).rename(columns={"k": "k_grid"})
    reached = table.assign(k=_bisect(model, table.assign(k=table["k_grid"]), table["outside"].to_numpy()))
    reach = (reached["k"] - reached["k_grid"]) * reached["side"]
    last = reached.loc[reach.groupby([reached[name] for name in COLUMNS[:-1]]).idxmax().sort_values()]
    return last[list(COLUMNS)].reset_index(drop=True)


def _bisect(model: Model, table: pd.DataFrame, outside: Floats) -> Floats:
    """The last `k` towards `outside` at which each cycle of a table was found stable, shape (n,)."""
    params = table[[parameter.name for parameter in model.parameters]].to_numpy(dtype=np.float64, copy=True)
    column = [parameter.name for parameter in model.parameters].index("k")
    guesses = table[[*model.section, "period"]].to_numpy(dtype=np.float64, copy=True)
    inside, outside = params[:, column].copy(), outside.copy()
    for _ in range(BISECTIONS):
        middle = (inside + outside) / 2
        params[:, column] = middle
        found = offer(model, params, guesses)
        good = _still(found, table["group"].tolist())
        inside, outside = np.where(good, middle, inside), np.where(good, outside, middle)
        for i in np.flatnonzero(good):
            guesses[i] = [*found[i].state.values(), found[i].period]
    return inside


def _still(found: Sequence[Orbit], groups: Sequence[str]) -> NDArray[np.bool_]:
    """Whether each orbit is one that counts, stable and of its group."""
    return np.array(
        [walks(o) and o.stable and o.group == group for o, group in zip(found, groups, strict=True)]
    )
