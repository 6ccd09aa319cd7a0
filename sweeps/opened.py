"""The rows of a finished sweep, some at a time, none of which is taken on trust."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from stridemap.errors import InputError
from stridemap.solver.cycles.status import Status
from stridemap.solver.model.model import Model
from stridemap.sweeps import files
from stridemap.sweeps.grid import Grid
from stridemap.sweeps.store import CELLS, ORBITS, check_columns, table_path
from stridemap.words import multiplier_columns

if TYPE_CHECKING:
    import pandas as pd

Floats = NDArray[np.float64]

CELL_STATUSES = ("found", "empty", "failed")
"""What can have become of a cell."""


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
                raise foreign(self.folder, fault)


def foreign(folder: str | Path, fault: str) -> InputError:
    """That the tables in a folder are not those of a sweep."""
    return InputError(f"the tables in {folder} are not those of a sweep: {fault}; sweep again")
