"""Limit cycles joined to branches: curves of cycles over one parameter, through folds, never across gaps.

Cycles at neighbouring values of the parameter are of one branch if they are each other's nearest, close
together and of the same index (see `fixed_point_index`), or if continuation leads from one to the other.
Where a branch ends between two values, its end is followed; two ends of different index that meet there are
the two sides of a fold.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.branches.following import MAX_CHANGE, BranchPath, follow_parameter
from stridemap.solver.branches.lines import values_of
from stridemap.solver.branches.main_branch import fixed_point_index
from stridemap.solver.cycles.orbits import Orbits
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.options import SearchOptions

Array = NDArray[np.float64]
Index = NDArray[np.int64]

SAME_CYCLE = 1e-5
"""Largest difference of two solutions that are one cycle."""

FOLD_DISTANCE = 0.02
"""Largest difference of the two sides of a fold, each followed to its end."""

BETWEEN = -1
"""Row of a cycle that was found between the values of the sweep."""


@dataclass(frozen=True)
class Branch:
    """Limit cycles in their order along a branch.

    Parameters
    ----------
    orbits : Orbits, length n
    row : ndarray of int, shape (n,)
        Row of each among the cycles that were joined; `BETWEEN` for those that following found.
    """

    orbits: Orbits
    row: Index

    @property
    def on_grid(self) -> NDArray[np.bool_]:
        """Which of the cycles are among those that were joined, shape (n,)."""
        return self.row != BETWEEN

    def reversed(self) -> "Branch":
        """The branch from its other end."""
        return Branch(self.orbits[::-1], self.row[::-1])


def branches(
    solver: Solver,
    orbits: Orbits,
    parameter: str,
    values: Sequence[float] | Array,
    options: SearchOptions | None = None,
) -> list[Branch]:
    """Join cycles that differ in one parameter to branches.

    Parameters
    ----------
    solver : Solver
    orbits : Orbits
        Cycles at one value of all other parameters.
    parameter : str
    values : sequence of float
        All values of the parameter in the sweep, ascending, those without a cycle too.
    options : SearchOptions, optional
        Their period range holds.

    Returns
    -------
    list of Branch
        Ordered by the value of the parameter at their first cycle, then by the period there.

    Raises
    ------
    ValueError
        If a cycle is at none of the values.
    """
    grid = np.asarray(values, dtype=np.float64)
    if not np.isin(values_of(orbits, parameter), grid).all():
        raise ValueError(f"cycles are at values of {parameter} that are not among the {len(grid)} given")
    if not len(orbits):
        return []
    pieces = _linked(orbits, np.searchsorted(grid, values_of(orbits, parameter)))
    followed = _followed(solver, orbits, pieces, parameter, grid, options)
    joined = _joined_at_folds(solver, followed, parameter)
    at = [(values_of(branch.orbits, parameter)[0], branch.orbits.period[0]) for branch in joined]
    return [joined[i] for i in np.lexsort(np.transpose(at)[::-1])]


def _linked(orbits: Orbits, position: Index) -> list[Index]:
    """Pieces that continue from each value to the next, as rows; `position` is each cycle's on the grid."""
    u, index = orbits.scaled, fixed_point_index(orbits.multipliers)
    piece, before = np.full(len(u), -1), np.full(len(u), -1)
    ends, count = np.empty(0, dtype=np.int64), 0
    for i in range(position.max() + 1):
        here = np.flatnonzero(position == i)
        last = before[ends]
        expected = np.where((last >= 0)[:, None], 2 * u[ends] - u[last], u[ends])
        distance = np.abs(expected[:, None] - u[here][None]).max(axis=2)
        change = np.abs(u[ends][:, None] - u[here][None]).max(axis=2)
        distance[(index[ends][:, None] != index[here][None]) | (change > MAX_CHANGE)] = np.inf
        one, other = _nearest_pairs(distance)
        before[here[other]], piece[here[other]] = ends[one], piece[ends[one]]
        new = here[piece[here] < 0]
        piece[new] = count + np.arange(len(new))
        count += len(new)
        ends = here
    order = np.lexsort((position, piece))
    return np.split(order, np.flatnonzero(np.diff(piece[order])) + 1)


def _nearest_pairs(distance: Array) -> tuple[list[int], list[int]]:
    """Pairs of rows and columns at a finite distance, nearest first, one to one."""
    one: list[int] = []
    other: list[int] = []
    while distance.min(initial=np.inf) < np.inf:
        i, j = np.unravel_index(distance.argmin(), distance.shape)
        one.append(int(i))
        other.append(int(j))
        distance[i, :] = distance[:, j] = np.inf
    return one, other


def _followed(
    solver: Solver,
    orbits: Orbits,
    pieces: list[Index],
    parameter: str,
    grid: Array,
    options: SearchOptions | None,
) -> list[Branch]:
    """Pieces joined where continuation leads from one to the next, with their other ends followed."""
    first, last = (np.array([piece[side] for piece in pieces]) for side in (0, -1))
    ahead = _from_ends(solver, orbits.take(last), parameter, grid, 1, options)
    starts, next_ = orbits.take(first), np.full(len(pieces), -1)
    for i, path in ahead.items():
        if path.reached:
            near = np.abs(starts.scaled - path.orbits.scaled[-1]).max(axis=1) < SAME_CYCLE
            near &= values_of(starts, parameter) == values_of(path.orbits, parameter)[-1]
            if near.any() and near.argmax() not in next_:
                next_[i] = near.argmax()
                ahead[i] = BranchPath(path.orbits[:-1], True)
    begins = np.setdiff1d(np.arange(len(pieces)), next_)
    back = _from_ends(solver, starts.take(begins), parameter, grid, -1, options)
    out = []
    for i, begin in enumerate(begins.tolist()):
        parts = [_between(back[i]).reversed()] if i in back else []
        while begin >= 0:
            parts.append(Branch(orbits.take(pieces[begin]), pieces[begin]))
            parts += [_between(ahead[begin])] if begin in ahead else []
            begin = int(next_[begin])
        out.append(_in_one(solver, parts))
    return out


def _from_ends(
    solver: Solver, ends: Orbits, parameter: str, grid: Array, direction: int, options: SearchOptions | None
) -> dict[int, BranchPath]:
    """Each end followed to the next value in a direction, by number, save those at the grid's own end."""
    position = np.searchsorted(grid, values_of(ends, parameter)) + direction
    inside = np.flatnonzero((position >= 0) & (position < len(grid)))
    paths = follow_parameter(solver, ends.take(inside), parameter, grid[position[inside]], options)
    return dict(zip(inside.tolist(), paths, strict=True))


def _between(path: BranchPath) -> Branch:
    return Branch(path.orbits, np.full(len(path.orbits), BETWEEN))


def _in_one(solver: Solver, parts: Iterable[Branch]) -> Branch:
    """Parts of a branch, one after the other."""
    parts = list(parts)
    orbits = Orbits.concatenate(solver.model, [part.orbits for part in parts])
    return Branch(orbits, np.concatenate([part.row for part in parts]))


def _joined_at_folds(solver: Solver, pieces: list[Branch], parameter: str) -> list[Branch]:
    """Branches of pieces whose ends meet as the two sides of a fold do, the closest first."""
    out = list(pieces)
    while (meeting := _fold(out, parameter)) is not None:
        (i, side), (j, other) = meeting
        one = out[i] if side == -1 else out[i].reversed()
        two = out[j] if other == 0 else out[j].reversed()
        out[i] = _in_one(solver, [one, two])
        del out[j]
    return out


def _fold(pieces: list[Branch], parameter: str) -> tuple[tuple[int, int], tuple[int, int]] | None:
    """The two ends that meet most closely, as (piece, side) each, if any do."""
    ends = [(i, side) for i in range(len(pieces)) for side in (0, -1)]
    owner = np.array([i for i, _ in ends])
    u = np.array([pieces[i].orbits.scaled[side] for i, side in ends])
    at = np.array([values_of(pieces[i].orbits, parameter)[side] for i, side in ends])
    index = fixed_point_index(np.array([pieces[i].orbits.multipliers[side] for i, side in ends]))
    distance = np.abs(u[:, None] - u[None]).max(axis=2)
    close = np.abs(at[:, None] - at[None]) < FOLD_DISTANCE**2
    distance[(index[:, None] == index[None]) | (owner[:, None] == owner[None]) | ~close] = np.inf
    if not distance.min() < FOLD_DISTANCE:
        return None
    first, second = np.unravel_index(distance.argmin(), distance.shape)
    return ends[first], ends[second]
