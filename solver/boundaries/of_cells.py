"""Boundaries in the plane of a sweep: seeds between cells of different classes, each followed once.

A survey that knows nothing of its plane follows branches right across it. Where a sweep has been, its cells
say where boundaries are: between two neighbours of different classes there must be one, unless what is known
passes between them already. There the cycles of one cell are followed to the other, which is a short way.
"""

import itertools
from collections.abc import Iterator
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.boundaries.smooth import SmoothLine
from stridemap.solver.boundaries.survey import Boundary, BoundarySurvey
from stridemap.solver.branches.arclength import at_value, follow
from stridemap.solver.branches.curve import Curve
from stridemap.solver.branches.plane import STABLE, Plane, cells_of
from stridemap.solver.branches.survey import Branch
from stridemap.solver.cycles.chain import Chain
from stridemap.solver.cycles.orbits import Orbits

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]


@dataclass(frozen=True)
class Gap:
    """Two neighbouring cells of different classes.

    Parameters
    ----------
    inside, outside : (int, int)
        Row and column of the cell with the higher class, and of the other.
    """

    inside: tuple[int, int]
    outside: tuple[int, int]

    @property
    def over(self) -> int:
        """Which parameter changes from one to the other: 0 along a row, 1 along a column."""
        return 0 if self.inside[0] == self.outside[0] else 1


@dataclass(frozen=True)
class CellSurvey(BoundarySurvey):
    """How the boundaries of gaits are found that pass between the cells of a map.

    Parameters
    ----------
    along, names, low, high, lines, progress, double_points
        As for `BoundarySurvey`; `lines` counts for nothing.
    plane : Plane
    orbits : Orbits
        The gaits from which it was classified.
    """

    plane: Plane = field(kw_only=True)
    orbits: Orbits = field(kw_only=True)

    def boundaries(self) -> list[Boundary]:
        """All boundaries of gaits between cells of different classes, in the order of discovery."""
        found: list[Boundary] = []
        gaps = _gaps(self.plane)
        total = len(gaps)
        while gaps:
            before = len(found)
            self.progress(f"between cells of the map: {total - len(gaps):,} of {total:,}")
            self._between(gaps.pop(0), found)
            gaps = self.unexplained(found[before:], gaps)
        return found

    def unexplained(self, found: list[Boundary], gaps: list[Gap] | None = None) -> list[Gap]:
        """Pairs of neighbours of different classes between which no boundary of gaits passes."""
        gaps = _gaps(self.plane) if gaps is None else gaps
        for boundary in found:
            line = SmoothLine.of(boundary)
            gait = _either(line.is_gait)
            stable = gait & _either(line.borders_stable)
            gaps = [one for one in gaps if not self._separated(line.points, gait, stable, one)]
        return gaps

    def _separated(self, points: Array, gait: Mask, stable: Mask, gap: Gap) -> bool:
        """Whether a line passes between two cells where it limits gaits of the inner cell's class."""
        here, there = (
            np.array([self.plane.x[column], self.plane.y[row]]) for row, column in (gap.inside, gap.outside)
        )
        piece = stable if self.plane.classes[gap.inside] == STABLE else gait
        return bool((piece & crosses(points, here, there)).any())

    def _between(self, gap: Gap, found: list[Boundary]) -> None:
        """Follow the boundaries that the cycles of one cell meet on the way to the other."""
        value = (self.plane.y[gap.inside[0]], self.plane.x[gap.inside[1]])[gap.over]
        across = 1 - gap.over
        for branch in self._ways(gap):
            for kind, curve, start in self._seeds(branch, across, value):
                new = self._followed(found, kind, curve, start)
                if new is not None and new.is_gait.any():
                    found.append(new)

    def _ways(self, gap: Gap) -> Iterator[Branch]:
        """Branches from the cycles of the inner cell to the outer one."""
        row, column = gap.inside
        axis = (self.plane.x, self.plane.y)[gap.over]
        here, there = (float(axis[one[1 - gap.over]]) for one in (gap.inside, gap.outside))
        value = float((self.plane.y[row], self.plane.x[column])[gap.over])
        survey = replace(self._survey(1 - gap.over, value), low=min(here, there), high=max(here, there))
        width = self.high[gap.over] - self.low[gap.over]
        curve = Curve.over(Chain(survey.solver.kernels), survey.params, survey.parameter, width)
        ahead = np.zeros(len(self.orbits.u[0]) + 1)
        ahead[-1] = np.sign(there - here)
        cells = cells_of(self.orbits, self.plane.names, self.plane.x, self.plane.y)
        rows = np.flatnonzero(cells == row * len(self.plane.x) + column)
        if self.plane.classes[gap.inside] == STABLE:
            rows = rows[self.orbits.known_stable[rows]]
        for u in self.orbits.u[rows]:
            start = at_value(curve, np.append(u, here), here, ahead, 10)
            if start is not None:
                ds = abs(there - here) / width / 4
                options = replace(survey.options, ds=ds, ds_max=max(2 * ds, WAY), max_steps=WAY_STEPS)
                points, reason = follow(curve, start, survey.window, options)
                yield survey._measured(curve, points, (reason, reason), None)


WAY, WAY_STEPS = 0.02, 200
"""Longest arclength step from one cell to the next, and how many: the cycle may change much more than the
parameter."""


def crosses(points: Array, here: Array, there: Array) -> NDArray[np.bool_]:
    """Which pieces of a polygonal line cross a segment, shape (m - 1,).

    Parameters
    ----------
    points : ndarray, shape (m, 2)
    here, there : ndarray, shape (2,)
    """

    def side(a: Array, b: Array, c: Array) -> Array:
        out: Array = (b[..., 0] - a[..., 0]) * (c[..., 1] - a[..., 1]) - (b[..., 1] - a[..., 1]) * (
            c[..., 0] - a[..., 0]
        )
        return out

    one, other = points[:-1], points[1:]
    apart = (side(here, there, one) > 0) != (side(here, there, other) > 0)
    return apart & ((side(one, other, here) > 0) != (side(one, other, there) > 0))


def _either(at: Mask) -> Mask:
    """Pieces of a line at one end or the other of which something is so."""
    return at[:-1] | at[1:]


def _gaps(plane: Plane) -> list[Gap]:
    """All pairs of neighbours of different classes: along rows first, each from the middle outwards."""
    gaps = []
    rows, columns = plane.classes.shape
    for di, dj in ((0, 1), (1, 0)):
        for i, j in itertools.product(range(rows - di), range(columns - dj)):
            one, other = (i, j), (i + di, j + dj)
            if plane.classes[one] != plane.classes[other]:
                inside = plane.classes[one] > plane.classes[other]
                gaps.append(Gap(one, other) if inside else Gap(other, one))
    middle = (rows - 1) / 2
    return sorted(gaps, key=lambda gap: (gap.over, abs(gap.inside[0] - middle)))
