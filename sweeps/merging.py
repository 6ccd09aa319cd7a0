"""The limit cycles of all tiles in the order of cells, of which only some are in memory at a time.

The cells of a tile are not beside each other in the table, so every tile has rows in all of it. They are
first sorted into files by ranges of cells, and then read back range by range.
"""

import contextlib
from collections.abc import Iterable, Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

Ints = NDArray[np.int64]
Floats = NDArray[np.float64]

RANGE_ROWS = 16_384
"""About so many rows are in memory at a time."""

MOST_RANGES = 150
"""Files that are open at a time: systems allow a process some hundred."""


def ranges(per_cell: NDArray[np.integer[Any]]) -> Ints:
    """The first cell of each range of cells that have some `RANGE_ROWS` rows, ascending, from 0.

    Parameters
    ----------
    per_cell : ndarray of int, shape (n_cells,)
        Number of rows of each cell.
    """
    before = np.cumsum(per_cell) - per_cell
    total = int(per_cell.sum())
    rows = max(RANGE_ROWS, -(-total // MOST_RANGES))
    begins = np.flatnonzero(np.diff(before // rows, prepend=-1) > 0)
    return np.asarray(begins, dtype=np.int64)


def by_cells(parts: Iterable[pa.Table], begins: Ints, stem: Path) -> Iterator[pa.Table]:
    """The rows of all parts, a table for each range of cells; within it they are as they came.

    Parameters
    ----------
    parts : iterable of Table
        Of one schema, with a column ``cell``.
    begins : ndarray of int
        As from `ranges`.
    stem : Path
        How the files begin in which rows wait; they are removed.
    """
    if len(begins) == 1:
        yield pa.concat_tables(parts)
        return
    paths = [stem.with_name(f"{stem.name}-{i:03d}.tmp") for i in range(len(begins))]
    try:
        _sort_into(parts, begins, paths)
        for path in paths:
            with pa.OSFile(str(path)) as file, pa.ipc.open_stream(file) as reader:
                rows = [reader.read_all()]
            path.unlink()
            yield rows.pop()  # nothing of them is kept here
    finally:
        for path in paths:
            with contextlib.suppress(OSError):
                path.unlink(missing_ok=True)


def _sort_into(parts: Iterable[pa.Table], begins: Ints, paths: list[Path]) -> None:
    """Append the rows of each part to the files of their ranges."""
    with ExitStack() as stack:
        writers: list[pa.ipc.RecordBatchStreamWriter] = []
        for part in parts:
            if not writers:
                files = [stack.enter_context(pa.OSFile(str(path), "wb")) for path in paths]
                writers = [stack.enter_context(pa.ipc.new_stream(file, part.schema)) for file in files]
            of = np.searchsorted(begins, part["cell"].to_numpy(), "right") - 1
            order = np.argsort(of, kind="stable")
            ordered = part.take(pa.array(order)).combine_chunks()
            edges = np.searchsorted(of[order], np.arange(len(begins) + 1))
            for writer, first, last in zip(writers, edges[:-1].tolist(), edges[1:].tolist(), strict=True):
                if last > first:
                    writer.write_table(ordered.slice(first, last - first))


class FirstSeen:
    """Where in the table each branch is first met, without the table."""

    def __init__(self) -> None:
        self._branch: list[Ints] = []
        self._cell: list[Ints] = []
        self._period: list[Floats] = []

    def add(self, branch: Ints, cell: Ints, period: Floats) -> None:
        """Take note of limit cycles of one part, shape (n,) each."""
        order = np.lexsort((period, cell, branch))
        ordered = branch[order]
        first = order[np.append(True, ordered[1:] != ordered[:-1])[: len(order)]]
        first.sort()  # among equals the first row counts
        for kept, values in ((self._branch, branch), (self._cell, cell), (self._period, period)):
            kept.append(values[first])

    def branches(self) -> Ints:
        """All branches in the order in which they are first met, by cell and period."""
        branch = np.concatenate([np.empty(0, dtype=np.int64), *self._branch])
        cell = np.concatenate([np.empty(0, dtype=np.int64), *self._cell])
        period = np.concatenate([np.empty(0), *self._period])
        ordered = branch[np.lexsort((period, cell))]
        _, first = np.unique(ordered, return_index=True)
        return np.asarray(ordered[np.sort(first)], dtype=np.int64)
