"""Families of limit cycles: branches of the search that are connected, numbered."""

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

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
    names, place = np.unique(np.concatenate([branch, joins.ravel()]), return_inverse=True)
    one, other = place[len(branch) :].reshape(-1, 2).T
    graph = coo_array((np.ones(len(one), dtype=bool), (one, other)), shape=(len(names), len(names)))
    family = connected_components(graph, directed=False)[1][place[: len(branch)]]
    _, first, number = np.unique(family, return_index=True, return_inverse=True)
    return np.argsort(np.argsort(first))[number]
