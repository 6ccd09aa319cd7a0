"""Where gaits end along a curve of cycles: points at which one of the conditions of a gait is zero."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.branches.arclength import CurvePoint
from stridemap.solver.branches.conditions import GaitConditions, GaitEnd
from stridemap.solver.branches.curve import ZeroCurve
from stridemap.solver.kernels.catalogue import CYCLE_N_RK
from stridemap.solver.options import ArclengthOptions

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
    options: ArclengthOptions,
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
    options : ArclengthOptions
    """
    holds = {name: one > 0 for name, one in values.items()}
    gait = np.all(list(holds.values()), axis=0)
    for number in np.flatnonzero(gait[:-1] != gait[1:]).tolist():
        inside = number if gait[number] else number + 1
        outside = 2 * number + 1 - inside
        broken = [name for name in holds if not holds[name][outside]]
        pair, found = (points[number], points[number + 1]), []
        for name in broken:
            known = tuple(values[name][number : number + 2].tolist())
            if end := _located(curve, name, pair, known, conditions, options):
                found.append(end)
        if found:  # of several that are broken, the one that is met first
            middle = points[inside].x
            yield number, min(found, key=lambda end: curve.norm(end.point.x - middle))


def _located(
    curve: ZeroCurve,
    name: GaitEnd,
    pair: tuple[CurvePoint, CurvePoint],
    known: tuple[float, ...],
    conditions: GaitConditions,
    options: ArclengthOptions,
) -> End | None:
    """Where a condition is zero between two points: regula falsi (Illinois) on the arclength step.

    The condition is `known` at both points.
    """
    one, other = pair
    n_rk = max(one.n_rk, other.n_rk)

    def value(point: CurvePoint) -> float:
        return float(conditions_along(curve, [point], conditions, [name])[name][0])

    low, high = 0.0, curve.dot(other.x - one.x, one.tangent)
    x_low, x_high = one.x, other.x
    f_low, f_high = known
    here: CurvePoint | None = None
    kept = 0  # the side that the last turn kept: 1 for the upper end, -1 for the lower one
    for turn in range(LOCATE_ITERATIONS):
        bounded = np.isfinite(f_low) and np.isfinite(f_high) and turn % 6 < 5
        part = f_low / (f_low - f_high) if bounded else 0.5
        guess = x_low + part * (x_high - x_low)
        found = curve.corrected(guess, one.tangent, n_rk, options.max_corrections + 3)
        if not found.converged:
            return None
        here = CurvePoint.at(curve, found, one.tangent, n_rk)
        ds, f = low + part * (high - low), value(here)
        left = abs(f) * (high - low) / abs(f_low - f_high) if f_low != f_high else 0.0
        if abs(f) < ROUNDING or (abs(f) < LOCATED and left < SETTLED) or high - low < SETTLED * abs(high):
            break
        if (f > 0) == (f_low > 0):
            low, x_low, f_low = ds, here.x, f
            f_high *= 0.5 if kept == 1 else 1.0  # kept twice in a row, an end would stay for ever
            kept = 1
        else:
            high, x_high, f_high = ds, here.x, f
            f_low *= 0.5 if kept == -1 else 1.0
            kept = -1
    if here is None or not abs(f) < LOCATED:
        return None
    closing = float(np.abs(curve.linearised(here.x, here.n_rk)[1]).max())
    return End(name, here, max(abs(f), closing))


LOCATE_ITERATIONS = 80
"""Halvings and secants until the end of a gait is found."""

LOCATED, ROUNDING = 1e-11, 1e-14
"""Modulus of a condition that counts as zero, and below which it cannot be brought."""

SETTLED = 1e-14
"""Arclength by which an end need not be moved any more."""
