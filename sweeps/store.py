"""The output folder of a sweep: three Parquet tables, and a part file for each finished piece of work.

``orbits.parquet`` has one row per limit cycle, ``cells.parquet`` one per grid cell, ``special.parquet`` one
per special point that was met. While a sweep runs, its
finished (round, tile) pieces are files in the subfolder ``parts``, which `Store.finish` removes once all
tables are in place. Every file is written under another name, flushed to the disk and renamed, so a kill
at any moment leaves the old or the new file, and every file carries the sweep's provenance, so nothing is
mixed with another sweep's. No time, host or number of workers enters a file.
"""

import contextlib
import json
import os
import uuid
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from operator import methodcaller
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pyarrow as pa

from stridemap.errors import InputError, StorageError, short
from stridemap.sweeps import files
from stridemap.sweeps.config import SweepConfig, canonical_json
from stridemap.sweeps.files import Pieces
from stridemap.sweeps.merging import Ints, by_cells
from stridemap.sweeps.provenance import DECIDING
from stridemap.words import hint

if TYPE_CHECKING:
    import pandas as pd

ORBITS, CELLS, SPECIAL, PARTS = "orbits.parquet", "cells.parquet", "special.parquet", "parts"

TABLES = (ORBITS, CELLS, SPECIAL)
"""What is in the folder of a finished sweep."""


@dataclass(frozen=True)
class Store:
    """The output folder of one sweep, open for writing. Made by `Store.create` or `Store.resume`.

    Attributes
    ----------
    folder : Path
        The folder.
    provenance : mapping
        What every file carries: the mapping given, with ``configuration`` and ``configuration_hash``.
    finished : bool
        Whether all tables were complete when the store was opened.
    """

    folder: Path
    provenance: Mapping[str, Any]
    finished: bool = False

    @classmethod
    def create(cls, folder: str | Path, config: SweepConfig, provenance: Mapping[str, Any]) -> "Store":
        """Open `folder`, made if it does not exist, for a sweep from the beginning.

        Where this very sweep is finished, it stays as it is; finished tables of the same configuration that
        were made with anything else (`provenance`) stay until `finish` replaces them.

        Raises
        ------
        InputError
            If `folder` is not a folder or cannot be written, holds anything of another configuration, a
            damaged or foreign file under one of our names, or an unfinished sweep. Nothing is touched.
        """
        store = cls(Path(folder), _with_configuration(provenance, config))
        outputs, parts = store._outputs(), store._parts()
        for path in [*outputs, *parts]:
            store._check(path, same_software=False)
        whole = len(outputs) == len(TABLES) and not parts
        if whole and all(files.provenance_of(p) == store.provenance for p in outputs):
            return cls(store.folder, store.provenance, finished=True)
        if parts:
            raise InputError(
                f"{folder} holds an unfinished sweep of this configuration ({len(parts)} finished pieces); "
                "continue it with --resume, or give another folder"
            )
        store._make_folder()
        return store

    @classmethod
    def resume(cls, folder: str | Path, config: SweepConfig, provenance: Mapping[str, Any]) -> "Store":
        """Open `folder` to continue the sweep in it, from the beginning if it holds none.

        Raises
        ------
        InputError
            As `create` does, except for an unfinished sweep; and if what is to be continued was computed
            with different software than `provenance` says. Nothing is touched.
        """
        store = cls(Path(folder), _with_configuration(provenance, config))
        outputs, parts = store._outputs(), store._parts()
        for path in parts:
            store._check(path, same_software=True)
        # As long as there are parts, `finish` was not reached or was cut short: the tables, if any, are to
        # be replaced, and may be an earlier run's.
        for path in outputs:
            store._check(path, same_software=not parts)
        if len(outputs) == len(TABLES) and not parts:
            return cls(store.folder, store.provenance, finished=True)
        store._make_folder()
        return store

    def has_part(self, round_: int, tile: int) -> bool:
        """Whether the piece of work `tile` of round `round_` is finished."""
        return self._part(round_, tile).exists()

    def write_part(self, round_: int, tile: int, data: pa.Table | Mapping[str, Any]) -> None:
        """Store the result of one piece of work, a table or a mapping of columns.

        Raises
        ------
        StorageError
            If the file cannot be written; what was stored before stays.
        """
        self._write(self._part(round_, tile), data if isinstance(data, pa.Table) else pa.table(dict(data)))

    def read_part(self, round_: int, tile: int, columns: Sequence[str] | None = None) -> pa.Table:
        """Return what `write_part` stored, or some columns of it, as a table.

        Raises
        ------
        InputError
            If the file is missing, damaged or not of this sweep.
        """
        path = self._part(round_, tile)
        self._check(path, same_software=True)
        return files.read(path, columns)

    def by_cells(self, parts: Iterable[pa.Table], begins: Ints) -> Iterator[pa.Table]:
        """Rows of parts in the order of ranges of cells: `stridemap.sweeps.merging.by_cells` in our folder.

        Raises
        ------
        StorageError
            When the disk is full.
        """
        try:
            yield from by_cells(parts, begins, self.folder / PARTS / uuid.uuid4().hex)
        except OSError as error:
            raise _cannot_write(self.folder, error) from None

    def finish(self, orbits: pa.Table | Pieces, cells: pa.Table | Pieces, special: pa.Table) -> None:
        """Write all tables, orbits ordered by cell and period, and then remove the parts.

        Parameters
        ----------
        orbits : Table or Pieces
            All limit cycles, as from `orbit_table`: in any order, or in pieces of ascending cells, each in
            any order. Of pieces, only those rows are in memory that are being written.
        cells : Table or Pieces
            All cells, as from `cell_table`.
        special : Table
            All special points, as from `in_order`.

        Raises
        ------
        StorageError
            If a file cannot be written; the parts stay.
        """
        # The other columns break ties, so that the order of the rows given never shows.
        rows = Pieces.of(orbits)
        keys = [(key, "ascending") for key in dict.fromkeys(["cell", "period", *rows.schema.names])]
        in_order = map(methodcaller("sort_by", keys), rows.tables)
        self._write(self.folder / ORBITS, Pieces(rows.schema, rows.rows, in_order))
        self._write(self.folder / CELLS, cells)
        self._write(self.folder / SPECIAL, special)
        # A kill in here leaves the first parts, as if the sweep had been killed after writing them.
        with contextlib.suppress(OSError):  # a file in there that is not ours keeps the folder
            for path in [*reversed(self._parts()), *(self.folder / PARTS).glob("*.tmp")]:
                path.unlink()
            (self.folder / PARTS).rmdir()

    def _part(self, round_: int, tile: int) -> Path:
        return self.folder / PARTS / f"round-{round_:06d}-tile-{tile:06d}.parquet"

    def _parts(self) -> list[Path]:
        folder = self.folder / PARTS
        # One with a name that is too long is not there; `_make_folder` says why it cannot be.
        return sorted(folder.glob("round-*-tile-*.parquet")) if os.path.isdir(folder) else []

    def _outputs(self) -> list[Path]:
        return [path for name in TABLES if os.path.lexists(path := self.folder / name)]

    def _check(self, path: Path, same_software: bool) -> None:
        """Refuse `path` if it is damaged, foreign or of another sweep."""
        found = files.provenance_of(path)
        if found["configuration_hash"] != self.provenance["configuration_hash"]:
            difference = _difference(found["configuration"], self.provenance["configuration"])
            raise InputError(
                f"{path} is the output of another configuration ({difference}); give another folder, or the "
                "configuration it was begun with"
            )
        found, own = ({name: one.get(name) for name in DECIDING} for one in (found, self.provenance))
        if same_software and found != own:
            raise InputError(
                f"{path} was computed with different software ({_difference(found, own)}); give another "
                "folder, or continue with the software that it was begun with"
            )

    def _make_folder(self) -> None:
        parts = self.folder / PARTS
        try:
            parts.mkdir(parents=True, exist_ok=True)
            for folder in (self.folder, parts):
                if not os.access(folder, os.W_OK | os.X_OK):
                    raise PermissionError(None, "no permission to write")
        except OSError as error:
            raise InputError(
                f"cannot write the sweep to {self.folder} ({error.strerror}); give a folder that can be "
                "written"
            ) from None

    def _write(self, path: Path, table: pa.Table | Pieces) -> None:
        """Write `table` with the provenance to `path`, in one step as seen from outside."""
        temporary = self.folder / PARTS / f"{uuid.uuid4().hex}.tmp"
        try:
            with temporary.open("xb") as file:
                files.write(file, path.name, self.provenance, Pieces.of(table))
                file.flush()
                os.fsync(file.fileno())
            temporary.replace(path)
            _sync(path.parent)
        except OSError as error:
            raise _cannot_write(path, error) from None
        finally:
            with contextlib.suppress(OSError):
                temporary.unlink(missing_ok=True)


def _cannot_write(path: Path, error: OSError) -> StorageError:
    return StorageError(
        f"cannot write {path} ({error.strerror or error}); make room or give a folder that can be "
        "written, and continue with --resume"
    )


def read_orbits(folder: str | Path, columns: Sequence[str] | None = None) -> "pd.DataFrame":
    """Return the limit cycles of a finished sweep, one row each, ordered by cell and period.

    Parameters
    ----------
    folder : path
        Output folder of a sweep.
    columns : sequence of str, optional
        The columns to read: only these take memory. By default all.

    Raises
    ------
    InputError
        If there is no such table in `folder`, it is damaged or foreign, or lacks a column that is named.
    """
    return _frame(folder, ORBITS, columns)


def read_cells(folder: str | Path, columns: Sequence[str] | None = None) -> "pd.DataFrame":
    """Return the grid cells of a finished sweep, one row each.

    Parameters
    ----------
    folder, columns
        As for `read_orbits`.

    Raises
    ------
    InputError
        As `read_orbits`.
    """
    return _frame(folder, CELLS, columns)


def read_special(folder: str | Path) -> "pd.DataFrame":
    """Return the special points that a finished sweep has met along the lines of its grid, one row each.

    They are ordered by line and by the value of the parameter that varies along it.

    Raises
    ------
    InputError
        As `read_orbits`, and if an earlier version of stridemap made the sweep.
    """
    path = Path(folder) / SPECIAL
    if not os.path.exists(path) and os.path.exists(_output(folder, ORBITS)):
        raise InputError(
            f"there is no {SPECIAL} in {folder}: an earlier version of stridemap made the sweep; sweep again"
        )
    return _frame(folder, SPECIAL)


def read_provenance(folder: str | Path) -> dict[str, Any]:
    """Return how the tables in `folder` were made: configuration, its hash, versions and so on.

    Raises
    ------
    InputError
        As `read_orbits`, and if the tables are not of one sweep.
    """
    orbits = files.provenance_of(_output(folder, ORBITS))
    for name in (CELLS, SPECIAL):
        if name == SPECIAL and not os.path.exists(Path(folder) / SPECIAL):
            continue  # earlier versions of stridemap did not write it
        other = files.provenance_of(_output(folder, name))
        if orbits != other:
            raise InputError(
                f"{ORBITS} and {name} in {folder} are not of one sweep ({_difference(orbits, other)}, in "
                "that order); sweep again"
            )
    return orbits


def _with_configuration(provenance: Mapping[str, Any], config: SweepConfig) -> dict[str, Any]:
    """Return the provenance that files carry, in the form in which it is read back from them."""
    configuration = {
        "configuration": json.loads(config.canonical()),
        "configuration_hash": config.config_hash,
    }
    data: dict[str, Any] = json.loads(canonical_json({**provenance, **configuration}))
    return data


def _output(folder: str | Path, name: str) -> Path:
    """Return the path of a table in `folder`, which must be there."""
    path = Path(folder) / name
    if not os.path.exists(path):  # a name that is too long does not exist either
        if os.path.exists(Path(folder) / PARTS):
            raise InputError(f"the sweep in {folder} is not finished; continue it with --resume")
        if os.path.isfile(folder):
            raise InputError(f"{folder} is a file; give the output folder of a sweep, not what lies in it")
        raise InputError(f"there is no {name} in {folder}; give the output folder of a sweep")
    return path


def table_path(folder: str | Path, name: str) -> Path:
    """The path of a table of a finished sweep, which is there and ours.

    Raises
    ------
    InputError
        As `read_orbits`.
    """
    path = _output(folder, name)
    files.provenance_of(path)
    return path


def _frame(folder: str | Path, name: str, columns: Sequence[str] | None = None) -> "pd.DataFrame":
    path = table_path(folder, name)
    if columns is not None:
        check_columns(columns, files.shape_of(path)[0].names)
    return files.frame(path, columns)


def check_columns(columns: Any, known: Sequence[str]) -> None:
    """Refuse what is not a list of columns that a table has.

    Raises
    ------
    InputError
    """
    if isinstance(columns, str) or not isinstance(columns, Sequence) or not columns:
        raise InputError(f"columns = {short(columns)} is not allowed; give a list of names, such as ['k']")
    for name in columns:
        if not isinstance(name, str) or name not in known:
            raise InputError(
                f"there is no column {name!r}{hint(str(name), known)}; columns are {', '.join(known)}"
            )
    if twice := [name for name in columns if columns.count(name) > 1]:
        raise InputError(f"the column {twice[0]} is given twice; leave one of them out")


def _difference(found: Any, own: Any, name: str = "") -> str:
    """Say in which entry two unequal JSON values differ first."""
    if isinstance(found, list) and isinstance(own, list):
        if len(found) != len(own):
            return f"{name} has {len(found)} values there, {len(own)} here"
        found, own = dict(enumerate(found)), dict(enumerate(own))
    if isinstance(found, dict) and isinstance(own, dict):
        key = min(key for key in found.keys() | own.keys() if found.get(key) != own.get(key))
        return _difference(found.get(key), own.get(key), f"{name}.{key}" if name else str(key))
    return f"{name} is {_short(found)} there, {_short(own)} here"


def _short(value: Any) -> str:
    text = json.dumps(value)
    return text if len(text) <= 60 else f"{text[:57]}..."


def _sync(folder: Path) -> None:
    """Flush a folder's entries to the disk, so that a rename in it outlives a power cut."""
    if os.name == "posix":
        descriptor = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(descriptor)
        finally:
            os.close(descriptor)
