"""Following limit cycles along one parameter: continuation with step control, many at once."""

from dataclasses import dataclass, field
from typing import Any

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from stridemap.solver.branches.main_branch import fixed_point_index
from stridemap.solver.cycles.search import offer
from stridemap.solver.model.model import Model
from stridemap.sweeps.tables import orbit_row

Floats = NDArray[np.float64]

LIKE = 0.05
"""Largest change, in any section coordinate or the period, that a step may make."""
HALVINGS = 14
"""A branch ends where its way is not found in steps of the way's 2^-HALVINGS."""


@dataclass
class Path:
    """A way from one cycle towards a value of the parameter.

    Parameters
    ----------
    rows : list of dict
        What was found on the way, in that order, as rows of ``orbits.parquet`` with cell -1.
    arrived : bool
        Whether the value was reached; if not, the branch ends at the last row.
    """

    rows: list[dict[str, Any]] = field(default_factory=list)
    arrived: bool = False


def state_columns(rows: pd.DataFrame) -> list[str]:
    """The section coordinates and the period: the columns between the status and the multipliers."""
    columns = list(rows.columns)
    return columns[columns.index("status") + 1 : columns.index("period") + 1]


def follow(model: Model, starts: pd.DataFrame, parameter: str, targets: Floats) -> list[Path]:
    """Follow each of n cycles towards a value of its own of a parameter.

    A step is taken if it leads to a cycle of the same index (see `fixed_point_index`) that differs little,
    and halved if not.

    Parameters
    ----------
    model : Model
    starts : pandas.DataFrame
        Rows of ``orbits.parquet``.
    parameter : str
    targets : ndarray, shape (n,)

    Returns
    -------
    list of Path, length n
    """
    names, index = state_columns(starts), fixed_point_index(starts)
    points = starts[[p.name for p in model.parameters]].to_numpy(copy=True)
    column = [p.name for p in model.parameters].index(parameter)
    begin, u = points[:, column].copy(), starts[names].to_numpy(copy=True)
    paths = [Path() for _ in targets]
    done, step = np.zeros(len(targets)), np.ones(len(targets))  # in shares of the way
    slope = np.zeros_like(u)
    open_ = np.arange(len(targets))
    while len(open_):
        ahead = done[open_] + step[open_]
        trial = points[open_]
        trial[:, column] = np.where(
            ahead == 1, targets[open_], begin[open_] + ahead * (targets - begin)[open_]
        )
        guesses = u[open_] + slope[open_] * step[open_, None]
        for i, orbit in zip(open_.tolist(), offer(model, trial, guesses), strict=True):
            row = orbit_row(-1, orbit) if orbit.status.found else None
            now = None if row is None else np.array([row[name] for name in names])
            if (
                row is not None
                and np.abs(now - u[i]).max() < LIKE
                and fixed_point_index(pd.DataFrame([row]))[0] == index[i]
            ):
                paths[i].rows.append(row)
                done[i] += step[i]
                slope[i], u[i] = (now - u[i]) / step[i], now
                paths[i].arrived = bool(done[i] == 1)
            else:
                step[i] /= 2
                slope[i] = 0  # near a fold a straight line leads astray
        open_ = open_[[not paths[i].arrived and step[i] >= 0.5**HALVINGS for i in open_.tolist()]]
    return paths
