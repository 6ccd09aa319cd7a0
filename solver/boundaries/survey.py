"""All boundaries in the plane of two parameters: seeds on lines across it, each boundary followed once."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.boundaries.codim2 import Codim2Point, codim2_points, with_ends
from stridemap.solver.boundaries.systems import (
    BoundaryCurve,
    EndBoundary,
    MultiplierBoundary,
    PeriodBoundary,
    TorusBoundary,
)
from stridemap.solver.branches.arclength import CurvePoint, EndReason, Window, both_ways, passes_through
from stridemap.solver.branches.bifurcation import SpecialType
from stridemap.solver.branches.conditions import GaitEnd
from stridemap.solver.branches.ends import End, conditions_along, gait_ends
from stridemap.solver.branches.equations import CycleEquations
from stridemap.solver.branches.survey import Branch, Survey

Array = NDArray[np.float64]

PERIOD_LIMIT = "period_limit"
"""Type of a boundary on which a step takes as long, or as short, as the range of periods allows."""


@dataclass(frozen=True)
class Boundary:
    """A boundary that was followed.

    Parameters
    ----------
    curve : BoundaryCurve
    type : str
        A `SpecialType`, a `GaitEnd`, or `PERIOD_LIMIT`.
    points : list of CurvePoint
        In order along it.
    reasons : (EndReason, EndReason)
        Why it was not followed beyond its first and its last point.
    conditions : dict of GaitEnd to ndarray, shape (number of points,)
        What is positive at a gait, without what is zero on the boundary.
    codim2 : list of (int, Codim2Point)
        Points at which two things happen at once, each with the number of the point before it.
    corners : list of (int, End)
        Where it begins or ceases to be one of gaits, likewise.
    """

    curve: BoundaryCurve
    type: str
    points: list[CurvePoint]
    reasons: tuple[EndReason, EndReason]
    conditions: dict[GaitEnd, Array]
    codim2: list[tuple[int, Codim2Point]]
    corners: list[tuple[int, End]]

    @property
    def period_n(self) -> int:
        """Number of walking steps after which its cycles close."""
        return self.curve.chain.n_steps

    @property
    def cycles(self) -> Array:
        """Unknowns of the cycles and both parameters at all points, shape (m, N + 2)."""
        return np.array([self.curve.cycle(point.x) for point in self.points])

    @property
    def is_gait(self) -> NDArray[np.bool_]:
        """Which points are gaits that a walker could walk, or their ends, shape (m,)."""
        gait: NDArray[np.bool_] = np.all([one > 0 for one in self.conditions.values()], axis=0)
        return gait

    @property
    def borders_stable(self) -> NDArray[np.bool_]:
        """Where all multipliers but those of the boundary lie inside the unit circle, shape (m,)."""
        others = [self.curve.others(point.x, point.multipliers) for point in self.points]
        return np.array([np.abs(one).max(initial=0.0) < 1.0 for one in others])

    @property
    def arclength(self) -> Array:
        """Length of the boundary up to each point, in terms of the scales of the entries, shape (m,)."""
        scaled = self.cycles / self.curve.equations.scale
        return np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(scaled, axis=0), axis=1))])

    def distance(self, before: int, cycle: Array) -> float:
        """How far beyond a point of the boundary a cycle lies, in terms of the scales."""
        here = self.curve.cycle(self.points[before].x)
        return float(np.linalg.norm((cycle - here) / self.curve.equations.scale))


@dataclass(frozen=True)
class BoundarySurvey:
    """How all boundaries in the plane of two parameters are found.

    Parameters
    ----------
    along : Survey
        How branches over one of the parameters are found; which one, its range and the value of the other
        are put in for each line.
    names : (str, str)
        The two parameters.
    low, high : (float, float)
        Ends of their ranges.
    lines : int
        Number of values of each parameter at which branches over the other one are followed.
    progress : callable
        Takes a line that says what is being done.
    double_points : bool
        Whether points at which two things happen at once are looked for.
    """

    along: Survey
    names: tuple[str, str]
    low: tuple[float, float]
    high: tuple[float, float]
    lines: int
    progress: Callable[[str], None]
    double_points: bool = True

    @property
    def window(self) -> Window:
        """Where boundaries are followed."""
        shortest, longest = self.along.window.shortest, self.along.window.longest
        slack = SLACK * (longest - shortest)  # a boundary may lie on the period's limit itself
        return Window(self.low, self.high, shortest - slack, longest + slack, self.along.window.room)

    def boundaries(self) -> list[Boundary]:
        """All boundaries, in the order of discovery."""
        found: list[Boundary] = []
        for across in (1, 0):
            for value in self._values(across):
                self.progress(f"following branches at {self.names[across]} = {value:.6g}")
                for branch in self._survey(across, value).branches():
                    for kind, curve, start in self._seeds(branch, across, value):
                        new = self._followed(found, kind, curve, start)
                        if new is not None:
                            found.append(new)
        return found

    def _values(self, which: int) -> Array:
        """Values of a parameter at which branches are followed: the middles of equal parts."""
        width = self.high[which] - self.low[which]
        return self.low[which] + width * (np.arange(self.lines) + 0.5) / self.lines

    def _survey(self, across: int, value: float) -> Survey:
        """All branches over one parameter at a value of the other."""
        params, over = self.along.params.copy(), 1 - across
        params[self.along.solver.model.spec.names.index(self.names[across])] = value
        name, low, high = self.names[over], self.low[over], self.high[over]
        return replace(self.along, params=params, parameter=name, low=low, high=high)

    def _seeds(
        self, branch: Branch, across: int, value: float
    ) -> Iterator[tuple[str, BoundaryCurve, tuple[Array, int]]]:
        """Boundaries that a branch crosses: their type, their curve, and a point with its resolution."""
        widths = tuple(high - low for low, high in zip(self.low, self.high, strict=True))
        equations = CycleEquations(branch.curve.chain, self.along.params, self.names, widths)

        def cycle(x: Array) -> Array:
            """The point of a branch as one with both parameters."""
            place = len(x) - 1 + across
            return np.insert(x, place, value)

        for _, special in branch.specials:
            curve: BoundaryCurve
            if special.type in (SpecialType.FOLD, SpecialType.PD):
                curve = MultiplierBoundary(equations, 1.0 if special.type == SpecialType.FOLD else -1.0)
            elif special.type == SpecialType.NS:
                curve = TorusBoundary(equations)
            else:
                continue
            x = curve.at(cycle(special.x), special.multipliers)
            if x is not None:
                yield special.type, curve, (x, curve.n_rk(x))
        for _, end in branch.ends:
            yield (
                end.type,
                EndBoundary(equations, self.along.conditions, end.type),
                (cycle(end.point.x), end.point.n_rk),
            )
        shortest, longest = self.along.window.shortest, self.along.window.longest
        for reason, point in zip(branch.reasons, (branch.points[0], branch.points[-1]), strict=True):
            if reason == EndReason.PERIOD:
                periods = equations.steps(cycle(point.x))[:, -1]
                limit = longest if periods.max() > longest else shortest
                step = int(np.abs(periods - limit).argmin())
                yield PERIOD_LIMIT, PeriodBoundary(equations, step, limit), (cycle(point.x), point.n_rk)

    def _followed(
        self, known: list[Boundary], kind: str, curve: BoundaryCurve, start: tuple[Array, int]
    ) -> Boundary | None:
        """The boundary through a point near it; None where it is known, or not found."""
        corrected = _onto(curve, *start)
        if corrected is None:
            self.progress(f"a boundary ({kind}) was not found again from its branch")
            return None
        if any(kind == one.type and on_boundary(one, corrected) for one in known):
            return None
        where = ", ".join(
            f"{name} = {value:.6g}" for name, value in zip(self.names, curve.values(corrected.x), strict=True)
        )
        self.progress(f"following boundary {len(known)} ({kind}) from {where}")
        options, conditions = self.along.options, self.along.conditions
        points, reasons = both_ways(curve, corrected, self.window, options)
        if isinstance(curve, TorusBoundary):
            points = with_ends(curve, points)
        names = [name for name in conditions.names if name != kind]
        values = conditions_along(curve, points, conditions, names)
        corners = list(gait_ends(curve, points, values, conditions, options))
        codim2 = list(codim2_points(curve, points)) if self.double_points else []
        return Boundary(curve, str(kind), points, reasons, values, codim2, corners)


def _onto(curve: BoundaryCurve, x: Array, n_rk: int) -> CurvePoint | None:
    """The point of a boundary near x, with a tangent."""
    n_rk = max(n_rk, curve.n_rk(x))
    matrix, _ = curve.linearised(x, n_rk)
    if not np.isfinite(matrix).all():
        return None
    across = np.linalg.svd(matrix * curve.scale)[2][-1] * curve.scale
    found = curve.corrected(x, across, n_rk, ONTO)
    return CurvePoint.at(curve, found, across, n_rk) if found.converged else None


def on_boundary(known: Boundary, point: CurvePoint) -> bool:
    """Whether a point is one of a boundary: where the boundary passes nearest it is solved for.

    Parameters
    ----------
    known : Boundary
    point : CurvePoint
    """
    curve = known.curve
    if len(known.points[0].x) != len(point.x):
        return False
    steps, size = curve.equations.steps(point.x), curve.equations.n_unknowns
    for k in range(known.period_n):
        turned = point.x.copy()
        turned[:size] = np.roll(steps, k, axis=0).ravel()
        if passes_through(curve, known.points, turned):
            return True
    return False


ONTO = 12
"""Newton corrections from a special point of a branch onto its boundary."""

SLACK = 1e-6
"""By how much the window of periods is wider than their range, as a part of it."""
