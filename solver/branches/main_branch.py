"""Which cycles are on the main branch.

Where all parameters but one are fixed, the limit cycles form curves over that one, for instance over the
spring `k`, which turn back at folds. The index of a fixed point, the sign of ``det(1 - DP)``, is that of the
product of one minus each multiplier: it changes at a fold, where a multiplier passes through 1, but not where
a multiplier passes through -1 or a pair leaves the unit circle. It is +1 for every stable cycle. So the
cycles that can be reached from stable walking by a slow change of the parameter, whether they are stable or
not, are those of index +1 on the sheets that hold stable cycles: the main branch.
"""

from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.branches.lines import line_numbers, values_of
from stridemap.solver.cycles.orbits import Orbits

Array = NDArray[np.float64]
Index = NDArray[np.int64]

MAX_PERIOD_CHANGE = 0.1
"""Largest difference in period between cycles of one sheet at neighbouring values of the parameter. Sheets
are further apart than that, and along one the period changes by less."""


def fixed_point_index(multipliers: NDArray[np.complex128]) -> Array:
    """Sign of ``det(1 - DP)``: it is 1 on the sheets of stable cycles.

    Parameters
    ----------
    multipliers : ndarray of complex, shape (n, nz)
        Floquet multipliers.

    Returns
    -------
    ndarray, shape (n,)
        -1, 0 or 1; NaN where multipliers are.
    """
    return np.sign(np.prod(1 - multipliers.T, axis=0).real)


def on_main_branch(orbits: Orbits, parameter: str) -> NDArray[np.bool_]:
    """Whether each cycle is of index +1 and its sheet holds a stable cycle.

    Neighbouring values of the parameter are those at which a line has cycles of index +1, so that values
    without one do not part a sheet whose periods on either side agree.

    Parameters
    ----------
    orbits : Orbits, length n
        Cycles at a grid of the parameter, on one line of parameter space or on several.
    parameter : str
        The parameter that varies along a branch.

    Returns
    -------
    ndarray of bool, shape (n,)
    """
    upright = np.flatnonzero(fixed_point_index(orbits.multipliers) > 0)
    line, value = line_numbers(orbits, parameter), values_of(orbits, parameter)
    order = upright[np.lexsort((value[upright], line[upright]))]
    changes = (np.diff(line[order]) != 0) | (np.diff(value[order]) != 0)
    columns = np.split(order, np.flatnonzero(changes) + 1)
    sheet = np.arange(len(orbits))  # a sheet is named by its first cycle
    for left, right in pairwise(columns):
        if line[left[0]] == line[right[0]]:
            one, other = _links(orbits.period[left], orbits.period[right])
            sheet[right[other]] = sheet[left[one]]
    main = np.zeros(len(orbits), dtype=bool)
    main[upright] = np.isin(sheet[upright], sheet[upright[orbits.known_stable[upright]]])
    return main


def _links(left: Array, right: Array) -> tuple[Index, Index]:
    """Pairs of periods at neighbouring values of the parameter, each the nearest of the other."""
    distance = np.abs(left[:, None] - right[None, :])
    nearest, back = distance.argmin(axis=1), distance.argmin(axis=0)
    one = np.arange(len(left))
    linked = (back[nearest] == one) & (distance[one, nearest] < MAX_PERIOD_CHANGE)
    return one[linked], nearest[linked]
