"""The columns of a sweep's two tables, and how rows become tables.

A row of orbits is a limit cycle, a row of cells a grid cell. Columns bear the names of the JSON that
``stridemap orbit`` prints, with state entries, parameters and multipliers as columns of their own.
"""

from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
import pyarrow as pa
from numpy.typing import ArrayLike

if TYPE_CHECKING:
    from stridemap.solver.cycles.orbit import Orbit
    from stridemap.solver.model.model import Model

# Measures of an orbit after its multipliers: the attributes of `Orbit` and the columns, in this order.
_MEASURES: tuple[tuple[str, pa.DataType], ...] = (
    ("spectral_radius", pa.float64()),
    ("stable", pa.bool_()),
    ("group", pa.string()),
    ("step_length", pa.float64()),
    ("speed", pa.float64()),
    ("d_max", pa.float64()),
    ("work", pa.float64()),
    ("work_positive", pa.float64()),
    ("work_net", pa.float64()),
    ("cot", pa.float64()),
    ("cot_per_speed", pa.float64()),
    ("min_vertical_force", pa.float64()),
    ("friction", pa.float64()),
    ("clearance", pa.float64()),
    ("peaks", pa.int64()),
    ("x_zero_crossings", pa.int64()),
    ("residual", pa.float64()),
    ("integration_error", pa.float64()),
)
_NULLABLE = ("group", "x_zero_crossings", "reason")


def orbit_schema(model: "Model") -> pa.Schema:
    """Return the columns of ``orbits.parquet``; all but `group` and `x_zero_crossings` are full."""
    columns = [
        *_cell_columns(model),
        ("status", pa.string()),
        *((name, pa.float64()) for name in model.section),
        ("period", pa.float64()),
        *(
            (f"multiplier_{i}_{part}", pa.float64())
            for i in range(len(model.section))
            for part in ("re", "im")
        ),
        *_MEASURES,
    ]
    return _schema(columns)


def cell_schema(model: "Model") -> pa.Schema:
    """Return the columns of ``cells.parquet``; all but `reason` are full."""
    counts = [("orbits", pa.int64()), ("stable_orbits", pa.int64())]
    return _schema([*_cell_columns(model), *counts, ("status", pa.string()), ("reason", pa.string())])


def orbit_row(cell: int, orbit: "Orbit") -> dict[str, Any]:
    """Return one orbit found in `cell` as a row of `orbit_schema`."""
    row: dict[str, Any] = {"cell": cell, **orbit.params, "status": orbit.status.value, **orbit.state}
    row["period"] = orbit.period
    for i, multiplier in enumerate(orbit.multipliers):
        row[f"multiplier_{i}_re"], row[f"multiplier_{i}_im"] = multiplier.real, multiplier.imag
    return row | {name: getattr(orbit, name) for name, _ in _MEASURES}


def orbit_table(model: "Model", rows: Sequence[Mapping[str, Any]]) -> pa.Table:
    """Return rows made by `orbit_row` as a table of `orbit_schema`.

    Raises
    ------
    ValueError
        If a row has other columns than the schema, or None where a column must be full.
    """
    schema = orbit_schema(model)
    for row in rows:
        if different := row.keys() ^ set(schema.names):
            raise ValueError(
                f"a row of orbits has missing or unknown columns: {', '.join(sorted(different))}"
            )
    table = pa.Table.from_pylist(list(rows), schema=schema)
    _require_full(table)
    return table


def cell_table(
    model: "Model", points: ArrayLike, orbits: pa.Table, status: Sequence[str], reason: Sequence[str | None]
) -> pa.Table:
    """Return the table of `cell_schema`, a row for each cell from 0, with the orbits of each counted.

    Parameters
    ----------
    model : Model
        The model.
    points : array_like, shape(n_cells, n_parameters)
        The parameter points of all cells, as from `Grid.points`.
    orbits : Table
        All orbits found, as from `orbit_table`.
    status, reason : sequence, length n_cells
        What became of each cell, and why if it failed (None if it did not).
    """
    columns = np.asarray(points, dtype=np.float64).T
    n_cells = columns.shape[1]
    found, stable = orbits["cell"].to_numpy(), orbits["stable"].to_numpy()
    data = {
        "cell": np.arange(n_cells),
        **{parameter.name: column for parameter, column in zip(model.parameters, columns, strict=True)},
        "orbits": np.bincount(found, minlength=n_cells),
        "stable_orbits": np.bincount(found[stable], minlength=n_cells),
        "status": status,
        "reason": reason,
    }
    table = pa.Table.from_pydict(data, schema=cell_schema(model))
    _require_full(table)
    return table


def _cell_columns(model: "Model") -> list[tuple[str, pa.DataType]]:
    """Return the columns that say where a row belongs: the cell and the parameters."""
    return [("cell", pa.int64()), *((parameter.name, pa.float64()) for parameter in model.parameters)]


def _schema(columns: Iterable[tuple[str, pa.DataType]]) -> pa.Schema:
    return pa.schema([pa.field(name, kind, nullable=name in _NULLABLE) for name, kind in columns])


def _require_full(table: pa.Table) -> None:
    """Refuse a null in a column that must be full; Arrow itself does not look until it writes a file."""
    for field in table.schema:
        if not field.nullable and table[field.name].null_count:
            raise ValueError(f"the column {field.name} has missing values")
