"""Tables as files of other programs: comma-separated values, MATLAB, and netCDF."""

import io
import os
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from stridemap.errors import InputError, StorageError
from stridemap.tables.gridded import Variable, gridded, plain_values
from stridemap.tables.table import SWEPT, Table

LONGEST_NAME = 63
"""Characters of a name in MATLAB."""


def export(table: Table, path: str | Path, by: str = "cycle") -> list[Path]:
    """Write a table for other programs: see `Table.export`.

    Parameters
    ----------
    table : Table
    path : str or path
    by : {"cycle", "branch"}

    Returns
    -------
    list of pathlib.Path

    Raises
    ------
    InputError
        For another ending.
    StorageError
        When a file cannot be written.
    """
    path = Path(path)
    check_ending(path)
    written = []
    for target, content in KINDS[path.suffix](table, path, by).items():
        try:
            target.parent.mkdir(parents=True, exist_ok=True)
            if os.path.exists(target) and not os.path.isfile(target):
                raise OSError(None, "it is not a file")  # to write into a pipe waits for who reads it
            target.write_bytes(content)
        except OSError as error:
            raise StorageError(
                f"cannot write {target} ({error.strerror or error}); give a path that can be written"
            ) from None
        written.append(target)
    return written


def check_ending(path: Path) -> None:
    """Refuse a path whose ending names no kind of file.

    Raises
    ------
    InputError
    """
    if path.suffix not in KINDS:
        raise InputError(f"{path} must end in {', '.join(KINDS)}, which says what is written")
    if path.name in SWEPT:
        raise InputError(f"{path} has the name of a table that a sweep wrote; choose another name")


def _csv(table: Table, path: Path, _by: str) -> dict[Path, bytes]:
    return {
        path: csv_text(table.frame).encode(),
        path.with_stem(f"{path.stem}_columns"): about_columns(table).encode(),
    }


def about_columns(table: Table) -> str:
    """What stands beside a table of comma-separated values: meaning and unit of each column."""
    import pandas as pd

    rows = [{"column": one.name, "meaning": one.label, "unit": one.unit} for one in table.columns.values()]
    return csv_text(pd.DataFrame(rows))


def csv_text(frame: Any, header: bool = True) -> str:
    """A data frame as comma-separated values, with all digits; what is missing is empty.

    Parameters
    ----------
    frame : pandas.DataFrame
    header : bool
        Whether the names of columns stand in the first line.
    """
    text: str = frame.to_csv(index=False, lineterminator="\n", header=header)
    return text


def _mat(table: Table, _path: Path, _by: str) -> dict[Path, bytes]:
    from scipy.io import savemat

    if long := [name for name in table.columns if len(name) > LONGEST_NAME]:
        raise InputError(f"the name {long[0]} is too long for MATLAB; select other columns, or write a .csv")
    rows = {"limit cycles": "orbits", "grid cells": "cells"}.get(table.what, table.what.replace(" ", "_"))
    content: dict[str, Any] = {rows: _columns(table.frame)}
    if table.cells is not None and rows != "cells":
        content["cells"] = _columns(table.cells)
    if table.grid:
        content["grid"] = {name: np.array(values)[:, None] for name, values in table.grid.items()}
    content["units"] = {name: one.unit for name, one in table.columns.items()}
    content["meanings"] = {name: one.label for name, one in table.columns.items()}
    content["model"] = table.model
    out = io.BytesIO()
    savemat(out, content, long_field_names=True, oned_as="column")
    # The first 116 bytes are free text in which SciPy writes the time: equal tables give equal bytes.
    head = b"MATLAB 5.0 MAT-file, written by stridemap".ljust(116)
    return {_path: head + out.getvalue()[116:]}


def _columns(frame: Any) -> dict[str, NDArray[Any]]:
    """Columns of a frame; texts become cell arrays."""
    return {str(name): plain_values(frame[name])[:, None] for name in frame.columns}


def _nc(table: Table, path: Path, by: str) -> dict[Path, bytes]:
    from scipy.io import netcdf_file

    data = gridded(table, by)
    out = _Kept()
    file = netcdf_file(out, "w", version=2)
    for name, value in data.attrs.items():
        setattr(file, name, value)
    lengths: dict[str, int] = {}
    for one in (*data.coordinates.values(), *data.variables.values()):
        lengths |= dict(zip(one.dims, one.values.shape, strict=True))
    for name, length in lengths.items():
        file.createDimension(name, length)
    for name, one in {**data.coordinates, **data.variables}.items():
        _write(file, name, one)
    file.flush()
    return {path: out.getvalue()}


class _Kept(io.BytesIO):
    """What is written stays when the file is closed, as SciPy does when it is deleted."""

    def close(self) -> None:
        """Keep what was written."""


def _write(file: Any, name: str, one: Variable) -> None:
    """A variable in a netCDF file: numbers as doubles, or 32 bits where whole ones fit; texts as bytes."""
    values, dims = one.values, one.dims
    attrs: Mapping[str, Any] = one.attrs
    if values.dtype == object:
        coded = np.array([str(text).encode() for text in values.ravel()], dtype=bytes)
        width = max(1, coded.dtype.itemsize)
        if f"text{width}" not in file.dimensions:
            file.createDimension(f"text{width}", width)
        dims = (*dims, f"text{width}")
        values = coded.astype(f"S{width}").view("S1").reshape(*one.values.shape, width)
        variable = file.createVariable(name, "c", dims)
        attrs = {**attrs, "_Encoding": "utf-8"}
    elif values.dtype.kind == "b":
        values = values.astype(np.int8)
        variable = file.createVariable(name, "b", dims)
        attrs = {**attrs, "dtype": "bool"}
    elif values.dtype.kind == "i" and np.abs(values).max(initial=0) < 2**31:
        values = values.astype(np.int32)
        variable = file.createVariable(name, "i", dims)
    else:
        values = values.astype(np.float64)
        variable = file.createVariable(name, "d", dims)
    variable[:] = values
    for key, value in attrs.items():
        if value:
            setattr(variable, key, value)


def _parquet(table: Table, path: Path, _by: str) -> dict[Path, bytes]:
    out = io.BytesIO()
    table.to_frame().to_parquet(out, index=False)
    return {path: out.getvalue()}


KINDS: Mapping[str, Callable[[Table, Path, str], dict[Path, bytes]]] = {
    ".csv": _csv,
    ".mat": _mat,
    ".nc": _nc,
    ".parquet": _parquet,
}
"""What writes each kind of file, by its ending."""
