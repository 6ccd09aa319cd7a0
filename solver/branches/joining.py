"""Limit cycles joined to branches: curves of cycles over one parameter, through folds, never across gaps.

Cycles at neighbouring values of the parameter are of one branch if they are each other's nearest, close
together and of the same index (see `fixed_point_index`), or if continuation leads from one to the other.
Where a branch ends between two values, its end is followed; two ends of different index that meet there are
the two sides of a fold.
"""

from collections.abc import Sequence

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from stridemap.solver.branches.following import LIKE, follow, state_columns
from stridemap.solver.branches.main_branch import fixed_point_index
from stridemap.solver.model.model import Model

Floats = NDArray[np.float64]
Piece = list[int]

SAME = 1e-5
"""Largest difference of two rows that are one cycle."""
MEETING = 0.02
"""Largest difference of the two sides of a fold, each followed to its end."""


def branches(
    model: Model, orbits: pd.DataFrame, parameter: str, values: Sequence[float] | Floats
) -> list[pd.DataFrame]:
    """Join cycles that differ in one parameter to branches.

    Parameters
    ----------
    model : Model
    orbits : pandas.DataFrame
        Rows of ``orbits.parquet`` at one value of all other parameters.
    parameter : str
    values : sequence of float
        All values of the parameter in the sweep, ascending, those without a cycle too.

    Returns
    -------
    list of pandas.DataFrame
        Rows in their order along a branch; those that were found between the sweep's values have cell -1.
        Branches are ordered by their first value of the parameter, then by the period there.
    """
    grid = np.asarray(values, dtype=np.float64)
    rows = orbits.reset_index(drop=True)
    if rows.empty:
        return []
    pieces = _linked(rows, parameter, grid)
    found = _followed(model, rows, pieces, parameter, grid)
    joined = _joined_at_folds(found, parameter)
    return sorted(joined, key=lambda branch: (branch[parameter].iloc[0], branch["period"].iloc[0]))


def _linked(rows: pd.DataFrame, parameter: str, grid: Floats) -> list[Piece]:
    """Pieces that go on from each value to the next."""
    u, index = rows[state_columns(rows)].to_numpy(), fixed_point_index(rows)
    place = np.searchsorted(grid, rows[parameter].to_numpy())
    pieces: list[Piece] = []
    reaching: list[Piece] = []  # the value before
    for i in range(len(grid)):
        here = np.flatnonzero(place == i)
        gone_on = _matches(reaching, here, u, index)
        reaching = []
        for row in here.tolist():
            if row in gone_on:
                piece = gone_on[row]
            else:
                pieces.append(piece := [])
            piece.append(row)
            reaching.append(piece)
    return pieces


def _matches(pieces: list[Piece], here: NDArray[np.int64], u: Floats, index: Floats) -> dict[int, Piece]:
    """The piece that each of the cycles at one value goes on with, nearest first, one to one."""
    if not pieces or not len(here):
        return {}
    ends = [piece[-1] for piece in pieces]
    expected = np.array([2 * u[p[-1]] - u[p[-2]] if len(p) > 1 else u[p[-1]] for p in pieces])
    distance = np.abs(expected[:, None] - u[here][None]).max(axis=2)
    change = np.abs(u[ends][:, None] - u[here][None]).max(axis=2)
    distance[(index[ends][:, None] != index[here][None]) | (change > LIKE)] = np.inf
    out: dict[int, Piece] = {}
    while distance.min() < np.inf:
        piece, row = np.unravel_index(distance.argmin(), distance.shape)
        out[int(here[row])] = pieces[piece]
        distance[piece, :] = distance[:, row] = np.inf
    return out


def _followed(
    model: Model, rows: pd.DataFrame, pieces: list[Piece], parameter: str, grid: Floats
) -> list[pd.DataFrame]:
    """Pieces joined where continuation leads from one to the next, with their other ends followed."""
    u, names = rows[state_columns(rows)].to_numpy(), state_columns(rows)
    starts = {piece[0]: piece for piece in pieces}
    frames = {piece[0]: [rows.iloc[piece]] for piece in pieces}
    last = _ends(rows, [piece[-1] for piece in pieces], parameter, grid, 1)
    ahead = follow(model, rows.iloc[list(last)], parameter, np.array(list(last.values())))
    next_: dict[int, int] = {}
    on_the_way = dict(zip(last, ahead, strict=True))
    for end, path in on_the_way.items():
        if path.arrived:
            arrival = np.array([path.rows[-1][name] for name in names])
            near = [
                s for s in starts if rows[parameter][s] == last[end] and np.abs(u[s] - arrival).max() < SAME
            ]
            if near and near[0] not in next_.values():
                next_[end] = near[0]
                path.rows.pop()
    followed = {end: _frame(path.rows, rows) for end, path in on_the_way.items()}
    first = _ends(rows, [s for s in starts if s not in next_.values()], parameter, grid, -1)
    back = follow(model, rows.iloc[list(first)], parameter, np.array(list(first.values())))
    before = {s: _frame(path.rows[::-1], rows) for s, path in zip(first, back, strict=True)}
    out = []
    for start in [s for s in starts if s not in next_.values()]:
        parts = [before.get(start, rows.iloc[:0])]
        following: int | None = start
        while following is not None:
            end = starts[following][-1]
            parts += [*frames[following], followed.get(end, rows.iloc[:0])]
            following = next_.get(end)
        out.append(pd.concat([part for part in parts if len(part)], ignore_index=True))
    return out


def _ends(
    rows: pd.DataFrame, ends: list[int], parameter: str, grid: Floats, direction: int
) -> dict[int, float]:
    """The value next to each end in a direction, for those that are not at the grid's own end."""
    place = np.searchsorted(grid, rows[parameter].to_numpy()[ends]) + direction
    return {end: float(grid[p]) for end, p in zip(ends, place.tolist(), strict=True) if 0 <= p < len(grid)}


def _frame(found: list[dict], like: pd.DataFrame) -> pd.DataFrame:
    return pd.DataFrame(found, columns=like.columns).astype(like.dtypes)


def _joined_at_folds(pieces: list[pd.DataFrame], parameter: str) -> list[pd.DataFrame]:
    """Branches of pieces whose ends meet as the two sides of a fold do, the closest first."""
    out = list(pieces)
    while (meeting := _fold(out, parameter)) is not None:
        (i, side), (j, other) = meeting
        one = out[i] if side == -1 else out[i][::-1]
        two = out[j] if other == 0 else out[j][::-1]
        out[i] = pd.concat([one, two], ignore_index=True)
        del out[j]
    return out


def _fold(pieces: list[pd.DataFrame], parameter: str) -> tuple[tuple[int, int], tuple[int, int]] | None:
    """The two ends that meet most closely, as (piece, side) each, if any do."""
    ends = [(i, side) for i in range(len(pieces)) for side in (0, -1)]
    last = pd.concat([pieces[i].iloc[[side]] for i, side in ends])
    u, index, at = last[state_columns(last)].to_numpy(), fixed_point_index(last), last[parameter].to_numpy()
    owner = np.array([i for i, _ in ends])
    distance = np.abs(u[:, None] - u[None]).max(axis=2)
    beside = np.abs(at[:, None] - at[None]) < MEETING**2
    distance[(index[:, None] == index[None]) | (owner[:, None] == owner[None]) | ~beside] = np.inf
    if not distance.min() < MEETING:
        return None
    first, second = np.unravel_index(distance.argmin(), distance.shape)
    return ends[first], ends[second]
