"""One piece of work of a sweep: all new limit cycles of a block of cells.

A pure function of its input, so that the result does not depend on who computes it, or when.
"""

from dataclasses import dataclass, field
from itertools import chain
from typing import Any

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.limit_cycle import Solver
from stridemap.solver.model import load
from stridemap.solver.orbit import Orbit, Status
from stridemap.solver.search import (
    DUPLICATE,
    SEARCH_TOLERANCE,
    SearchOptions,
    distinct,
    merge,
    section_point,
    starts,
)
from stridemap.sweeps.grid import Grid
from stridemap.sweeps.tables import orbit_row

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

LIKE = 0.03
"""Largest difference, in any section coordinate or the period, between cycles of neighbouring cells that are
taken for the same branch. Too small a value costs time only."""


@dataclass(frozen=True)
class Task:
    """What a worker needs to work on one tile.

    Parameters
    ----------
    model : str
    grid : Grid
    params : dict of str to float
        Parameters that are not on an axis of the grid.
    options : SearchOptions
    round, tile : int
    cells : ndarray of int, shape (n,)
        The tile's cells, ascending.
    seeds : ndarray of int
        Those of them that get many starts.
    sources, targets, offers : ndarray, shapes (m,), (m,) and (m, nz + 1)
        All cycles of cells elsewhere, those cells, and the cells here that the cycles are offered to.
    known_cells, known : ndarray, shapes (l,) and (l, nz + 1)
        Cycles that the tile's cells have already.
    """

    model: str
    grid: Grid
    params: dict[str, float]
    options: SearchOptions
    round: int
    tile: int
    cells: Ints
    seeds: Ints
    sources: Ints
    targets: Ints
    offers: Floats
    known_cells: Ints
    known: Floats


@dataclass(frozen=True)
class Result:
    """What a worker found: rows of the table of orbits, and the cells that failed with the reason."""

    round: int
    tile: int
    rows: list[dict[str, Any]]
    failures: dict[int, str] = field(default_factory=dict)


def work(task: Task) -> Result:
    """Search a tile until nothing new appears in it.

    Parameters
    ----------
    task : Task

    Returns
    -------
    Result
        A cell whose computation raises is a failure with its reason; the others are not affected.
    """
    search = _Search(task)
    options = task.options
    guesses = [starts(search.solver.model, options, cell) for cell in task.seeds.tolist()]
    targets, offers = search.wanted_offers()
    cells = np.concatenate([targets, np.repeat(task.seeds, options.starts)])
    search.relax(cells, np.concatenate([offers, *guesses]))
    rows = [orbit_row(cell, orbit) for cell in sorted(search.new) for orbit in search.new[cell]]
    return Result(task.round, task.tile, rows, search.failures)


def without_their_like(offered: list[Floats], present: list[Floats]) -> list[Floats]:
    """Cycles of one cell that have no like among those of another, which so are worth an offer.

    Likes are matched one to one, nearest first: of two cycles beside a fold, one is offered to a cell that
    has only the other.
    """
    if not offered or not present:
        return offered
    distance = np.abs(np.array(offered)[:, None, :] - np.array(present)[None, :, :]).max(axis=2)
    free = np.ones(len(offered), dtype=bool)
    while distance.min() < LIKE:
        one, other = np.unravel_index(distance.argmin(), distance.shape)
        free[one] = False
        distance[one, :] = distance[:, other] = np.inf
    return [u for u, is_free in zip(offered, free, strict=True) if is_free]


class _Search:
    """The search in one tile; grows the cycles of each cell."""

    def __init__(self, task: Task) -> None:
        self.task = task
        self.solver = Solver.of(load(task.model))
        self.new: dict[int, list[Orbit]] = {}
        self.failures: dict[int, str] = {}
        # The cycles of each cell, and other solutions that need no second look.
        self._cycles: dict[int, list[Floats]] = {int(cell): [] for cell in task.cells}
        self._rejected: dict[int, list[Floats]] = {int(cell): [] for cell in task.cells}
        self._offered: set[tuple[int, int]] = set()
        for cell, u in zip(task.known_cells, task.known, strict=True):
            self._cycles[int(cell)].append(u)
        points = task.grid.points(self.solver.model, task.params, task.cells)
        self._point = dict(zip(task.cells.tolist(), points, strict=True))

    def wanted_offers(self) -> tuple[Ints, Floats]:
        """Offers from elsewhere whose like their target does not have, with their targets."""
        task = self.task
        targets, offers = [], [np.empty((0, task.offers.shape[1]))]
        edges = np.flatnonzero(np.diff(task.sources) | np.diff(task.targets)) + 1
        for rows in np.split(np.arange(len(task.sources)), edges):
            if len(rows):
                target = int(task.targets[rows[0]])
                wanted = without_their_like(list(task.offers[rows]), self._cycles[target])
                targets += [target] * len(wanted)
                offers += [u[None, :] for u in wanted]
        return np.array(targets, dtype=np.int64), np.concatenate(offers)

    def relax(self, cells: Ints, guesses: Floats) -> None:
        """Solve from guesses, offer what is new to neighbours in the tile, and so on."""
        while len(cells):
            found = self._solve(cells, guesses)
            offers = [
                (target, u)
                for cell in sorted({cell for cell, _ in found})
                for target in self.task.grid.neighbours(cell).tolist()
                if target in self._point
                for u in without_their_like(self._cycles[cell], self._cycles[target])
                if (target, id(u)) not in self._offered
            ]
            self._offered |= {(target, id(u)) for target, u in offers}
            cells = np.array([target for target, _ in offers], dtype=np.int64)
            guesses = np.array([u for _, u in offers]).reshape(len(offers), guesses.shape[1])

    def _solve(self, cells: Ints, guesses: Floats) -> list[tuple[int, Orbit]]:
        """New cycles from guesses, with their cells."""
        try:
            return self._solve_together(cells, guesses)
        except Exception:
            found: list[tuple[int, Orbit]] = []
            # One of the cells spoils the batch: alone, it spoils only itself.
            for cell in np.unique(cells):
                mine = cells == cell
                try:
                    found += self._solve_together(cells[mine], guesses[mine])
                except Exception as error:
                    self.failures[int(cell)] = f"{type(error).__name__}: {error}"
            return found

    def _solve_together(self, cells: Ints, guesses: Floats) -> list[tuple[int, Orbit]]:
        u, closed = self.solver.search(guesses, self._points(cells))
        shortest, longest = self.task.options.wider_period_range
        closed &= (u[:, -1] > shortest) & (u[:, -1] <= longest)
        cells, u = distinct(cells[closed], u[closed])
        unseen = np.array([self._unseen(c, x) for c, x in zip(cells.tolist(), u, strict=True)], dtype=bool)
        cells, u = cells[unseen], u[unseen]
        orbits = self.solver.complete(u, self._points(cells), self.task.options.wider_period_range)
        new: list[tuple[int, Orbit]] = []
        merged = merge(len(cells), np.searchsorted(np.unique(cells), cells), orbits)
        for cell, candidates in zip(np.unique(cells).tolist(), merged, strict=False):
            for orbit in candidates:
                point = np.array(section_point(orbit))
                # Newton's method at full resolution may have moved on to a cycle that is there already.
                if self._unseen(cell, point, DUPLICATE):
                    self._cycles[cell].append(point)
                    self.new.setdefault(cell, []).append(orbit)
                    new.append((cell, orbit))
        for cell, x, orbit in zip(cells.tolist(), u, orbits, strict=True):
            if not orbit.status.found and orbit.status != Status.NOT_CONVERGED:
                self._rejected[cell].append(x)
        return new

    def _points(self, cells: Ints) -> Floats:
        width = len(self.solver.model.parameters)
        return np.array([self._point[c] for c in cells.tolist()]).reshape(len(cells), width)

    def _unseen(self, cell: int, u: Floats, tolerance: float = SEARCH_TOLERANCE) -> bool:
        seen = chain(self._cycles[cell], self._rejected[cell])
        return all(abs(u[-1] - s[-1]) > tolerance or np.abs(u - s).max() > tolerance for s in seen)
