"""Branches as lines to draw: their special points among their points, and how each piece looks.

So looks change exactly where a special point lies, and not at the next point of the branch.
"""

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Ints = NDArray[np.int_]

NO_GAIT, UNSTABLE, STABLE = range(3)
"""Looks of a piece of a branch, from the least to the most."""


def kinds_of(gait: NDArray[np.bool_], largest: Array) -> Ints:
    """How each point looks by itself, from whether it is a gait and the modulus of its largest multiplier."""
    return np.where(gait, np.where(largest < 1.0, STABLE, UNSTABLE), NO_GAIT)


def placed(lengths: Array, special: Array) -> Ints:
    """The order of a branch's points and then its special points along it, by their arclengths."""
    return np.argsort(np.concatenate([lengths, special]), kind="stable")


def looks_between(order: Ints, kinds: Ints) -> Ints:
    """How the pieces of a branch look, shape (m - 1,).

    Parameters
    ----------
    order : ndarray of int, shape (m,)
        As from `placed`.
    kinds : ndarray of int, shape (n,)
        Of its n points.
    """
    n = len(kinds)
    # A piece between two points without a special point between them looks as the less of both.
    ordinary = order < n
    before = np.maximum.accumulate(np.where(ordinary, order, 0))
    after = np.minimum(before + 1, n - 1)
    look = np.minimum(kinds[before], kinds[after])
    look = np.where(ordinary & ~np.append(ordinary[1:], True), kinds[before], look)
    look = np.where(~ordinary & np.append(ordinary[1:], False), kinds[after], look)
    return np.asarray(look[:-1])
