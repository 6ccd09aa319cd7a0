"""Whole tables in SI units."""

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from stridemap.columns import Column, columns_of, description
from stridemap.errors import InputError, short
from stridemap.solver.model.loading import load
from stridemap.tables.table import Table, table_of
from stridemap.units import Units, check_scaled


def table_si(table: Any, units: Units, model: Any = None) -> Any:
    """A table in SI units: what `Units.table_si` does.

    Parameters
    ----------
    table : pandas.DataFrame, xarray.Dataset, Orbits, Branches, Boundaries or Table
    units : Units
    model : str, path or Model, optional
    """
    spec = None if model is None else load(model).spec
    if spec is not None:
        check_scaled(spec)
    if hasattr(table, "data_vars"):
        return _dataset(table, units, {} if spec is None else columns_of(spec))
    if isinstance(table, Table):
        return in_si(table, units)
    if hasattr(table, "model") and hasattr(table, "to_frame"):
        check_scaled(table.model.spec)
        return in_si(table_of(table), units).to_frame()
    if not (hasattr(table, "columns") and hasattr(table, "attrs")):
        raise InputError(
            f"{short(table)} is not a table; give a pandas.DataFrame, an xarray.Dataset, limit cycles or "
            "branches, and a single column to to_si"
        )
    frame, said = table, description(table)[0]
    if spec is None and not said:
        raise InputError(
            'the table does not say what its columns hold; name its model, as in table_si(table, "wobbling")'
        )
    # What a frame says of itself goes first: it knows whether it is in SI units already.
    return in_si(Table.of_frame(frame, None if said else spec), units).to_frame()


def in_si(table: Table, units: Units) -> Table:
    """A table in SI units.

    Raises
    ------
    InputError
        When it is in SI units already, or has columns whose units no size converts.
    """
    check(table.columns)
    return converted(table, units)


def converted(table: Table, units: Units) -> Table:
    """A table in SI units, some of whose columns were found to be convertible."""
    frame = _converted(table.frame, table.columns, units)
    cells = None if table.cells is None else _converted(table.cells, table.columns, units)
    grid = {
        name: tuple(value * _factor(table.columns[name], units) for value in values)
        for name, values in table.grid.items()
    }
    columns = {name: one.in_si for name, one in table.columns.items()}
    return replace(table, frame=frame, columns=columns, grid=grid, cells=cells)


def check(columns: Mapping[str, Column]) -> None:
    """Refuse columns that cannot be converted, all of them or some.

    Raises
    ------
    InputError
    """
    dimensional = [one for one in columns.values() if one.unit not in ("", "1", "rad")]
    done = [one for one in dimensional if one.unit == one.si]
    if done:
        raise InputError(
            f"the table is in SI units already: {done[0].name} is in {done[0].unit}; convert the table that "
            "is in the model's units"
        )
    if foreign := [one for one in dimensional if not one.scale]:
        raise InputError(
            f"the column {foreign[0].name} is in {foreign[0].unit}, which has nothing to do with a robot's "
            "size; convert it by hand"
        )
    if not dimensional and not any(one.scale for one in columns.values()):
        raise InputError(
            "no column of the table has a unit; read it with stridemap.read_table, or name its model"
        )


def _factor(column: Column, units: Units) -> float:
    """By what its numbers are multiplied."""
    return units.unit(column.scale) if column.scale not in ("", "1", "rad") else 1.0


def _converted(frame: Any, columns: Mapping[str, Column], units: Units) -> Any:
    """A frame with its dimensional columns converted."""
    changed = {
        name: frame[name] * factor
        for name, one in columns.items()
        if name in frame.columns and (factor := _factor(one, units)) != 1.0
    }
    return frame.assign(**changed)


def _dataset(data: Any, units: Units, known: Mapping[str, Column]) -> Any:
    """A dataset of xarray, by the attributes of its variables, or else by a model's columns."""
    columns = {
        str(name): _said(str(name), one.attrs) or known.get(str(name)) for name, one in data.variables.items()
    }
    if not any(columns.values()):
        raise InputError(
            "the dataset does not say what its variables hold; name its model, as in "
            'table_si(data, "wobbling")'
        )
    present = {name: one for name, one in columns.items() if one is not None}
    check(present)
    out = data.copy()
    for name, one in present.items():
        factor = _factor(one, units)
        attrs = {**data[name].attrs, "units": one.in_si.unit, "scale": ""}
        values = data[name].variable * factor if factor != 1.0 else data[name].variable
        values.attrs = attrs
        out = out.assign_coords({name: values}) if name in data.coords else out.assign({name: values})
    return out


def _said(name: str, attrs: Mapping[str, Any]) -> Column | None:
    """What the attributes of a variable say of it."""
    if "scale" not in attrs or "units" not in attrs:
        return None
    words = [str(attrs.get(key, "")) for key in ("long_name", "units", "scale", "si_units")]
    return Column(name, *words)
