"""Tables written for other programs while they are read, so that neither is in memory as a whole."""

import contextlib
import json
import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import IO, Any

from stridemap.errors import StorageError
from stridemap.tables.export import about_columns, check_ending, csv_text
from stridemap.tables.export import export as export_whole
from stridemap.tables.reading import read_batches, read_table, some_columns, table_head
from stridemap.tables.table import Table
from stridemap.tables.whole_file import whole_file


def export_file(
    path: Path,
    target: Path,
    by: str = "cycle",
    *,
    model: Any = None,
    units: Any = None,
    columns: Sequence[str] | None = None,
    where: str | None = None,
) -> tuple[list[Path], int]:
    """Write a table, or a part of it, for other programs.

    The tables of sweeps are written batch by batch as comma-separated values and Parquet files; all else has
    to be in memory.

    Parameters
    ----------
    path : Path
        As for `stridemap.read_table`, like `model`, `units`, `columns` and `where`.
    target : Path
        As for `Table.export`, like `by`.

    Returns
    -------
    list of Path
        What was written.
    int
        Number of rows.

    Raises
    ------
    InputError
        As `stridemap.read_table`, and for another ending.
    StorageError
        When a file cannot be written; one that was there before is as it was.
    """
    check_ending(target)
    head = table_head(path, model, units)
    if target.suffix not in STREAMED or not head.grid:
        table = read_table(path, model, units, columns, where)
        return export_whole(table, target, by), len(table)
    batches = read_batches(path, model, units, columns, where)
    if columns is not None:
        head = some_columns(head, columns)
    counted = _Counted(batches)
    with _written(target) as file:
        STREAMED[target.suffix](head, counted, file)
    beside = target.with_stem(f"{target.stem}_columns")
    if target.suffix == ".csv":
        with _written(beside) as file:
            file.write(about_columns(head).encode())
        return [target, beside], counted.rows
    return [target], counted.rows


class _Counted:
    """Batches whose rows are counted as they go by."""

    def __init__(self, batches: Iterator[Table]) -> None:
        self.batches, self.rows = batches, 0

    def __iter__(self) -> Iterator[Table]:
        for batch in self.batches:
            self.rows += len(batch)
            yield batch


@contextlib.contextmanager
def _written(target: Path) -> Iterator[IO[bytes]]:
    """A file that takes its place when it is complete."""
    try:
        if os.path.exists(target) and not os.path.isfile(target):
            raise OSError(None, "it is not a file")  # to write into a pipe waits for who reads it
        with whole_file(target) as file:
            yield file
    except OSError as error:
        raise StorageError(
            f"cannot write {target} ({error.strerror or error}); give a path that can be written"
        ) from None


def _csv(head: Table, batches: _Counted, file: IO[bytes]) -> None:
    file.write(csv_text(head.frame).encode())
    for batch in batches:
        file.write(csv_text(batch.frame, header=False).encode())


def _parquet(head: Table, batches: _Counted, file: IO[bytes]) -> None:
    import pyarrow as pa
    import pyarrow.parquet as pq

    frame = head.to_frame()
    schema = pa.Table.from_pandas(frame, preserve_index=False).schema
    # Where pandas looks for what a frame says of itself.
    metadata = {**(schema.metadata or {}), b"PANDAS_ATTRS": json.dumps(frame.attrs).encode()}
    schema = schema.with_metadata(metadata)
    with pq.ParquetWriter(file, schema) as writer:
        for batch in batches:
            writer.write_table(pa.Table.from_pandas(batch.frame, schema=schema, preserve_index=False))


STREAMED: Mapping[str, Callable[[Table, _Counted, IO[bytes]], None]] = {".csv": _csv, ".parquet": _parquet}
"""What writes kinds of files batch by batch, by their endings."""
