"""Special points as columns of a table."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from stridemap.solver.model.model import Model
from stridemap.sweeps.grid import Grid
from stridemap.sweeps.special import SpecialPoint
from stridemap.words import multiplier_columns


def special_columns(
    model: Model, grid: Grid, params: dict[str, float], points: Sequence[SpecialPoint]
) -> dict[str, list[Any]]:
    """Columns of the table of special points, in their order; those that no point has are left out.

    Parameters
    ----------
    model : Model
    grid : Grid
    params : dict of str to float
        Parameters that are not on an axis of the grid.
    points : sequence of SpecialPoint
    """
    axis = grid.longest_axis
    places = grid.indices([point.cell for point in points]) if points else np.empty((0, len(grid.axes)), int)
    lower = np.array([point.lower for point in points])
    # The last cell of the line that is not beyond the point.
    places[:, axis] = np.fmax(np.searchsorted(grid.axes[axis], lower, "right") - 1, 0)
    cells = grid.cells(places)
    first = places.copy()
    first[:, axis] = 0
    parameters = grid.points(model, params, cells).T if points else np.empty((len(model.spec.names), 0))
    rows: list[dict[str, Any]] = []
    varied = grid.names[axis]
    for i, point in enumerate(points):
        row = {
            "cell": int(cells[i]),
            "line": int(grid.cells(first[i : i + 1])[0]),
            "branch": point.branch,
            "type": point.type,
            "lower": point.lower,
            "upper": point.upper,
            "reason": point.reason,
            **dict(zip(model.spec.names, parameters[:, i].tolist(), strict=True)),
            varied: None if point.reason else point.lower,
            **_located(model, point.values),
        }
        rows.append(row)
    names = dict.fromkeys(name for row in rows for name in row)
    return {name: [row.get(name) for row in rows] for name in names}


def _located(model: Model, values: dict[str, Any]) -> dict[str, Any]:
    """Columns of what was located."""
    if not values:
        return {}
    out = {name: value for name, value in values.items() if name not in ("u", "multipliers")}
    out |= dict(zip((*model.section, "period"), values["u"].tolist(), strict=True))
    for i, one in enumerate(values["multipliers"].tolist()):
        real, imaginary = multiplier_columns(i)
        out |= {real: one.real, imaginary: one.imag}
    return out
