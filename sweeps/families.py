"""Families of limit cycles: branches of the search that are connected, numbered."""

import numpy as np
from numpy.typing import NDArray

Ints = NDArray[np.int64]


def families(branch: Ints, joins: Ints) -> Ints:
    """The family of each limit cycle, numbered from 0 in the order in which they appear.

    Parameters
    ----------
    branch : ndarray of int, shape (n,)
        The branch of each cycle.
    joins : ndarray of int, shape (m, 2)
        Pairs of branches that are connected.

    Returns
    -------
    ndarray of int, shape (n,)
    """
    _, first, number = np.unique(smallest_of_family(branch, joins), return_index=True, return_inverse=True)
    return np.argsort(np.argsort(first))[number]


def smallest_of_family(branch: Ints, joins: Ints) -> Ints:
    """The smallest branch of the family of each of some branches; arguments and shape as in `families`."""
    names, place = np.unique(np.concatenate([branch, joins.ravel()]), return_inverse=True)
    one, other = place[len(branch) :].reshape(-1, 2).T
    return np.asarray(names[_smallest_connected(len(names), one, other)[place[: len(branch)]]])


def with_smallest(joins: Ints) -> Ints:
    """Pairs that connect the same branches: each with the smallest of its family, so that there are few."""
    names = np.unique(joins)
    pairs = np.column_stack([names, smallest_of_family(names, joins)])
    return pairs[pairs[:, 0] != pairs[:, 1]]


def _smallest_connected(n: int, one: Ints, other: Ints) -> Ints:
    """The smallest of all numbers that each of n is connected with; SciPy's own takes a while to load."""
    smallest = np.arange(n)
    while True:
        apart = smallest[one] != smallest[other]
        if not apart.any():
            return smallest
        one, other = one[apart], other[apart]
        low, high = np.sort([smallest[one], smallest[other]], axis=0)
        np.minimum.at(smallest, high, low)
        while not np.array_equal(shorter := smallest[smallest], smallest):
            smallest = shorter
