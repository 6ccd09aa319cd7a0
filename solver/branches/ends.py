"""Where gaits end along a curve of cycles: points at which one of the conditions of a gait is zero."""

from collections.abc import Hashable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Self

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.branches.arclength import CurvePoint
from stridemap.solver.branches.asking import Asking, Question, asked, together
from stridemap.solver.branches.conditions import GaitConditions, GaitEnd
from stridemap.solver.branches.curve import Corrected, Correction, Linearisation, ZeroCurve
from stridemap.solver.kernels.catalogue import CYCLE_N_RK
from stridemap.solver.options import ContinuationOptions

Array = NDArray[np.float64]


@dataclass(frozen=True)
class End:
    """A point of a curve at which a gait ends or begins.

    Parameters
    ----------
    type : GaitEnd
    point : CurvePoint
    residual : float
        Largest of the closing error and the modulus of the condition there.
    """

    type: GaitEnd
    point: CurvePoint
    residual: float


def conditions_along(
    curve: ZeroCurve,
    points: list[CurvePoint],
    conditions: GaitConditions,
    names: Sequence[GaitEnd] | None = None,
) -> dict[GaitEnd, Array]:
    """Conditions of a gait at points of a curve, shape (m,) each: those named, or all."""
    return _conditions_at([curve] * len(points), points, conditions, names)


def _conditions_at(
    curves: Sequence[ZeroCurve],
    points: Sequence[CurvePoint],
    conditions: GaitConditions,
    names: Sequence[GaitEnd] | None,
) -> dict[GaitEnd, Array]:
    """The same at a point of each of some curves, of cycles of as many steps."""
    u = np.array([one.x[: on.equations.n_unknowns] for on, one in zip(curves, points, strict=True)])
    params = [on.equations.point(on.values(one.x)) for on, one in zip(curves, points, strict=True)]
    n_rk = [min(2 * point.n_rk, 2 * CYCLE_N_RK[-1]) for point in points]
    return conditions.of_cycles(n_rk, u, np.array(params), curves[0].chain.n_steps, names)


def gait_ends(
    curve: ZeroCurve,
    points: list[CurvePoint],
    values: dict[GaitEnd, Array],
    conditions: GaitConditions,
    options: ContinuationOptions,
) -> Iterator[tuple[int, End]]:
    """Ends and beginnings of gaits between neighbouring points, each with the number of the point before it.

    A condition that changes its sign where another one is broken on both sides neither ends nor begins a
    gait.

    Parameters
    ----------
    curve : ZeroCurve
    points : list of CurvePoint
    values : dict of GaitEnd to ndarray
        As from `conditions_along`.
    conditions : GaitConditions
    options : ContinuationOptions
    """
    found = list(searches(curve, points, values, conditions, options))
    for (number, _), end in zip(found, together(search for _, search in found), strict=True):
        if end is not None:
            yield number, end


@dataclass(frozen=True)
class Trial(Question[float]):
    """Asks for the value of a condition at a point."""

    conditions: GaitConditions
    curve: ZeroCurve
    point: CurvePoint
    name: GaitEnd

    @property
    def kind(self) -> Hashable:
        """One condition of cycles of as many steps is computed for many of them at once."""
        return id(self.conditions), self.name, self.curve.chain.n_steps

    @classmethod
    def answers(cls, questions: Sequence[Self]) -> list[float]:
        """Values of the condition."""
        first, points = questions[0], [one.point for one in questions]
        values = _conditions_at([one.curve for one in questions], points, first.conditions, [first.name])
        out: list[float] = values[first.name].tolist()
        return out


Search = Asking[End | None]
"""A search for an end: it returns the end, or None where it found none."""


def searches(
    curve: ZeroCurve,
    points: list[CurvePoint],
    values: dict[GaitEnd, Array],
    conditions: GaitConditions,
    options: ContinuationOptions,
) -> Iterator[tuple[int, Search]]:
    """A search for each end of `gait_ends`, with the number of the point before it. Parameters as there."""
    holds = {name: one > 0 for name, one in values.items()}
    gait = np.all(list(holds.values()), axis=0)
    for number in np.flatnonzero(gait[:-1] != gait[1:]).tolist():
        begins = bool(gait[number])
        outside = number + begins
        known: dict[GaitEnd, tuple[float, float]] = {
            name: (float(values[name][number]), float(values[name][number + 1]))
            for name in holds
            if not holds[name][outside]
        }
        between = _Between(curve, points[number], points[number + 1], conditions, options)
        yield number, between.first_met(known, begins)


@dataclass(frozen=True)
class _Zero:
    """A point at which a condition is nearly zero: its value f, and the slope of that in the arclength."""

    point: CurvePoint
    f: float
    slope: float


@dataclass(frozen=True)
class _Between:
    """The part of a curve between two points, `one` and `other`, on which there is an end."""

    curve: ZeroCurve
    one: CurvePoint
    other: CurvePoint
    conditions: GaitConditions
    options: ContinuationOptions

    @cached_property
    def length(self) -> float:
        """Of the arclength step from one point to the other."""
        return self._along(self.other.x)

    def _along(self, x: Array) -> float:
        return self.curve.dot(x - self.one.x, self.one.tangent)

    def first_met(self, known: dict[GaitEnd, tuple[float, float]], begins: bool) -> Search:
        """Of several conditions that are broken at one point, the end that is met first from the other.

        Parameters
        ----------
        known : dict of GaitEnd to (float, float)
            Values of the conditions at `one` and at `other`.
        begins : bool
            Whether they hold at `one`, and not at `other`.
        """
        part, broken, first = self, known, None
        while broken:
            # Where the foot grazes the ground an early touchdown appears all at once: no secant locates that.
            for name in sorted(broken, key=lambda one: one == GaitEnd.EARLY_TOUCHDOWN):
                found = yield from part._located(name, broken[name])
                nearer = np.inf if first is None else self._away(first, begins)
                if found is not None and self._away(found, begins) < nearer + NOISE * self.length:
                    break
            else:
                return None  # one of them is met first, but where?
            if not self._away(found, begins) < nearer:
                break  # rounding does not tell which of the two is
            first = found
            part, broken = yield from self._until(first, known, begins)
        return first

    def _away(self, end: End, begins: bool) -> float:
        """Distance of an end from the point at which the conditions hold."""
        return self.curve.norm(end.point.x - (self.one if begins else self.other).x)

    def _until(
        self, end: End, known: dict[GaitEnd, tuple[float, float]], begins: bool
    ) -> Asking[tuple["_Between", dict[GaitEnd, tuple[float, float]]]]:
        """The part up to just before an end, and those other conditions that are broken there."""
        others = {name: values for name, values in known.items() if name != end.type}
        if not others:
            return self, {}
        back = (self.one if begins else self.other).x - end.point.x
        guess = end.point.x + min(JUST / max(self.curve.norm(back), JUST), 0.5) * back
        if not 0 < self._along(guess) < self.length:
            return self, {}  # it is at the point at which they hold
        found = yield from self._corrected(guess, self._along(guess) / self.length, end.point.n_rk)
        here, broken = found or end.point, {}
        for name, (one, other) in others.items():
            f = yield from self._tried(here, name)
            if not f > 0:
                broken[name] = (one, f) if begins else (f, other)
        # The search for an earlier one begins at the resolution of the points, as that for this one did.
        here = replace(here, n_rk=max(self.one.n_rk, self.other.n_rk))
        return replace(self, other=here) if begins else replace(self, one=here), broken

    def _located(self, name: GaitEnd, known: tuple[float, float]) -> Search:
        """Where a condition is zero.

        It is found at the resolution of the points first, and then at ever finer ones until it does not
        change any more.
        """
        found, n_rk = None, max(self.one.n_rk, self.other.n_rk)
        if n_rk < CYCLE_N_RK[-1]:
            found = yield from self._bracketed(name, known, n_rk, ROUGH)
        if found is not None:
            found = yield from self._refined(name, found)
        if found is None:
            found = yield from self._bracketed(name, known, CYCLE_N_RK[-1], SETTLED)
        if found is None or not abs(found.f) < LOCATED:
            return None
        here = found.point
        matrix, residual = yield from asked(Linearisation(self.curve, here.x, here.n_rk))
        closing = float(np.abs(residual).max())
        exact = Corrected(here.x, matrix, closing)
        point = CurvePoint.at(self.curve, exact, self.one.tangent, here.n_rk)
        return End(name, point, max(abs(found.f), closing))

    def _bracketed(
        self, name: GaitEnd, known: tuple[float, float], n_rk: int, settled: float
    ) -> Asking[_Zero | None]:
        """Regula falsi (Illinois) on the arclength step, until it changes by less than `settled`.

        Where rounding blurs the condition, it is the last good one of the trials that lie so near each other
        that rounding decides.
        """
        length = self.length
        low, high = 0.0, length
        x_low, x_high = self.one.x, self.other.x
        f_low, f_high = known
        last = low, f_low
        trials: list[tuple[float, _Zero]] = []
        kept = 0  # the side that the last turn kept: 1 for the upper end, -1 for the lower one
        creeping = 0  # turns that hardly changed the condition: where it jumps, secants creep from one end
        for _ in range(LOCATE_ITERATIONS):
            bounded = np.isfinite(f_low) and np.isfinite(f_high) and creeping < 2
            part = f_low / (f_low - f_high) if bounded else 0.5
            guess, ds = x_low + part * (x_high - x_low), low + part * (high - low)
            here = yield from self._corrected(guess, ds / length, n_rk)
            if here is None:
                return None
            f = yield from self._tried(here, name)
            before = last if np.isfinite(last[1]) and last[1] != f and last[0] != ds else (high, f_high)
            slope = (f - before[1]) / (ds - before[0]) if ds != before[0] else np.nan
            hardly = not bounded or abs(f) > 0.5 * abs(last[1])
            creeping = min(creeping + 1, 2) if bounded and hardly else int(hardly)
            trials.append((ds, _Zero(here, f, slope)))
            last = ds, f
            left = abs(f / slope) if np.isfinite(slope) and slope != 0.0 else np.inf
            if abs(f) < ROUNDING or (abs(f) < LOCATED and left < settled) or left < 0.01 * settled:
                break
            if high - low < settled * abs(high):
                break
            if (f > 0) == (f_low > 0):
                low, x_low, f_low = ds, here.x, f
                f_high *= 0.5 if kept == 1 else 1.0  # kept twice in a row, an end would stay for ever
                kept = 1
            else:
                high, x_high, f_high = ds, here.x, f
                f_low *= 0.5 if kept == -1 else 1.0
                kept = -1
            if left < settled and settled == ROUGH:
                break
        near = (zero for ds, zero in reversed(trials) if abs(ds - last[0]) <= NOISE * length)
        return next((zero for zero in near if abs(zero.f) < LOCATED), trials[-1][1])

    def _refined(self, name: GaitEnd, found: _Zero) -> Asking[_Zero | None]:
        """The same zero at ever finer resolutions, by secants; None where they do not lead there."""
        across, length = self.one.tangent, self.length
        x, slope, n_rk = found.point.x, found.slope, found.point.n_rk
        x = x - found.f / slope * across if np.isfinite(slope) and slope else x
        while n_rk < CYCLE_N_RK[-1]:
            n_rk, before, last = min(2 * n_rk, CYCLE_N_RK[-1]), x, None
            for _ in range(SECANTS):
                if not np.isfinite(slope) or slope == 0.0:
                    return None
                ds = self._along(x)
                if not -0.01 * length < ds < 1.01 * length:
                    return None
                here = yield from self._corrected(x, ds / length, n_rk)
                if here is None:
                    return None
                f = yield from self._tried(here, name)
                noise = last is not None and abs(f) > 0.2 * abs(last[1])
                if last is not None and abs(ds - last[0]) > NOISE * length and f != last[1]:
                    slope = (f - last[1]) / (ds - last[0])
                x, last, found = here.x, (ds, f), _Zero(here, f, slope)
                left = abs(f / slope)
                if abs(f) < ROUNDING or (abs(f) < LOCATED and left < SETTLED_FINE):
                    break
                if noise and abs(f) < LOCATED and left < UNCHANGED:
                    break
                x = here.x - f / slope * across
            else:
                return None
            if self.curve.norm(x - before) < UNCHANGED:
                break
        return found

    def _tried(self, point: CurvePoint, name: GaitEnd) -> Asking[float]:
        """The value of a condition at a point."""
        return asked(Trial(self.conditions, self.curve, point, name))

    def _corrected(self, guess: Array, part: float, n_rk: int) -> Asking[CurvePoint | None]:
        """The point in the plane through a guess, a part of the way from one point to the other."""
        across, iterations = self.one.tangent, self.options.max_corrections + 3
        near = self.one.matrix + part * (self.other.matrix - self.one.matrix)
        found = yield from asked(Correction(self.curve, guess, across, n_rk, iterations, near))
        if not found.converged:
            found = yield from asked(Correction(self.curve, guess, across, n_rk, iterations))
        if not found.converged:
            return None
        return CurvePoint(found.x, across, found.matrix, self.one.multipliers, n_rk)


LOCATE_ITERATIONS = 80
"""Halvings and secants until the end of a gait is found."""

LOCATED, ROUNDING = 1e-11, 1e-14
"""Modulus of a condition that counts as zero, and below which it cannot be brought."""

SETTLED, SETTLED_FINE, ROUGH = 1e-14, 1e-13, 1e-7
"""Arclength by which an end need not be moved any more: by bisection, by secants at a finer resolution, and
before there are finer ones."""

UNCHANGED = 3e-11
"""Change of an end at twice the resolution that needs no finer one, in terms of the scale: the next would be
a hundredth of it, or less. Where rounding keeps the condition from becoming smaller, so near will do."""

JUST = 1e-9
"""How far before an end others are looked at, in terms of the scale: farther than rounding moves it."""

SECANTS = 8
"""Secants at one resolution."""

NOISE = 1e-6
"""Part of the distance of two points that a secant must span, so that rounding does not decide its slope, nor
which of two trials is nearer to the end."""
