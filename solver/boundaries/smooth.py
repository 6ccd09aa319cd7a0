"""Boundaries as lines that are fine enough to be drawn: cubic pieces between their points."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.boundaries.survey import Boundary
from stridemap.solver.boundaries.systems import BoundaryCurve
from stridemap.solver.branches.arclength import at_value

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

PARTS = 6
"""Parts into which each piece between two points is cut."""


NEAR = 0.1
"""Distance of a boundary from the middle of a cell, in terms of the distance of two cells, below which it is
solved for: the cubic pieces are off by less."""


@dataclass(frozen=True)
class SmoothLine:
    """A boundary in the plane of its parameters.

    Parameters
    ----------
    x : ndarray, shape (m, M + 1)
        Points of the boundary's curve; the two parameters come last.
    is_gait, borders_stable : ndarray of bool, shape (m,)
        As of the `Boundary`; where one changes is interpolated.
    """

    x: Array
    is_gait: Mask
    borders_stable: Mask

    @property
    def points(self) -> Array:
        """Both parameters, shape (m, 2)."""
        return self.x[:, -2:]

    @classmethod
    def of(cls, boundary: Boundary, parts: int = PARTS) -> "SmoothLine":
        """The line through the points of a boundary, along their tangents (cubic Hermite interpolation)."""
        curve, points = boundary.curve, boundary.points
        x, tangent = np.array([one.x for one in points]), np.array([one.tangent for one in points])
        length = np.array([curve.norm(one) for one in np.diff(x, axis=0)])[:, None, None]
        s = np.linspace(0.0, 1.0, parts, endpoint=False)[None, :, None]
        here, there = x[:-1, None], x[1:, None]
        slope, next_slope = length * tangent[:-1, None], length * tangent[1:, None]
        inner = (
            here
            + s * slope
            + s**2 * (3 * (there - here) - 2 * slope - next_slope)
            + s**3 * (2 * (here - there) + slope + next_slope)
        )
        margins = [_between(value, parts) for value in boundary.conditions.values()]
        others = [curve.others(one.x, one.multipliers) for one in points]
        radius = np.array([np.abs(one).max(initial=0.0) for one in others])
        return cls(
            np.vstack([inner.reshape(-1, x.shape[1]), x[-1:]]),
            np.all([one > 0 for one in margins], axis=0),
            _between(1.0 - radius, parts) > 0,
        )

    def exact_beside(self, curve: BoundaryCurve, columns: Array, rows: Array) -> "SmoothLine":
        """The line with a point more, solved for, on each row of cells that it passes beside a cell's middle.

        So it says exactly on which side the cell lies.

        Parameters
        ----------
        curve : BoundaryCurve
            Of the boundary.
        columns, rows : ndarray
            Values of the first and of the second parameter in the middles of the cells, ascending.
        """
        y = self.x[:, -1]
        piece, row = np.nonzero((y[:-1, None] < rows) != (y[1:, None] < rows))
        part = (rows[row] - y[piece]) / (y[piece + 1] - y[piece])
        guess = self.x[piece] + part[:, None] * (self.x[piece + 1] - self.x[piece])
        apart = np.abs(guess[:, -2, None] - columns).min(axis=1)
        reach = np.linalg.norm((self.x[piece + 1] - self.x[piece]) / curve.scale, axis=1)
        place, exact = [], []
        for i in np.flatnonzero(apart < NEAR * np.diff(columns).min()).tolist():
            ahead = self.x[piece[i] + 1] - self.x[piece[i]]
            found = at_value(curve, guess[i], float(rows[row[i]]), ahead, 10)
            if found is not None and curve.norm(found.x - guess[i]) < reach[i]:
                place.append((piece[i] + 1, part[i]))
                exact.append(found.x)
        order = sorted(range(len(place)), key=place.__getitem__)
        at = np.array([place[i][0] for i in order], dtype=np.int64)
        between = np.array([place[i][1] < 0.5 for i in order], dtype=bool)
        nearer = np.where(between, at - 1, at)
        return SmoothLine(
            np.insert(self.x, at, np.array(exact).reshape(-1, self.x.shape[1])[order], axis=0),
            np.insert(self.is_gait, at, self.is_gait[nearer]),
            np.insert(self.borders_stable, at, self.borders_stable[nearer]),
        )


def _between(value: Array, parts: int) -> Array:
    """A value at the points of a smooth line by linear interpolation; if it is infinite, the nearer one."""
    at = np.arange((len(value) - 1) * parts + 1) / parts
    low = np.minimum(at.astype(int), len(value) - 2) if len(value) > 1 else np.zeros(1, dtype=int)
    if len(value) == 1:
        return value
    part = at - low
    one, other = value[low], value[low + 1]
    finite = np.isfinite(one) & np.isfinite(other)
    nearer = np.where(part < 0.5, one, other)
    with np.errstate(invalid="ignore"):
        return np.where(finite, one + part * (other - one), nearer)
