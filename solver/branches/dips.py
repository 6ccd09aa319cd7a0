"""Points that are added to a curve where something happens twice between two neighbours.

A quantity that has the same sign at two points may have passed through zero and come back between them: at
two doublings close together, or where a foot just touches the ground. What it does beside them tells: between
two points it is about the cubic through its values, with the slopes of parabolas through three points each.
"""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.branches.arclength import CurvePoint
from stridemap.solver.branches.asking import alone
from stridemap.solver.branches.bifurcation import SpecialType
from stridemap.solver.branches.conditions import GaitConditions
from stridemap.solver.branches.curve import Curve
from stridemap.solver.branches.ends import conditions_along
from stridemap.solver.branches.special import point_between, tests
from stridemap.solver.options import ContinuationOptions

Array = NDArray[np.float64]

TESTS = (SpecialType.FOLD, SpecialType.PD, SpecialType.NS)
"""Bifurcations with a test that is smooth along a curve."""

NEAR = 0.5
"""An extreme between two points is looked at where it is less than this part of the smaller value at them."""

LOOKS = 4
"""Points at most at which an extreme is looked for."""

SETTLED = 1e-3
"""Part of the distance of two points by which the place of an extreme need not be moved any more."""


def with_dips(
    curve: Curve, points: list[CurvePoint], conditions: GaitConditions, options: ContinuationOptions
) -> list[CurvePoint]:
    """Points of a curve, and between them those at which a quantity has another sign than on both sides.

    The quantities are the tests of bifurcations and the conditions of a gait.

    Parameters
    ----------
    curve : Curve
    points : list of CurvePoint
    conditions : GaitConditions
    options : ContinuationOptions
    """
    if len(points) < 3:
        return points
    steps = np.diff([point.x for point in points], axis=0)
    lengths = np.concatenate([[0.0], np.cumsum([curve.norm(one) for one in steps])])
    added: dict[int, list[CurvePoint]] = {}
    for name, values in _quantities(curve, points, conditions).items():
        for i, part in dips(lengths, values):
            ends = points[i], points[i + 1]
            found = _looked_for(curve, ends, values[i : i + 2], part, name, conditions, options)
            if found is not None:
                added.setdefault(i, []).append(found)
    out = []
    for i, point in enumerate(points):
        between = added.get(i, [])
        along = [curve.dot(one.x - point.x, point.tangent) for one in between]
        out += [point, *(between[j] for j in np.argsort(along))]
    return out


def dips(lengths: Array, values: Array) -> Iterator[tuple[int, float]]:
    """Intervals in which values of one sign seem to come near zero, each with the place of that in it.

    Parameters
    ----------
    lengths : ndarray, shape (m,)
        Ascending, m >= 3.
    values : ndarray, shape (m,)
    """
    with np.errstate(all="ignore"):
        slopes = np.gradient(values, lengths, edge_order=2)
        h, f, g, sign = np.diff(lengths), values[:-1], values[1:], np.sign(values[:-1])
        d, e = slopes[:-1] * h, slopes[1:] * h
        towards = np.isfinite(d) & np.isfinite(e) & (f * g > 0) & (sign * d < 0) & (sign * e > 0)
    for i in np.flatnonzero(towards).tolist():
        # The cubic f + d t + b t^2 + a t^3 has one extreme in between, because its slopes have two signs.
        a, b = 2 * (f[i] - g[i]) + d[i] + e[i], 3 * (g[i] - f[i]) - 2 * d[i] - e[i]
        roots = np.roots([3 * a, 2 * b, d[i]])
        inside = [root.real for root in roots if abs(root.imag) < 1e-12 and 0 < root.real < 1]
        for t in inside[:1]:
            extreme = f[i] + t * (d[i] + t * (b + t * a))
            if sign[i] * extreme < NEAR * min(abs(f[i]), abs(g[i])):
                yield i, float(t)


def _quantities(curve: Curve, points: list[CurvePoint], conditions: GaitConditions) -> dict[str, Array]:
    """Tests of bifurcations and conditions of a gait at points, shape (m,) each."""
    found = [tests(curve, point) for point in points]
    out: dict[str, Array] = {name: np.array([one[name] for one in found]) for name in TESTS}
    for name, values in conditions_along(curve, points, conditions).items():
        out[name] = values
    return out


def _looked_for(
    curve: Curve,
    ends: tuple[CurvePoint, CurvePoint],
    values: Array,
    part: float,
    name: str,
    conditions: GaitConditions,
    options: ContinuationOptions,
) -> CurvePoint | None:
    """A point between two at which a quantity has another sign; None where its extreme has none."""
    before, after = values
    for _ in range(LOOKS):
        here = alone(point_between(curve, *ends, options, part))
        if here is None:
            return None
        value = _quantities(curve, [here], conditions)[name][0]
        if value * before < 0:
            return here
        # The extreme of the parabola through all three.
        left, right = (value - before) / part, (after - value) / (1 - part)
        bend = right - left
        moved = part / 2 - left / (2 * bend) if bend else part
        if not 0 < moved < 1 or abs(moved - part) < SETTLED:
            return None
        part = moved
    return None
