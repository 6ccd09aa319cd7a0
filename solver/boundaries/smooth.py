"""Boundaries as lines that are fine enough to be drawn: cubic pieces between their points."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.boundaries.survey import Boundary

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

PARTS = 6
"""Parts into which each piece between two points is cut."""


@dataclass(frozen=True)
class SmoothLine:
    """A boundary in the plane of its parameters.

    Parameters
    ----------
    points : ndarray, shape (m, 2)
    is_gait, borders_stable : ndarray of bool, shape (m,)
        As of the `Boundary`; where one changes is interpolated.
    """

    points: Array
    is_gait: Mask
    borders_stable: Mask

    @classmethod
    def of(cls, boundary: Boundary, parts: int = PARTS) -> "SmoothLine":
        """The line through the points of a boundary, along their tangents (cubic Hermite interpolation)."""
        curve, points = boundary.curve, boundary.points
        x, tangent = np.array([one.x for one in points]), np.array([one.tangent for one in points])
        length = np.array([curve.norm(one) for one in np.diff(x, axis=0)])[:, None, None]
        s = np.linspace(0.0, 1.0, parts, endpoint=False)[None, :, None]
        here, there = x[:-1, None, -2:], x[1:, None, -2:]
        slope, next_slope = length * tangent[:-1, None, -2:], length * tangent[1:, None, -2:]
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
            np.vstack([inner.reshape(-1, 2), x[-1:, -2:]]),
            np.all([one > 0 for one in margins], axis=0),
            _between(1.0 - radius, parts) > 0,
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
