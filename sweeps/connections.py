"""Branches on different lines that are one: that a guess leads from one to the other does not say so.

A search may end far from its guess, on another branch. Following does not, but costs more. So it is done only
where it decides whether two families are one, and when nothing new appears any more, for all tiles together.
"""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.branches.continuation import follow
from stridemap.solver.cycles.duplicates import SEARCH_TOLERANCE
from stridemap.solver.cycles.orbits import Orbits
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.model.scales import Scales
from stridemap.sweeps.apart import one_by_one
from stridemap.sweeps.families import families, with_smallest
from stridemap.sweeps.software import refuse_other
from stridemap.sweeps.solutions import NONE, SAME_BRANCH, Guesses, Links, Solutions
from stridemap.sweeps.special_columns import special_columns
from stridemap.sweeps.tasks import Result, Task

Ints = NDArray[np.int64]

ATTEMPTS = 2
"""How often it is tried to follow two branches that may be one from a line to the line beside it."""

STEPS_ACROSS, DS_ACROSS, DS_MAX_ACROSS = 60, 0.1, 0.2
"""Arclength steps at most from one cell to the one beside it; the first and the longest, in terms of the way.
With steps as long as the way, one branch in twenty came to a cell that it turns back from."""


def open_links(links: Links, joins: Ints, attempts: int = 1) -> Ints:
    """Which links may make one of two families: the first few of each pair of families.

    Parameters
    ----------
    links : Links
        Those to be tried first come first.
    joins : ndarray of int, shape (m, 2)
        Pairs of branches that are known to be one.
    attempts : int
        How many of each pair.

    Returns
    -------
    ndarray of int
        Rows of `links`, ascending.
    """
    pairs = np.sort(families(np.append(links.branch, links.other), joins).reshape(2, -1), axis=0)
    open_ = np.flatnonzero(pairs[0] != pairs[1])
    _, pair, count = np.unique(pairs[:, open_], axis=1, return_inverse=True, return_counts=True)
    order = np.argsort(pair.ravel(), kind="stable")
    place = np.arange(len(open_)) - np.repeat(np.cumsum(count) - count, count)
    return np.sort(open_[order[place < attempts]])


def connect(task: Task) -> Result:
    """Follow guesses from the cells in which they are solutions to their own.

    Parameters
    ----------
    task : Task
        Its incoming guesses are followed, to those solutions that were seen.

    Returns
    -------
    Result
        Pairs of branches that are one. A guess whose following raises is a failure of its cell.
    """
    refuse_other(task.software)
    failures: dict[int, str] = {}
    parts = one_by_one(
        lambda guesses: _followed_across(task, guesses), task.incoming, task.incoming.cell, failures
    )
    joins = np.concatenate([np.empty((0, 2), dtype=np.int64), *parts])
    width, none = task.incoming.u.shape[1], np.empty(0, dtype=np.int64)
    return Result(
        task.round,
        task.tile,
        {"cell": none, "branch": none, **Orbits.empty(task.model).columns()},
        failures,
        Solutions.empty(width),
        Guesses.empty(width),
        Links.empty(width),
        with_smallest(joins),
        special_columns(task.model, task.grid, task.params, []),
        {},
    )


def _followed_across(task: Task, guesses: Guesses) -> Ints:
    """Branches of guesses, and those to which they lead in the guesses' cells, as far as they do, (n, 2)."""
    solver = Solver.for_model(task.model, task.backend, task.acceptance)
    origin, there = (
        task.grid.points(task.model, task.params, cells) for cells in (guesses.origin, guesses.cell)
    )
    options = task.continuation
    ds, max_steps = max(DS_ACROSS, options.ds_min), min(options.max_steps, STEPS_ACROSS)
    options = replace(options, ds=ds, ds_max=max(ds, DS_MAX_ACROSS), max_steps=max_steps)
    begin, periods = np.zeros(len(guesses)), task.search.wider_period_range
    followed = follow(solver, guesses.u, begin, origin, there, periods, options, upwards=True)
    passed = followed.crossings(np.array([0.0, 1.0]))
    end = passed.position == 1
    row = passed.branch[end]
    u, moved = solver.polished(passed.u[end], there[row])
    arrived = Solutions(guesses.cell[row], u, guesses.branch[row]).take(moved < SAME_BRANCH)
    at = arrived.same_as(task.seen, SEARCH_TOLERANCE, Scales.of(task.model).unknowns)
    return np.column_stack([arrived.branch, task.seen.branch[at]])[at != NONE]
