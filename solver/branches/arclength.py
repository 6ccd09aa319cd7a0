"""Pseudo-arclength continuation of one curve of cycles, corrected by Newton's method at every point.

(H. B. Keller 1977.) From a point x1 with the unit tangent tau, the next one solves ``F(x) = 0`` together with

    <x - x1, tau> = ds,

so that a fold, where the curve turns back in the parameter, is passed like any other point. The arclength
step `ds` follows the number of Newton's corrections and the angle by which the tangent turns: large angles
hide branch points, and lead onto other branches. Unlike `continuation`, which follows many branches to one
value each, this follows a curve through its whole range, and keeps every point.
"""

from dataclasses import dataclass
from enum import StrEnum

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.branches.curve import Corrected, ZeroCurve
from stridemap.solver.options import ContinuationOptions

Array = NDArray[np.float64]


class EndReason(StrEnum):
    """Why a curve was not followed any further."""

    RANGE = "range"
    """It leaves the range of a parameter."""
    PERIOD = "period_limit"
    """A walking step becomes shorter or longer than the range of periods allows."""
    CLOSED = "closed"
    """It has come back to where it began."""
    STANDING = "standing"
    """The steps shrink to nothing: the walker stands."""
    STALLED = "stalled"
    """No shorter arclength step leads on."""
    DOUBLE = "double_multiplier"
    """The pair of multipliers of a torus becomes one double real multiplier."""
    REGION = "region"
    """A section coordinate is far outside the search box: see `SearchOptions.room_for`."""
    BRANCH_POINT = "branch_point"
    """It begins or ends at another branch: beyond a cycle that closes after half of its steps already, the
    same cycles come again, with their halves exchanged."""
    STEPS = "max_steps"
    """The largest number of arclength steps was taken."""


SAID = {
    EndReason.PERIOD: "where a step becomes too short or too long",
    EndReason.STANDING: "where the walker stands",
    EndReason.STALLED: "where no shorter arclength step leads on",
    EndReason.DOUBLE: "where the pair of multipliers meets",
    EndReason.REGION: "far outside the search box",
    EndReason.BRANCH_POINT: "on another branch",
    EndReason.STEPS: "after the largest number of arclength steps",
}
"""Where a curve ends, in words; nothing is said of one that closes or leaves the range."""


def ends_in_words(reasons: tuple[EndReason, EndReason]) -> str:
    """Where a curve ends within the range, as the end of a sentence; empty where it does not."""
    said = dict.fromkeys(SAID[one] for one in reasons if one in SAID)
    return f"; it ends {' and '.join(said)}" if said else ""


@dataclass(frozen=True)
class CurvePoint:
    """A point of a curve.

    Parameters
    ----------
    x : ndarray, shape (M + 1,)
    tangent : ndarray, shape (M + 1,)
        Unit tangent, in the direction in which the curve is followed.
    matrix : ndarray, shape (M, M + 1)
        Derivative of the equations.
    multipliers : ndarray of complex, shape (nz,)
    n_rk : int
        RK steps per walking step with which it was computed.
    """

    x: Array
    tangent: Array
    matrix: Array
    multipliers: NDArray[np.complex128]
    n_rk: int

    @classmethod
    def at(cls, curve: ZeroCurve, corrected: Corrected, ahead: Array, n_rk: int) -> "CurvePoint":
        """A point that Newton's method found, with the tangent on the side of `ahead`."""
        tangent, multipliers = curve.tangent(corrected.matrix, ahead), curve.multipliers(corrected.matrix)
        return cls(corrected.x, tangent, corrected.matrix, multipliers, n_rk)

    def reversed(self) -> "CurvePoint":
        """The same point, to be followed the other way."""
        return CurvePoint(self.x, -self.tangent, self.matrix, self.multipliers, self.n_rk)


@dataclass(frozen=True)
class Window:
    """Where a curve is followed.

    Parameters
    ----------
    low, high : tuple of float, length f
        Ends of the ranges of the parameters that vary.
    shortest, longest : float
        Range of the periods of each walking step.
    room : ndarray, shape (nz, 2), optional
        Least and greatest value of each section coordinate; without it they may be anything.
    """

    low: tuple[float, ...]
    high: tuple[float, ...]
    shortest: float
    longest: float
    room: Array | None = None

    def left(self, here: Array, there: Array) -> tuple[int, float] | None:
        """Which parameter leaves its range first between two points, and the end at which it does.

        Parameters
        ----------
        here, there : ndarray, shape (f,)
            Values of the parameters.

        Returns
        -------
        (int, float) or None
            Number of the parameter and end of its range; None where `there` is within.
        """
        first, nearest = None, np.inf
        for i, (low, high) in enumerate(zip(self.low, self.high, strict=True)):
            if low <= there[i] <= high:
                continue
            end = high if there[i] > high else low
            part = (end - here[i]) / (there[i] - here[i])
            if part < nearest:
                first, nearest = (i, end), part
        return first


def advanced(curve: ZeroCurve, start: CurvePoint, ds: float, iterations: int) -> CurvePoint | None:
    """The point at an arclength step from another one; None where Newton's method does not find it.

    Parameters
    ----------
    curve : ZeroCurve
    start : CurvePoint
    ds : float
    iterations : int
        Largest number of corrections.
    """
    guess = start.x + ds * start.tangent
    n_rk = curve.n_rk(guess)
    found = curve.corrected(guess, start.tangent, n_rk, iterations)
    return CurvePoint.at(curve, found, start.tangent, n_rk) if found.converged else None


def at_value(
    curve: ZeroCurve, guess: Array, value: float, ahead: Array, iterations: int, which: int = -1
) -> CurvePoint | None:
    """The point with a value of a parameter, from a guess; None where Newton's method does not find it."""
    guess, across = guess.copy(), np.zeros(len(guess))
    guess[which], across[which] = value, curve.scale[which]
    n_rk = curve.n_rk(guess)
    found = curve.corrected(guess, across, n_rk, iterations)
    return CurvePoint.at(curve, found, ahead, n_rk) if found.converged else None


def follow(
    curve: ZeroCurve, start: CurvePoint, window: Window, options: ContinuationOptions, ds: float | None = None
) -> tuple[list[CurvePoint], EndReason]:
    """Follow a curve from a point, in the direction of its tangent.

    Parameters
    ----------
    curve : ZeroCurve
    start : CurvePoint
    window : Window
    options : ContinuationOptions
    ds : float, optional
        The first arclength step.

    Returns
    -------
    points : list of CurvePoint
        The start first; where the curve leaves the parameter's range, the last one is at its end.
    reason : EndReason
    """
    points, ds = [start], options.ds if ds is None else ds
    for _ in range(options.max_steps):
        here = points[-1]
        there = advanced(curve, here, ds, options.max_corrections)
        turn = -1.0 if there is None else curve.dot(there.tangent, here.tangent)
        astray = there is None or _strays(curve, here, there, ds) or _jumps(curve, here, there)
        if there is None or astray or turn < options.min_tangent_cosine:
            ds *= options.step_shrink
            if ds < options.ds_min:
                return points, EndReason.STALLED
            continue
        if left := window.left(curve.values(here.x), curve.values(there.x)):
            last = _last_point(curve, here, there, left, options)
            if last is None and ds * options.step_shrink >= options.ds_min:
                ds *= options.step_shrink  # from nearer by, it is found
                continue
            return points + (last or []), EndReason.RANGE
        points.append(there)
        if reason := _ended(curve, points, window):
            return points, reason
        if turn > options.easy_tangent_cosine:
            ds = min(ds * options.step_growth, options.ds_max)
    return points, EndReason.STEPS


def both_ways(
    curve: ZeroCurve, start: CurvePoint, window: Window, options: ContinuationOptions
) -> tuple[list[CurvePoint], tuple[EndReason, EndReason]]:
    """Follow a curve from a point in both directions: see `follow`.

    Returns
    -------
    points : list of CurvePoint
        From one end to the other, in the direction of the start's tangent.
    reasons : (EndReason, EndReason)
        Why it ends at the first and at the last point.
    """
    ahead, last = follow(curve, start, window, options)
    if last == EndReason.CLOSED:
        return ahead, (last, last)
    behind, first = follow(curve, start.reversed(), window, options)
    return [point.reversed() for point in behind[:0:-1]] + ahead, (first, last)


def _strays(curve: ZeroCurve, here: CurvePoint, there: CurvePoint, ds: float) -> bool:
    """Whether the corrections led far from where the tangent pointed, perhaps onto another curve."""
    return curve.norm(there.x - here.x - ds * here.tangent) > MAX_CORRECTION * ds


def _jumps(curve: ZeroCurve, here: CurvePoint, there: CurvePoint) -> bool:
    """Whether two points are beside each other rather than one after the other.

    The way along an arc points, up to third order, where the mean of the tangents at both ends does. A step
    onto a curve that runs beside this one, where the tangents hardly differ, goes aside by the distance of
    the two.
    """
    way, mean = there.x - here.x, here.tangent + there.tangent
    if not way.any():
        return False
    return curve.norm(way / curve.norm(way) - mean / curve.norm(mean)) > MAX_SIDESTEP


def _last_point(
    curve: ZeroCurve,
    here: CurvePoint,
    there: CurvePoint,
    left: tuple[int, float],
    options: ContinuationOptions,
) -> list[CurvePoint] | None:
    """The point at the end of a parameter's range that lies between two; none where it is the first.

    None where Newton's method does not find it.
    """
    number, end = left
    which = number - len(curve.values(here.x))
    if here.x[which] == end:
        return []
    part = (end - here.x[which]) / (there.x[which] - here.x[which])
    guess = here.x + part * (there.x - here.x)
    last = at_value(curve, guess, end, here.tangent, options.max_corrections + 4, which)
    return [last] if last is not None else None


def _ended(curve: ZeroCurve, points: list[CurvePoint], window: Window) -> EndReason | None:
    """Whether a curve ends at its newest point, and why."""
    x = points[-1].x
    steps, model = curve.equations.steps(x), curve.equations.model
    if not ((steps[:, -1] > window.shortest) & (steps[:, -1] <= window.longest)).all():
        return EndReason.PERIOD
    if np.abs(steps[:, :-1] / model.spec.scales).max() < STANDING:
        return EndReason.STANDING
    if window.room is not None and not _between(window.room, steps[:, :-1]):
        return EndReason.REGION
    if curve.beyond(x):
        return EndReason.DOUBLE
    if len(curve.values(x)) == 1 and _halves_exchange(steps, curve.equations.steps(points[-2].x), curve):
        return EndReason.BRANCH_POINT
    if len(points) > 3:
        first, across = points[0], points[0].tangent
        ahead = curve.dot(x - first.x, across)
        before = curve.dot(points[-2].x - first.x, across)
        near = curve.norm(x - first.x) < 2 * curve.norm(x - points[-2].x)
        if before < 0 <= ahead and near:
            return EndReason.CLOSED
    return None


def _halves_exchange(steps: Array, before: Array, curve: ZeroCurve) -> bool:
    """Whether the difference of a cycle's halves has passed through zero since the point before."""
    n = len(steps)
    if n % 2:
        return False
    scale = curve.scale[: steps.size].reshape(steps.shape)
    one, other = ((each[: n // 2] - each[n // 2 :]) / scale[: n // 2] for each in (steps, before))
    return bool((one * other).sum() < 0)


def passes_through(curve: ZeroCurve, points: list[CurvePoint], x: Array) -> bool:
    """Whether a curve that was followed passes through a point: where it passes nearest it is solved for.

    A fold may lie between two of its points, so that it passes values of a parameter that none of them has.
    And another curve may run beside it, so near that from a point far away Newton's method finds that one: in
    the end it is decided by following the curve in short steps, which do not go aside unnoticed.

    Parameters
    ----------
    curve : ZeroCurve
    points : list of CurvePoint
        In order along it.
    x : ndarray, shape (M + 1,)
    """
    known = np.array([point.x for point in points])
    lengths = np.linalg.norm(np.diff(known, axis=0) / curve.scale, axis=1)
    reach = np.maximum(np.append(lengths, 0.0), np.append(0.0, lengths))
    away = np.linalg.norm((known - x) / curve.scale, axis=1)
    near = np.flatnonzero(away < 2 * np.maximum(reach, SAME))
    for point in (points[i] for i in near[np.argsort(away[near], kind="stable")]):
        ahead = curve.dot(x - point.x, point.tangent)
        found = curve.corrected(point.x + ahead * point.tangent, point.tangent, point.n_rk, 10)
        far = found.converged and curve.norm(found.x - x) > BESIDE
        if not far and _leads_to(curve, point if ahead >= 0 else point.reversed(), x):
            return True
    return False


def _leads_to(curve: ZeroCurve, point: CurvePoint, x: Array) -> bool:
    """Whether a curve leads from one of its points to another one, in short steps."""
    ds = SHORT
    for _ in range(int(2 * curve.norm(x - point.x) / SHORT) + SHORT_STEPS):
        left = curve.dot(x - point.x, point.tangent)
        if left <= 0.0:
            break
        there = advanced(curve, point, min(ds, left), 10)
        if there is None or _jumps(curve, point, there):
            if left < SAME:
                break
            ds = min(ds, left) / 2
        elif left <= ds:
            return curve.norm(there.x - x) < SAME  # both lie in the plane across the tangent
        else:
            point, ds = there, min(2 * ds, SHORT)
    return curve.norm(point.x - x) < SAME


def _between(ends: Array, values: Array) -> bool:
    """Whether all values lie between the ends, which are given per column."""
    return bool(((ends[:, 0] <= values) & (values <= ends[:, 1])).all())


MAX_CORRECTION = 0.3
"""Largest correction, as a part of the arclength step."""

MAX_SIDESTEP = 0.004
"""Largest angle, in radians, by which the way between two points differs from the mean of their tangents."""

SAME = 1e-5
"""Distance, in terms of the scale, of two points that are one."""

BESIDE = 1e-2
"""Distance, in terms of the scale, from which on a point is not one of a curve and not one beside it."""

SHORT, SHORT_STEPS = 0.005, 20
"""Arclength steps that do not go aside unnoticed to a curve that is farther than 2e-5, and how many of them
are taken at most beyond those that the way needs."""

STANDING = 1e-4
"""A section point whose entries are all below this part of their scale is a walker that stands."""
