"""A finished sweep, read by somebody who need not have written it: nothing in it is taken on trust.

What a folder says of itself is held against a schema and against the model, which is one that comes with
stridemap or one that the reader names. No file of the folder is ever run.
"""

import hashlib
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray
from pydantic import AfterValidator, BaseModel, ConfigDict, Field, ValidationError

from stridemap.errors import InputError
from stridemap.solver.cycles.status import Status
from stridemap.solver.model.loading import available, load
from stridemap.solver.model.model import Model
from stridemap.sweeps import files
from stridemap.sweeps.config import canonical_json
from stridemap.sweeps.grid import Grid
from stridemap.sweeps.store import (
    CELLS,
    ORBITS,
    SPECIAL,
    check_columns,
    read_provenance,
    read_special,
    table_path,
)
from stridemap.sweeps.tables import FORMAT, cell_schema, orbit_schema, special_schema
from stridemap.words import multiplier_columns

if TYPE_CHECKING:
    import pandas as pd

Floats = NDArray[np.float64]

CELL_STATUSES = ("found", "empty", "failed")
"""What can have become of a cell."""

NEEDED = ("stable", "spectral_radius")
"""Measured quantities that every sweep has."""

MOST_CYCLES = 1_000
"""Rows per cell beyond which a table is not a sweep's. The most that was ever found in a cell is a few dozen;
a small file can claim so many rows that they do not fit into the memory."""

_STRICT = ConfigDict(frozen=True, strict=True, allow_inf_nan=False)


def _plain(text: str) -> str:
    if not text.isprintable():
        raise ValueError("it has characters that cannot be printed")
    return text


Text = Annotated[str, Field(max_length=2_000), AfterValidator(_plain)]
"""A line of text."""

Word = Annotated[str, Field(max_length=100, pattern="^[A-Za-z][A-Za-z0-9_]*$")]
"""The name of something."""

Hash = Annotated[str, Field(pattern="^[0-9a-f]{64}$")]
Setting = Text | int | float | bool | None | dict[Word, int]


class _Configuration(BaseModel):
    model_config = _STRICT

    model: Word
    params: dict[Word, float]
    grid: Annotated[dict[Word, Annotated[list[float], Field(min_length=1)]], Field(min_length=1)]
    search: dict[Word, Setting]
    acceptance: dict[Word, Setting] = {}
    continuation: dict[Word, Setting] = {}
    special_points: bool = True
    units: dict[Word, float] = {}


class _Provenance(BaseModel):
    model_config = _STRICT

    format: int
    measures: list[Word]
    model: Word
    model_hash: Hash
    versions: dict[Text, Text]
    arithmetic: Text
    compiler: Text | None
    commit: Text | None
    tile_cells: int
    configuration: _Configuration
    configuration_hash: Hash


@dataclass(frozen=True)
class FinishedSweep:
    """A sweep that was read and found to be in order.

    Parameters
    ----------
    model : Model
    provenance : mapping
        How it was made; see `stridemap.read_provenance`.
    orbits, cells, special : pandas.DataFrame
        Limit cycles, grid cells, and special points along the lines of the grid.
    """

    model: Model
    provenance: Mapping[str, Any]
    orbits: "pd.DataFrame"
    cells: "pd.DataFrame"
    special: "pd.DataFrame"


@dataclass(frozen=True)
class OpenedSweep:
    """A finished sweep whose account of itself is in order; its rows are checked as they are read.

    Parameters
    ----------
    folder : path
    model : Model
    provenance : mapping
    names : mapping of str to tuple of str
        The columns of each table, by the name of its file.
    """

    folder: str | Path
    model: Model
    provenance: Mapping[str, Any]
    names: Mapping[str, tuple[str, ...]]

    @cached_property
    def grid(self) -> Grid:
        """The grid, its axes in the model's order of parameters."""
        return Grid.from_mapping(self.axes)

    @property
    def axes(self) -> dict[str, Floats]:
        """The values of each axis of the grid, in the model's order of parameters."""
        axes = self.provenance["configuration"]["grid"]
        return {name: np.array(axes[name]) for name in self.model.spec.names if name in axes}

    def empty(self, table: str = ORBITS) -> "pd.DataFrame":
        """All columns of limit cycles or of cells, without a row."""
        schema, _ = files.shape_of(table_path(self.folder, table))
        return files.frame_of(schema.remove_metadata().empty_table())

    def frames(self, table: str = ORBITS, columns: Sequence[str] | None = None) -> "Iterator[pd.DataFrame]":
        """Rows of limit cycles or of cells, some ten thousand at a time, in order.

        Parameters
        ----------
        table : {ORBITS, CELLS}
        columns : sequence of str, optional
            By default all. What says where rows belong is read and checked with them.

        Raises
        ------
        InputError
            For a column that there is not, a damaged file, and rows that no sweep writes.
        """
        for wanted, frame in self._checked_frames(table, columns):
            yield frame[wanted]

    def frame(
        self,
        table: str = ORBITS,
        columns: Sequence[str] | None = None,
        where: "Callable[[pd.DataFrame], Any] | None" = None,
        needed: Sequence[str] = (),
    ) -> "pd.DataFrame":
        """Limit cycles or cells; what is not selected never is in memory as a whole.

        Parameters
        ----------
        table, columns
            As for `frames`.
        where : callable, optional
            For which of some rows a condition holds, as an array of bool; by default all are read.
        needed : sequence of str
            Columns that `where` needs, beside ``cell``.
        """
        wanted = list(self.names[table] if columns is None else columns)
        check_columns(wanted, self.names[table])
        judged = {"status", "period", *self.model.section}
        judged |= {name for i in range(len(self.model.section)) for name in multiplier_columns(i)}
        looked = list(dict.fromkeys(["cell", *(name for name in wanted if name in judged), *needed]))
        masks = []
        for _, frame in self._checked_frames(table, looked):
            kept = np.ones(len(frame), dtype=bool) if where is None else np.asarray(where(frame), dtype=bool)
            masks.append(kept)
        path = table_path(self.folder, table)
        return files.frame(path, wanted, None if where is None else masks)

    def _checked_frames(
        self, table: str, columns: Sequence[str] | None
    ) -> "Iterator[tuple[list[str], pd.DataFrame]]":
        """The columns that are wanted, and rows of these and of what says where they belong."""
        wanted = list(self.names[table] if columns is None else columns)
        check_columns(wanted, self.names[table])
        places = ["cell", *self.model.spec.names, *(["status"] if table == CELLS else [])]
        last = -1
        for frame in files.frames(table_path(self.folder, table), list(dict.fromkeys([*places, *wanted]))):
            if table == CELLS:
                self._check_cells(frame, last + 1)
                last += len(frame)
            else:
                self._check_orbits(frame, last)
                last = int(frame["cell"].iloc[-1]) if len(frame) else last
            yield wanted, frame

    def _check_cells(self, frame: "pd.DataFrame", first: int) -> None:
        """Refuse cells that no sweep writes."""
        cells = np.arange(first, first + len(frame))
        self._refuse(
            {
                "the cells are not those of the grid": not np.array_equal(frame["cell"].to_numpy(), cells)
                or not np.array_equal(self._own(frame), self._points(cells)),
                "a cell has a status that is not one": not frame["status"].isin(CELL_STATUSES).all(),
            }
        )

    def _check_orbits(self, frame: "pd.DataFrame", last: int) -> None:
        """Refuse limit cycles that no sweep writes, by the columns that were read; they follow a cell."""
        model, cell = self.model, frame["cell"].to_numpy()
        unknowns = [name for name in (*model.section, "period") if name in frame]
        multipliers = [
            name for i in range(len(model.section)) for name in multiplier_columns(i) if name in frame
        ]
        statuses = [status.value for status in Status if status.found]
        in_range = bool(((cell >= 0) & (cell < self.grid.n_cells)).all())
        in_range = in_range and bool((np.diff(cell, prepend=last) >= 0).all())
        self._refuse(
            {
                "the limit cycles are not in the order of their cells": not in_range,
                "a limit cycle is not at its cell's parameters": in_range
                and not np.array_equal(self._own(frame), self._points(cell)),
                "a limit cycle has a status that is not one": "status" in frame
                and not frame["status"].isin(statuses).all(),
                "a state or a period is not a finite number": not np.isfinite(
                    frame[unknowns].to_numpy(dtype=np.float64)
                ).all(),
                "a period is not above 0": "period" in frame and not (frame["period"].to_numpy() > 0).all(),
                "a multiplier is not a number": bool(
                    np.isnan(frame[multipliers].to_numpy(dtype=np.float64)).any()
                ),
            }
        )

    def _own(self, frame: "pd.DataFrame") -> Any:
        return frame[list(self.model.spec.names)].to_numpy()

    def _points(self, cells: Any) -> Any:
        return self.grid.points(self.model, self.provenance["configuration"]["params"], cells)

    def _refuse(self, faults: Mapping[str, bool]) -> None:
        for fault, found in faults.items():
            if found:
                raise _foreign(self.folder, fault)


def open_sweep(folder: str | Path, model: str | Path | Model | None = None) -> OpenedSweep:
    """Open a finished sweep after checking all that it says of itself; no row is read yet.

    Parameters
    ----------
    folder : path
        Output folder of a sweep.
    model : str, path or Model, optional
        What the sweep's model is loaded by, where it does not come with stridemap. Without it, nothing that
        the folder names is loaded: not even a model file that lies in it.

    Raises
    ------
    InputError
        When there is no finished sweep in `folder`, the model is another one than the sweep's, or the tables
        are not those of a sweep of it.
    """
    provenance = _checked(read_provenance(folder), folder)
    loaded = load(model) if model is not None else _builtin(provenance["model"], folder)
    _check_model(folder, provenance, loaded)
    return OpenedSweep(folder, loaded, provenance, _check_columns(folder, provenance, loaded))


def read_sweep(folder: str | Path, model: str | Path | Model | None = None) -> FinishedSweep:
    """Read a finished sweep after checking all that it says of itself.

    Parameters
    ----------
    folder, model
        As for `open_sweep`.

    Raises
    ------
    InputError
        As `open_sweep`, and when rows are not those of a sweep.
    """
    opened = open_sweep(folder, model)
    cells, orbits = opened.frame(CELLS), opened.frame(ORBITS)
    return FinishedSweep(opened.model, opened.provenance, orbits, cells, read_special(folder))


def _checked(found: dict[str, Any], folder: str | Path) -> dict[str, Any]:
    """The provenance in a folder, whose every entry is of the kind that a sweep writes."""
    if found.get("format") != FORMAT:
        raise InputError(
            f"the tables in {folder} were written by another version of stridemap (format "
            f"{_short(found.get('format'))}, not {FORMAT}); sweep again"
        )
    try:
        _Provenance.model_validate(found)
    except ValidationError as error:
        first = error.errors(include_url=False)[0]
        entry = ".".join(map(str, first["loc"]))[:100] or "it"
        raise _foreign(folder, f"{entry} in their metadata is {_short(first['input'])}") from None
    configuration = found["configuration"]
    if hashlib.sha256(canonical_json(configuration).encode()).hexdigest() != found["configuration_hash"]:
        raise _foreign(folder, "the configuration in their metadata does not have the hash that stands there")
    return found


def _builtin(name: str, folder: str | Path) -> Model:
    """The model of that name, if it comes with stridemap."""
    if name not in available():
        raise InputError(
            f"the sweep in {folder} is of the model {name}, which does not come with stridemap; "
            f"name the model's file with --model {name}.py (from Python, model=), if you trust it: it is run"
        )
    return load(name)


def _check_model(folder: str | Path, provenance: Mapping[str, Any], model: Model) -> None:
    """Refuse a sweep whose walker is not the one that is loaded: its steps would differ."""
    if provenance["model"] != model.name:
        raise InputError(
            f"the sweep in {folder} is of the model {provenance['model']}, not of {model.name}; "
            "give the model that it was made with"
        )
    if provenance["model_hash"] != model.hash:
        raise InputError(
            f"the sweep in {folder} is of another version of the model {model.name} (hash "
            f"{provenance['model_hash'][:12]} there, {model.hash[:12]} here); sweep again, or use the "
            "stridemap that computed it"
        )
    configuration = provenance["configuration"]
    grid, params = list(configuration["grid"]), list(configuration["params"])
    if sorted(grid + params) != sorted(model.spec.names):
        raise _foreign(folder, f"their configuration does not have the parameters of {model.name}")
    for a in model.parameters:
        for value in configuration["grid"].get(a.name) or [configuration["params"][a.name]]:
            try:
                a.check(value)
            except InputError as error:
                raise _foreign(folder, str(error)) from None
    if any((np.diff(values) <= 0).any() for values in configuration["grid"].values()):
        raise _foreign(folder, "the values of their grid do not ascend")


def _check_columns(
    folder: str | Path, provenance: Mapping[str, Any], model: Model
) -> dict[str, tuple[str, ...]]:
    """The columns of each table; refuses other ones than those of a sweep, and more rows than it can have."""
    measures = provenance["measures"]
    if unknown := sorted(set(measures) - set(model.measured)):
        raise InputError(
            f"the tables in {folder} have the column {unknown[0]}, which this version of stridemap does not "
            "know; sweep again, or use the stridemap that computed them"
        )
    if lacking := [name for name in NEEDED if name not in measures]:
        raise _foreign(folder, f"they lack the column {lacking[0]}")
    wanted = [field for field in orbit_schema(model) if field.name not in set(model.measured) - set(measures)]
    n_cells = int(np.prod([len(axis) for axis in provenance["configuration"]["grid"].values()], dtype=object))
    tables = {ORBITS: wanted, CELLS: list(cell_schema(model)), SPECIAL: list(special_schema(model))}
    names = {}
    for name, fields in tables.items():
        schema, rows = files.shape_of(table_path(folder, name))
        _check_schema(folder, name, schema, fields)
        if name == CELLS and rows != n_cells:
            raise _foreign(folder, f"{CELLS} has {rows:,} rows for a grid of {n_cells:,} cells")
        if name in (ORBITS, SPECIAL) and rows > MOST_CYCLES * n_cells:
            raise _foreign(folder, f"{name} has {rows:,} rows for {n_cells:,} cells")
        names[name] = tuple(schema.names)
    return names


def _check_schema(folder: str | Path, table: str, schema: pa.Schema, fields: Iterable[pa.Field]) -> None:
    wanted = {field.name: field.type for field in fields}
    if twice := [name for name in schema.names if schema.names.count(name) > 1]:
        raise _foreign(folder, f"{table} has two columns {_short(twice[0])}")
    for name, kind in wanted.items():
        if name not in schema.names:
            raise _foreign(folder, f"{table} lacks the column {name}")
        if schema.field(name).type != kind:
            raise _foreign(folder, f"the column {name} of {table} is {schema.field(name).type}, not {kind}")
    if more := sorted(set(schema.names) - set(wanted)):
        raise _foreign(folder, f"{table} has a column {_short(more[0])}")


def _foreign(folder: str | Path, fault: str) -> InputError:
    return InputError(f"the tables in {folder} are not those of a sweep: {fault}; sweep again")


def _short(value: Any) -> str:
    text = ascii(value)
    return text if len(text) <= 60 else f"{text[:57]}..."
