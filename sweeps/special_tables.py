"""Special points as a table, and which rows of such tables are one point."""

from collections.abc import Sequence
from typing import Any

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from stridemap.solver.model.model import Model
from stridemap.solver.model.scales import Scales
from stridemap.sweeps.grid import Grid
from stridemap.sweeps.special import SpecialPoint
from stridemap.sweeps.tables import special_schema
from stridemap.words import multiplier_columns

Ints = NDArray[np.int64]

SAME_POINT = 1e-6
"""Largest difference of two special points that are one, in any entry and in terms of the scales."""


def special_table(
    model: Model, grid: Grid, params: dict[str, float], points: Sequence[SpecialPoint]
) -> pa.Table:
    """Special points as a table of `special_schema`, in their order.

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
    rows: dict[str, list[Any]] = {name: [] for name in special_schema(model).names}
    varied = grid.names[axis]
    for i, point in enumerate(points):
        row: dict[str, Any] = {
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
        for name, column in rows.items():
            column.append(row.get(name))
    return pa.Table.from_pydict(rows, schema=special_schema(model))


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


def in_order(model: Model, varied: str, width: float, table: pa.Table) -> pa.Table:
    """Rows ordered by line, value, type and branch, each point once.

    What was not located is left out where a point of its type was, between the two values.

    Parameters
    ----------
    model : Model
    varied : str
        The parameter that varies along lines.
    width : float
        Length of its range.
    table : Table
        With final numbers of branches.
    """
    keys = ("line", "lower", "upper", "type", "branch", "period")
    scale = np.append(Scales.of(model).unknowns, width)
    names = (*model.section, "period", varied)
    x = np.column_stack([table[name].to_numpy(zero_copy_only=False) for name in names]) / scale
    rows = table.select(["line", "type", "branch", "lower", "upper", "reason"]).to_pylist()
    kept: dict[tuple[int, str], list[int]] = {}
    for located in (True, False):
        for i, row in enumerate(rows):
            if (row["reason"] is None) != located:
                continue
            like = kept.setdefault((row["line"], row["type"]), [])
            if not any(_is_one(rows[j], row, x[j], x[i]) for j in like):
                like.append(i)
    index = np.sort(np.array([i for like in kept.values() for i in like], dtype=np.int64))
    return table.take(pa.array(index)).sort_by([(key, "ascending") for key in keys])


def _is_one(known: dict[str, Any], row: dict[str, Any], x: Any, y: Any) -> bool:
    """Whether a row says nothing that a known one of its line and type does not say."""
    if row["reason"] is None:
        return bool((np.abs(x - y) < SAME_POINT).all())
    overlap = bool(known["lower"] <= row["upper"] and row["lower"] <= known["upper"])
    return overlap and known["branch"] == row["branch"]
