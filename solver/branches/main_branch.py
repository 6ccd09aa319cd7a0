"""Which cycles walk, and which of them are on the main branch.

At a fixed mass ratio and oscillator frequency the limit cycles form curves over the spring `k`, which turn
back at folds. The index of a fixed point, the sign of ``det(1 - DP)``, is that of the product of one minus
each multiplier: it changes at a fold, where a multiplier passes through 1, but not where a multiplier
passes through -1 or a pair leaves the unit circle. It is +1 for every stable cycle. So the cycles that can
be reached from stable walking by a slow change of `k`, whether they are stable or not, are those of index
+1 on the sheets that hold stable cycles: the main branch.
"""

import itertools
from typing import Any

import numpy as np
import pandas as pd
from numpy.typing import NDArray

LINK = 0.1
"""Largest difference in period between cycles of one sheet at neighbouring values of `k`. Sheets are further
apart than that, and along one the period changes by less."""


def walks(orbit: Any) -> Any:
    """Whether a cycle counts: converged, forward, and with a stance foot that never pulls at the ground.

    Parameters
    ----------
    orbit : Orbit or DataFrame
        One orbit, or rows of ``orbits.parquet``; then the answer is a column.
    """
    return (orbit.status == "converged") & (orbit.step_length > 0) & (orbit.min_vertical_force > 0)


def fixed_point_index(orbits: pd.DataFrame) -> NDArray[np.float64]:
    """Sign of ``det(1 - DP)`` from the multipliers, shape (n,): 1 on the sheets of stable cycles."""
    n = sum(name.startswith("multiplier_") and name.endswith("_re") for name in orbits.columns)
    multipliers = [
        orbits[f"multiplier_{i}_re"].to_numpy() + 1j * orbits[f"multiplier_{i}_im"].to_numpy()
        for i in range(n)
    ]
    determinant: NDArray[np.float64] = np.prod([1 - m for m in multipliers], axis=0).real
    return np.sign(determinant)


def on_main_branch(orbits: pd.DataFrame) -> NDArray[np.bool_]:
    """Whether each cycle is of index +1 and its sheet holds a stable cycle, shape (n,).

    Parameters
    ----------
    orbits : DataFrame
        Cycles of a grid of ``k`` at pairs of ``alpha`` and ``omega``.
    """
    main = np.zeros(len(orbits), dtype=bool)
    index = fixed_point_index(orbits)
    period, stable = orbits["period"].to_numpy(), orbits["stable"].to_numpy()
    for rows in orbits.groupby(["alpha", "omega"]).indices.values():
        upright = rows[index[rows] > 0]
        k, column = np.unique(orbits["k"].to_numpy()[upright], return_inverse=True)
        columns = [upright[column == i] for i in range(len(k))]
        sheet = dict(zip(upright.tolist(), upright.tolist(), strict=True))  # named by its first cycle
        for left, right in itertools.pairwise(columns):
            for one, other in _links(period[left], period[right]):
                sheet[int(right[other])] = sheet[int(left[one])]
        alive = {sheet[row] for row in upright.tolist() if stable[row]}
        main[[row for row in upright.tolist() if sheet[row] in alive]] = True
    return main


def _links(left: NDArray[np.float64], right: NDArray[np.float64]) -> list[tuple[int, int]]:
    """Pairs of periods at neighbouring values of `k`, each the nearest of the other."""
    distance = np.abs(left[:, None] - right[None, :])
    nearest = distance.argmin(axis=1)
    return [
        (i, int(j)) for i, j in enumerate(nearest) if distance[:, j].argmin() == i and distance[i, j] < LINK
    ]
