"""Cycles between the points of a grid, where a measure is smallest.

The smallest value of a measure over a group mostly lies where the grid has no point: at the fold that bounds
the group, or where two multipliers pass each other in modulus. It is approached from the grid's smallest by
searching at values of the parameter around it, again and again, each time more closely around the best so
far.
"""

from collections.abc import Sequence
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
Mask = NDArray[np.bool_]

REFINEMENTS, POINTS_PER_SIDE = 6, 4
"""How often it is searched more closely, and at how many values on either side. A spacing of 0.1 becomes
3e-5."""

MAX_CHANGE = 0.1
"""Largest difference, in any section coordinate or the period, between a cycle and the best so far."""


@dataclass(frozen=True)
class Minima:
    """Cycles around smallest values.

    Parameters
    ----------
    orbits : Orbits, length n
        Cycles that were searched on the way to the smallest values, each once.
    on_main_branch : ndarray of bool, shape (n,)
        Whether the search for them began on the main branch.
    """

    orbits: Orbits
    on_main_branch: Mask


def minima(
    solver: Solver,
    orbits: Orbits,
    on_main_branch: Mask,
    parameter: str,
    values: Array,
    measures: Sequence[str],
    options: SearchOptions | None = None,
) -> Minima:
    """Cycles around the smallest value of each measure, for stable cycles and the main branch of each group.

    Parameters
    ----------
    solver : Solver
    orbits : Orbits, length n
        Physical gaits (see `is_physical_gait`) at a grid of the parameter, on one line of parameter space or
        on several.
    on_main_branch : ndarray of bool, shape (n,)
    parameter : str
        The parameter that varies along a line.
    values : ndarray, shape (m,)
        Every value of it that was searched, ascending.
    measures : sequence of str
        Names of measured quantities.
    options : SearchOptions, optional
        Their period range holds.
    """
    row, measure, only_stable = _starts(orbits, on_main_branch, group_numbers(orbits, parameter), measures)
    if not len(row) or len(values) < 2:
        return Minima(orbits.take(row[:0]), on_main_branch[:0])
    column = solver.model.spec.names.index(parameter)
    best, n = orbits.take(row), np.arange(len(row))
    reach, found, owners = float(np.diff(values).max()), [best.take(row[:0])], [row[:0]]
    for _ in range(REFINEMENTS):
        reach /= POINTS_PER_SIDE
        aside = reach * np.array([i for i in range(-POINTS_PER_SIDE, POINTS_PER_SIDE + 1) if i])
        around = values_of(best, parameter)[:, None] + aside
        inside = (around >= values[0]) & (around <= values[-1])
        owner, _ = np.nonzero(inside)
        points = best.params[owner]
        points[:, column] = around[inside]
        trial = continued(solver, points, best.u[owner], options)
        good = _of_the_same_kind(trial, best.take(owner), only_stable[owner])
        found.append(trial.take(good))
        owners.append(owner[good])
        amount, number = np.full(inside.shape, np.inf), np.zeros(inside.shape, dtype=np.int64)
        every = _amounts(trial, measures)[measure[owner], np.arange(len(trial))]
        amount[inside] = np.where(good, every, np.inf)
        number[inside] = len(best) + np.arange(len(trial))
        least = amount.argmin(axis=1)
        better = amount[n, least] < _amounts(best, measures)[measure, n]
        best = Orbits.concatenate(solver.model, [best, trial]).take(np.where(better, number[n, least], n))
    orbits = Orbits.concatenate(solver.model, found)
    kept = _first_of_each(np.column_stack([orbits.params, orbits.period]))
    return Minima(orbits.take(kept), on_main_branch[row[np.concatenate(owners)[kept]]])


def _starts(
    orbits: Orbits, on_main_branch: Mask, group: Index, measures: Sequence[str]
) -> tuple[Index, Index, Mask]:
    """The grid's smallest of each measure: its row, the measure's number, and whether of stable cycles."""
    amounts, starts = _amounts(orbits, measures), []
    for number in np.unique(group):
        for keep, only_stable in ((orbits.known_stable, True), (on_main_branch, False)):
            rows = np.flatnonzero((group == number) & keep)
            for measure, amount in enumerate(amounts[:, rows]):
                if np.isfinite(amount).any():
                    starts.append((rows[amount.argmin()], measure, only_stable))
    columns = np.array(starts, dtype=np.int64).reshape(-1, 3).T
    return columns[0], columns[1], columns[2].astype(bool)


def _amounts(orbits: Orbits, measures: Sequence[str]) -> Array:
    """Every measure of every cycle, shape (len(measures), n); infinite where there is none."""
    table = np.array([orbits.measures[name].astype(np.float64) for name in measures])
    return np.where(np.isnan(table), np.inf, table)


def _of_the_same_kind(trial: Orbits, best: Orbits, only_stable: Mask) -> Mask:
    """Which cycles continue those that they were searched from."""
    near = np.abs(trial.scaled - best.scaled).max(axis=1) < MAX_CHANGE
    kind = (trial.group == best.group) & (trial.known_stable | ~only_stable)
    return near & kind & is_physical_gait(trial)


def _first_of_each(rows: Array) -> Index:
    """Numbers of the first of each set of equal rows, ascending."""
    return np.sort(np.unique(rows, axis=0, return_index=True)[1])
