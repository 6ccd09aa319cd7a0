"""Where gaits end along a curve of cycles: points at which one of the conditions of a gait is zero."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.branches.arclength import CurvePoint, advanced
from stridemap.solver.branches.conditions import GaitConditions, GaitEnd
from stridemap.solver.branches.curve import ZeroCurve
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
    holds = {name: one > 0 for name, one in values.items()}
    gait = np.all(list(holds.values()), axis=0)
    for number in np.flatnonzero(gait[:-1] != gait[1:]).tolist():
        inside = number if gait[number] else number + 1
        outside = 2 * number + 1 - inside
        broken = [name for name in holds if not holds[name][outside]]
        found = [
            end
            for name in broken
            if (end := _located(curve, name, points[number], points[number + 1], conditions, options))
        ]
        if found:  # of several that are broken, the one that is met first
            middle = points[inside].x
            yield number, min(found, key=lambda end: curve.norm(end.point.x - middle))


def _located(
    curve: ZeroCurve,
    name: GaitEnd,
    one: CurvePoint,
    other: CurvePoint,
    conditions: GaitConditions,
    options: ContinuationOptions,
) -> End | None:
    """Where a condition is zero between two points: regula falsi (Illinois) on the arclength step."""

    def value(point: CurvePoint) -> float:
        return float(conditions_along(curve, [point], conditions, [name])[name][0])

    low, high = 0.0, curve.dot(other.x - one.x, one.tangent)
    f_low, f_high = value(one), value(other)
    here: CurvePoint | None = None
    for turn in range(LOCATE_ITERATIONS):
        bounded = np.isfinite(f_low) and np.isfinite(f_high) and turn % 6 < 5
        ds = low + (high - low) * (f_low / (f_low - f_high) if bounded else 0.5)
        here = advanced(curve, one, ds, options.max_corrections + 3)
        if here is None:
            return None
        f = value(here)
        if abs(f) < ROUNDING or high - low < 1e-15 * (1.0 + abs(high)):
            break
        if (f > 0) == (f_low > 0):
            low, f_low, f_high = ds, f, 0.5 * f_high
        else:
            high, f_high, f_low = ds, f, 0.5 * f_low
    if here is None or not abs(f) < LOCATED:
        return None
    closing = float(np.abs(curve.linearised(here.x, here.n_rk)[1]).max())
    return End(name, here, max(abs(f), closing))


LOCATE_ITERATIONS = 80
"""Halvings and secants until the end of a gait is found."""

LOCATED, ROUNDING = 1e-11, 1e-14
"""Modulus of a condition that counts as zero, and below which it cannot be brought."""
