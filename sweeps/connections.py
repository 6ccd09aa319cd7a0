"""Branches on different lines that are one: that a guess leads from one to the other does not say so."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from stridemap.sweeps.families import families
from stridemap.sweeps.solutions import Guesses

Ints = NDArray[np.int64]

ATTEMPTS = 2
"""How often it is tried to follow two branches that may be one from a line to the line beside it. With four
times, one of 27 families of a stiff spring was not in two parts, and following took twice as long."""


def connections(guesses: Guesses, other: Ints, joins: Ints, followed: Callable[[Guesses], Ints]) -> Ints:
    """Pairs of branches that are one, by following from cells to the cells beside them.

    A search may end far from its guess, on another branch. Following does not, but costs more; so it is done
    only where it decides whether two families are one.

    Parameters
    ----------
    guesses : Guesses
        Those to be tried first come first.
    other : ndarray of int, shape (n,)
        Branches to which searches from the guesses have led.
    joins : ndarray of int, shape (m, 2)
        Pairs of branches that are known to be one.
    followed : callable
        Guesses -> pairs of their branches and those to which following leads, shape (k, 2).

    Returns
    -------
    ndarray of int, shape (j, 2)
        What is not in `joins` yet.
    """
    found = np.empty((0, 2), dtype=np.int64)
    for _ in range(ATTEMPTS):
        every = np.concatenate([joins, found])
        pairs = np.sort(families(np.append(guesses.branch, other), every).reshape(2, -1), axis=0)
        open_ = np.flatnonzero(pairs[0] != pairs[1])
        if not len(open_):
            break
        _, first = np.unique(pairs[:, open_], axis=1, return_index=True)
        found = np.concatenate([found, followed(guesses.take(open_[first]))])
        open_ = np.delete(open_, first)
        guesses, other = guesses.take(open_), other[open_]
    return found
