"""Sweeps: every limit cycle of every cell of a grid of parameters.

Many starts on a subgrid give the first cycles. The branch of each is followed along its line of the grid,
around folds, and from some of its cycles Newton's method is started in the cells beside them, until nothing
new appears. The grid is cut into tiles. In one round, each tile with incoming guesses is worked on by itself;
what reaches another tile waits for the next round. Tiles and rounds do not depend on the number of workers,
so neither do the tables.
"""

import contextlib
import os
from collections import Counter, defaultdict
from collections.abc import Callable, Mapping
from concurrent.futures import Executor, Future, as_completed
from dataclasses import dataclass, field
from itertools import count
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa
import pyarrow.compute as pc
from numpy.typing import NDArray

from stridemap.errors import InputError, short
from stridemap.solver.backends.base import Backend
from stridemap.solver.backends.selection import load_kernels, named_backend
from stridemap.solver.cycles.degenerate import have_no_cycle, why_no_cycle
from stridemap.solver.cycles.status import Status
from stridemap.sweeps.cluster import cluster, scheduler_address
from stridemap.sweeps.config import MAX_COUNT, SweepConfig, load_config
from stridemap.sweeps.executors import interrupts_held, processes
from stridemap.sweeps.failures import explained, no_workers
from stridemap.sweeps.families import families
from stridemap.sweeps.grid import Grid, tile_size, tiles
from stridemap.sweeps.lock import held, refuse_if_held
from stridemap.sweeps.parts import part_table, result_of, solutions_of
from stridemap.sweeps.provenance import provenance
from stridemap.sweeps.solutions import Guesses, Solutions
from stridemap.sweeps.special_tables import in_order, special_table_of
from stridemap.sweeps.store import CELLS, SPECIAL, Store, read_table
from stridemap.sweeps.tables import cell_table, orbit_schema, table_of
from stridemap.sweeps.tasks import Result, Task
from stridemap.sweeps.tiles import work

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

MOST_WORKERS = 1024
"""Processes of one sweep: each takes some 200 MB, and no machine has as many cores."""


@dataclass(frozen=True)
class Progress:
    """How far a sweep is.

    Parameters
    ----------
    round : int
        Rounds count from 1.
    done, total : int
        Tiles of this round.
    orbits : int
        Limit cycles found so far.
    """

    round: int
    done: int
    total: int
    orbits: int


@dataclass(frozen=True)
class Summary:
    """What a sweep found.

    Parameters
    ----------
    folder : pathlib.Path
    cells, orbits, stable_orbits, failed_cells : int
    already_finished : bool
        Whether the tables were there before.
    special : dict of str to int
        Number of special points that were located along the lines of the grid, by type.
    special_not_located : int
        Number of those that were not.
    """

    folder: Path
    cells: int
    orbits: int
    stable_orbits: int
    failed_cells: int
    already_finished: bool = False
    special: dict[str, int] = field(default_factory=dict)
    special_not_located: int = 0


def sweep(
    config: SweepConfig | str | Path,
    out: str | Path,
    *,
    workers: int | None = None,
    executor: Executor | None = None,
    dask: str | Path | None = None,
    resume: bool = False,
    backend: str | Backend | None = None,
    tile_cells: int | None = None,
    progress: Callable[[Progress], None] | None = None,
) -> Summary:
    """Find all limit cycles of a grid and write ``orbits.parquet``, ``cells.parquet``, ``special.parquet``.

    Parameters
    ----------
    config : SweepConfig or path of a TOML file
    out : path
        Output folder.
    workers : int, optional
        Number of processes; by default one per core.
    executor : concurrent.futures.Executor, optional
        Runs the tiles in place of processes of our own. It is not shut down. A tile carries all that it
        needs, so it may be computed on another machine.
    dask : str or path, optional
        Address of a Dask scheduler, such as "tcp://10.0.0.5:8786", or the path of its scheduler file: its
        workers run the tiles. The software there must be the same as here.
    resume : bool
        Continue from the tiles that an earlier run finished.
    backend : str or Backend, optional
        What runs the kernels: "lanes", "scalar" or "interpreter"; by default the fastest that works here.
    tile_cells : int, optional
        Largest number of cells in a piece of work; by default some quarter of the grid, within bounds. Which
        cycles are found may depend on it, never on the number of workers.
    progress : callable, optional
        Called with a `Progress` after each tile.

    Returns
    -------
    Summary

    Raises
    ------
    InputError
        For unusable configuration, output folder or arguments, and when no scheduler answers.
    WorkerError
        When a worker process dies, the cluster is lost, or a worker has other software; finished tiles stay.
    StorageError
        When the disk is full; finished tiles stay.
    """
    config = config if isinstance(config, SweepConfig) else load_config(config)
    if workers is not None:
        _check_count("workers", workers, MOST_WORKERS)
    if dask is not None:
        if workers is not None or executor is not None:
            other = "executor" if workers is None else "workers"
            raise InputError(f"dask and {other} cannot be given together; leave one of them out")
        dask = scheduler_address(dask)
    if tile_cells is None:
        tile_cells = tile_size(Grid.from_mapping(config.grid))
    _check_count("tile_cells", tile_cells, MAX_COUNT)
    refuse_if_held(out)
    kernels = load_kernels(config.loaded, named_backend(backend))
    software = {**provenance(kernels), "tile_cells": tile_cells}
    store = Store.resume(out, config, software) if resume else Store.create(out, config, software)
    run = _Run(config, kernels.backend, tile_cells, store, progress or (lambda _: None))
    if store.finished:
        return run.summary_of_finished()
    with contextlib.ExitStack() as stack:
        stack.enter_context(held(store.folder))
        if executor is not None:
            return run.all_rounds(executor)
        if dask is not None:
            return run.all_rounds(stack.enter_context(cluster(dask)))
        try:
            pool = stack.enter_context(processes(workers or os.cpu_count() or 1))
        except OSError as error:
            raise no_workers(error) from None
        return run.all_rounds(pool)


def _check_count(name: str, value: Any, most: int) -> None:
    """Refuse what is not a whole number from 1 to a bound."""
    if isinstance(value, bool) or not isinstance(value, int | np.integer) or not 1 <= value <= most:
        shown = short(value)
        if isinstance(value, int) and value < 1:
            raise InputError(f"{name} = {shown} is not allowed: at least 1 is needed")
        raise InputError(f"{name} = {shown} is not allowed: a whole number from 1 to {most:,} is needed")


class _Run:
    """The rounds of one sweep."""

    def __init__(
        self,
        config: SweepConfig,
        backend: Backend,
        tile_cells: int,
        store: Store,
        progress: Callable[[Progress], None],
    ) -> None:
        self.config, self.backend, self.store, self.progress = config, backend, store, progress
        self.model = config.loaded
        self.grid = Grid.from_mapping(config.grid)
        self.tiles = tiles(self.grid, tile_cells)
        self.options = config.search.options
        self.orbits: list[pa.Table] = []
        self.failures: dict[int, str] = {}
        self.discarded: dict[int, Counter[Status]] = defaultdict(Counter)
        self.orbits_found = 0
        # For each tile what its cells have: cycles, and what the search gave before it converged.
        self.known: dict[int, list[Solutions]] = defaultdict(list)
        self.seen: dict[int, list[Solutions]] = defaultdict(list)
        self.joins: list[Ints] = []
        self.special: list[pa.Table] = []

    def all_rounds(self, pool: Executor) -> Summary:
        """Work until nothing new appears, then write the tables."""
        seeds = self.grid.subgrid(self.config.strides)
        owner = self.tiles.tile_of(seeds)
        tasks = [
            self._task(1, tile, seeds[owner == tile], self._guesses([])) for tile in np.unique(owner).tolist()
        ]
        for round_ in count(1):
            incoming = self._run_round(pool, round_, tasks)
            tasks = [self._task(round_ + 1, tile, seeds[:0], incoming[tile]) for tile in sorted(incoming)]
            if not tasks:
                return self._finish()
        raise AssertionError("count has no end")

    def _task(self, round_: int, tile: int, seeds: Ints, incoming: Guesses) -> Task:
        return Task(
            model=self.model,
            grid=self.grid,
            params=dict(self.config.params),
            search=self.options,
            acceptance=self.config.acceptance,
            continuation=self.config.continuation,
            special_points=self.config.special_points,
            backend=self.backend,
            round=round_,
            tile=tile,
            cells=self.tiles[tile],
            seeds=seeds,
            incoming=incoming,
            known=self._all(self.known[tile]),
            seen=self._all(self.seen[tile]),
        )

    def _run_round(self, pool: Executor, round_: int, tasks: list[Task]) -> dict[int, Guesses]:
        """Compute the tiles of a round that no earlier run finished; returns the guesses for each tile."""
        done = [task for task in tasks if self.store.has_part(round_, task.tile)]
        finished = len(done)
        self._report(round_, finished, len(tasks))
        open_tasks = [task for task in tasks if not self.store.has_part(round_, task.tile)]
        futures: list[Future[Result]] = []
        found = 0
        try:
            with interrupts_held():  # processes are started where tasks are submitted
                futures += [pool.submit(work, task) for task in open_tasks]
            for future in as_completed(futures):
                result = future.result()
                self.store.write_part(result.round, result.tile, part_table(self.model, result))
                finished += 1
                found += self._counted(result)
                self._report(round_, finished, len(tasks), found)
        except BaseException as error:
            for future in futures:
                future.cancel()
            if (reason := explained(error)) is not None:
                raise reason from None
            raise
        # Read back in the order of tiles, whatever the order in which they were finished.
        parts = ((task.tile, self.store.read_part(round_, task.tile)) for task in tasks)
        return self._absorb([result_of(self.model, round_, tile, part) for tile, part in parts])

    def _report(self, round_: int, done: int, total: int, found: int = 0) -> None:
        self.progress(Progress(round_, done, total, self.orbits_found + found))

    def _counts(self, period: Any) -> Any:
        """Whether a period is in the range that was asked for, and not just near it."""
        shortest, longest = self.options.period_range
        return (period > shortest) & (period <= longest)

    def _counted(self, result: Result) -> int:
        """How many limit cycles of a result count."""
        return int(np.count_nonzero(self._counts(np.asarray(result.orbits["period"]))))

    def _absorb(self, results: list[Result]) -> dict[int, Guesses]:
        """Take up the results of a round, in the order of tiles; returns the guesses for each tile."""
        for result in results:
            self.failures |= result.failures
            for (cell, status), n in result.discarded.items():
                self.discarded[cell][Status(status)] += n
            self.orbits.append(table_of(self.model, result.orbits))
            self.orbits_found += self._counted(result)
            self.known[result.tile].append(solutions_of(self.model, result.orbits))
            self.seen[result.tile].append(result.seen)
            self.joins.append(result.joins)
            self.special.append(special_table_of(self.model, result.special))
        every = self._guesses([result.outgoing for result in results])
        owner = self.tiles.tile_of(every.cell)
        return {tile: every.take(owner == tile) for tile in np.unique(owner).tolist()}

    def _all(self, parts: list[Solutions]) -> Solutions:
        return Solutions.concatenate(parts, len(self.model.section) + 1)

    def _guesses(self, parts: list[Guesses]) -> Guesses:
        return Guesses.concatenate(parts, len(self.model.section) + 1)

    def _finish(self) -> Summary:
        schema = orbit_schema(self.model)
        orbits = pa.concat_tables(self.orbits) if self.orbits else schema.empty_table()
        orbits = orbits.filter(self._counts(orbits["period"].to_numpy()))
        orbits = orbits.sort_by([("cell", "ascending"), ("period", "ascending")])
        special = pa.concat_tables(self.special)
        # Cycles come first: families of which there is none in a cell get the numbers after theirs.
        branches = [table["branch"].to_numpy() for table in (orbits, special)]
        numbers = families(np.concatenate(branches), np.concatenate(self.joins))
        orbits = _numbered(orbits, numbers[: len(orbits)])
        axis = self.grid.longest_axis
        width = float(np.ptp(self.grid.axes[axis])) or 1.0
        special = in_order(
            self.model, self.grid.names[axis], width, _numbered(special, numbers[len(orbits) :])
        )
        points = self.grid.points(self.model, self.config.params)
        found = np.bincount(orbits["cell"].to_numpy(), minlength=self.grid.n_cells)
        status, reason = self._outcomes(points, found)
        cells = cell_table(self.model, points, orbits, status, reason)
        self.store.finish(orbits, cells, special)
        return self._summary(cells, special)

    def _outcomes(self, points: Floats, found: Ints) -> tuple[list[str], list[str | None]]:
        """Status of each cell, and why it is failed or empty, or lacks something."""
        # Where a parameter is at an end of its allowed range, equations may degenerate.
        ends = np.array([[one.lower, one.upper] for one in self.model.parameters], dtype=float).T
        at_end = (points[:, None, :] == ends).any(axis=(1, 2))
        asked = np.flatnonzero(at_end & (found == 0))
        degenerate = set(asked[have_no_cycle(self.model, points[asked])].tolist())
        status, reason = [], []
        for cell, n in enumerate(found.tolist()):
            one, why = self._outcome(cell, n)
            if cell in degenerate and one == "empty":
                why = f"{why}; {why_no_cycle(self.model, points[cell])}"
            status.append(one)
            reason.append(why)
        return status, reason

    def _outcome(self, cell: int, found: int) -> tuple[str, str | None]:
        if cell in self.failures:
            return "failed", self.failures[cell]
        thrown = self.discarded.get(cell, Counter())
        if found:
            lost = thrown[Status.UNRESOLVED]
            return "found", f"not all: {_thrown_away({Status.UNRESOLVED: lost})}" if lost else None
        lower, upper = self.options.period_range
        why = (
            f"no limit cycle with {lower:g} < period <= {upper:g} was found, from the starts or from "
            "neighbouring cells"
        )
        return "empty", f"{why}; thrown away: {_thrown_away(thrown)}" if thrown else why

    def summary_of_finished(self) -> Summary:
        """Read the summary of a sweep that was finished before."""
        folder = self.store.folder
        return self._summary(read_table(folder, CELLS), read_table(folder, SPECIAL), already_finished=True)

    def _summary(self, cells: pa.Table, special: pa.Table, already_finished: bool = False) -> Summary:
        located = special.filter(pc.is_null(special["reason"]))
        return Summary(
            self.store.folder,
            cells=len(cells),
            orbits=pc.sum(cells["orbits"]).as_py(),
            stable_orbits=pc.sum(cells["stable_orbits"]).as_py(),
            failed_cells=pc.sum(pc.equal(cells["status"], "failed")).as_py(),
            already_finished=already_finished,
            special=dict(sorted(Counter(located["type"].to_pylist()).items())),
            special_not_located=len(special) - len(located),
        )


def _numbered(table: pa.Table, branch: Ints) -> pa.Table:
    """A table with other numbers of branches."""
    column = table.schema.get_field_index("branch")
    return table.set_column(column, table.schema.field("branch"), pa.array(branch))


def _thrown_away(counts: Mapping[Status, int]) -> str:
    """How many solutions were no limit cycle, and why."""
    known = (status for status in Status if counts.get(status))
    return ", ".join(f"{counts[one]} solution{'' if counts[one] == 1 else 's'} {one.reason}" for one in known)
