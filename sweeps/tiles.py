"""One piece of work of a sweep: all new limit cycles of a block of cells.

A pure function of its input, so that the result does not depend on who computes it, or when.
"""

from collections.abc import Iterable
from dataclasses import dataclass, field
from itertools import chain
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from stridemap.errors import InputError
from stridemap.solver.backends.library import LockstepKernels
from stridemap.solver.branches.continuation import follow
from stridemap.solver.cycles.orbit import Orbit, Status
from stridemap.solver.cycles.search import (
    DUPLICATE,
    SEARCH_TOLERANCE,
    SearchOptions,
    distinct,
    merge,
    section_point,
    starts,
)
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.model.model import Model
from stridemap.sweeps.grid import Grid
from stridemap.sweeps.tables import orbit_row

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

SAME_BRANCH = 1e-3
"""Largest difference between a cycle and the end of a branch that arrived in its cell, if it is that branch's
and need not be followed back to where the branch came from. Too small a value costs time only."""

PULL = 1.0
"""Of the foot at the ground, in terms of the weight. A cycle that needs more is far from every physical one:
it is a row as any other, but its branch is not followed."""

NO_GAIT = (Status.NOT_A_STEP, Status.LATER_TOUCHDOWN)
"""Solutions that are no gait, but whose branch may become one again in another cell, and is followed."""

NOWHERE = -1
"""Source of a guess that did not come along a branch."""


class Offer(NamedTuple):
    """A guess for a cell, with the cell that the branch came from."""

    cell: int
    source: int
    u: Floats


@dataclass(frozen=True)
class Task:
    """What a worker needs to work on one tile.

    Parameters
    ----------
    model : Model
        With its generated files: nothing of it has to lie where the work is done.
    grid : Grid
    params : dict of str to float
        Parameters that are not on an axis of the grid.
    options : SearchOptions
    lockstep : bool
        Whether the sweep's kernels are those for several points an instruction.
    round, tile : int
    cells : ndarray of int, shape (n,)
        The tile's cells, ascending.
    seeds : ndarray of int
        Those of them that get many starts.
    offers : list of Offer
        Guesses from branches that began in other tiles.
    known : list of (int, ndarray)
        Cycles that the tile's cells have already, with their cells: section point and period.
    seen : list of (int, ndarray)
        What the search gave there, before it was completed: the cycles, and what turned out to be none.
    """

    model: Model
    grid: Grid
    params: dict[str, float]
    options: SearchOptions
    lockstep: bool
    round: int
    tile: int
    cells: Ints
    seeds: Ints
    offers: list[Offer]
    known: list[tuple[int, Floats]]
    seen: list[tuple[int, Floats]]


@dataclass(frozen=True)
class Result:
    """What a worker found.

    Parameters
    ----------
    round, tile : int
    rows : list of dict
        Rows of the table of orbits.
    failures : dict of int to str
        Cells that failed with the reason.
    seen : list of (int, ndarray)
        What is to be added to the task's.
    offers : list of Offer
        For cells of other tiles.
    """

    round: int
    tile: int
    rows: list[dict[str, Any]]
    failures: dict[int, str] = field(default_factory=dict)
    seen: list[tuple[int, Floats]] = field(default_factory=list)
    offers: list[Offer] = field(default_factory=list)


def work(task: Task) -> Result:
    """Search a tile until nothing new appears in it.

    Parameters
    ----------
    task : Task

    Returns
    -------
    Result
        A cell whose computation raises is a failure with its reason; the others are not affected.

    Raises
    ------
    InputError
        When this process has other kernels than the one that began the sweep: the bytes would differ.
    """
    search = _Search(task)
    if isinstance(search.solver.kernels, LockstepKernels) != task.lockstep:
        raise InputError(
            f"a worker on this sweep computes with other kernels ({search.solver.kernels.compiler}) than the "
            "process that began it: give all machines the same compiler (environment variable CC)"
        )
    model, options = search.solver.model, task.options
    guesses = (Offer(cell, NOWHERE, u) for cell in task.seeds.tolist() for u in starts(model, options, cell))
    search.relax([*task.offers, *guesses])
    rows = [orbit_row(cell, orbit) for cell in sorted(search.new) for orbit in search.new[cell]]
    return Result(task.round, task.tile, rows, search.failures, search.new_seen, search.outgoing)


class _Search:
    """The search in one tile; grows the cycles of each cell."""

    def __init__(self, task: Task) -> None:
        self.task = task
        self.solver = Solver.of(task.model)
        self.new: dict[int, list[Orbit]] = {}
        self.new_seen: list[tuple[int, Floats]] = []
        self.outgoing: list[Offer] = []
        self.failures: dict[int, str] = {}
        self._neighbours: dict[int, list[int]] = {int(cell): [] for cell in task.cells}
        for cell, neighbour in task.grid.neighbour_pairs(task.cells).tolist():
            self._neighbours[cell].append(neighbour)
        self._cycles: dict[int, list[Floats]] = {int(cell): [] for cell in task.cells}
        self._seen: dict[int, list[Floats]] = {int(cell): [] for cell in task.cells}
        # Ends of branches by the cell in which they ended and the one that they came from.
        self._ends: dict[tuple[int, int], list[Floats]] = {}
        for cell, u in task.known:
            self._cycles[cell].append(u)
        for cell, u in task.seen:
            self._seen[cell].append(u)

    def relax(self, guesses: list[Offer]) -> None:
        """Solve from guesses, follow what is new to the neighbours, and so on."""
        while guesses:
            for cell, source, u in guesses:
                if source != NOWHERE:
                    self._ends.setdefault((cell, source), []).append(u)
            found = self._apart(self._solve, guesses)
            branches = [
                Offer(target, cell, u)
                for cell, u in sorted(found, key=lambda one: one[0])
                for target in self._neighbours[cell]
                if _unlike(u, self._ends.get((cell, target), []), SAME_BRANCH)
            ]
            ends = self._apart(self._follow, branches)
            self.outgoing += [end for end in ends if end.cell not in self._cycles]
            guesses = [end for end in ends if end.cell in self._cycles]

    def _apart(self, method: Any, offers: list[Offer]) -> list[Any]:
        """Apply a method to all offers; where that raises, to those of each cell apart."""
        try:
            return list(method(offers))
        except Exception:
            out: list[Any] = []
            for cell in sorted({offer.cell for offer in offers}):
                try:
                    out += method([offer for offer in offers if offer.cell == cell])
                except Exception as error:
                    if cell in self._cycles:  # a branch into another tile is lost, but no cell fails
                        self.failures[cell] = f"{type(error).__name__}: {error}"
            return out

    def _follow(self, branches: list[Offer]) -> list[Offer]:
        """Where branches end that begin at a cycle of `source` and lead towards `cell`."""
        if not branches:
            return []
        u = np.array([branch.u for branch in branches])
        params, towards = (self._points([getattr(b, name) for b in branches]) for name in ("source", "cell"))
        ends = follow(self.solver, u, params, towards, self.task.options.wider_period_range)
        lost = np.setdiff1d(np.arange(len(branches)), ends.branch).tolist()
        out = [branches[i]._replace(source=NOWHERE) for i in lost]  # the cycle itself may do
        for i, end, arrived in zip(ends.branch.tolist(), ends.u, ends.arrived.tolist(), strict=True):
            target, source, _ = branches[i]
            out.append(Offer(target, source, end) if arrived else Offer(source, NOWHERE, end))
        return out

    def _solve(self, guesses: list[Offer]) -> list[tuple[int, Floats]]:
        """Solutions from guesses that are new and are to be followed, with their cells."""
        cells = np.array([guess.cell for guess in guesses])
        u, closed = self.solver.search(np.array([guess.u for guess in guesses]), self._points(cells))
        shortest, longest = self.task.options.wider_period_range
        closed &= (u[:, -1] > shortest) & (u[:, -1] <= longest)
        cells, u = distinct(cells[closed], u[closed])
        unseen = [
            _unlike(x, chain(self._seen[cell], self._cycles[cell]), SEARCH_TOLERANCE)
            for cell, x in zip(cells.tolist(), u, strict=True)
        ]
        cells, u = cells[unseen], u[unseen]
        if not len(cells):
            return []
        orbits = self.solver.complete(u, self._points(cells), self.task.options.wider_period_range)
        loads = self.solver.model.evaluate("total_mass", p=self._points(cells))["weight"]
        weight = dict(zip(cells.tolist(), loads.tolist(), strict=True))
        new: list[tuple[int, Floats]] = []
        for cell, x, orbit in zip(cells.tolist(), u, orbits, strict=True):
            if orbit.status != Status.NOT_CONVERGED:
                self._seen[cell].append(x)
                self.new_seen.append((cell, x))
            if orbit.status in NO_GAIT:
                new.append((cell, x))
        merged = merge(len(cells), np.searchsorted(np.unique(cells), cells), orbits)
        for cell, candidates in zip(np.unique(cells).tolist(), merged, strict=False):
            for orbit in candidates:
                point = np.array(section_point(orbit))
                # Newton's method at full resolution may have moved on to a cycle that is there already.
                if _unlike(point, self._cycles[cell], DUPLICATE):
                    self._cycles[cell].append(point)
                    self.new.setdefault(cell, []).append(orbit)
                    if not orbit.min_vertical_force < -PULL * weight[cell]:
                        new.append((cell, point))
        return new

    def _points(self, cells: Any) -> Floats:
        return self.task.grid.points(self.solver.model, self.task.params, cells)


def _unlike(u: Floats, others: Iterable[Floats], tolerance: float) -> bool:
    """Whether a solution is none of the others."""
    return all(abs(u[-1] - v[-1]) > tolerance or np.abs(u - v).max() > tolerance for v in others)
