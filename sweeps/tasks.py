"""What a worker is given for one piece of a sweep, and what it gives back: plain arrays.

A piece is a tile, whose cycles are searched for (`tiles.work`), or some links between lines, which are
followed (`connections.connect`): these are its incoming guesses, and its number stands in the place of a
tile's.

The tables are made of them where they are written. What makes tables takes as long to load as all else that a
worker needs.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.backends.base import Backend
from stridemap.solver.model.model import Model
from stridemap.solver.options import AcceptanceOptions, ContinuationOptions, SearchOptions
from stridemap.sweeps.grid import Grid
from stridemap.sweeps.software import software
from stridemap.sweeps.solutions import Guesses, Links, Solutions

Ints = NDArray[np.int64]


@dataclass(frozen=True)
class Task:
    """What a worker needs to work on one tile: all of it, wherever the worker is.

    Parameters
    ----------
    model : Model
        With its generated files.
    grid : Grid
    params : dict of str to float
        Parameters that are not on an axis of the grid.
    search, acceptance, continuation : SearchOptions, AcceptanceOptions, ContinuationOptions
    backend : Backend
        What runs the kernels.
    round, tile : int
    cells : ndarray of int, shape (n,)
        The tile's cells, ascending.
    seeds : ndarray of int
        Those of them that get many starts.
    incoming : Guesses
        From branches of other tiles.
    known : Solutions
        Cycles that the tile's cells have already.
    seen : Solutions
        What the search gave there, before it converged: the cycles, and what turned out not to be one.
    special_points : bool
        Whether they are located.
    software : dict of str to str
        What the process that made the task runs; a worker with another is refused.
    """

    model: Model
    grid: Grid
    params: dict[str, float]
    search: SearchOptions
    acceptance: AcceptanceOptions
    continuation: ContinuationOptions
    backend: Backend
    round: int
    tile: int
    cells: Ints
    seeds: Ints
    incoming: Guesses
    known: Solutions
    seen: Solutions
    special_points: bool = True
    software: dict[str, str] = field(default_factory=lambda: dict(software()))

    @property
    def size(self) -> int:
        """Bytes of what it carries of cells and cycles."""
        return sum(one.u.nbytes + one.cell.nbytes for one in (self.incoming, self.known, self.seen))


@dataclass(frozen=True)
class Result:
    """What a worker found.

    Parameters
    ----------
    round, tile : int
    orbits : mapping of str to array, shape (n,)
        Columns of the table of orbits, with the numbers of branches that the search gave them.
    failures : dict of int to str
        Cells that failed with the reason.
    seen : Solutions
        What is to be added to the task's.
    outgoing : Guesses
        For cells of other tiles.
    links : Links
        Where following decides whether two branches are one.
    joins : ndarray of int, shape (n, 2)
        Pairs of branches that are one.
    special : mapping of str to sequence, length n
        Columns of the table of special points, with the numbers of branches that the search gave them.
    discarded : dict of (int, str) to int
        How many solutions in which cell were no limit cycle, by `Status`.
    """

    round: int
    tile: int
    orbits: Mapping[str, Any]
    failures: dict[int, str]
    seen: Solutions
    outgoing: Guesses
    links: Links
    joins: Ints
    special: Mapping[str, Any]
    discarded: dict[tuple[int, str], int]
