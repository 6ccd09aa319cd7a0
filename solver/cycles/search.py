"""All limit cycles at points of parameter space: many starts, Newton's method, duplicates merged.

The number of starts adapts: as long as a limit cycle was reached from one start alone, as many starts again
are made, up to a bound. The chance that a further start leads to something new is about the share of starts
whose limit cycle no other start has reached (I. J. Good 1953, Biometrika 40, 237), so that it is small in
the end.
"""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.cycles.duplicates import (
    DUPLICATE,
    SEARCH_TOLERANCE,
    backwards,
    first_of_each,
    grouped,
)
from stridemap.solver.cycles.orbits import Orbits
from stridemap.solver.cycles.report import ENDS, IMPOSSIBLE, LIMIT_CYCLE, OPEN, SearchReport
from stridemap.solver.cycles.sobol import sobol_points
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.cycles.status import STATUSES
from stridemap.solver.model.model import Model
from stridemap.solver.model.scales import Scales
from stridemap.solver.options import SearchOptions

Array = NDArray[np.float64]
Index = NDArray[np.int64]

TWICE = 2
"""A limit cycle that so many starts have reached is not one that others like it are missed for."""


def starts(model: Model, options: SearchOptions, point: int = 0, skip: int = 0) -> Array:
    """Quasi-random starts over the search box and the range of periods.

    Periods are spread evenly; section points crowd around the middle of the box, where gaits are, without
    leaving out its edges.

    Parameters
    ----------
    model : Model
    options : SearchOptions
    point : int
        Points of a grid may get starts of their own.
    skip : int
        Starts of the sequence that are left out.

    Returns
    -------
    ndarray, shape (options.starts, nz + 1)
        Section points with periods (Sobol points, scrambled).
    """
    box = options.box_for(model)
    # Sobol points are balanced in powers of two; a part of them is cut off.
    last = skip + options.starts
    rng = np.random.default_rng([options.seed, point])
    unit = sobol_points(len(box) + 1, int(np.ceil(np.log2(last))), rng)[skip:last]
    section = box[:, 0] + box[:, 1] * (2 * unit[:, :-1] - 1) ** 3
    shortest, longest = options.resolved_for(model).period_range
    period = shortest + (longest - shortest) * unit[:, -1:]
    return np.hstack([section, period])


def find_all(solver: Solver, points: Array, options: SearchOptions | None = None) -> tuple[Index, Orbits]:
    """All limit cycles at each of n points.

    Parameters
    ----------
    solver : Solver
    points : ndarray, shape (n, n_parameters)
    options : SearchOptions, optional

    Returns
    -------
    point : ndarray of int, shape (m,)
        The point of each cycle, ascending.
    orbits : Orbits, length m
        Ordered by point, then period. ``orbits.search`` says what the search did and threw away.
    """
    options = (options or SearchOptions()).resolved_for(solver.model)
    found = _Found.nothing(solver.model)
    open_, made = np.arange(len(points)), 0
    batch = options.starts
    while len(open_):
        # The same starts for each: what is found at a point does not depend on the others.
        guesses = starts(solver.model, replace(options, starts=batch, max_starts=None), skip=made)
        at = np.repeat(open_, batch)
        found.add(solver, at, np.tile(guesses, (len(open_), 1)), points, options.period_range)
        made += batch
        open_ = open_[np.isin(open_, found.unsettled)]
        batch = min(made, options.most_starts - made)
        if batch <= 0:
            break
    return found.point, replace(found.orbits, search=found.report())


class _Found:
    """What was found so far, with the number of starts that led to each solution."""

    def __init__(self, model: Model) -> None:
        self.model = model
        self.scale = Scales.of(model).unknowns
        self.starts = 0
        self.ended = dict.fromkeys(ENDS, 0)
        # All distinct solutions of the rough search, with what they converged to.
        self.cell = np.empty(0, dtype=np.int64)
        self.rough = np.empty((0, len(model.section) + 1))
        self.count = np.empty(0, dtype=np.int64)
        self.solved = Orbits.empty(model)

    @classmethod
    def nothing(cls, model: Model) -> "_Found":
        """Before the first start."""
        return cls(model)

    def add(
        self, solver: Solver, at: Index, guesses: Array, points: Array, period_range: tuple[float, float]
    ) -> None:
        """Search from guesses at points, and converge to what is new."""
        search = solver.searched(guesses, points[at])
        u, closed = search.u, search.closed
        self.starts += len(at)
        self.ended[OPEN] += int(np.count_nonzero(search.open))
        self.ended[IMPOSSIBLE] += int(np.count_nonzero(search.impossible))
        known = len(self.cell)
        cell, rough = np.concatenate([self.cell, at[closed]]), np.concatenate([self.rough, u[closed]])
        kept, group = grouped(cell, rough, SEARCH_TOLERANCE, backwards(rough), self.scale)
        count = np.bincount(group, np.concatenate([self.count, np.ones(len(cell) - known, dtype=np.int64)]))
        # A solution of an earlier batch stays, so that what was converged from it need not be again.
        first = np.full(len(kept), len(cell))
        np.minimum.at(first, group, np.arange(len(cell)))
        row = np.where(first < known, first, kept) if known else kept
        new = np.flatnonzero(row >= known)
        more = solver.converge(rough[row[new]], points[cell[row[new]]], period_range)
        every = Orbits.concatenate(self.model, [self.solved, more])
        place = np.empty(len(row), dtype=np.int64)
        place[new] = len(self.solved) + np.arange(len(new))
        old = np.flatnonzero(row < known)
        place[old] = row[old]
        self.cell, self.rough, self.count = cell[row], rough[row], count.astype(np.int64)
        self.solved = every.take(place)

    @property
    def _gaits(self) -> tuple[Index, Index]:
        """Rows of the limit cycles without duplicates, and the number of starts that led to each."""
        rows = np.flatnonzero(self.solved.found)
        kept, group = grouped(self.cell[rows], self.solved.u[rows], DUPLICATE, None, self.scale)
        return rows[kept], np.bincount(group, self.count[rows], len(kept)).astype(np.int64)

    @property
    def unsettled(self) -> Index:
        """Points at which a limit cycle was reached from one start alone, once for each such cycle."""
        rows, reached = self._gaits
        return self.cell[rows[reached < TWICE]]

    @property
    def point(self) -> Index:
        """The point of each limit cycle."""
        return self.cell[self._gaits[0]]

    @property
    def orbits(self) -> Orbits:
        """The limit cycles, ordered by point, then period."""
        return self.solved.take(self._gaits[0])

    def report(self) -> SearchReport:
        """What the search did."""
        ended = dict(self.ended)
        for code, status in enumerate(STATUSES.tolist()):
            word = LIMIT_CYCLE if status.found else status.value
            ended[word] += int(self.count[self.solved.codes == code].sum())
        _, reached = self._gaits
        return SearchReport(
            self.starts,
            ended,
            reached,
            settled=bool((reached >= TWICE).all()),
            discarded=self.solved.take(np.flatnonzero(~self.solved.found)),
        )


def continued(solver: Solver, points: Array, guesses: Array, options: SearchOptions | None = None) -> Orbits:
    """One limit cycle per point, from a guess for each; failures carry their reason.

    Parameters
    ----------
    solver : Solver
    points : ndarray, shape (n, n_parameters)
    guesses : ndarray, shape (n, nz + 1)
        Section points and periods.
    options : SearchOptions, optional

    Returns
    -------
    Orbits, length n
    """
    options = (options or SearchOptions()).resolved_for(solver.model)
    u, _ = solver.search(guesses, points)
    return solver.converge(u, points, options.period_range)


def merged(cell: Index, orbits: Orbits) -> tuple[Index, Orbits]:
    """Found limit cycles without duplicates, in the order of cell, then period.

    Parameters
    ----------
    cell : ndarray of int, shape (n,)
        Cell of each orbit.
    orbits : Orbits
    """
    found = np.flatnonzero(orbits.found)
    kept = found[
        first_of_each(cell[found], orbits.u[found], DUPLICATE, None, Scales.of(orbits.model).unknowns)
    ]
    return cell[kept], orbits.take(kept)
