"""Classes of points of a map between its cells, from the cycles of the cells around."""

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

AROUND = np.array([(i, j) for i in (-1, 0, 1) for j in (-1, 0, 1)])
"""Rows and columns from a cell to itself and to those around it."""


def classes_at(
    solver: Solver, plane: Plane, orbits: Orbits, x: Array, y: Array, options: SearchOptions | None = None
) -> Index:
    """Classes of points of a map, found from all cycles of the cells around each, shape (m,).

    Parameters
    ----------
    solver : Solver
    plane : Plane
    orbits : Orbits
        The physical gaits (see `is_physical_gait`) from which it was classified, at one value of all other
        parameters.
    x, y : ndarray, shape (m,)
    options : SearchOptions, optional
        Their period range holds.
    """
    options = (options or SearchOptions()).resolved_for(solver.model)
    row, column = (
        np.abs(np.asarray(at)[:, None] - axis).argmin(axis=1) for at, axis in ((y, plane.y), (x, plane.x))
    )
    points = np.repeat(orbits.params[:1], len(row), axis=0)
    points[:, [solver.model.spec.names.index(name) for name in plane.names]] = np.column_stack([x, y])
    at, guesses = _around(plane, orbits, row, column)
    u, closed = solver.search(guesses, points[at])
    at, u = distinct(at[closed], u[closed], scale=Scales.of(solver.model).unknowns)
    at, found = merged(at, solver.converge(u, points[at], options.period_range))
    gaits = np.flatnonzero(is_physical_gait(found))
    return classified(at[gaits], found.take(gaits), len(row))[0]


def _around(plane: Plane, orbits: Orbits, row: Index, column: Index) -> tuple[Index, Array]:
    """Guesses for m cells from the cycles there and beside: number of the cell (0 to m - 1), cycle."""
    cells = cells_of(orbits, plane.names, plane.x, plane.y)
    order = np.argsort(cells, kind="stable")
    cells, u = cells[order], orbits.u[order]
    rows, columns = row[:, None] + AROUND[:, 0], column[:, None] + AROUND[:, 1]
    inside = (rows >= 0) & (rows < len(plane.y)) & (columns >= 0) & (columns < len(plane.x))
    at, _ = np.nonzero(inside)
    cell = rows[inside] * len(plane.x) + columns[inside]
    first, end = (np.searchsorted(cells, cell, side) for side in ("left", "right"))
    count = end - first
    within = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count)
    return np.repeat(at, count), u[np.repeat(first, count) + within]
