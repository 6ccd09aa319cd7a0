"""Sweeps: every limit cycle of every cell of a grid of parameters.

Many starts on a subgrid give the first cycles. From every cycle found in a cell its branch is followed to
the neighbours in all grid directions, around folds, until nothing new appears. The grid is cut into tiles. In
one round, each tile with open offers is worked on by itself; what arrives in another tile waits for the next
round. Tiles and rounds do not depend on the number of workers, so neither do the tables.
"""

import contextlib
import multiprocessing
import os
import signal
import threading
import warnings
from collections import defaultdict
from collections.abc import Callable, Iterator, Mapping
from concurrent.futures import BrokenExecutor, Executor, Future, ProcessPoolExecutor, as_completed
from dataclasses import dataclass
from itertools import count
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pyarrow as pa
import pyarrow.compute
from numpy.typing import NDArray

from stridemap.errors import InputError
from stridemap.solver.backends.library import LockstepKernels, load_kernels
from stridemap.solver.cycles.search import SearchOptions
from stridemap.solver.model.loading import load
from stridemap.solver.model.model import Model
from stridemap.sweeps.config import SweepConfig, load_config
from stridemap.sweeps.grid import Grid, tiles
from stridemap.sweeps.provenance import provenance
from stridemap.sweeps.store import Store, read_cells
from stridemap.sweeps.tables import cell_table, orbit_schema, orbit_table
from stridemap.sweeps.tiles import Offer, Result, Task, work

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

TILE_CELLS = 160
KIND, REASON, SOURCE = "_kind", "_reason", "_source"
"""Columns of a part beside those of orbits: what a row is, why a cell failed, where an offer comes from."""

KINDS = ORBIT, FAILURE, SEEN, OFFER = "orbit", "failure", "seen", "offer"
"""Kinds of rows of a part."""


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
    """

    folder: Path
    cells: int
    orbits: int
    stable_orbits: int
    failed_cells: int
    already_finished: bool = False


def sweep(
    config: SweepConfig | str | Path,
    out: str | Path,
    *,
    workers: int | None = None,
    executor: Executor | None = None,
    resume: bool = False,
    progress: Callable[[Progress], None] | None = None,
) -> Summary:
    """Find all limit cycles of a grid and write ``orbits.parquet`` and ``cells.parquet``.

    Parameters
    ----------
    config : SweepConfig or path of a TOML file
    out : path
        Output folder.
    workers : int, optional
        Number of processes; by default one a core.
    executor : concurrent.futures.Executor, optional
        Runs the tiles in place of processes of our own. It is not shut down.
    resume : bool
        Continue from the tiles that an earlier run finished.
    progress : callable, optional
        Called with a `Progress` after each tile.

    Returns
    -------
    Summary

    Raises
    ------
    InputError
        For unusable configuration or output folder, or when a worker process dies; finished tiles stay.
    """
    config = config if isinstance(config, SweepConfig) else load_config(config)
    if workers is not None and workers < 1:
        raise InputError(f"workers = {workers} is not allowed: at least 1 is needed")
    model = load(config.model)
    software = provenance(model, load_kernels(model))
    store = Store.resume(out, config, software) if resume else Store.create(out, config, software)
    run = _Run(config, model, store, progress or (lambda _: None))
    if store.finished:
        return run.summary_of_finished()
    with contextlib.ExitStack() as stack:
        pool = executor or stack.enter_context(_processes(workers or os.cpu_count() or 1))
        return run.all_rounds(pool)


@contextlib.contextmanager
def _processes(workers: int) -> Iterator[Executor]:
    """Worker processes that leave an interrupt to the parent; what has begun is finished."""
    context = multiprocessing.get_context("spawn")
    pool = ProcessPoolExecutor(workers, mp_context=context, initializer=_follow_parent)
    try:
        yield pool
    finally:
        pool.shutdown(wait=True, cancel_futures=True)


@contextlib.contextmanager
def _interrupts_held() -> Iterator[None]:
    """Hold interrupts back; a process started in here never gets one, not even while it starts."""
    came: list[int] = []
    mask = getattr(signal, "pthread_sigmask", None)  # what a process inherits; not on Windows
    blocked = mask(signal.SIG_BLOCK, {signal.SIGINT}) if mask else None
    # Another thread may take a blocked signal, and Python then interrupts the main thread all the same.
    held = (signal.SIGINT, signal.SIGTERM) if threading.current_thread() is threading.main_thread() else ()
    handlers = {number: signal.signal(number, lambda got, _: came.append(got)) for number in held}
    try:
        yield
    finally:
        for signum, handler in handlers.items():
            signal.signal(signum, handler)
        if mask:
            mask(signal.SIG_SETMASK, blocked)
    for number in came[:1]:
        signal.raise_signal(number)


def _follow_parent() -> None:
    """Leave interrupts and warnings to the parent, and end when it is killed."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    warnings.simplefilter("ignore")
    parent = multiprocessing.parent_process()
    if parent is not None:

        def wait() -> None:
            parent.join()
            os._exit(1)

        threading.Thread(target=wait, daemon=True).start()


class _Run:
    """The rounds of one sweep."""

    def __init__(
        self, config: SweepConfig, model: Model, store: Store, progress: Callable[[Progress], None]
    ) -> None:
        self.config, self.model, self.store, self.progress = config, model, store, progress
        self.grid = Grid.from_mapping(config.grid)
        self.tiles = tiles(self.grid, TILE_CELLS)
        search = config.search
        self.options = SearchOptions(search.starts, search.seed, search.period_min, search.period_max)
        self.parts: list[pa.Table] = []
        self.failures: dict[int, str] = {}
        self.orbits_found = 0
        # For each tile what its cells have: cycles, and what the search gave before it was completed.
        self.known: dict[int, list[tuple[int, Floats]]] = defaultdict(list)
        self.seen: dict[int, list[tuple[int, Floats]]] = defaultdict(list)

    def all_rounds(self, pool: Executor) -> Summary:
        """Work until nothing new appears, then write the tables."""
        seeds = self.grid.subgrid(self.config.strides)
        owner = self.tiles.tile_of(seeds)
        tasks = [self._task(1, tile, seeds[owner == tile], []) for tile in np.unique(owner).tolist()]
        for round_ in count(1):
            offers = self._run_round(pool, round_, tasks)
            tasks = [self._task(round_ + 1, tile, seeds[:0], offers[tile]) for tile in sorted(offers)]
            if not tasks:
                return self._finish()
        raise AssertionError("count has no end")

    def _task(self, round_: int, tile: int, seeds: Ints, offers: list[Offer]) -> Task:
        return Task(
            model=self.model,
            grid=self.grid,
            params=dict(self.config.params),
            options=self.options,
            lockstep=isinstance(load_kernels(self.model), LockstepKernels),
            round=round_,
            tile=tile,
            cells=self.tiles[tile],
            seeds=seeds,
            offers=offers,
            known=self.known[tile],
            seen=self.seen[tile],
        )

    def _run_round(self, pool: Executor, round_: int, tasks: list[Task]) -> dict[int, list[Offer]]:
        """Compute the tiles of a round that no earlier run finished; returns the offers for each tile."""
        done = [task for task in tasks if self.store.has_part(round_, task.tile)]
        finished = len(done)
        self._report(round_, finished, len(tasks))
        open_tasks = [task for task in tasks if not self.store.has_part(round_, task.tile)]
        futures: list[Future[Result]] = []
        found = 0
        try:
            with _interrupts_held():  # processes are started where tasks are submitted
                futures += [pool.submit(work, task) for task in open_tasks]
            for future in as_completed(futures):
                result = future.result()
                self.store.write_part(result.round, result.tile, self._part(result))
                finished += 1
                found += sum(self._counts(row["period"]) for row in result.rows)
                self._report(round_, finished, len(tasks), found)
        except BrokenExecutor:
            raise InputError(
                "a worker process died (out of memory, or a script that sweeps without "
                '`if __name__ == "__main__":`?); finished tiles are kept: continue with --resume, '
                "perhaps with fewer --workers"
            ) from None
        except BaseException:
            for future in futures:
                future.cancel()
            raise
        # Read back in the order of tiles, whatever the order in which they were finished.
        return self._absorb([(task.tile, self.store.read_part(round_, task.tile)) for task in tasks])

    def _report(self, round_: int, done: int, total: int, found: int = 0) -> None:
        self.progress(Progress(round_, done, total, self.orbits_found + found))

    def _counts(self, period: Any) -> Any:
        """Whether a period is in the range that was asked for, and not just near it."""
        shortest, longest = self.options.period_range
        return (period > shortest) & (period <= longest)

    def _part(self, result: Result) -> pa.Table:
        names = [*self.model.section, "period"]
        rows: list[Mapping[str, Any]] = [{**row, KIND: ORBIT} for row in result.rows]
        rows += [{"cell": cell, KIND: FAILURE, REASON: why} for cell, why in sorted(result.failures.items())]
        for cell, u in result.seen:
            rows.append({"cell": cell, KIND: SEEN, **dict(zip(names, u.tolist(), strict=True))})
        for cell, source, u in result.offers:
            point = dict(zip(names, u.tolist(), strict=True))
            rows.append({"cell": cell, KIND: OFFER, SOURCE: source, **point})
        fields = [field.with_nullable(True) for field in orbit_schema(self.model)]
        fields += [pa.field(KIND, pa.string()), pa.field(REASON, pa.string()), pa.field(SOURCE, pa.int64())]
        return pa.Table.from_pylist(rows, schema=pa.schema(fields))

    def _absorb(self, parts: list[tuple[int, pa.Table]]) -> dict[int, list[Offer]]:
        """Take up the finished parts of a round, in the order of tiles; returns the offers for each tile."""
        offers: dict[int, list[Offer]] = defaultdict(list)
        for tile, part in parts:
            of_kind = {kind: part.filter(pa.compute.equal(part[KIND], kind)) for kind in KINDS}
            failed = of_kind[FAILURE]
            self.failures |= dict(zip(failed["cell"].to_pylist(), failed[REASON].to_pylist(), strict=True))
            orbits = of_kind[ORBIT].drop_columns([KIND, REASON, SOURCE])
            self.parts.append(orbits)
            self.orbits_found += int(np.count_nonzero(self._counts(orbits["period"].to_numpy())))
            self.known[tile] += self._points(of_kind[ORBIT])
            self.seen[tile] += self._points(of_kind[SEEN])
            made = of_kind[OFFER]
            for (cell, u), source in zip(self._points(made), made[SOURCE].to_pylist(), strict=True):
                offers[int(self.tiles.tile_of([cell])[0])].append(Offer(cell, source, u))
        return offers

    def _points(self, rows: pa.Table) -> list[tuple[int, Floats]]:
        """Cells and section points with periods of rows of a part."""
        u = np.column_stack([rows[name].to_numpy() for name in (*self.model.section, "period")])
        return list(zip(rows["cell"].to_pylist(), u, strict=True))

    def _finish(self) -> Summary:
        schema = orbit_schema(self.model)
        orbits = pa.concat_tables(self.parts).cast(schema) if self.parts else orbit_table(self.model, [])
        orbits = orbits.filter(self._counts(orbits["period"].to_numpy()))
        points = self.grid.points(self.model, self.config.params)
        found = np.bincount(orbits["cell"].to_numpy(), minlength=self.grid.n_cells)
        status, reason = zip(*(self._cell(cell, n) for cell, n in enumerate(found.tolist())), strict=True)
        cells = cell_table(self.model, points, orbits, status, reason)
        self.store.finish(orbits, cells)
        return self._summary(cells.to_pandas())

    def _cell(self, cell: int, found: int) -> tuple[str, str | None]:
        if cell in self.failures:
            return "failed", self.failures[cell]
        if found:
            return "found", None
        lower, upper = self.options.period_range
        return (
            "empty",
            f"no start and no neighbour's cycle led to a limit cycle with {lower:g} < period <= {upper:g}",
        )

    def summary_of_finished(self) -> Summary:
        """Read the summary of a sweep that was finished before."""
        return self._summary(read_cells(self.store.folder), already_finished=True)

    def _summary(self, cells: pd.DataFrame, already_finished: bool = False) -> Summary:
        return Summary(
            self.store.folder,
            cells=len(cells),
            orbits=int(cells["orbits"].sum()),
            stable_orbits=int(cells["stable_orbits"].sum()),
            failed_cells=int((cells["status"] == "failed").sum()),
            already_finished=already_finished,
        )
