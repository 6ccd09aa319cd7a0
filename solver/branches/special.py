"""Bifurcations of cycles between points of a curve: which there are, and where.

Between two points at which a test function differs in sign, or the number of multipliers outside the unit
circle does, a special point is bracketed until Newton's method on its own system (`defining`) converges to
it.
"""

import itertools
from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.branches.arclength import CurvePoint
from stridemap.solver.branches.asking import Asking, asked, together
from stridemap.solver.branches.bifurcation import Special, SpecialType
from stridemap.solver.branches.curve import Correction, Curve
from stridemap.solver.branches.defining import Attempt, finer
from stridemap.solver.kernels.catalogue import CYCLE_N_RK
from stridemap.solver.options import ContinuationOptions

Array = NDArray[np.float64]

BISECTIONS, SUBDIVISIONS = 24, 8
"""How often the bracket of one special point is halved before Newton's method must succeed, and a part of a
curve in which several things happen at once."""


# -- test functions --------------------------------------------------------------------------------------


def unstable_count(point: CurvePoint) -> int:
    """Number of multipliers outside the unit circle."""
    return int((np.abs(point.multipliers) > 1.0).sum())


def tests(curve: Curve, point: CurvePoint) -> dict[SpecialType, float]:
    """What changes its sign at each type of special point."""
    multipliers = point.multipliers
    i, j = np.triu_indices(len(multipliers), 1)
    square = np.vstack([point.matrix * curve.scale, point.tangent / curve.scale])
    return {
        SpecialType.FOLD: float(point.tangent[-1]),
        SpecialType.PD: float(np.prod(1.0 + multipliers).real),
        SpecialType.NS: float(np.prod(multipliers[i] * multipliers[j] - 1.0).real) if len(i) else 1.0,
        SpecialType.BP: float(np.linalg.slogdet(square)[0]),
    }


def special_points(
    curve: Curve, points: list[CurvePoint], options: ContinuationOptions
) -> Iterator[tuple[int, Special]]:
    """Bifurcations between neighbouring points of a curve, each with the number of the point before it."""
    pairs = itertools.pairwise(points)
    found = together(specials_between(curve, one, other, options) for one, other in pairs)
    for number, specials in enumerate(found):
        for special in specials:
            yield number, special


def specials_between(
    curve: Curve,
    one: CurvePoint,
    other: CurvePoint,
    options: ContinuationOptions,
    depth: int = SUBDIVISIONS,
) -> Asking[list[Special]]:
    """A search for the bifurcations between two points of a curve, which it returns in order."""
    first, second = tests(curve, one), tests(curve, other)
    crossed = [kind for kind in SpecialType if first[kind] * second[kind] < 0]
    if not _a_pair_may_cross(one, other):
        crossed = [kind for kind in crossed if kind != SpecialType.NS]
    change = abs(unstable_count(other) - unstable_count(one))
    # A doubling would change the count. A multiplier goes through infinity where the foot grazes the ground.
    if not change and crossed in ([], [SpecialType.PD]):
        return []
    specials = []
    if len(crossed) == 1:
        special = yield from _located(curve, crossed[0], one, other, options)
        specials += [special] if special is not None else []
    explained = sum(CHANGES[special.type] for special in specials)
    # Two doublings leave the sign of their test as it was: what the count of multipliers says must add up.
    if len(crossed) < 2 and change <= explained and (explained - change) % 2 == 0:
        return specials
    middle = (yield from point_between(curve, one, other, options)) if depth else None
    if middle is not None:
        before = yield from specials_between(curve, one, middle, options, depth - 1)
        after = yield from specials_between(curve, middle, other, options, depth - 1)
        return [*before, *after]
    halvings, found = BISECTIONS - 2 * (SUBDIVISIONS - depth), []
    for kind in crossed:
        found.append((yield from _located(curve, kind, one, other, options, halvings)))
    return [special for special in found if special is not None]


def _a_pair_may_cross(one: CurvePoint, other: CurvePoint) -> bool:
    """Whether a pair of complex multipliers may cross the unit circle between two points.

    Two real ones can have the product 1, which changes the sign of the test as well: but then as many
    multipliers are complex at both points, as many of these are outside, and as many of all.
    """
    pairs = [point.multipliers[point.multipliers.imag != 0] for point in (one, other)]
    before, after = ((len(some), int((np.abs(some) > 1.0).sum())) for some in pairs)
    return before != after or abs(unstable_count(other) - unstable_count(one)) > 1


CHANGES = {SpecialType.FOLD: 1, SpecialType.PD: 1, SpecialType.NS: 2, SpecialType.BP: 1}
"""By how much each changes the number of multipliers outside the unit circle."""


def point_between(
    curve: Curve, one: CurvePoint, other: CurvePoint, options: ContinuationOptions, part: float = 0.5
) -> Asking[CurvePoint | None]:
    """A search for a point of the curve between two; it returns None where there is none."""
    if not curve.dot(other.x - one.x, one.tangent) > 0:
        return None
    n_rk = max(one.n_rk, other.n_rk)
    guess = one.x + part * (other.x - one.x)
    iterations = options.max_corrections + 3
    found = yield from asked(Correction(curve, guess, one.tangent, n_rk, iterations))
    return CurvePoint.at(curve, found, one.tangent, n_rk) if found.converged else None


def _located(
    curve: Curve,
    kind: SpecialType,
    one: CurvePoint,
    other: CurvePoint,
    options: ContinuationOptions,
    halvings: int = BISECTIONS,
) -> Asking[Special | None]:
    """The special point of a type between two points of a curve; None where there is none after all.

    Newton's method starts from a bracket that is halved until it converges to a point within.
    """
    sign, growing = tests(curve, one)[kind], 0
    for _ in range(halvings):
        if kind == SpecialType.NS and not _a_pair_may_cross(one, other):
            return None
        guess = _likeliest(curve, kind, one, other)
        reach = REACH * curve.norm(other.x - one.x)
        special = yield from asked(Attempt(kind, curve, guess, reach))
        if special is not None and _within(curve, one, other, special.x):
            return (yield from _refined(curve, special, guess))
        middle = yield from point_between(curve, one, other, options)
        if middle is None:
            return None
        largest = max(abs(tests(curve, one)[kind]), abs(tests(curve, other)[kind]))
        growing = growing + 1 if abs(tests(curve, middle)[kind]) > largest else 0
        if growing == POLE:
            return None  # it goes through infinity, where the foot grazes the ground
        one, other = (middle, other) if tests(curve, middle)[kind] * sign > 0 else (one, middle)
    return None


def _refined(curve: Curve, special: Special, guess: CurvePoint) -> Asking[Special]:
    """The same special point at ever finer resolutions, until it does not change any more."""
    n_rk = finer(guess.n_rk)
    while n_rk < CYCLE_N_RK[-1]:
        guess = CurvePoint(special.x, guess.tangent, guess.matrix, special.multipliers, n_rk)
        again = yield from asked(Attempt(special.type, curve, guess, before=special))
        if again is None:
            break
        change = curve.norm(again.x - special.x)
        special, n_rk = again, finer(n_rk)
        if change < RESOLVED * GAIN:
            break
    return special


def _likeliest(curve: Curve, kind: SpecialType, one: CurvePoint, other: CurvePoint) -> CurvePoint:
    """The end of a bracket that is nearer to the special point, moved there linearly."""
    before, after = abs(tests(curve, one)[kind]), abs(tests(curve, other)[kind])
    part = before / (before + after) if before + after > 0 else 0.5
    near = one if part < 0.5 else other
    return CurvePoint(
        one.x + part * (other.x - one.x), near.tangent, near.matrix, near.multipliers, near.n_rk
    )


def _within(curve: Curve, one: CurvePoint, other: CurvePoint, x: Array) -> bool:
    """Whether a point lies between two others, or hardly beyond them."""
    length = curve.norm(other.x - one.x)
    slack = 1e-3 * length + 1e-9
    return (
        curve.dot(x - one.x, one.tangent) > -slack
        and curve.dot(other.x - x, other.tangent) > -slack
        and curve.norm(x - one.x) < 1.5 * length + 1e-9
    )


REACH = 1.0
"""How far from its guess within a bracket Newton's method may go, in terms of the bracket's length. What it
finds farther away is not in the bracket; to see that takes many steps with second derivatives."""

POLE = 4
"""Halvings at which a test function grows, after which it has a pole and not a zero."""

RESOLVED, GAIN = 1e-12, 32.0
"""Error of a special point, in terms of the scale, that needs no finer resolution, and by which factor at
least it is smaller than what twice the resolution has changed: 256 with a method of order 8."""
