"""The table of special points, and which of its rows are one point."""

from collections.abc import Mapping
from typing import Any

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from stridemap.solver.model.model import Model
from stridemap.solver.model.scales import Scales
from stridemap.sweeps.tables import special_schema

Ints = NDArray[np.int64]

SAME_POINT = 1e-6
"""Largest difference of two special points that are one, in any entry and in terms of the scales."""


def special_table_of(model: Model, columns: Mapping[str, Any]) -> pa.Table:
    """Special points as a table of `special_schema`, from the columns that they have."""
    n = len(next(iter(columns.values()), ()))
    schema = special_schema(model)
    return pa.Table.from_pydict({name: columns.get(name, [None] * n) for name in schema.names}, schema=schema)


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
    # Tiles that share a line meet a point once each. Of these the first counts that belongs to a family with
    # cycles in cells: its number is lower than that of a family without one.
    by_branch = sorted(enumerate(rows), key=lambda numbered: numbered[1]["branch"])
    for located in (True, False):
        for i, row in by_branch:
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
