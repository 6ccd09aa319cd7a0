"""One piece of work of a sweep: all new limit cycles of a block of cells.

A pure function of its input, so that the result does not depend on who computes it, or when.
"""

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass, field
from itertools import chain
from typing import Any, NamedTuple

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from stridemap.solver.backends.base import Backend
from stridemap.solver.branches.continuation import follow
from stridemap.solver.cycles.duplicates import DUPLICATE, SEARCH_TOLERANCE, distinct
from stridemap.solver.cycles.orbits import Orbits
from stridemap.solver.cycles.search import merged, starts
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.cycles.status import FOUND, STATUSES, Status
from stridemap.solver.model.model import Model
from stridemap.solver.model.scales import Scales
from stridemap.solver.options import AcceptanceOptions, ContinuationOptions, SearchOptions
from stridemap.sweeps.grid import Grid
from stridemap.sweeps.tables import orbit_table

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

SAME_BRANCH = 1e-3
"""Largest difference between a cycle and the end of a branch that reached its cell, if it is that branch's
and need not be followed back to where the branch came from. Too small a value costs time only."""

MAX_ADHESION = 1.0
"""Largest pull of the foot at the ground, in terms of the weight. A cycle that needs more is far from every
physical one: it is a row like any other, but its branch is not followed."""

NO_GAIT = (Status.NOT_A_STEP.code, Status.LATER_TOUCHDOWN.code)
"""Solutions that are not gaits, but whose branch may become one again in another cell, and is followed."""

NO_SOURCE = -1
"""Source of a guess that did not come along a branch."""


class Guess(NamedTuple):
    """A guess for a cell, with the cell that the branch came from."""

    cell: int
    source: int
    u: Floats


@dataclass(frozen=True)
class Task:
    """What a worker needs to work on one tile: all of it, wherever the worker is.

    Parameters
    ----------
    model : Model
        With its generated files.
    grid : Grid
    params : dict of str to float
        Parameters that are not on an axis of the grid.
    search, acceptance, continuation : SearchOptions, AcceptanceOptions, ContinuationOptions
    backend : Backend
        What runs the kernels.
    round, tile : int
    cells : ndarray of int, shape (n,)
        The tile's cells, ascending.
    seeds : ndarray of int
        Those of them that get many starts.
    incoming : list of Guess
        Guesses from branches that began in other tiles.
    known : list of (int, ndarray)
        Cycles that the tile's cells have already, with their cells: section point and period.
    seen : list of (int, ndarray)
        What the search gave there, before it converged: the cycles, and what turned out not to be one.
    """

    model: Model
    grid: Grid
    params: dict[str, float]
    search: SearchOptions
    acceptance: AcceptanceOptions
    continuation: ContinuationOptions
    backend: Backend
    round: int
    tile: int
    cells: Ints
    seeds: Ints
    incoming: list[Guess]
    known: list[tuple[int, Floats]]
    seen: list[tuple[int, Floats]]


@dataclass(frozen=True)
class Result:
    """What a worker found.

    Parameters
    ----------
    round, tile : int
    orbits : Table
        Rows of the table of orbits.
    failures : dict of int to str
        Cells that failed with the reason.
    seen : list of (int, ndarray)
        What is to be added to the task's.
    outgoing : list of Guess
        For cells of other tiles.
    discarded : dict of (int, str) to int
        How many solutions in which cell were no limit cycle, by `Status`.
    """

    round: int
    tile: int
    orbits: pa.Table
    failures: dict[int, str] = field(default_factory=dict)
    seen: list[tuple[int, Floats]] = field(default_factory=list)
    outgoing: list[Guess] = field(default_factory=list)
    discarded: dict[tuple[int, str], int] = field(default_factory=dict)


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
    CompilerError
        When the task's backend cannot be had here.
    """
    search = _Search(task)
    model, options = task.model, task.search
    guesses = (
        Guess(cell, NO_SOURCE, u) for cell in task.seeds.tolist() for u in starts(model, options, cell)
    )
    search.relax([*task.incoming, *guesses])
    table = orbit_table(*search.all_new())
    return Result(
        task.round,
        task.tile,
        table,
        search.failures,
        search.new_seen,
        search.outgoing,
        dict(search.discarded),
    )


class _Search:
    """The search in one tile; grows the cycles of each cell."""

    def __init__(self, task: Task) -> None:
        self.task = task
        self.solver = Solver.for_model(task.model, task.backend, task.acceptance)
        self.scale = Scales.of(task.model).unknowns
        self.new: list[tuple[Ints, Orbits]] = []
        self.new_seen: list[tuple[int, Floats]] = []
        self.outgoing: list[Guess] = []
        self.failures: dict[int, str] = {}
        self.discarded: Counter[tuple[int, str]] = Counter()
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

    def relax(self, guesses: list[Guess]) -> None:
        """Solve from guesses, follow what is new to the neighbours, and so on."""
        while guesses:
            for cell, source, u in guesses:
                if source != NO_SOURCE:
                    self._ends.setdefault((cell, source), []).append(u)
            found = self._one_by_one(self._solve, guesses)
            branches = [
                Guess(target, cell, u)
                for cell, u in sorted(found, key=lambda one: one[0])
                for target in self._neighbours[cell]
                if _unlike(u, self._ends.get((cell, target), []), SAME_BRANCH, self.scale)
            ]
            ends = self._one_by_one(self._follow, branches)
            self.outgoing += [end for end in ends if end.cell not in self._cycles]
            guesses = [end for end in ends if end.cell in self._cycles]

    def all_new(self) -> tuple[Ints, Orbits]:
        """The new limit cycles with their cells, ascending."""
        cells = np.concatenate([np.empty(0, dtype=np.int64), *(cell for cell, _ in self.new)])
        orbits = Orbits.concatenate(self.solver.model, [found for _, found in self.new])
        order = np.argsort(cells, kind="stable")
        return cells[order], orbits.take(order)

    def _one_by_one(self, method: Any, guesses: list[Guess]) -> list[Any]:
        """Apply a method to all guesses; where that raises, to those of each cell by themselves."""
        try:
            return list(method(guesses))
        except Exception:
            out: list[Any] = []
            for cell in sorted({guess.cell for guess in guesses}):
                try:
                    out += method([guess for guess in guesses if guess.cell == cell])
                except Exception as error:
                    if cell in self._cycles:  # a branch into another tile is lost, but no cell fails
                        self.failures[cell] = f"{type(error).__name__}: {error}"
            return out

    def _follow(self, branches: list[Guess]) -> list[Guess]:
        """Where branches end that begin at a cycle of `source` and lead to `cell`."""
        if not branches:
            return []
        u = np.array([branch.u for branch in branches])
        params, target = (self._points([getattr(b, name) for b in branches]) for name in ("source", "cell"))
        task = self.task
        ends = follow(self.solver, u, params, target, task.search.wider_period_range, task.continuation)
        lost = np.setdiff1d(np.arange(len(branches)), ends.branch).tolist()
        out = [branches[i]._replace(source=NO_SOURCE) for i in lost]  # the cycle itself may do
        for i, end, reached in zip(ends.branch.tolist(), ends.u, ends.reached.tolist(), strict=True):
            cell, source, _ = branches[i]
            out.append(Guess(cell, source, end) if reached else Guess(source, NO_SOURCE, end))
        return out

    def _solve(self, guesses: list[Guess]) -> list[tuple[int, Floats]]:
        """Solutions from guesses that are new and are to be followed, with their cells."""
        cells = np.array([guess.cell for guess in guesses])
        u, closed = self.solver.search(np.array([guess.u for guess in guesses]), self._points(cells))
        shortest, longest = self.task.search.wider_period_range
        closed &= (u[:, -1] > shortest) & (u[:, -1] <= longest)
        cells, u = distinct(cells[closed], u[closed], scale=self.scale)
        unseen = [
            _unlike(x, chain(self._seen[cell], self._cycles[cell]), SEARCH_TOLERANCE, self.scale)
            for cell, x in zip(cells.tolist(), u, strict=True)
        ]
        cells, u = cells[unseen], u[unseen]
        if not len(cells):
            return []
        orbits = self.solver.converge(u, self._points(cells), self.task.search.wider_period_range)
        new: list[tuple[int, Floats]] = []
        for cell, x, code in zip(cells.tolist(), u, orbits.codes.tolist(), strict=True):
            if code != Status.NOT_CONVERGED.code:
                self._seen[cell].append(x)
                self.new_seen.append((cell, x))
            if code in NO_GAIT:
                new.append((cell, x))
            if code not in FOUND:
                self.discarded[cell, STATUSES[code].value] += 1
        return new + self._enter(*merged(cells, orbits))

    def _enter(self, cells: Ints, orbits: Orbits) -> list[tuple[int, Floats]]:
        """Enter limit cycles that are new; returns those whose branch is to be followed."""
        # Newton's method at full resolution may have moved on to a cycle that is there already.
        new = np.zeros(len(cells), dtype=bool)
        for i, (cell, u) in enumerate(zip(cells.tolist(), orbits.u, strict=True)):
            if _unlike(u, self._cycles[cell], DUPLICATE, self.scale):
                self._cycles[cell].append(u)
                new[i] = True
        cells, orbits = cells[new], orbits.take(new)
        self.new.append((cells, orbits))
        weight = self.solver.model.evaluate("total_mass", p=orbits.params)["weight"]
        followed = ~(orbits.min_vertical_force < -MAX_ADHESION * weight)
        return list(zip(cells[followed].tolist(), orbits.u[followed], strict=True))

    def _points(self, cells: Any) -> Floats:
        return self.task.grid.points(self.solver.model, self.task.params, cells)


def _unlike(u: Floats, others: Iterable[Floats], tolerance: float, scale: Floats) -> bool:
    """Whether a solution differs from all of the others, in terms of the model's scales."""
    last = tolerance * scale[-1]
    return all(abs(u[-1] - v[-1]) > last or np.abs((u - v) / scale).max() > tolerance for v in others)
