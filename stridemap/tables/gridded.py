"""Tables as arrays over named dimensions: the parameters of a sweep's grid, and the cycles of each cell."""

from collections.abc import Mapping
from dataclasses import dataclass
from importlib.util import find_spec
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from stridemap.errors import InputError
from stridemap.tables.table import Table

if TYPE_CHECKING:
    import xarray

BY = ("cycle", "branch")
"""What the cycles of one cell are told apart by."""

LARGEST = 200_000_000
"""Entries of an array beyond which a grid is refused: most of them would be empty."""


@dataclass(frozen=True)
class Variable:
    """An array over named dimensions, with its attributes.

    Parameters
    ----------
    dims : tuple of str
    values : ndarray
    attrs : mapping of str to str
    """

    dims: tuple[str, ...]
    values: NDArray[Any]
    attrs: Mapping[str, str]


@dataclass(frozen=True)
class Gridded:
    """Variables that share their dimensions.

    Parameters
    ----------
    coordinates, variables : mapping of str to Variable
    attrs : mapping of str to str
    """

    coordinates: Mapping[str, Variable]
    variables: Mapping[str, Variable]
    attrs: Mapping[str, str]


def to_xarray(table: Table, by: str = "cycle") -> "xarray.Dataset":
    """A table as an `xarray.Dataset`: see `Table.to_xarray`.

    Parameters
    ----------
    table : Table
    by : {"cycle", "branch"}

    Raises
    ------
    InputError
        When xarray is not installed, or the arrays would be too large.
    """
    if find_spec("xarray") is None:
        raise InputError("this needs xarray, which is not installed here: run `pip install xarray`")
    import xarray as xr

    data = gridded(table, by)

    def variables(of: Mapping[str, Variable]) -> dict[str, Any]:
        return {name: (one.dims, one.values, dict(one.attrs)) for name, one in of.items()}

    return xr.Dataset(variables(data.variables), variables(data.coordinates), dict(data.attrs))


def gridded(table: Table, by: str = "cycle") -> Gridded:
    """A table as arrays; see `to_xarray`.

    Raises
    ------
    InputError
        For an unknown `by`, or arrays that would be too large.
    """
    if by not in BY:
        raise InputError(f"by = {by!r} is not allowed; it is {' or '.join(BY)}")
    attrs = {"title": repr(table)[1:-1], "source": "stridemap", "model": table.model}
    if not table.grid:
        if by == "branch":
            raise InputError("by = 'branch' is for a sweep, whose cells have branches; leave it out")
        dim = "cycle" if table.what == "limit cycles" else "row"
        coordinates = {dim: Variable((dim,), np.arange(len(table)), {"long_name": f"number of the {dim}"})}
        variables = {
            name: Variable(
                (dim,), _filled(table, name, (len(table),), (np.arange(len(table)),)), _attrs(table, name)
            )
            for name in table.columns
        }
        return Gridded(coordinates, variables, attrs)
    needed = [*table.grid, "cell", *(["period"] if table.what != "grid cells" else [])]
    needed += ["branch"] if by == "branch" else []
    if lacking := [name for name in needed if name not in table.columns]:
        columns = f"column{'s' if len(lacking) > 1 else ''} {', '.join(lacking)}"
        raise InputError(f"arrays over the grid need the {columns}, which the table lacks; read all columns")
    axes = {name: np.array(values) for name, values in table.grid.items()}
    shape = tuple(map(len, axes.values()))
    coordinates = {name: Variable((name,), values, _attrs(table, name)) for name, values in axes.items()}
    variables = _of_cells(table, tuple(axes), shape)
    if table.what == "grid cells":
        return Gridded(coordinates, variables, attrs)
    more, places = _places(table, by)
    for name, values in more.items():
        label = {"cycle": "limit cycle of the cell, by rising period", "branch": "branch of limit cycles"}
        coordinates[name] = Variable((name,), values, {"long_name": label.get(name, "passage of the branch")})
    whole = (*shape, *map(len, more.values()))
    if (size := int(np.prod(whole, dtype=object))) > LARGEST:
        sizes = " x ".join(f"{n:,} {name}" for name, n in zip((*axes, *more), whole, strict=True))
        raise InputError(
            f"the arrays would have {size:,} entries each ({sizes}); select rows first, or use by = 'cycle'"
        )
    index = (*np.unravel_index(table.frame["cell"].to_numpy(), shape), *places)
    for name in table.columns:
        if name not in (*axes, "cell", *more):
            variables[name] = Variable(
                (*axes, *more), _filled(table, name, whole, index), _attrs(table, name)
            )
    return Gridded(coordinates, variables, attrs)


def _places(table: Table, by: str) -> tuple[dict[str, NDArray[Any]], tuple[NDArray[Any], ...]]:
    """Coordinates of the dimensions within a cell, and where on them each limit cycle lies."""
    frame = table.frame
    if by == "cycle":
        number = _rank(frame, ["cell"])
        return {"cycle": np.arange(number.max(initial=-1) + 1)}, (number,)
    branches, place = np.unique(frame["branch"].to_numpy(), return_inverse=True)
    passage = _rank(frame, ["cell", "branch"])
    return {"branch": branches, "passage": np.arange(passage.max(initial=-1) + 1)}, (place, passage)


def _rank(frame: Any, within: list[str]) -> NDArray[Any]:
    """Number of each row within its group, by rising period."""
    order = frame["period"].to_numpy().argsort(kind="stable")
    counted = frame.iloc[order].groupby(within, sort=False).cumcount().to_numpy()
    rank: NDArray[Any] = np.empty(len(frame), dtype=np.int64)
    rank[order] = counted
    return rank


def _of_cells(table: Table, axes: tuple[str, ...], shape: tuple[int, ...]) -> dict[str, Variable]:
    """What became of the cells, over the grid alone; their ``status`` is ``cell_status`` here."""
    if table.cells is None:
        return {}
    names = {
        "orbits": "orbits",
        "stable_orbits": "stable_orbits",
        "cell_status": "status",
        "reason": "reason",
    }
    labels = {"cell_status": "what became of the cell", "reason": "why the cell failed"}
    out = {}
    for name, column in names.items():
        values = table.cells[column]
        filled = (
            values.fillna("").to_numpy(dtype=object) if column in ("status", "reason") else values.to_numpy()
        )
        attrs = {"long_name": labels.get(name, _label(name))}
        out[name] = Variable(axes, filled.reshape(shape), attrs)
    return out


def _label(name: str) -> str:
    from stridemap.words import CELL_COLUMNS

    return CELL_COLUMNS.get(name, name)


def _filled(table: Table, name: str, shape: tuple[int, ...], index: tuple[NDArray[Any], ...]) -> NDArray[Any]:
    """A column as an array, with what stands for a gap of its kind elsewhere."""
    values = plain_values(table.frame[name])
    gap: Any = np.nan if values.dtype.kind == "f" else ""
    if values.dtype.kind in "ib":
        if int(np.prod(shape)) == len(values):
            gap = 0  # there are no gaps
        else:
            values, gap = values.astype(np.float64), np.nan
    out = np.full(shape, gap, dtype=values.dtype)
    out[index] = values
    return out


def plain_values(values: Any) -> NDArray[Any]:
    """A column of a data frame as an array of numbers, truths or texts.

    Whole numbers and truths with gaps are numbers, with NaN for a gap; in texts a gap is empty.

    Parameters
    ----------
    values : pandas.Series
    """
    import pandas as pd

    missing = values.isna().to_numpy()
    kind = pd.api.types.infer_dtype(values, skipna=True)
    if kind == "boolean" and not missing.any():
        return np.asarray(values.to_numpy(dtype=bool))
    if kind in ("boolean", "integer", "floating", "mixed-integer-float"):
        if kind == "integer" and not missing.any():
            return np.asarray(values.to_numpy(dtype=np.int64))
        return np.asarray(values.astype("Float64").to_numpy(dtype=np.float64, na_value=np.nan))
    if missing.all() and not isinstance(values.dtype, pd.StringDtype) and values.dtype != object:
        return np.full(len(values), np.nan)
    texts = np.array(
        ["" if gap else str(one) for one, gap in zip(values, missing, strict=True)], dtype=object
    )
    return texts


def _attrs(table: Table, name: str) -> dict[str, str]:
    """Attributes of a variable, by the conventions of netCDF."""
    one = table.columns[name]
    attrs = {"long_name": one.label}
    if one.unit:
        attrs |= {"units": one.unit, "scale": one.scale, "si_units": one.si}
    return attrs
