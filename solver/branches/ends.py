"""Where gaits end along a curve of cycles: points at which one of the conditions of a gait is zero."""

from collections.abc import Generator, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.branches.arclength import CurvePoint
from stridemap.solver.branches.conditions import GaitConditions, GaitEnd
from stridemap.solver.branches.curve import Corrected, ZeroCurve
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
    x = np.array([point.x for point in points])
    params = np.array([curve.equations.point(curve.values(one)) for one in x])
    n_rk = [min(2 * point.n_rk, 2 * CYCLE_N_RK[-1]) for point in points]
    u = x[:, : curve.equations.n_unknowns]
    return conditions.of_cycles(n_rk, u, params, curve.chain.n_steps, names)


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
    found = list(searches(curve, points, values, options))
    for (number, _), end in zip(found, together([search for _, search in found], conditions), strict=True):
        if end is not None:
            yield number, end


@dataclass(frozen=True)
class Trial:
    """A point at which the value of a condition is asked for."""

    curve: ZeroCurve
    point: CurvePoint
    name: GaitEnd


Search = Generator[Trial, float, End | None]
"""A search for an end: it asks for values of conditions, and returns the end, or None where it found none."""


def searches(
    curve: ZeroCurve, points: list[CurvePoint], values: dict[GaitEnd, Array], options: ContinuationOptions
) -> Iterator[tuple[int, Search]]:
    """A search for each end of `gait_ends`, with the number of the point before it. Parameters as there."""
    holds = {name: one > 0 for name, one in values.items()}
    gait = np.all(list(holds.values()), axis=0)
    for number in np.flatnonzero(gait[:-1] != gait[1:]).tolist():
        inside = number if gait[number] else number + 1
        outside = 2 * number + 1 - inside
        pair = points[number], points[number + 1]
        known = {
            name: tuple(values[name][number : number + 2].tolist())
            for name in holds
            if not holds[name][outside]
        }
        yield number, _first_met(curve, known, pair, points[inside].x, options)


def together(searches_: Sequence[Search], conditions: GaitConditions) -> list[End | None]:
    """What searches return, which all go on at a time: so conditions are computed for many points at once."""
    out: list[End | None] = [None] * len(searches_)
    asked: dict[int, Trial] = {}

    def go_on(i: int, answer: float | None) -> None:
        try:
            asked[i] = next(searches_[i]) if answer is None else searches_[i].send(answer)
        except StopIteration as stop:
            asked.pop(i, None)
            out[i] = stop.value

    for i in range(len(searches_)):
        go_on(i, None)
    while asked:
        numbers = list(asked)
        for i, value in zip(numbers, _values([asked[i] for i in numbers], conditions), strict=True):
            go_on(i, value)
    return out


def _values(trials: list[Trial], conditions: GaitConditions) -> list[float]:
    """Values of the conditions that are asked for."""
    out = np.empty(len(trials))
    keys = [(trial.name, trial.curve.chain.n_steps) for trial in trials]
    for name, n_steps in dict.fromkeys(keys):
        at = [i for i, key in enumerate(keys) if key == (name, n_steps)]
        some = [trials[i] for i in at]
        x = [trial.point.x[: trial.curve.equations.n_unknowns] for trial in some]
        params = [trial.curve.equations.point(trial.curve.values(trial.point.x)) for trial in some]
        n_rk = [min(2 * trial.point.n_rk, 2 * CYCLE_N_RK[-1]) for trial in some]
        out[at] = conditions.of_cycles(n_rk, np.array(x), np.array(params), n_steps, [name])[name]
    values: list[float] = out.tolist()
    return values


def _first_met(
    curve: ZeroCurve,
    known: dict[GaitEnd, tuple[float, ...]],
    pair: tuple[CurvePoint, CurvePoint],
    inside: Array,
    options: ContinuationOptions,
) -> Search:
    """Of several conditions that are broken on one side, the end at which one is met first from the other."""
    found = []
    for name, values in known.items():
        end = yield from _located(curve, name, pair, values, options)
        if end is not None:
            found.append(end)
    return min(found, key=lambda end: curve.norm(end.point.x - inside), default=None)


def _located(
    curve: ZeroCurve,
    name: GaitEnd,
    pair: tuple[CurvePoint, CurvePoint],
    known: tuple[float, ...],
    options: ContinuationOptions,
) -> Search:
    """Where a condition is zero between two points, at which it is `known`.

    It is found at the resolution of the points first, and then at ever finer ones until it does not change
    any more.
    """
    n_rk = max(point.n_rk for point in pair)
    found = yield from _bracketed(curve, name, pair, known, options, n_rk, ROUGH)
    if found is not None:
        found = yield from _refined(curve, name, pair, found, options)
    if found is None:
        finest = CYCLE_N_RK[-1]
        found = yield from _bracketed(curve, name, pair, known, options, finest, SETTLED)
    if found is None or not abs(found.f) < LOCATED:
        return None
    here = found.point
    matrix, residual = curve.linearised(here.x, here.n_rk)
    closing = float(np.abs(residual).max())
    exact = Corrected(here.x, matrix, closing, ())
    point = CurvePoint.at(curve, exact, pair[0].tangent, here.n_rk)
    return End(name, point, max(abs(found.f), closing))


@dataclass(frozen=True)
class _Zero:
    """A point at which a condition is nearly zero: its value f, and the slope of that in the arclength."""

    point: CurvePoint
    f: float
    slope: float


def _bracketed(
    curve: ZeroCurve,
    name: GaitEnd,
    pair: tuple[CurvePoint, CurvePoint],
    known: tuple[float, ...],
    options: ContinuationOptions,
    n_rk: int,
    settled: float,
) -> Generator[Trial, float, _Zero | None]:
    """Regula falsi (Illinois) on the arclength step, until it changes by less than `settled`."""
    one, other = pair
    length = curve.dot(other.x - one.x, one.tangent)
    low, high = 0.0, length
    x_low, x_high = one.x, other.x
    f_low, f_high = known
    last = low, f_low
    found: _Zero | None = None
    kept = 0  # the side that the last turn kept: 1 for the upper end, -1 for the lower one
    creeping = 0  # turns that hardly changed the condition: where it jumps, secants creep along from one end
    for _ in range(LOCATE_ITERATIONS):
        bounded = np.isfinite(f_low) and np.isfinite(f_high) and creeping < 2
        part = f_low / (f_low - f_high) if bounded else 0.5
        guess, ds = x_low + part * (x_high - x_low), low + part * (high - low)
        here = _corrected(curve, pair, guess, ds / length, n_rk, options)
        if here is None:
            return None
        f = yield Trial(curve, here, name)
        before = last if np.isfinite(last[1]) and last[1] != f and last[0] != ds else (high, f_high)
        slope = (f - before[1]) / (ds - before[0]) if ds != before[0] else np.nan
        hardly = not bounded or abs(f) > 0.5 * abs(last[1])
        creeping = min(creeping + 1, 2) if bounded and hardly else int(hardly)
        found, last = _Zero(here, f, slope), (ds, f)
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
    return found


def _refined(
    curve: ZeroCurve,
    name: GaitEnd,
    pair: tuple[CurvePoint, CurvePoint],
    found: _Zero,
    options: ContinuationOptions,
) -> Generator[Trial, float, _Zero | None]:
    """The same zero at ever finer resolutions, by secants; None where they do not lead there."""
    one, other = pair
    length = curve.dot(other.x - one.x, one.tangent)
    x, slope, n_rk = found.point.x, found.slope, found.point.n_rk
    x = x - found.f / slope * one.tangent if np.isfinite(slope) and slope else x
    while n_rk < CYCLE_N_RK[-1]:
        n_rk, before, last = min(2 * n_rk, CYCLE_N_RK[-1]), x, None
        for _ in range(SECANTS):
            if not np.isfinite(slope) or slope == 0.0:
                return None
            ds = curve.dot(x - one.x, one.tangent)
            if not -0.01 * length < ds < 1.01 * length:
                return None
            here = _corrected(curve, pair, x, ds / length, n_rk, options)
            if here is None:
                return None
            f = yield Trial(curve, here, name)
            noise = last is not None and abs(f) > 0.2 * abs(last[1])
            if last is not None and abs(ds - last[0]) > NOISE * length and f != last[1]:
                slope = (f - last[1]) / (ds - last[0])
            x, last, found = here.x, (ds, f), _Zero(here, f, slope)
            left = abs(f / slope)
            if abs(f) < ROUNDING or (abs(f) < LOCATED and left < SETTLED_FINE):
                break
            if noise and abs(f) < LOCATED and left < UNCHANGED:
                break
            x = here.x - f / slope * one.tangent
        else:
            return None
        if curve.norm(x - before) < UNCHANGED:
            break
    return found


def _corrected(
    curve: ZeroCurve,
    pair: tuple[CurvePoint, CurvePoint],
    guess: Array,
    part: float,
    n_rk: int,
    options: ContinuationOptions,
) -> CurvePoint | None:
    """The point in the plane through a guess, a part of the way from one point to another."""
    one, other = pair
    near = one.matrix + part * (other.matrix - one.matrix)
    found = curve.corrected(guess, one.tangent, n_rk, options.max_corrections + 3, near)
    if not found.converged:
        found = curve.corrected(guess, one.tangent, n_rk, options.max_corrections + 3)
    if not found.converged:
        return None
    return CurvePoint(found.x, one.tangent, found.matrix, one.multipliers, n_rk)


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

SECANTS = 8
"""Secants at one resolution."""

NOISE = 1e-6
"""Part of the distance of two points that a secant must span, so that rounding does not decide its slope."""
