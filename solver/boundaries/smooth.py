"""Boundaries as lines that are fine enough to be drawn: cubic pieces between their points."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.boundaries.survey import Boundary
from stridemap.solver.branches import cubics
from stridemap.solver.branches.arclength import at_value

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

PARTS = 6
"""Parts into which each piece between two points is cut."""

NEAR = 0.1
"""Distance of a boundary from the middle of a cell, in terms of the distance of two cells, below which it is
solved for; and of what is found from the cubic piece, in terms of a part's length, at most."""

ON_IT = 1e-6
"""Of a part's length: a point of the line that is so near to a row is on it."""


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
        tau = np.tile(np.arange(parts) / parts, max(len(points) - 1, 0))
        inner = cubics.value(np.repeat(_pieces(boundary), parts, axis=0), tau[:, None])
        margins = [_between(value, parts) for value in boundary.conditions.values()]
        others = [curve.others(one.x, one.multipliers) for one in points]
        radius = np.array([np.abs(one).max(initial=0.0) for one in others])
        return cls(
            np.vstack([inner, points[-1].x]),
            np.all([one > 0 for one in margins], axis=0),
            _between(1.0 - radius, parts) > 0,
        )

    def exact_beside(self, boundary: Boundary, columns: Array, rows: Array) -> "SmoothLine":
        """The line with a point more, solved for, wherever it crosses a row of cells near a cell's middle.

        So it says exactly on which side of it, along the row, the cell lies.

        Parameters
        ----------
        boundary : Boundary
            The one of which this is the line.
        columns, rows : ndarray
            Values of the first and of the second parameter in the middles of the cells, ascending; at least
            two columns.
        """
        curve, y = boundary.curve, self.x[:, -1]
        part, row = np.nonzero((y[:-1, None] < rows) != (y[1:, None] < rows))
        parts = max((len(y) - 1) // max(len(boundary.points) - 1, 1), 1)
        piece, place = np.divmod(part, parts)
        # Another boundary may run beside it: what is solved for is to be near the cubic piece itself.
        cubic = _pieces(boundary)[piece]
        tau = cubics.root(cubic[:, :, -1], rows[row], place / parts, (place + 1) / parts)
        guess = cubics.value(cubic, tau[:, None])
        reach = np.linalg.norm((self.x[part + 1] - self.x[part]) / curve.scale, axis=1)
        apart = np.abs(guess[:, -2, None] - columns).min(axis=1)
        along = tau * parts - place
        # Where the line has a point on the row, as where a boundary was found, another one would be a kink.
        inside = (along > ON_IT) & (along < 1 - ON_IT)
        near = np.flatnonzero(inside & (apart < NEAR * np.diff(columns).min()))
        exact = []
        for i in near[np.lexsort((tau[near], piece[near]))].tolist():
            ahead = self.x[part[i] + 1] - self.x[part[i]]
            found = at_value(curve, guess[i], float(rows[row[i]]), ahead, 10)
            if found is not None and curve.norm(found.x - guess[i]) < NEAR * reach[i]:
                exact.append((part[i] + 1, along[i] < 0.5, found.x))
        if not exact:
            return self
        at, earlier, x = (np.array(column) for column in zip(*exact, strict=True))
        nearer = np.where(earlier, at - 1, at)
        return SmoothLine(
            np.insert(self.x, at, x, axis=0),
            np.insert(self.is_gait, at, self.is_gait[nearer]),
            np.insert(self.borders_stable, at, self.borders_stable[nearer]),
        )


def _pieces(boundary: Boundary) -> Array:
    """Cubics between neighbouring points of a boundary, shape (m - 1, 4, M + 1); see `cubics`."""
    x, tangent = (np.array([getattr(one, name) for one in boundary.points]) for name in ("x", "tangent"))
    return cubics.cubics(x[:-1], x[1:], tangent[:-1], tangent[1:], boundary.curve.scale)


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
