"""A map made finer along its edges: cells are halved where neighbours differ, and only there.

What lies between cells of one class is taken to be of that class. Elsewhere all cycles of the cells around
are guesses, and what is found decides. When it differs from a neighbour that was taken as given, that one is
computed too, and so on, so that an edge always runs between cells that were computed.
"""

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.branches.plane import Plane, cells_of, classified
from stridemap.solver.cycles.duplicates import distinct
from stridemap.solver.cycles.gait import is_physical_gait
from stridemap.solver.cycles.orbits import Orbits
from stridemap.solver.cycles.search import merged
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.model.scales import Scales
from stridemap.solver.options import SearchOptions

Array = NDArray[np.float64]
Index = NDArray[np.int64]
Mask = NDArray[np.bool_]

NEIGHBOURS = np.array([(i, j) for i in (-1, 0, 1) for j in (-1, 0, 1) if (i, j) != (0, 0)])
"""Rows and columns from a cell to those around it."""


def refined(
    solver: Solver, plane: Plane, orbits: Orbits, times: int, options: SearchOptions | None = None
) -> Plane:
    """Halve the cells of a map along its edges.

    Parameters
    ----------
    solver : Solver
    plane : Plane
    orbits : Orbits
        The physical gaits (see `is_physical_gait`) from which it was classified, at one value of all other
        parameters.
    times : int
        How often.
    options : SearchOptions, optional
        Their period range holds.

    Raises
    ------
    ValueError
        If cycles differ in a parameter that is not of the plane.
    """
    others = [i for i, name in enumerate(solver.model.spec.names) if name not in plane.names]
    if (orbits.params[:, others] != orbits.params[:1, others]).any():
        raise ValueError(f"the cycles of a plane of {' and '.join(plane.names)} must agree in all others")
    cells = _Cells(solver, plane, orbits, (options or SearchOptions()).resolved_for(solver.model))
    for _ in range(times):
        cells.halve()
        wanted = ~cells.known & _differs(cells.classes, np.ones_like(cells.known))
        while wanted.any():
            cells.compute(wanted)
            wanted = ~cells.known & _differs(cells.classes, cells.known)
    return Plane(plane.names, cells.x, cells.y, cells.classes, cells.groups)


def classes_at(
    solver: Solver, plane: Plane, orbits: Orbits, x: Array, y: Array, options: SearchOptions | None = None
) -> Index:
    """Classes of points of a map, found from all cycles of the cells around each, shape (m,).

    Parameters
    ----------
    solver, plane, orbits, options
        As for `refined`.
    x, y : ndarray, shape (m,)
    """
    cells = _Cells(solver, plane, orbits, (options or SearchOptions()).resolved_for(solver.model))
    row, column = (
        np.abs(np.asarray(at)[:, None] - axis).argmin(axis=1) for at, axis in ((y, plane.y), (x, plane.x))
    )
    points = np.repeat(cells.point, len(row), axis=0)
    points[:, cells.columns] = np.column_stack([x, y])
    own, guesses = cells.around(row, column, with_own=True)
    at, found = cells.solved(points, own, guesses)
    gaits = np.flatnonzero(is_physical_gait(found))
    return classified(at[gaits], found.take(gaits), len(row))[0]


class _Cells:
    """Cells of a plane: what they are, which of them were computed, and the cycles of these.

    ``u``, shape (n, nz + 1), are the cycles, ordered by ``cell``, shape (n,), the number of their cell.
    """

    def __init__(self, solver: Solver, plane: Plane, orbits: Orbits, options: SearchOptions) -> None:
        self.solver, self.options, self.point = solver, options, orbits.params[:1]
        self.columns = [solver.model.spec.names.index(name) for name in plane.names]
        self.x, self.y, self.classes, self.groups = plane.x, plane.y, plane.classes, plane.groups
        self.known = np.ones(plane.classes.shape, dtype=bool)
        self.cell, self.u = np.empty(0, dtype=np.int64), orbits.u[:0]
        self._add(cells_of(orbits, plane.names, plane.x, plane.y), orbits.u)

    def halve(self) -> None:
        """Twice as many cells along each side, the new ones as the cell before them."""
        row, column = np.divmod(self.cell, len(self.x))
        known = self.known
        self.x, self.y = (np.interp(np.arange(2 * len(v) - 1), np.arange(0, 2 * len(v) - 1, 2), v)
                          for v in (self.x, self.y))  # fmt: skip
        before = np.ix_(np.arange(len(self.y)) // 2, np.arange(len(self.x)) // 2)
        self.classes, self.groups = self.classes[before], self.groups[before]
        self.known = np.zeros(self.classes.shape, dtype=bool)
        self.known[::2, ::2] = known
        self.cell = 2 * row * len(self.x) + 2 * column

    def compute(self, wanted: Mask) -> None:
        """Compute cells from the cycles around them."""
        row, column = np.nonzero(wanted)
        points = np.repeat(self.point, len(row), axis=0)
        points[:, self.columns] = np.column_stack([self.x[column], self.y[row]])
        at, orbits = self.solved(points, *self.around(row, column))
        gaits = np.flatnonzero(is_physical_gait(orbits))
        at, orbits = at[gaits], orbits.take(gaits)
        self.classes[row, column], self.groups[row, column] = classified(at, orbits, len(row))
        self.known[row, column] = True
        self._add(row[at] * len(self.x) + column[at], orbits.u)

    def around(self, row: Index, column: Index, with_own: bool = False) -> tuple[Index, Array]:
        """Guesses for m cells from the cycles of their neighbours: number of the cell (0 to m - 1), cycle."""
        places = np.vstack([NEIGHBOURS, np.zeros((1, 2), dtype=int)]) if with_own else NEIGHBOURS
        rows, columns = row[:, None] + places[:, 0], column[:, None] + places[:, 1]
        inside = (rows >= 0) & (rows < len(self.y)) & (columns >= 0) & (columns < len(self.x))
        at, _ = np.nonzero(inside)
        cell = rows[inside] * len(self.x) + columns[inside]
        first, end = (np.searchsorted(self.cell, cell, side) for side in ("left", "right"))
        count = end - first
        within = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count)
        return np.repeat(at, count), self.u[np.repeat(first, count) + within]

    def solved(self, points: Array, at: Index, guesses: Array) -> tuple[Index, Orbits]:
        """Limit cycles at m points, from guesses for some of them, and the number of each one's point."""
        u, closed = self.solver.search(guesses, points[at])
        at, u = distinct(at[closed], u[closed], scale=Scales.of(self.solver.model).unknowns)
        return merged(at, self.solver.converge(u, points[at], self.options.period_range))

    def _add(self, cell: Index, u: Array) -> None:
        """Enter cycles."""
        cells = np.concatenate([self.cell, cell])
        order = np.argsort(cells, kind="stable")
        self.cell, self.u = cells[order], np.concatenate([self.u, u])[order]


def _differs(classes: Index, among: Mask) -> Mask:
    """Which cells have, among some, a neighbour of another class."""
    padded = np.pad(classes, 1, mode="edge")
    counted = np.pad(among, 1)
    out = np.zeros(classes.shape, dtype=bool)
    rows, columns = classes.shape
    for i, j in NEIGHBOURS.tolist():
        there = np.s_[1 + i : 1 + i + rows, 1 + j : 1 + j + columns]
        out |= counted[there] & (padded[there] != classes)
    return out
