"""Tables from files: of sweeps, branches, boundaries, limit cycles and walks."""

import json
import os
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from stridemap.errors import InputError, short
from stridemap.solver.model.loading import available, load
from stridemap.spec import ModelSpec
from stridemap.sweeps.files import GROUP_ROWS
from stridemap.sweeps.opened import OpenedSweep
from stridemap.sweeps.reading import open_sweep
from stridemap.sweeps.store import CELLS, ORBITS, check_columns
from stridemap.tables.conversion import check, converted
from stridemap.tables.table import SWEPT, Table
from stridemap.tables.where import names_in, selected
from stridemap.units import Units

MODEL = "model"
"""What asks for the units of the model."""

ENDINGS = (".parquet", ".csv")


def read_table(
    path: str | Path,
    model: Any = None,
    units: "Units | str | None" = None,
    columns: Sequence[str] | None = None,
    where: str | None = None,
) -> Table:
    """Read a table with the meaning and the unit of each of its columns.

    Parameters
    ----------
    path : str or path
        Output folder of a sweep, or one of its tables; or a ``.parquet`` or ``.csv`` file that a command
        of stridemap wrote.
    model : str, path or Model, optional
        The table's model, where the file does not say what its columns hold, as a ``.csv`` cannot; and of a
        sweep, where its model does not come with stridemap.
    units : Units or "model", optional
        The size of a robot: the table is converted to its SI units. Without it, the tables of a sweep whose
        file gives ``[units]`` are in SI units, and all others as they were written; with "model", those of a
        sweep are in the units of the model, in which they are stored.
    columns : sequence of str, optional
        The columns to read, by default all. With them, a sweep's table is without its `cells`.
    where : str, optional
        Read only rows for which a condition holds; see `Table.where`. Of a sweep, the other rows never take
        memory, and neither do columns that are not read.

    Returns
    -------
    Table

    Raises
    ------
    InputError
        When there is no such table, it lacks a column that is named, or the condition is not understood.
    """
    reader = _Reader(Path(path), model, units, columns, where)
    table = reader.source.read(reader.wanted, reader.needed, reader.mask)
    return reader.converted(table)


def read_batches(
    path: str | Path,
    model: Any = None,
    units: "Units | str | None" = None,
    columns: Sequence[str] | None = None,
    where: str | None = None,
) -> Iterator[Table]:
    """Read a table of a sweep in batches, of which each takes some 10 MB: for what need not see all at once.

    Parameters
    ----------
    path, model, units, columns, where
        As for `read_table`.

    Yields
    ------
    Table
        At least one row, and some ten thousand at most, which follow each other in the table; no `cells`.

    Raises
    ------
    InputError
        As `read_table`.
    """
    reader = _Reader(Path(path), model, units, columns, where)
    return reader.batches()


def table_head(path: str | Path, model: Any = None, units: "Units | str | None" = None) -> Table:
    """A table without its rows, as `read_table` would give it: what columns it has, of what kinds.

    Parameters
    ----------
    path, model, units
        As for `read_table`.
    """
    return _Reader(Path(path), model, units, None, None).head


class _Reader:
    """A table that is to be read: from where, in what units, and what of it; all of it is checked here."""

    def __init__(
        self, path: Path, model: Any, units: Any, columns: Sequence[str] | None, where: str | None
    ) -> None:
        if not (units is None or units == MODEL or isinstance(units, Units)):
            raise InputError(f"units = {short(units)} is not allowed; give stridemap.Units or {MODEL!r}")
        self.source, self.units = _found(path, model), units
        stored = self.source.head
        if isinstance(units, Units):
            check(stored.columns)
        self.head = self._converted(stored)
        self.where, self.wanted, self.needed = where, columns, []
        if columns is not None:
            check_columns(columns, list(stored.columns))
        if where is not None:
            selected(self.head.frame, where)  # refuses what is not a condition on these columns
            self.needed = [name for name in names_in(where) if name in stored.columns]

    def converted(self, table: Table) -> Table:
        """A table in the units that are asked for, from those in which it is stored."""
        return replace(self._converted(replace(table, grid={})), grid=self.head.grid)

    def _converted(self, table: Table) -> Table:
        if self.units is None and table.units:
            return _as_given(table)
        return converted(table, self.units) if isinstance(self.units, Units) else table

    @property
    def mask(self) -> "Callable[[Any], Any] | None":
        """For which rows of a frame the condition holds, which is one on values in the units asked for."""
        if self.where is None:
            return None
        condition = self.where

        def holds(frame: Any) -> Any:
            return selected(self.converted(_part(self.source.head, frame)).frame, condition)

        return holds

    def batches(self) -> Iterator[Table]:
        """The table in batches."""
        stored, mask = self.source.head, self.mask
        names = None if self.wanted is None else list(dict.fromkeys([*self.wanted, *self.needed]))
        for frame in self.source.frames(names):
            kept = frame if mask is None else frame[mask(frame)]
            if len(kept):
                shown = kept if self.wanted is None else kept[list(self.wanted)]
                yield self.converted(_part(stored, shown.reset_index(drop=True)))


def some_columns(table: Table, columns: Sequence[str]) -> Table:
    """A table with some of its columns."""
    return _part(table, table.frame[list(columns)])


def _part(table: Table, frame: Any) -> Table:
    """A table with other rows, and some of its columns."""
    columns = {name: table.columns[name] for name in frame.columns}
    return replace(table, frame=frame, columns=columns, cells=None)


@dataclass(frozen=True)
class _Plain:
    """A file that holds one table: it is read as a whole.

    Parameters
    ----------
    table : Table
    """

    table: Table

    @property
    def head(self) -> Table:
        """The table without its rows."""
        return replace(self.table, frame=self.table.frame.iloc[:0])

    def read(self, columns: Any, _needed: Any, mask: Any) -> Table:
        """The rows for which a condition holds, and some columns."""
        frame = self.table.frame if mask is None else self.table.frame[mask(self.table.frame)]
        return _part(self.table, frame if columns is None else frame[list(columns)])

    def frames(self, columns: Any) -> Iterator[Any]:
        """Some columns in batches."""
        frame = self.table.frame if columns is None else self.table.frame[list(columns)]
        return (frame.iloc[at : at + GROUP_ROWS] for at in range(0, len(frame), GROUP_ROWS))


@dataclass(frozen=True)
class _Swept:
    """A table of a sweep, of which no more is read than is asked for.

    Parameters
    ----------
    opened : OpenedSweep
    name : {ORBITS, CELLS}
    head : Table
        It without its rows.
    """

    opened: OpenedSweep
    name: str
    head: Table

    def read(self, columns: Any, needed: Any, mask: Any) -> Table:
        """The rows for which a condition holds, and some columns."""
        cells = self.opened.frame(CELLS) if columns is None and self.name == ORBITS else None
        frame = self.opened.frame(self.name, columns, mask, needed)
        if columns is None and self.name == CELLS:
            cells = frame
        frame.attrs = dict(self.head.frame.attrs)
        return replace(_part(self.head, frame), cells=cells)

    def frames(self, columns: Any) -> Iterator[Any]:
        """Some columns in batches."""
        return self.opened.frames(self.name, columns)


def _as_given(table: Table) -> Table:
    """The table of a sweep in the SI units that its file was written in, with the parameters that it gave."""
    in_si = converted(table, Units.from_mapping(table.units))
    # 3,500 N/m became a number without a unit and comes back: its last bit may differ then.
    names = table.parameters
    frames = [
        None if frame is None else frame.assign(**{n: _rounded(frame[n]) for n in names if n in frame})
        for frame in (in_si.frame, in_si.cells)
    ]
    grid = {name: tuple(_rounded(values).tolist()) for name, values in in_si.grid.items()}
    return replace(in_si, frame=frames[0], cells=frames[1], grid=grid)


def _rounded(values: Any) -> Any:
    every, place = np.unique(np.asarray(values, dtype=np.float64), return_inverse=True)
    return np.array([float(f"{value:.15g}") for value in every.tolist()])[place]


def _found(path: Path, model: Any) -> _Plain | _Swept:
    """The table of a file or a folder, in the units in which it is stored."""
    if os.path.isdir(path) or path.name in SWEPT:
        return _swept(path, model)
    if path.suffix not in ENDINGS:
        raise InputError(
            f"{path} is not a table; give the output folder of a sweep, or a file that ends in "
            f"{' or '.join(ENDINGS)}"
        )
    spec = None if model is None else load(model).spec
    frame, in_si = _read(path), False
    if spec is None and path.suffix == ".parquet":
        spec, in_si = _walk(path)
    if spec is not None and not frame.attrs:
        strange = [name for name in spec.names if name not in frame.columns and "time" not in frame.columns]
        if strange:
            raise InputError(
                f"{path} has no column {strange[0]}, which tables of {spec.name} have; name the model that "
                "it is of"
            )
    table = Table.of_frame(frame, spec if not frame.attrs else None)
    if in_si:
        table = replace(table, columns={name: one.in_si for name, one in table.columns.items()})
    if spec is not None and table.model and table.model != spec.name:
        raise InputError(f"{path} is of the model {table.model}, not of {spec.name}; name that one, or none")
    return _Plain(table)


def _swept(path: Path, model: Any) -> _Swept:
    """A table of a finished sweep: its limit cycles, or its cells where their file is named."""
    opened = open_sweep(path if os.path.isdir(path) else path.parent, model)
    configuration, name = opened.provenance["configuration"], CELLS if path.name == CELLS else ORBITS
    head = Table.of_frame(
        opened.empty(name),
        opened.model.spec,
        "grid cells" if name == CELLS else "limit cycles",
        grid={axis: tuple(values.tolist()) for axis, values in opened.axes.items()},
        units=configuration.get("units", {}),
        parameters=opened.model.spec.names,
    )
    return _Swept(opened, name, head)


def _read(path: Path) -> Any:
    """The rows of a file."""
    import pandas as pd
    import pyarrow as pa
    import pyarrow.csv

    if os.path.exists(path) and not os.path.isfile(path):  # to open a pipe would wait for ever
        raise InputError(f"cannot read {path} (it is not a file); give a file")
    try:
        if path.suffix == ".csv":
            options = pyarrow.csv.ConvertOptions(strings_can_be_null=True)
            frame = pyarrow.csv.read_csv(path, convert_options=options).to_pandas()
        else:
            frame = pd.read_parquet(path)
    except (pa.ArrowException, UnicodeDecodeError) as error:
        kind = "Parquet file" if path.suffix == ".parquet" else "table of comma-separated values"
        raise InputError(f"{path} is damaged or is not a {kind} ({_first(error)}); write it again") from None
    except OSError as error:
        reason = error.strerror or "it is damaged or is not a Parquet file"
        raise InputError(f"cannot read {path} ({reason}); give a file that can be read") from None
    if not all(isinstance(name, str) and name for name in frame.columns) or not len(frame.columns):
        raise InputError(f"{path} has columns without names; give a table that stridemap wrote")
    return frame


def _first(error: Exception) -> str:
    return str(error).splitlines()[0][:100] if str(error) else type(error).__name__


def _walk(path: Path) -> tuple[ModelSpec | None, bool]:
    """The model that the metadata of a walk name, if it comes with stridemap; whether it is in SI units."""
    import pyarrow.parquet as pq

    metadata = pq.read_schema(path).metadata or {}
    try:
        about = json.loads(metadata.get(b"stridemap", b"null"))
        name, in_si = about["model"], "units" in about
    except (KeyError, TypeError, ValueError, RecursionError):
        return None, False
    return (load(name).spec if isinstance(name, str) and name in available() else None), in_si
