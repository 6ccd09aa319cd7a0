"""Parameters for which a quantity of a limit cycle takes a wanted value.

From limit cycles at a grid of the parameter branches are traced, through folds. Along a branch the quantity
is a continuous function: a change of sign of its difference from the wanted value brackets a solution. Where
it turns towards the value and back between two cycles, the turning point is looked at as well.

Between two neighbouring cycles A and B the branch is parametrised by the chord: at the fraction s, the
section point, period and parameter x = (u, p) solve

    R(u, p) = 0,    <x - x_A, x_B - x_A> = s |x_B - x_A|^2,

which is regular at folds too. A bracketed root in s, with the quantity measured on the converged cycle at
each, ends where rounding does.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.branches.arclength import Window, at_value, both_ways
from stridemap.solver.branches.curve import Curve
from stridemap.solver.branches.lines import values_of
from stridemap.solver.cycles.chain import Chain
from stridemap.solver.cycles.orbits import Orbits
from stridemap.solver.cycles.search import find_all, merged
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.options import ContinuationOptions, SearchOptions

Array = NDArray[np.float64]

SAME = 1e-5
"""Largest difference, in terms of the scale, of two solutions that are one cycle."""
ACCEPTED = 1e-11
"""Largest difference from the wanted value, in terms of the values around it: what is larger is a jump."""
CORRECTIONS = 20
"""Newton's corrections at one point; a few suffice, and more than this means that there is no such point."""
NEAR = 0.5
"""A turning point is looked at where the parabola through three cycles leads so much nearer to the value."""


class _LostError(Exception):
    """There is no limit cycle at a point between two cycles of a branch."""


@dataclass(frozen=True)
class Target:
    """What is looked for.

    Parameters
    ----------
    quantity : str
        A measured quantity, ``period``, or an entry of the section.
    value : float
    parameter : str
        The parameter that varies.
    low, high : float
        Ends of its range.
    """

    quantity: str
    value: float
    parameter: str
    low: float
    high: float

    def of(self, orbits: Orbits) -> Array:
        """The quantity of each cycle, shape (n,)."""
        section = orbits.model.section
        if self.quantity == "period":
            return orbits.period
        if self.quantity in section:
            return orbits.u[:, section.index(self.quantity)]
        return np.asarray(orbits.measures[self.quantity], dtype=np.float64)


@dataclass(frozen=True)
class Line:
    """A line of parameter space along which one parameter varies.

    Parameters
    ----------
    solver : Solver
    curve : Curve
    window : Window
    """

    solver: Solver
    curve: Curve
    window: Window

    def params(self, values: Array) -> Array:
        """Parameter points at values of the parameter, shape (n, n_params)."""
        return np.array([self.curve.equations.point(value) for value in values]).reshape(len(values), -1)

    def traced(self, u: Array, value: float) -> Array:
        """The branch through a limit cycle, from one end to the other, shape (n, nz + 2)."""
        x = np.append(u, value)
        start = at_value(self.curve, x, value, np.eye(len(x))[-1], CORRECTIONS)
        if start is None:
            return x[None, :]
        points, _ = both_ways(self.curve, start, self.window, ContinuationOptions())
        return np.array([point.x for point in points])


def hits(
    solver: Solver, point: Array, target: Target, values: Array, options: SearchOptions
) -> tuple[Orbits, Orbits]:
    """Limit cycles whose quantity has the wanted value, and all cycles that were seen on the way.

    Parameters
    ----------
    solver : Solver
    point : ndarray, shape (n_params,)
        The other parameters.
    target : Target
    values : ndarray, shape (m,)
        Values of the parameter at which all cycles are searched, ascending.
    options : SearchOptions
    """
    period_range = options.resolved_for(solver.model).period_range
    curve = Curve.over(Chain(solver.kernels), point, target.parameter, target.high - target.low)
    room = options.room_for(solver.model)
    line = Line(solver, curve, Window((target.low,), (target.high,), *period_range, room))
    _, seeds = find_all(solver, line.params(values), options)
    left, parts, branches = seeds, [seeds], []
    while len(left):
        x = line.traced(left.u[0], values_of(left, target.parameter)[0])
        branch = solver.converge(x[:, :-1], line.params(x[:, -1]), period_range)
        branches.append(branch)
        parts.append(branch.take(branch.found))
        left = left.take(_elsewhere(line, x, left))
    found = [one for branch in branches for one in _on_branch(line, branch, target)]
    solutions = Orbits.concatenate(solver.model, found)
    # Two brackets that meet at a cycle may both lead to it.
    _, solutions = merged(np.zeros(len(solutions), dtype=np.int64), solutions)
    order = np.lexsort((solutions.period, values_of(solutions, target.parameter)))
    return solutions.take(order), Orbits.concatenate(solver.model, parts)


def _elsewhere(line: Line, x: Array, cycles: Orbits) -> NDArray[np.bool_]:
    """Which cycles are not on a branch that was traced; the first is what it was traced from."""
    values = values_of(cycles, line.curve.parameter)
    ends = np.sort(np.stack([x[:-1, -1], x[1:, -1]]), axis=0)
    cycle, piece = np.nonzero((values[:, None] >= ends[0]) & (values[:, None] <= ends[1]))
    elsewhere = np.ones(len(cycles), dtype=bool)
    elsewhere[0] = False
    if len(cycle):
        span = x[piece + 1, -1] - x[piece, -1]
        part = np.where(span == 0, 0.0, (values[cycle] - x[piece, -1]) / np.where(span == 0, 1.0, span))
        guesses = x[piece, :-1] + part[:, None] * (x[piece + 1, :-1] - x[piece, :-1])
        u, closed = line.solver.search(guesses, cycles.params[cycle])
        with np.errstate(invalid="ignore"):
            same = closed & (np.abs((u - cycles.u[cycle]) / line.curve.scale[:-1]).max(axis=1) < SAME)
        elsewhere[cycle[same]] = False
    return elsewhere


def _on_branch(line: Line, orbits: Orbits, target: Target) -> Iterator[Orbits]:
    """The solutions on one branch, each as an array of one cycle."""
    away = np.where(orbits.found, target.of(orbits) - target.value, np.nan)
    for i in np.flatnonzero(away == 0).tolist():
        yield orbits.take([i])
    with np.errstate(invalid="ignore"):
        changes = away[:-1] * away[1:] < 0
    for i in np.flatnonzero(changes).tolist():
        yield from _Chord(line, orbits.take([i, i + 1]), target).root(0.0, 1.0)
    for i in range(1, len(orbits) - 1):
        if _may_reach(away[i - 1 : i + 2]):
            for one in (i - 1, i):
                yield from _Chord(line, orbits.take([one, one + 1]), target).roots_around_a_turn()


def _may_reach(away: Array) -> bool:
    """Whether the difference of three cycles turns between them, perhaps after it was zero."""
    if not np.isfinite(away).all() or len(set(np.sign(away).tolist())) > 1:
        return False
    left, middle, right = np.abs(away).tolist()
    if not (middle <= left and middle <= right and middle < max(left, right)):
        return False
    curvature, slope = left - 2 * middle + right, (right - left) / 2
    return bool(middle - slope**2 / (2 * curvature) <= NEAR * middle)


class _Chord:
    """The branch between two neighbouring cycles, as a function of the fraction of the chord."""

    def __init__(self, line: Line, ends: Orbits, target: Target) -> None:
        self.line, self.ends, self.target = line, ends, target
        self.x = np.column_stack([ends.u, values_of(ends, target.parameter)])
        self.n_rk = max(line.curve.n_rk(x) for x in self.x)
        self._known: dict[float, tuple[float, Orbits]] = {}

    def root(self, left: float, right: float) -> Iterator[Orbits]:
        """The solution between two fractions with differences of opposite signs; nothing at a jump."""
        from scipy.optimize import brentq  # takes half a second to load

        try:
            s = brentq(self.away, left, right, xtol=1e-16, rtol=4 * np.finfo(float).eps)
            self.away(s)
        except _LostError:
            return
        amount, orbit = min(self._known.values(), key=lambda one: abs(one[0]))
        around = max(abs(self.target.value), *np.abs(self.target.of(self.ends)).tolist())
        if abs(amount) <= ACCEPTED * around:
            yield orbit

    def roots_around_a_turn(self) -> Iterator[Orbits]:
        """The solutions where the difference turns within the chord and was zero before and after."""
        from scipy.optimize import minimize_scalar

        sign = math.copysign(1.0, self.away(0.0))
        try:
            turn = minimize_scalar(
                lambda s: sign * self.away(s), bounds=(0, 1), method="bounded", options={"xatol": 1e-9}
            ).x
            if sign * self.away(turn) >= 0:
                return
        except _LostError:
            return
        for left, right in ((0.0, turn), (turn, 1.0)):
            again = _Chord(self.line, self.ends, self.target)
            if again.away(left) * again.away(right) < 0:
                yield from again.root(left, right)

    def away(self, s: float) -> float:
        """The quantity less the wanted value at a fraction of the chord."""
        if s not in self._known:
            orbit = self.ends.take([int(s)]) if s in (0.0, 1.0) else self._cycle(s)
            amount = float(self.target.of(orbit)[0]) - self.target.value
            if not math.isfinite(amount):
                raise _LostError
            self._known[s] = amount, orbit
        return self._known[s][0]

    def _cycle(self, s: float) -> Orbits:
        """The limit cycle at a fraction of the chord, converged and measured."""
        chord = self.x[1] - self.x[0]
        found = self.line.curve.corrected(self.x[0] + s * chord, chord, self.n_rk, CORRECTIONS)
        if not found.converged:
            raise _LostError
        window, x = self.line.window, found.x
        period_range = window.shortest, window.longest
        orbit = self.line.solver.converge(x[None, :-1], self.line.params(x[-1:]), period_range)
        if not orbit.found[0]:
            raise _LostError
        return orbit
