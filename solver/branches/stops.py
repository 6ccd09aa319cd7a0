"""Known points of branches: where one arrives there, it is the known branch, and need not be followed on."""

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.branches.cubics import cubics, value

Array = NDArray[np.float64]
Index = NDArray[np.int64]

ON_CURVE = 0.004
"""Distance from the cubic between two points, in terms of theirs, at which a point is on the curve."""

BULGE = 0.5
"""How far beyond two points their branch may bulge, in terms of their distance."""


class Stops:
    """Known points, by their lines.

    Parameters
    ----------
    x : ndarray, shape (n, M)
        The last entry is the position on the line, from 0 to 1.
    line : ndarray of int, shape (n,)
        Number of the line of each.
    scale : ndarray, shape (M,)
    """

    def __init__(self, x: Array, line: Index, scale: Array) -> None:
        key = _key(line, x[:, -1])
        self.number = np.argsort(key, kind="stable")
        self.key, self.x, self.scale = key[self.number], x[self.number], scale

    @classmethod
    def none(cls, scale: Array) -> "Stops":
        """No known points."""
        return cls(np.empty((0, len(scale))), np.empty(0, dtype=np.int64), scale)

    def between(self, line: Index, x: Array, y: Array, tangent: Array, new: Array) -> tuple[Index, Index]:
        """Which points are on branches between x and y.

        Parameters
        ----------
        line : ndarray of int, shape (k,)
        x, y, tangent, new : ndarray, shape (k, M)
            Points with their unit tangents.

        Returns
        -------
        row, stop : ndarray of int, shape (m,)
            Number of the branch among the k, and of the known point.
        """
        with np.errstate(over="ignore", invalid="ignore"):
            return self._between(line, x, y, tangent, new)

    def _between(self, line: Index, x: Array, y: Array, tangent: Array, new: Array) -> tuple[Index, Index]:
        length = np.sqrt((((y - x) / self.scale) ** 2).sum(axis=1))
        reach = BULGE * length * self.scale[-1]
        low, high = np.minimum(x[:, -1], y[:, -1]) - reach, np.maximum(x[:, -1], y[:, -1]) + reach
        first = np.searchsorted(self.key, _key(line, low), "left")
        count = np.maximum(np.searchsorted(self.key, _key(line, high), "right") - first, 0)
        row = np.repeat(np.arange(len(x)), count)
        at = np.repeat(first - (np.cumsum(count) - count), count) + np.arange(len(row))
        away, chord = (self.x[at] - x[row]) / self.scale, ((y - x) / self.scale)[row]
        part = (away * chord).sum(axis=1) / length[row] ** 2
        # The start itself is at part 0, but for rounding.
        near = (part > 1e-9) & (part <= 1) & ((away**2).sum(axis=1) < 2 * length[row] ** 2)
        row, at, part = row[near], at[near], part[near]
        there = value(cubics(x[row], y[row], tangent[row], new[row], self.scale), part[:, None])
        distance = np.sqrt((((there - self.x[at]) / self.scale) ** 2).sum(axis=1))
        good = distance < ON_CURVE * length[row]
        return row[good], self.number[at[good]]


def _key(line: Index, s: Array) -> Array:
    """Numbers that order points by line, then position."""
    return line + 0.5 * np.clip(s, -0.5, 1.4)
