"""The cells of a plane of two parameters, classified by the limit cycles found in them."""

import string
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.branches.lines import values_of
from stridemap.solver.cycles.orbits import Orbits

Array = NDArray[np.float64]
Index = NDArray[np.int64]

NONE, UNSTABLE, STABLE = 0, 1, 2
"""Classes of a cell: no cycle, no stable one, a stable one."""

NO_GROUP = -1
"""Where there is no cycle, or its group has no single letter."""


@dataclass(frozen=True)
class Plane:
    """Classes and groups of the cells of a plane; cells are numbered row by row.

    Parameters
    ----------
    names : (str, str)
        The two parameters.
    x, y : ndarray, shapes (n,) and (m,)
        Their values, ascending.
    classes : ndarray of int, shape (m, n)
        `NONE`, `UNSTABLE` or `STABLE`.
    groups : ndarray of int, shape (m, n)
        Group of the cell's most stable cycle, 0 for A; `NO_GROUP` where there is none.
    """

    names: tuple[str, str]
    x: Array
    y: Array
    classes: Index
    groups: Index

    @classmethod
    def of_orbits(
        cls,
        orbits: Orbits,
        names: tuple[str, str],
        x: Sequence[float] | Array,
        y: Sequence[float] | Array,
    ) -> "Plane":
        """Classify the cells by the limit cycles found in them.

        Parameters
        ----------
        orbits : Orbits
            At values of the two parameters that are in `x` and `y`.
        names : (str, str)
        x, y : sequence of float
            All values that were searched, ascending.
        """
        xs, ys = np.asarray(x, dtype=np.float64), np.asarray(y, dtype=np.float64)
        cell = cells_of(orbits, names, xs, ys)
        classes, groups = classified(cell, orbits, len(ys) * len(xs))
        shape = len(ys), len(xs)
        return cls(names, xs, ys, classes.reshape(shape), groups.reshape(shape))


def middle_edges(values: Array) -> tuple[float, float]:
    """Ends of a row of cells whose middles are the values: half a cell beyond the first and the last."""
    low, high = values[0] - (values[1] - values[0]) / 2, values[-1] + (values[-1] - values[-2]) / 2
    return float(low), float(high)


def cells_of(orbits: Orbits, names: tuple[str, str], x: Array, y: Array) -> Index:
    """The number of the cell in which each cycle lies, shape (n,)."""
    columns, rows = (
        np.searchsorted(axis, values_of(orbits, name)) for name, axis in zip(names, (x, y), strict=True)
    )
    return rows * len(x) + columns


def classified(cell: Index, orbits: Orbits, n_cells: int) -> tuple[Index, Index]:
    """Classes and groups of cells.

    Parameters
    ----------
    cell : ndarray of int, shape (n,)
        The cell of each cycle.
    orbits : Orbits, length n
    n_cells : int

    Returns
    -------
    classes, groups : ndarray of int, shape (n_cells,)
    """
    classes, groups = np.full(n_cells, NONE), np.full(n_cells, NO_GROUP)
    classes[cell] = UNSTABLE
    classes[cell[orbits.known_stable]] = STABLE
    order = np.lexsort((orbits.spectral_radius, cell))
    cells, first = np.unique(cell[order], return_index=True)
    names, number = np.unique(orbits.group[order[first]].astype(str), return_inverse=True)
    numbers = np.array([_group_number(name) for name in names.tolist()], dtype=np.int64)
    groups[cells] = numbers[number]
    return classes, groups


def _group_number(name: Any) -> int:
    """0 for A, 1 for B; `NO_GROUP` where there is none, and beyond Z."""
    return string.ascii_uppercase.index(name) if len(name) == 1 else NO_GROUP
