"""All branches of cycles over one parameter: seeds at several values, each branch followed once."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.branches.arclength import (
    SAME,
    CurvePoint,
    EndReason,
    Window,
    at_value,
    both_ways,
    follow,
    passes_through,
)
from stridemap.solver.branches.asking import alone
from stridemap.solver.branches.bifurcation import Special, SpecialType
from stridemap.solver.branches.conditions import GaitConditions, GaitEnd
from stridemap.solver.branches.curve import Curve
from stridemap.solver.branches.dips import with_dips
from stridemap.solver.branches.ends import End, conditions_along, gait_ends
from stridemap.solver.branches.special import special_points
from stridemap.solver.branches.switching import Switched, crossing, doubled, supercritical
from stridemap.solver.cycles.chain import Chain
from stridemap.solver.cycles.search import find_all
from stridemap.solver.cycles.several_steps import find_chains
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.options import ContinuationOptions, SearchOptions

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Branch:
    """A branch of cycles.

    Parameters
    ----------
    curve : Curve
    points : list of CurvePoint
        In order along the branch.
    reasons : (EndReason, EndReason)
        Why it was not followed beyond its first and its last point.
    specials : list of (int, Special)
        Bifurcations, each with the number of the point before it.
    ends : list of (int, End)
        Where gaits end or begin, likewise.
    conditions : dict of GaitEnd to ndarray, shape (number of points,)
        What is positive at a gait.
    criticality : dict of int to bool
        Of doublings, by their place in `specials`: whether they are supercritical.
    origin : (int, int) or None
        Branch and place in its `specials` at which this one begins.
    """

    curve: Curve
    points: list[CurvePoint]
    reasons: tuple[EndReason, EndReason]
    specials: list[tuple[int, Special]]
    ends: list[tuple[int, End]]
    conditions: dict[GaitEnd, Array]
    criticality: dict[int, bool]
    origin: tuple[int, int] | None = None

    @property
    def period_n(self) -> int:
        """Number of walking steps after which its cycles close."""
        return self.curve.chain.n_steps

    @property
    def x(self) -> Array:
        """Unknowns and parameter of all points, shape (m, N + 1)."""
        return np.array([point.x for point in self.points])

    @property
    def arclength(self) -> Array:
        """Length of the branch up to each point, in terms of the scales of the entries, shape (m,)."""
        lengths = [self.curve.norm(one) for one in np.diff(self.x, axis=0)]
        return np.concatenate([[0.0], np.cumsum(lengths)])

    def distance(self, before: int, x: Array) -> float:
        """How far beyond a point of the branch another one lies, in terms of the scales."""
        return self.curve.norm(x - self.points[before].x)

    @property
    def is_gait(self) -> NDArray[np.bool_]:
        """Which points are gaits that a walker could walk, shape (m,)."""
        gait: NDArray[np.bool_] = np.all([one > 0 for one in self.conditions.values()], axis=0)
        return gait


@dataclass(frozen=True)
class Survey:
    """How all branches over a parameter are found.

    Parameters
    ----------
    solver : Solver
    params : ndarray, shape (n_params,)
    parameter : str
    low, high : float
        Range of the parameter.
    period_n : int
        Number of walking steps after which the cycles close.
    cascade : int
        How many doublings in a row are followed onto the doubled branches.
    seeds : int
        Number of values of the parameter at which cycles are searched for.
    search : SearchOptions
    options : ContinuationOptions
    conditions : GaitConditions
    progress : callable
        Takes a line that says what is being done.
    """

    solver: Solver
    params: Array
    parameter: str
    low: float
    high: float
    period_n: int
    cascade: int
    seeds: int
    search: SearchOptions
    options: ContinuationOptions
    conditions: GaitConditions
    progress: Callable[[str], None]

    @property
    def window(self) -> Window:
        """Where branches are followed."""
        model = self.solver.model
        shortest, longest = self.search.resolved_for(model).period_range
        return Window((self.low,), (self.high,), shortest, longest, self.search.room_for(model))

    def branches(self) -> list[Branch]:
        """All branches, those of seeds first, then those that leave them, in the order of discovery."""
        found: list[Branch] = []
        curve = Curve.over(
            Chain(self.solver.kernels, self.period_n), self.params, self.parameter, self.high - self.low
        )
        for value in self.values():
            self.progress(f"searching at {self.parameter} = {value:.6g}")
            for u in self._cycles(value):
                x = np.append(u, value)
                if not any(on_branch(branch, x) for branch in found):
                    start = at_value(curve, x, value, np.eye(len(x))[-1], 10)
                    if start is not None:
                        found.append(self._both_ways(curve, start, number=len(found)))
        level = range(len(found))
        for turn in range(max(self.cascade, 1)):
            before = len(found)
            for number in level:
                found += self._leaving(found, number, doublings=self.cascade > turn)
            level = range(before, len(found))
        return found

    def values(self) -> Array:
        """Values of the parameter at which cycles are searched for: the middles of equal parts."""
        return self.low + (self.high - self.low) * (np.arange(self.seeds) + 0.5) / self.seeds

    def _cycles(self, value: float) -> Array:
        """Unknowns of all cycles at a value of the parameter."""
        point = self.params.copy()
        point[self.solver.model.spec.names.index(self.parameter)] = value
        if self.period_n == 1:
            return find_all(self.solver, point[None, :], self.search)[1].u
        return find_chains(self.solver, point, self.period_n, self.search)[0]

    def _both_ways(self, curve: Curve, start: CurvePoint, number: int) -> Branch:
        """The whole branch through a point."""
        self.progress(f"following branch {number} from {self.parameter} = {start.x[-1]:.6g}")
        points, reasons = both_ways(curve, start, self.window, self.options)
        return self._measured(curve, points, reasons, None)

    def _measured(
        self,
        curve: Curve,
        points: list[CurvePoint],
        reasons: tuple[EndReason, EndReason],
        origin: tuple[int, int] | None,
    ) -> Branch:
        """A branch with its special points.

        Where it was followed through a cycle that closes after half of its steps, it ends at that.
        """
        points = with_dips(curve, points, self.conditions, self.options)
        specials = list(special_points(curve, points, self.options))
        for end in (0, -1):
            if reasons[end] == EndReason.BRANCH_POINT and (end or origin is None):
                points, specials = ending_there(curve, points, specials, end)
        values = conditions_along(curve, points, self.conditions)
        ends = list(gait_ends(curve, points, values, self.conditions, self.options))
        return Branch(curve, points, reasons, specials, ends, values, {}, origin)

    def _leaving(self, found: list[Branch], number: int, doublings: bool) -> list[Branch]:
        """Branches that leave a branch at its doublings and branch points."""
        branch = found[number]
        new: list[Branch] = []
        for place, (_, special) in enumerate(branch.specials):
            for switched in self._switched(branch, special, place):
                if special.type == SpecialType.PD and not doublings:
                    continue
                if any(on_branch(other, switched.start.x) for other in [*found, *new]):
                    continue
                self.progress(
                    f"following the branch of {switched.curve.chain.n_steps} steps from "
                    f"{self.parameter} = {special.x[-1]:.6g}"
                )
                offset = switched.start.x[-1] - special.x[-1]
                ds = max(abs(offset) / self.options.ds_max, self.options.ds)
                points, reason = follow(switched.curve, switched.start, self.window, self.options, ds)
                new.append(
                    self._measured(switched.curve, points, (EndReason.BRANCH_POINT, reason), (number, place))
                )
        return new

    def _switched(self, branch: Branch, special: Special, place: int) -> Iterator[Switched]:
        """Beginnings of the branches that leave a special point; a doubling's criticality is noted."""
        if special.type == SpecialType.PD:
            switched = alone(doubled(branch.curve, special, self.options))
            if switched is not None:
                branch.criticality[place] = supercritical(special, switched)
                yield switched
        elif special.type == SpecialType.BP:
            for side in (1, -1):
                switched = alone(crossing(branch.curve, special, self.options, side))
                if switched is not None:
                    yield switched


def ending_there(
    curve: Curve, points: list[CurvePoint], specials: list[tuple[int, Special]], end: int
) -> tuple[list[CurvePoint], list[tuple[int, Special]]]:
    """Points and bifurcations of a branch, without what lies beyond the branch point at one of its ends.

    The branch point itself is a point of the branch, and is a doubling on the other one.

    Parameters
    ----------
    curve : Curve
    points : list of CurvePoint
    specials : list of (int, Special)
        Bifurcations, each with the number of the point before it.
    end : {0, -1}
        Whether the branch ends so at its first or at its last point.
    """
    interval, nearest = (0, points[1].x) if end == 0 else (len(points) - 2, points[-2].x)
    kept = points[1:] if end == 0 else points[:-1]
    there = [one.x for before, one in specials if before == interval and one.type == SpecialType.BP]
    if not there:
        return kept, [(before - (end == 0), one) for before, one in specials if before != interval]
    x = min(there, key=lambda x: curve.norm(x - nearest))
    # The branch turns back there, which is no fold of its own.
    reach = curve.norm(x - nearest) - SAME
    left = [
        (before, one) for before, one in specials if before != interval or curve.norm(one.x - nearest) < reach
    ]
    n_rk = curve.n_rk(x)
    matrix, _ = curve.linearised(x, n_rk)
    last = CurvePoint(x, kept[end].tangent, matrix, curve.multipliers(matrix), n_rk)
    return ([last, *kept] if end == 0 else [*kept, last]), left


def on_branch(branch: Branch, x: Array) -> bool:
    """Whether a point, with whichever of its steps first, is one of a branch.

    Parameters
    ----------
    branch : Branch
    x : ndarray, shape (N + 1,)
    """
    if branch.x.shape[1] != len(x):
        return False
    steps = x[:-1].reshape(branch.period_n, branch.curve.chain.width)
    turned = (np.append(np.roll(steps, k, axis=0).ravel(), x[-1]) for k in range(branch.period_n))
    return any(passes_through(branch.curve, branch.points, one) for one in turned)
