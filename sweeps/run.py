"""Sweeps: every limit cycle of every cell of a grid of parameters.

Many starts on a subgrid give the first cycles. The branch of each is followed along its line of the grid,
around folds, and from some of its cycles Newton's method is started in the cells beside them, until nothing
new appears. The grid is cut into tiles. In one round, each tile with incoming guesses is worked on by itself;
what reaches another tile waits for the next round. When nothing new appears any more, the branches of
different lines are followed to each other that may be one. Tiles and rounds do not depend on the number of
workers, so neither do the tables.
"""

import contextlib
import os
from collections import Counter
from collections.abc import Callable, Generator, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import FIRST_COMPLETED, Executor, Future, wait
from dataclasses import dataclass, field
from functools import partial
from itertools import count, islice
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa
import pyarrow.compute as pc
from numpy.typing import NDArray

from stridemap.errors import InputError, short
from stridemap.solver.backends.base import Backend
from stridemap.solver.backends.selection import load_kernels, named_backend
from stridemap.sweeps.cluster import cluster, scheduler_address
from stridemap.sweeps.config import MAX_COUNT, SweepConfig, load_config, parse_config
from stridemap.sweeps.connections import ATTEMPTS, connect
from stridemap.sweeps.executors import interrupts_held, processes
from stridemap.sweeps.failures import explained, no_workers
from stridemap.sweeps.files import read
from stridemap.sweeps.found import Found
from stridemap.sweeps.grid import Grid, tile_size, tiles
from stridemap.sweeps.lock import held, refuse_if_held
from stridemap.sweeps.parts import (
    counted_columns,
    guess_columns,
    guesses_of,
    known_columns,
    known_of,
    part_table,
    result_of,
)
from stridemap.sweeps.provenance import provenance
from stridemap.sweeps.solutions import Guesses, Links, Solutions
from stridemap.sweeps.store import CELLS, SPECIAL, Store, table_path
from stridemap.sweeps.tasks import Result, Task
from stridemap.sweeps.tiles import work

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

MOST_WORKERS = 1024
"""Processes of one sweep: each takes some 200 MB, and no machine has as many cores."""

LINKS = 1000
"""How many links a worker is given to follow: the more, the less a link costs."""

AHEAD = 4
"""How many tiles are submitted at a time for each worker of this machine."""

AHEAD_ELSEWHERE, AHEAD_BYTES = 64, 64_000_000
"""How many are submitted to an executor that does not say how many workers it has: so many, and more as long
as what they carry takes less memory than this."""


@dataclass(frozen=True)
class Progress:
    """How far a sweep is.

    Parameters
    ----------
    round : int
        Rounds count from 1.
    done, total : int
        Pieces of work of this round: tiles, and in the last rounds branches that are followed to others.
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
    config: SweepConfig | Mapping[str, Any] | str | Path,
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
    config : SweepConfig, mapping, or path of a TOML file
        A mapping holds what a file would: ``{"model": "compass", "grid": {"omega": [2.0, 3.0]}}``.
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
        Largest number of cells in a piece of work; by default less than a third of the grid, within bounds.
        Which cycles are found may depend on it, never on the number of workers.
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
    if not isinstance(config, SweepConfig):
        config = parse_config(config) if isinstance(config, Mapping) else load_config(config)
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
    workers = workers or os.cpu_count() or 1
    known = workers if executor is None and dask is None else getattr(executor, "_max_workers", None)
    ahead = (AHEAD * known, 0) if isinstance(known, int) else (AHEAD_ELSEWHERE, AHEAD_BYTES)
    run = _Run(config, kernels.backend, tile_cells, store, progress or (lambda _: None), ahead)
    if store.finished:
        return run.summary_of_finished()
    with contextlib.ExitStack() as stack:
        stack.enter_context(held(store.folder))
        if executor is not None:
            return run.all_rounds(executor)
        if dask is not None:
            return run.all_rounds(stack.enter_context(cluster(dask)))
        try:
            pool = stack.enter_context(processes(workers))
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
    """The rounds of one sweep. The limit cycles that were found are in the parts, and not in memory."""

    def __init__(
        self,
        config: SweepConfig,
        backend: Backend,
        tile_cells: int,
        store: Store,
        progress: Callable[[Progress], None],
        ahead: tuple[int, int],
    ) -> None:
        self.config, self.backend, self.store, self.progress = config, backend, store, progress
        self.ahead = ahead
        self.model = config.loaded
        self.grid = Grid.from_mapping(config.grid)
        self.tiles = tiles(self.grid, tile_cells)
        self.options = config.search.options
        self.found = Found(config, self.grid)
        self.width = len(self.model.section) + 1

    def all_rounds(self, pool: Executor) -> Summary:
        """Work until nothing new appears, find out which branches are one, and write the tables."""
        seeds = self.grid.subgrid(self.config.strides)
        owner = self.tiles.tile_of(seeds)
        given: dict[int, Ints] = {tile: seeds[owner == tile] for tile in np.unique(owner).tolist()}
        senders: dict[int, list[int]] = {}
        rounds = count(1)
        while given:
            round_ = next(rounds)
            tasks = {
                tile: partial(self._tile_task, round_, tile, given[tile], senders.get(tile, []))
                for tile in given
            }
            senders = self._run_round(pool, work, round_, tasks)
            given = dict.fromkeys(sorted(senders), seeds[:0])
        for round_ in islice(rounds, ATTEMPTS):
            links = self.found.next_links()
            if not len(links):
                break
            seen = self._seen_in(links.cell)
            tasks = {
                number: partial(self._link_task, round_, number, links, seen)
                for number in range(-(-len(links) // LINKS))
            }
            self._run_round(pool, connect, round_, tasks)
        return self._finish()

    def _tile_task(self, round_: int, tile: int, seeds: Ints, senders: Sequence[int]) -> Task:
        """What a worker needs, read from the parts that earlier rounds have left."""
        columns, known, seen = known_columns(self.model), [], []
        for one in self.found.parts:
            if one[1] == tile:
                cycles, solutions = known_of(self.model, self.store.read_part(*one, columns))
                known.append(cycles)
                seen.append(solutions)
        incoming = []
        for sender in senders:
            sent = guesses_of(self.model, self.store.read_part(round_ - 1, sender, guess_columns(self.model)))
            incoming.append(sent.take(self.tiles.tile_of(sent.cell) == tile))
        return self._task(
            round_,
            tile,
            cells=self.tiles[tile],
            seeds=seeds,
            incoming=Guesses.concatenate(incoming, self.width),
            known=Solutions.concatenate(known, self.width),
            seen=Solutions.concatenate(seen, self.width),
        )

    def _link_task(self, round_: int, number: int, links: Links, seen: Solutions) -> Task:
        """What a worker needs to follow some of the links."""
        links = links.take(np.arange(LINKS * number, min(LINKS * (number + 1), len(links))))
        cells = np.unique(links.cell)
        return self._task(
            round_,
            number,
            cells=cells,
            seeds=cells[:0],
            incoming=Guesses(links.cell, links.u, links.branch, links.origin),
            known=Solutions.empty(self.width),
            seen=seen.take(np.isin(seen.cell, cells)),
        )

    def _seen_in(self, cells: Ints) -> Solutions:
        """What the search gave in some cells."""
        columns = known_columns(self.model)
        parts = (known_of(self.model, self.store.read_part(*one, columns)) for one in self.found.parts)
        seen = [solutions.take(np.isin(solutions.cell, cells)) for _, solutions in parts]
        return Solutions.concatenate(seen, self.width)

    def _task(self, round_: int, tile: int, **parts: Any) -> Task:
        """A task of this sweep."""
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
            **parts,
        )

    def _run_round(
        self,
        pool: Executor,
        method: Callable[[Task], Result],
        round_: int,
        tasks: Mapping[int, Callable[[], Task]],
    ) -> dict[int, list[int]]:
        """Compute what no earlier run finished of a round.

        Parameters
        ----------
        pool : Executor
        method : callable
            What workers do.
        round_ : int
        tasks : mapping of int to callable
            What makes each task when it is its turn, by ascending numbers: those of tiles, or of pieces.

        Returns
        -------
        dict of int to list of int
            The tiles that have sent guesses to a tile.
        """
        open_ = [number for number in tasks if not self.store.has_part(round_, number)]
        finished, found = len(tasks) - len(open_), 0
        self._report(round_, finished, len(tasks))
        made = (tasks[number]() for number in open_)
        with contextlib.closing(self._computed(pool, method, made)) as results:
            for result in results:
                self.store.write_part(result.round, result.tile, part_table(self.model, result))
                finished += 1
                found += self.found.counted(result)
                self._report(round_, finished, len(tasks), found)
        # Read back in the order of tiles, whatever the order in which they were finished.
        columns = counted_columns(self.model, self.config.special_points)
        parts = ((number, self.store.read_part(round_, number, columns)) for number in tasks)
        return self._absorb(result_of(self.model, round_, number, part) for number, part in parts)

    def _computed(
        self, pool: Executor, method: Callable[[Task], Result], tasks: Iterator[Task]
    ) -> Generator[Result, None, None]:
        """Results as they are finished; only so many tasks are made ahead of them."""
        sizes: dict[Future[Result], int] = {}
        count_, size = self.ahead
        try:
            while True:
                while len(sizes) < count_ or sum(sizes.values()) < size:
                    if (task := next(tasks, None)) is None:
                        break
                    with interrupts_held():  # processes are started where tasks are submitted
                        sizes[pool.submit(method, task)] = task.size
                if not sizes:
                    return
                done, _ = wait(list(sizes), return_when=FIRST_COMPLETED)
                ended = [future for future in sizes if future in done]
                done = set()  # a result is kept no longer than it takes to write it
                while ended:
                    future = ended.pop(0)
                    del sizes[future]
                    yield future.result()
                    del future
        except BaseException as error:
            for future in sizes:
                future.cancel()
            if (reason := explained(error)) is not None:
                raise reason from None
            raise

    def _report(self, round_: int, done: int, total: int, found: int = 0) -> None:
        self.progress(Progress(round_, done, total, self.found.n_orbits + found))

    def _absorb(self, results: Iterable[Result]) -> dict[int, list[int]]:
        """Take up the results of a round, in the order of tiles; returns who sends guesses to each tile."""
        senders: dict[int, list[int]] = {}
        for result in results:
            self.found.add(result)
            for tile in np.unique(self.tiles.tile_of(result.outgoing.cell)).tolist():
                senders.setdefault(tile, []).append(result.tile)
        return senders

    def _finish(self) -> Summary:
        found = self.found
        orbits, cells, special = found.tables(self.store)
        self.store.finish(orbits, cells, special)
        return self._summary(found.n_orbits, int(found.stable.sum()), len(found.failures), special)

    def summary_of_finished(self) -> Summary:
        """Read the summary of a sweep that was finished before."""
        folder = self.store.folder
        cells = read(table_path(folder, CELLS), ["orbits", "stable_orbits", "status"])
        special = read(table_path(folder, SPECIAL), ["type", "reason"])
        orbits, stable = (pc.sum(cells[name]).as_py() for name in ("orbits", "stable_orbits"))
        failed = pc.sum(pc.equal(cells["status"], "failed")).as_py()
        return self._summary(orbits, stable, failed, special, already_finished=True)

    def _summary(
        self, orbits: int, stable: int, failed: int, special: pa.Table, already_finished: bool = False
    ) -> Summary:
        located = special.filter(pc.is_null(special["reason"]))
        return Summary(
            self.store.folder,
            cells=self.grid.n_cells,
            orbits=orbits,
            stable_orbits=stable,
            failed_cells=failed,
            already_finished=already_finished,
            special=dict(sorted(Counter(located["type"].to_pylist()).items())),
            special_not_located=len(special) - len(located),
        )
