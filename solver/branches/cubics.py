"""Cubics through two points of a curve with its tangents there: what a branch is between its points.

A cubic of the parameter tau from 0 to 1 has its coefficients on axis 1, that of the highest power first.
"""

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Index = NDArray[np.int64]

HALVINGS = 40
"""Of an interval that holds one root."""


def cubics(x0: Array, x1: Array, tangent0: Array, tangent1: Array, scale: Array) -> Array:
    """Coefficients of the cubics through pairs of points, shape (n, 4, M).

    Parameters
    ----------
    x0, x1 : ndarray, shape (n, M)
    tangent0, tangent1 : ndarray, shape (n, M)
        Unit tangents in terms of the scale.
    scale : ndarray, shape (M,)
    """
    chord = x1 - x0
    length = np.sqrt(((chord / scale) ** 2).sum(axis=1))[:, None]
    m0, m1 = length * tangent0, length * tangent1
    return np.stack([m0 + m1 - 2 * chord, 3 * chord - 2 * m0 - m1, m0, x0], axis=1)


def value(cubic: Array, tau: Array) -> Array:
    """Values at tau.

    Parameters
    ----------
    cubic : ndarray, shape (n, 4) or (n, 4, M)
    tau : ndarray, shape (n,) or (n, 1)
        One for each cubic.
    """
    out = cubic[:, 0] * tau
    for i in (1, 2):
        out = (out + cubic[:, i]) * tau
    return np.asarray(out + cubic[:, 3])


def monotonic(cubic: Array) -> tuple[Index, Array, Array]:
    """Pieces of cubics between their turning points: number of the cubic, and both ends of the piece.

    Parameters
    ----------
    cubic : ndarray, shape (n, 4)
    """
    a, b, c = 3 * cubic[:, 0], 2 * cubic[:, 1], cubic[:, 2]
    with np.errstate(all="ignore"):
        # Both roots without cancellation.
        q = -0.5 * (b + np.copysign(np.sqrt(b**2 - 4 * a * c), b))
        turns = np.stack([q / a, c / q], axis=1)
    turns = np.sort(np.where((turns > 0) & (turns < 1), turns, 1.0), axis=1)
    side = np.zeros((len(cubic), 1))
    ends = np.concatenate([side, turns, side + 1], axis=1)
    number, part = np.nonzero(ends[:, 1:] > ends[:, :-1])
    return number, ends[number, part], ends[number, part + 1]


def root(cubic: Array, level: Array, low: Array, high: Array) -> Array:
    """Where cubics that are monotonic between two ends are at a level.

    Parameters
    ----------
    cubic : ndarray, shape (n, 4)
    level, low, high : ndarray, shape (n,)
    """
    sign = np.sign(value(cubic, high) - value(cubic, low))
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        beyond = sign * (value(cubic, middle) - level) > 0
        high, low = np.where(beyond, middle, high), np.where(beyond, low, middle)
    return 0.5 * (low + high)
