"""Where stable cycles begin and end in one parameter, bisected between the points of a grid."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.branches.lines import group_numbers, values_of
from stridemap.solver.cycles.gait import is_physical_gait
from stridemap.solver.cycles.orbits import Orbits
from stridemap.solver.cycles.search import continued
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.options import SearchOptions

Array = NDArray[np.float64]
Index = NDArray[np.int64]

BISECTIONS = 8
"""A spacing of 0.1 becomes 0.0004."""


@dataclass(frozen=True)
class Edges:
    """Edges of ranges with stable cycles of one group.

    Parameters
    ----------
    row : ndarray of int, shape (n,)
        Row of a stable cycle at the last grid point inside, among those that were given.
    side : ndarray of int, shape (n,)
        On which side of that point the edge is: -1 for a range's lower end, 1 for its upper end.
    value : ndarray, shape (n,)
        The edge: the last value of the parameter at which the cycle was found stable.
    """

    row: Index
    side: Index
    value: Array


def bisected(
    solver: Solver, orbits: Orbits, parameter: str, values: Array, options: SearchOptions | None = None
) -> Edges:
    """Every edge of stable cycles between two points of a grid of one parameter, by bisection.

    From the cycle at the edge's grid point, one is sought half way to the next grid point: if it is there,
    stable and of the same group, the edge is beyond, and so on. Whether the cycle turns unstable there or
    ends in a fold makes no difference. Where there are two such cycles, the one that reaches further counts.

    Parameters
    ----------
    solver : Solver
    orbits : Orbits
        Physical gaits (see `is_physical_gait`) at values of the grid, on one line of parameter space or on
        several.
    parameter : str
        The parameter that varies along a line.
    values : ndarray, shape (m,)
        Every value of it that was searched, ascending.
    options : SearchOptions, optional
        Their period range holds.

    Returns
    -------
    Edges
        Ordered by line, group, value and side.
    """
    group, position = group_numbers(orbits, parameter), np.searchsorted(values, values_of(orbits, parameter))
    rows, sides = _at_edges(group, position, orbits.known_stable, len(values))
    inside = _bisect(solver, orbits.take(rows), parameter, values[position[rows] + sides], options)
    reach = (inside - values[position[rows]]) * sides
    order = np.lexsort((-reach, sides, position[rows], group[rows]))
    keys = np.stack([sides, position[rows], group[rows]])[:, order]
    first = order[np.append(True, (np.diff(keys) != 0).any(axis=0))[: len(order)]]
    return Edges(rows[first], sides[first], inside[first])


def _at_edges(group: Index, position: Index, stable: NDArray[np.bool_], n: int) -> tuple[Index, Index]:
    """Rows of stable cycles beside whose grid point there is one without a stable cycle, and its side."""
    present = np.zeros((group.max(initial=0) + 1, n), dtype=bool)
    present[group[stable], position[stable]] = True
    rows, sides = [], []
    for side in (-1, 1):
        beyond = position + side
        inside = (beyond >= 0) & (beyond < n)
        at_edge = stable & inside & ~present[group, np.clip(beyond, 0, n - 1)]
        rows.append(np.flatnonzero(at_edge))
        sides.append(np.full(len(rows[-1]), side))
    return np.concatenate(rows), np.concatenate(sides)


def _bisect(
    solver: Solver, orbits: Orbits, parameter: str, outside: Array, options: SearchOptions | None
) -> Array:
    """The last value towards `outside` at which each cycle was found stable, shape (n,)."""
    points, guesses = orbits.params.copy(), orbits.u.copy()
    column = solver.model.spec.names.index(parameter)
    inside = points[:, column].copy()
    for _ in range(BISECTIONS):
        middle = (inside + outside) / 2
        points[:, column] = middle
        found = continued(solver, points, guesses, options)
        good = is_physical_gait(found) & found.known_stable & (found.group == orbits.group)
        inside, outside = np.where(good, middle, inside), np.where(good, outside, middle)
        guesses[good] = found.u[good]
    return inside
