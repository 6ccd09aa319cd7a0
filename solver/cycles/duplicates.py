"""Solutions that agree are one: which of them stays, and how many starts led to each."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Index = NDArray[np.int64]

DUPLICATE = 1e-6
"""Largest difference, in any section coordinate or the period and in terms of the model's scales, between two
solutions that are one."""

SEARCH_TOLERANCE = 10 * DUPLICATE
"""The same for solutions of a search, which stops early."""


def distinct(
    cell: Index, u: Array, tolerance: float = SEARCH_TOLERANCE, *, scale: Array | float = 1.0
) -> tuple[Index, Array]:
    """One of each set of solutions of the same cell that agree, in the order of cell, then period.

    Parameters
    ----------
    cell : ndarray of int, shape (n,)
    u : ndarray, shape (n, nz + 1)
    tolerance : float
    scale : ndarray, shape (nz + 1,)
        What the tolerance is in terms of: `stridemap.solver.model.scales.Scales.unknowns`.
    """
    kept, _ = grouped(cell, u, tolerance, backwards(u), scale)
    return cell[kept], u[kept]


def backwards(u: Array) -> range:
    """The order in which `distinct` has entries of the state decide: the last one first."""
    return range(u.shape[1] - 2, -1, -1)


def first_of_each(
    cell: Index,
    u: Array,
    tolerance: float,
    ties: Sequence[int] | None = None,
    scale: Array | float = 1.0,
) -> Index:
    """Rows of the first of each set of solutions of one cell that agree: see `grouped`."""
    return grouped(cell, u, tolerance, ties, scale)[0]


def grouped(
    cell: Index,
    u: Array,
    tolerance: float,
    ties: Sequence[int] | None = None,
    scale: Array | float = 1.0,
) -> tuple[Index, Index]:
    """Rows of the first of each set of solutions of one cell that agree, ordered by cell, period and state.

    A solution is kept unless it agrees with one that was kept before it. In each round the first solution
    that is left in every cell is kept, and all that agree with it are dropped.

    Parameters
    ----------
    cell : ndarray of int, shape (n,)
    u : ndarray, shape (n, nz + 1)
    tolerance : float
        Largest difference of two that agree, in any entry and in terms of `scale`.
    ties : sequence of int, optional
        Entries of the state that order solutions of equal period, the first one first; by default in order.
        Solutions that agree often have periods of equal bits: which of them stays shows in the last bits of
        all that follows.
    scale : ndarray, shape (nz + 1,)

    Returns
    -------
    kept : ndarray of int, shape (k,)
    group : ndarray of int, shape (n,)
        For each solution the place, in `kept`, of the one that it agrees with.
    """
    ties = range(u.shape[1] - 1) if ties is None else ties
    order = np.lexsort((*(u[:, i] for i in reversed(ties)), u[:, -1], cell))
    rank = np.empty_like(order)
    rank[order] = np.arange(len(order))
    representative = np.arange(len(u))
    kept, left = [], order
    while len(left):
        begins = np.append(True, cell[left[1:]] != cell[left[:-1]])
        first = left[begins]
        kept.append(first)
        owner = first[np.cumsum(begins) - 1]
        with np.errstate(invalid="ignore"):
            apart = np.abs((u[left] - u[owner]) / scale).max(axis=1) > tolerance
        go_on = apart & ~begins
        representative[left[~go_on]] = owner[~go_on]
        left = left[go_on]
    rows = np.concatenate(kept) if kept else order
    rows = rows[np.argsort(rank[rows])]
    place = np.empty(len(u), dtype=np.int64)
    place[rows] = np.arange(len(rows))
    return rows, place[representative]
