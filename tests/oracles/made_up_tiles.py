"""Tiles of a sweep that nobody computed, so that its tables can be as large as one likes."""

from concurrent.futures import Executor, Future

import numpy as np

from stridemap.sweeps.solutions import Guesses, Links, Solutions
from stridemap.sweeps.tables import orbit_schema
from stridemap.sweeps.tasks import Result

BRANCHES = 2**32


class Later(Future):
    """What is finished and takes no memory before it is asked for."""

    def __init__(self, make):
        super().__init__()
        self.make = make
        self.set_result(None)

    def result(self, timeout=None):
        return self.make()


class MadeUp(Executor):
    """In place of the workers of a sweep: two rounds of tiles with random numbers.

    Each cell has ``per_cell`` limit cycles, the last of which is found in the second round where the first
    sends guesses from tile to tile, and one solution that is thrown away.

    Parameters
    ----------
    per_cell : int
    like : mapping, optional
        A row of ``orbits.parquet``: its state and its measures are those of all cycles, within 3 %.
    """

    _max_workers = 2  # as a pool of processes says it

    def __init__(self, per_cell=3, like=None):
        self.per_cell, self.like = per_cell, like or {}

    def submit(self, fn, /, task):
        return Later(lambda: self.result(task))

    def result(self, task):
        """What a worker would have found in a tile."""
        rng = np.random.default_rng([task.round, task.tile])
        first = task.round == 1
        number = self.per_cell - 1 if first else 1
        cells = task.cells if first else np.unique(task.incoming.cell)
        cell = np.repeat(cells, number)
        branch = task.tile * BRANCHES + np.tile(np.arange(number), len(cells)) + (0 if first else number + 9)
        columns = self.columns(task, cell, rng)
        u = np.column_stack([columns[name] for name in (*task.model.section, "period")])
        seen = Solutions(cell, u, branch)
        return Result(
            task.round, task.tile, {**columns, "branch": branch}, {}, seen,
            self.outgoing(task, seen), Links.empty(u.shape[1]), np.column_stack([branch, branch])[:9], {},
            {(one, "not_a_step"): 1 for one in cells.tolist()} if first else {},
        )  # fmt: skip

    def columns(self, task, cell, rng):
        n, points = len(cell), task.grid.points(task.model, task.params, cell).T
        out = {"cell": cell, **dict(zip(task.model.spec.names, points, strict=True))}
        for field in orbit_schema(task.model):
            if field.name in out or field.name == "branch":
                continue
            kind, value = str(field.type), self.like.get(field.name)
            if kind == "double":
                out[field.name] = rng.uniform(0.1, 1.9, n)
                if value is not None:
                    out[field.name] = value * rng.uniform(0.97, 1.03, n)
            elif kind == "int64":
                out[field.name] = rng.integers(1, 4, n)
            elif kind == "bool":
                out[field.name] = rng.random(n) < 0.5
            else:
                out[field.name] = rng.choice(list("ABCD"), n)
        return out | {"status": np.full(n, "converged")}

    def outgoing(self, task, seen):
        """In the first round a guess in every other tile's cells beside ours; in the second none."""
        nothing = Guesses.empty(seen.u.shape[1])
        if task.round > 1:
            return nothing
        row, beside = task.grid.beside(seen.cell)
        away = ~np.isin(beside, task.cells)
        row, beside = row[away], beside[away]
        return Guesses(beside, seen.u[row], seen.branch[row], seen.cell[row])
