"""Ranges of `k` with stable cycles of one group, from a table of cycles and their bisected edges."""

from dataclasses import dataclass

import numpy as np
import pandas as pd
from numpy.typing import NDArray

Array = NDArray[np.float64]


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


def stable_runs(orbits: pd.DataFrame, grid: Array, edges: pd.DataFrame) -> list[Run]:
    """The ranges with stable cycles among `orbits`, which are of one group at one alpha and omega.

    Parameters
    ----------
    orbits : DataFrame
    grid : ndarray
        Every value of `k` that was searched, ascending.
    edges : DataFrame
        Bisected edges of that group, as from `edge_table`; where one is missing, the grid point stands for
        it.
    """
    known = {(row.k_grid, row.side): row.k for row in edges.itertuples()}
    out = []
    for i, j in _runs(grid, orbits["k"][orbits["stable"].fillna(False).astype(bool)].to_numpy()):
        low, high = float(grid[i]), float(grid[j])
        opens, closes = known.get((low, -1), low), known.get((high, 1), high)
        out.append(Run(low, high, opens, closes, i == 0, j == len(grid) - 1))
    return out


def _runs(grid: Array, stable: Array) -> list[tuple[int, int]]:
    """First and last index in `grid` of each run of consecutive values that are all among `stable`."""
    inside = np.isin(grid, stable).astype(int)
    change = np.diff(np.concatenate([[0], inside, [0]]))
    first, last = np.flatnonzero(change > 0), np.flatnonzero(change < 0) - 1
    return list(zip(first.tolist(), last.tolist(), strict=True))
