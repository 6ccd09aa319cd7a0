"""All limit cycles at points of parameter space: many starts, Newton's method, duplicates merged."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from scipy.stats import qmc

from stridemap.solver.cycles.orbits import Orbits
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.model.model import Model
from stridemap.solver.options import SearchOptions

Array = NDArray[np.float64]
Index = NDArray[np.int64]

DUPLICATE = 1e-6
"""Largest difference, in any section coordinate or the period, between two solutions that are one."""

SEARCH_TOLERANCE = 10 * DUPLICATE
"""The same for solutions of a search, which stops early."""


def starts(model: Model, options: SearchOptions, point: int = 0) -> Array:
    """Quasi-random starts over the model's search box and the range of periods.

    Periods are spread evenly; section points crowd around the middle of the box, where gaits are, without
    leaving out its edges.

    Parameters
    ----------
    model : Model
    options : SearchOptions
    point : int
        Points of a grid may get starts of their own.

    Returns
    -------
    ndarray, shape (options.starts, nz + 1)
        Section points with periods (Sobol points, scrambled).
    """
    box = np.array([model.spec.search_box[name] for name in model.section])
    sobol = qmc.Sobol(len(box) + 1, rng=np.random.default_rng([options.seed, point]))
    # Sobol points are balanced in powers of two; a part of them is cut off.
    unit = sobol.random_base2(int(np.ceil(np.log2(options.starts))))[: options.starts]
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
        Ordered by point, then period.
    """
    options = (options or SearchOptions()).resolved_for(solver.model)
    if not len(points):
        return np.empty(0, dtype=np.int64), Orbits.empty(solver.model)
    point = np.repeat(np.arange(len(points)), options.starts)
    # The same starts for each: what is found at a point does not depend on the others.
    u, closed = solver.search(np.tile(starts(solver.model, options), (len(points), 1)), points[point])
    point, u = distinct(point[closed], u[closed])
    return merged(point, solver.converge(u, points[point], options.period_range))


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


def distinct(cell: Index, u: Array, tolerance: float = SEARCH_TOLERANCE) -> tuple[Index, Array]:
    """One of each set of solutions of the same cell that agree, in the order of cell, then period.

    Parameters
    ----------
    cell : ndarray of int, shape (n,)
    u : ndarray, shape (n, nz + 1)
    tolerance : float
    """
    kept = first_of_each(cell, u, tolerance, range(u.shape[1] - 2, -1, -1))
    return cell[kept], u[kept]


def merged(cell: Index, orbits: Orbits) -> tuple[Index, Orbits]:
    """Found limit cycles without duplicates, in the order of cell, then period.

    Parameters
    ----------
    cell : ndarray of int, shape (n,)
        Cell of each orbit.
    orbits : Orbits
    """
    found = np.flatnonzero(orbits.found)
    kept = found[first_of_each(cell[found], orbits.u[found], DUPLICATE)]
    return cell[kept], orbits.take(kept)


def first_of_each(cell: Index, u: Array, tolerance: float, ties: Sequence[int] | None = None) -> Index:
    """Rows of the first of each set of solutions of one cell that agree, ordered by cell, period and state.

    A solution is kept unless it agrees with one that was kept before it. In each round the first solution
    that is left in every cell is kept, and all that agree with it are dropped.

    Parameters
    ----------
    cell : ndarray of int, shape (n,)
    u : ndarray, shape (n, nz + 1)
    tolerance : float
        Largest difference of two that agree, in any entry.
    ties : sequence of int, optional
        Entries of the state that order solutions of equal period, the first one first; by default in order.
        Solutions that agree often have periods of equal bits: which of them stays shows in the last bits of
        all that follows.
    """
    ties = range(u.shape[1] - 1) if ties is None else ties
    order = np.lexsort((*(u[:, i] for i in reversed(ties)), u[:, -1], cell))
    rank = np.empty_like(order)
    rank[order] = np.arange(len(order))
    kept, left = [], order
    while len(left):
        begins = np.append(True, cell[left[1:]] != cell[left[:-1]])
        first = left[begins]
        kept.append(first)
        owner = first[np.cumsum(begins) - 1]
        with np.errstate(invalid="ignore"):
            apart = np.abs(u[left] - u[owner]).max(axis=1) > tolerance
        left = left[apart & ~begins]
    rows = np.concatenate(kept) if kept else order
    return rows[np.argsort(rank[rows])]
