"""One Parquet file of a sweep: written in row groups of bounded size, and read in such pieces.

Every file carries in its metadata the provenance, its name, and a digest of both. Of a large table only some
rows are in memory at a time, both where it is written and where it is read.
"""

import contextlib
import hashlib
import json
import os
import stat
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
from numpy.typing import NDArray

from stridemap.errors import InputError
from stridemap.sweeps.config import canonical_json

if TYPE_CHECKING:
    import pandas as pd

Mask = NDArray[np.bool_]

GROUP_ROWS = 16_384
"""Rows of a row group: the piece of a file that is in memory at a time, some 6 MB of limit cycles."""

DICTIONARY = 16_384
"""Bytes of the different values of a column in a row group above which they are written as they are."""

# Keys of the schema metadata: the provenance, the name that the file was written under, and the digest of
# both with columns and number of rows: Parquet has checksums for its pages, but none for its footer.
_PROVENANCE, _FILE, _DIGEST = b"stridemap", b"stridemap.file", b"stridemap.digest"


@dataclass(frozen=True)
class Pieces:
    """A table in pieces, which follow one another.

    Parameters
    ----------
    schema : Schema
    rows : int
        Of all of them together.
    tables : iterable of Table
        Each is asked for when the one before is written.
    """

    schema: pa.Schema
    rows: int
    tables: Iterable[pa.Table]

    @classmethod
    def of(cls, table: "pa.Table | Pieces") -> "Pieces":
        """A whole table as one piece; pieces as they are."""
        return table if isinstance(table, Pieces) else cls(table.schema, table.num_rows, [table])


# -- written -------------------------------------------------------------------------------------------------


def write(file: Any, name: str, provenance: Mapping[str, Any], pieces: Pieces) -> None:
    """Write a table with its provenance into an open file.

    The bytes depend on the rows and their order, not on how they were cut into pieces.

    Parameters
    ----------
    file : file object
    name : str
        The name under which it will be found.
    provenance : mapping
    pieces : Pieces
    """
    metadata = {_PROVENANCE: canonical_json(provenance).encode(), _FILE: name.encode()}
    metadata[_DIGEST] = digest(pieces.schema, pieces.rows, metadata)
    schema = pieces.schema.with_metadata(metadata)
    # Snappy, because MATLAB reads it; checksums, because footers alone show no flipped bit. Dictionaries are
    # for values that are repeated: where all differ, they would take a sixth more than the values.
    kept = {"compression": "snappy", "write_page_checksum": True, "dictionary_pagesize_limit": DICTIONARY}
    with pq.ParquetWriter(file, schema, **kept) as writer:
        written = 0
        for group in _row_groups(pieces):
            writer.write_table(group.replace_schema_metadata(metadata), row_group_size=GROUP_ROWS)
            written += group.num_rows
            pa.default_memory_pool().release_unused()
    if written != pieces.rows:
        raise AssertionError(f"{written} rows of {name} were written, and {pieces.rows} announced")


def _row_groups(pieces: Pieces) -> Iterator[pa.Table]:
    """Tables of `GROUP_ROWS` rows each, the last of fewer; one without rows where there is none."""
    waiting = pieces.schema.empty_table()
    for table in pieces.tables:
        waiting, at = pa.concat_tables([waiting, table]), 0
        del table  # what was written is not kept
        while waiting.num_rows - at >= GROUP_ROWS:
            # One chunk, so that how the table was put together leaves no trace in the pages.
            yield waiting.slice(at, GROUP_ROWS).combine_chunks()
            at += GROUP_ROWS
        if at:
            waiting = waiting.slice(at).combine_chunks()
    if waiting.num_rows or not pieces.rows:
        yield waiting.combine_chunks()


def digest(schema: pa.Schema, rows: int, metadata: Mapping[bytes, bytes]) -> bytes:
    """What a file's metadata say of its columns, its number of rows, its provenance and its name."""
    columns = [f"{field.name} {field.type} {field.nullable}" for field in schema]
    text = [metadata.get(_PROVENANCE, b""), metadata.get(_FILE, b""), str(rows).encode()]
    return hashlib.sha256(b"\n".join([*text, *(c.encode() for c in columns)])).hexdigest().encode()


# -- read ----------------------------------------------------------------------------------------------------


@contextlib.contextmanager
def opened(path: Path) -> Iterator[pq.ParquetFile]:
    """Open a Parquet file, and turn whatever shows that it is not one, there or later, into an InputError."""
    try:
        if not stat.S_ISREG(os.stat(path).st_mode):  # to open a pipe would wait for ever
            raise InputError(f"cannot read {path} (it is not a file); move it away and sweep again")
        with pq.ParquetFile(path, page_checksum_verification=True) as file:
            yield file
    except (pa.ArrowException, OSError, UnicodeDecodeError, MemoryError, RecursionError) as error:
        if isinstance(error, OSError) and error.errno is not None:
            raise InputError(f"cannot read {path} ({error.strerror or error})") from None
        raise _damaged(path) from None


def _damaged(path: Path) -> InputError:
    return InputError(
        f"{path} is damaged or is not a Parquet file; restore it, or move it away and sweep again"
    )


def provenance_of(path: Path) -> dict[str, Any]:
    """The provenance in a file of ours, after checking that it is one and bears its own name."""
    with opened(path) as file:
        schema, rows = file.schema_arrow, file.metadata.num_rows
    metadata = schema.metadata or {}
    if _DIGEST in metadata and metadata[_DIGEST] != digest(schema, rows, metadata):
        raise _damaged(path)
    try:
        data: dict[str, Any] = json.loads(metadata[_PROVENANCE])
        told = isinstance(data["configuration"], dict) and isinstance(data["configuration_hash"], str)
        if metadata[_FILE] == path.name.encode() and metadata[_DIGEST] and told:
            return data
    except (KeyError, TypeError, ValueError, RecursionError):
        pass  # reported below, as a file under another name is
    raise InputError(
        f"{path} is a Parquet file, but not one that a sweep wrote under this name; move it away or give "
        "another folder"
    )


def shape_of(path: Path) -> tuple[pa.Schema, int]:
    """Columns of a file and the number of its rows, as its footer says."""
    with opened(path) as file:
        return file.schema_arrow, file.metadata.num_rows


def read(path: Path, columns: Sequence[str] | None = None) -> pa.Table:
    """A whole file, or some of its columns, without the metadata."""
    with opened(path) as file:
        return _valid(file.read(columns=None if columns is None else list(columns)))


def frames(path: Path, columns: Sequence[str]) -> Iterator["pd.DataFrame"]:
    """Some columns of a file, a data frame for each of its row groups.

    Parameters
    ----------
    path : Path
    columns : sequence of str
    """
    with opened(path) as file:
        for group in range(file.num_row_groups):
            yield frame_of(_row_group(file, group, columns))


def frame(
    path: Path, columns: Sequence[str] | None = None, masks: Sequence[Mask] | None = None
) -> "pd.DataFrame":
    """A data frame of a file, column by column, so that nothing is in memory twice.

    Parameters
    ----------
    path : Path
    columns : sequence of str, optional
        By default all.
    masks : sequence of ndarray of bool, optional
        For each row group which of its rows; by default all.
    """
    import pandas as pd

    with opened(path) as file:
        schema = file.schema_arrow.remove_metadata()
        names = schema.names if columns is None else list(columns)
        groups = [g for g in range(file.num_row_groups) if masks is None or masks[g].any()]

        def chunks(name: str) -> Iterator[pa.Table]:
            for group in groups:
                part = _row_group(file, group, [name])
                yield part if masks is None else part.filter(pa.array(masks[group]))

        empty = pa.schema([schema.field(name) for name in names]).empty_table()
        series = {}
        for name in names:
            whole = pa.concat_tables([empty.select([name]), *chunks(name)])
            series[name] = frame_of(whole)[name]
        count = len(next(iter(series.values()), ()))
        if masks is None and count != file.metadata.num_rows and names:
            raise pa.ArrowInvalid("other rows than the footer says")
        return pd.DataFrame(series, copy=False)


def frame_of(table: pa.Table) -> "pd.DataFrame":
    """A data frame in which what can be missing has types that know gaps."""
    out: pd.DataFrame = table.to_pandas()
    for field in table.schema:
        if field.nullable and pa.types.is_integer(field.type):  # pandas would make them floats
            out[field.name] = out[field.name].astype("Int64")
        if field.nullable and pa.types.is_boolean(field.type):  # or objects
            out[field.name] = out[field.name].astype("boolean")
    return out


def _row_group(file: pq.ParquetFile, group: int, columns: Sequence[str]) -> pa.Table:
    """Columns of a row group, all of which have its rows: read one by one, nothing else would show it."""
    table = _valid(file.read_row_group(group, columns=list(columns)))
    if table.num_rows != file.metadata.row_group(group).num_rows:
        raise pa.ArrowInvalid("other rows than the footer says")
    return table


def _valid(table: pa.Table) -> pa.Table:
    table = table.replace_schema_metadata(None)
    table.validate(full=True)  # texts in it are text
    return table
