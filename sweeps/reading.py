"""A finished sweep, read by somebody who need not have written it: nothing in it is taken on trust.

What a folder says of itself is held against a schema and against the model, which is one that comes with
stridemap or one that the reader names. No file of the folder is ever run.
"""

import hashlib
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import numpy as np
import pyarrow as pa
from pydantic import AfterValidator, BaseModel, ConfigDict, Field, ValidationError

from stridemap.errors import InputError
from stridemap.solver.model.loading import available, load
from stridemap.solver.model.model import Model
from stridemap.sweeps import files
from stridemap.sweeps.config import canonical_json
from stridemap.sweeps.opened import OpenedSweep, foreign
from stridemap.sweeps.store import (
    CELLS,
    ORBITS,
    SPECIAL,
    read_provenance,
    read_special,
    table_path,
)
from stridemap.sweeps.tables import FORMAT, cell_schema, orbit_schema, special_schema

if TYPE_CHECKING:
    import pandas as pd

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
Setting = Text | int | float | bool | None | dict[Word, int] | dict[Word, list[float]]


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
        raise foreign(
            folder, f"{_entry(found, first['loc'])} in their metadata is {_short(first['input'])}"
        ) from None
    configuration = found["configuration"]
    if hashlib.sha256(canonical_json(configuration).encode()).hexdigest() != found["configuration_hash"]:
        raise foreign(folder, "the configuration in their metadata does not have the hash that stands there")
    return found


def _entry(found: Any, place: Sequence[str | int]) -> str:
    """The entry of the metadata at a place; which of several kinds it might have been is left out."""
    names = []
    for name in place:
        if not isinstance(found, dict):
            break
        names.append(str(name))
        found = found.get(name)
    return ".".join(names)[:100] or "it"


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
        raise foreign(folder, f"their configuration does not have the parameters of {model.name}")
    for a in model.parameters:
        for value in configuration["grid"].get(a.name) or [configuration["params"][a.name]]:
            try:
                a.check(value)
            except InputError as error:
                raise foreign(folder, str(error)) from None
    if any((np.diff(values) <= 0).any() for values in configuration["grid"].values()):
        raise foreign(folder, "the values of their grid do not ascend")


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
        raise foreign(folder, f"they lack the column {lacking[0]}")
    wanted = [field for field in orbit_schema(model) if field.name not in set(model.measured) - set(measures)]
    n_cells = int(np.prod([len(axis) for axis in provenance["configuration"]["grid"].values()], dtype=object))
    tables = {ORBITS: wanted, CELLS: list(cell_schema(model)), SPECIAL: list(special_schema(model))}
    names = {}
    for name, fields in tables.items():
        schema, rows = files.shape_of(table_path(folder, name))
        _check_schema(folder, name, schema, fields)
        if name == CELLS and rows != n_cells:
            raise foreign(folder, f"{CELLS} has {rows:,} rows for a grid of {n_cells:,} cells")
        if name in (ORBITS, SPECIAL) and rows > MOST_CYCLES * n_cells:
            raise foreign(folder, f"{name} has {rows:,} rows for {n_cells:,} cells")
        names[name] = tuple(schema.names)
    return names


def _check_schema(folder: str | Path, table: str, schema: pa.Schema, fields: Iterable[pa.Field]) -> None:
    wanted = {field.name: field.type for field in fields}
    if twice := [name for name in schema.names if schema.names.count(name) > 1]:
        raise foreign(folder, f"{table} has two columns {_short(twice[0])}")
    for name, kind in wanted.items():
        if name not in schema.names:
            raise foreign(folder, f"{table} lacks the column {name}")
        if schema.field(name).type != kind:
            raise foreign(folder, f"the column {name} of {table} is {schema.field(name).type}, not {kind}")
    if more := sorted(set(schema.names) - set(wanted)):
        raise foreign(folder, f"{table} has a column {_short(more[0])}")


def _short(value: Any) -> str:
    text = ascii(value)
    return text if len(text) <= 60 else f"{text[:57]}..."
