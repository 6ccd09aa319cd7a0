"""The columns of a sweep's tables, and how limit cycles become tables.

A row of orbits is a limit cycle, a row of cells a grid cell, a row of special points such a point on a line
of the grid. Columns bear the names of the JSON that ``stridemap orbit`` prints, with state entries,
parameters and multipliers as columns of their own; which quantities there are says `stridemap.quantities`.
"""

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np
import pyarrow as pa
from numpy.typing import ArrayLike, NDArray

from stridemap.solver.cycles.orbits import Orbits
from stridemap.solver.model.model import Model
from stridemap.words import multiplier_columns

FORMAT = 5
"""Of the tables: it rises when columns change, other than those of measured quantities."""

PARTS_FORMAT = 2
"""Of what is kept of a sweep until it is finished: it rises when that, or what is made of it, changes."""

_TYPES = {"float": pa.float64(), "int": pa.int64(), "bool": pa.bool_(), "str": pa.string()}


def orbit_schema(model: Model) -> pa.Schema:
    """Columns of ``orbits.parquet``; all but those of quantities that a model can lack are full."""
    columns = [
        *_cell_columns(model),
        ("branch", pa.int64()),
        ("status", pa.string()),
        *((name, pa.float64()) for name in model.section),
        ("period", pa.float64()),
        *((name, pa.float64()) for i in range(len(model.section)) for name in multiplier_columns(i)),
        *((name, _TYPES[quantity.type]) for name, quantity in model.measured.items()),
    ]
    return _schema(columns, {name for name, quantity in model.measured.items() if quantity.optional})


def cell_schema(model: Model) -> pa.Schema:
    """Columns of ``cells.parquet``; all but `reason` are full."""
    counts = [("orbits", pa.int64()), ("stable_orbits", pa.int64())]
    columns = [*_cell_columns(model), *counts, ("status", pa.string()), ("reason", pa.string())]
    return _schema(columns, {"reason"})


def special_schema(model: Model) -> pa.Schema:
    """Columns of ``special.parquet``; a point that was not located has its place and a reason alone."""
    places = [("cell", pa.int64()), ("line", pa.int64()), ("branch", pa.int64()), ("type", pa.string())]
    bounds = [("lower", pa.float64()), ("upper", pa.float64())]
    parameters = [(name, pa.float64()) for name in model.spec.names]
    located = [
        *((name, pa.float64()) for name in model.section),
        ("period", pa.float64()),
        *((name, pa.float64()) for i in range(len(model.section)) for name in multiplier_columns(i)),
        ("residual", pa.float64()),
        ("gait", pa.bool_()),
        ("criticality", pa.string()),
        ("multiplier_re", pa.float64()),
        ("multiplier_im", pa.float64()),
        ("crossing_slope", pa.float64()),
        *((f"null_{name}_{part}", pa.float64()) for name in model.section for part in ("re", "im")),
        ("reason", pa.string()),
    ]
    nullable = {name for name, _ in [*parameters, *located]}
    return _schema([*places, *parameters, *bounds, *located], nullable)


def orbit_table(cell: NDArray[np.int64], branch: NDArray[np.int64], orbits: Orbits) -> pa.Table:
    """Limit cycles as a table of `orbit_schema`.

    Parameters
    ----------
    cell, branch : ndarray of int, shape (n,)
        The grid cell and the branch of each.
    orbits : Orbits

    Raises
    ------
    ValueError
        If a value is missing in a column that must be full.
    """
    return table_of(orbits.model, {"cell": cell, "branch": branch, **orbits.columns()})


def table_of(model: Model, columns: Mapping[str, Any]) -> pa.Table:
    """A table of `orbit_schema` from its columns, as NumPy or Arrow has them.

    Raises
    ------
    ValueError
        If a value is missing in a column that must be full.
    """
    schema, columns = orbit_schema(model), dict(columns)
    for name in (field.name for field in schema if field.nullable):  # what a model lacks is null, not NaN
        if isinstance(columns[name], np.ndarray):
            columns[name] = pa.array(columns[name], schema.field(name).type, from_pandas=True)
    table = pa.Table.from_pydict(columns, schema=schema)
    _require_full(table)
    return table


def cell_table(
    model: Model,
    points: ArrayLike,
    counts: Mapping[str, NDArray[Any]],
    status: Sequence[str],
    reason: Sequence[str | None],
    first: int = 0,
) -> pa.Table:
    """A table of `cell_schema`, one row per cell.

    Parameters
    ----------
    model : Model
        The model.
    points : array_like, shape(n_cells, n_parameters)
        The parameter points of the cells, as from `Grid.points`.
    counts : mapping of str to ndarray of int, shape(n_cells,)
        For each cell how many ``orbits`` it has, and ``stable_orbits``.
    status, reason : sequence, length n_cells
        What became of each cell, and why if it failed (None if it did not).
    first : int
        Number of the first cell.
    """
    columns = np.asarray(points, dtype=np.float64).T
    data = {
        "cell": np.arange(first, first + columns.shape[1]),
        **dict(zip(model.spec.names, columns, strict=True)),
        **counts,
        "status": status,
        "reason": reason,
    }
    table = pa.Table.from_pydict(data, schema=cell_schema(model))
    _require_full(table)
    return table


def _cell_columns(model: Model) -> list[tuple[str, pa.DataType]]:
    """The columns that say where a row belongs: the cell and the parameters."""
    return [("cell", pa.int64()), *((name, pa.float64()) for name in model.spec.names)]


def _schema(columns: Iterable[tuple[str, pa.DataType]], nullable: set[str]) -> pa.Schema:
    return pa.schema([pa.field(name, kind, nullable=name in nullable) for name, kind in columns])


def _require_full(table: pa.Table) -> None:
    """Refuse a null in a column that must be full; Arrow itself does not look until it writes a file."""
    for field in table.schema:
        if not field.nullable and table[field.name].null_count:
            raise ValueError(f"the column {field.name} has missing values")
