"""From one branch onto another: at a period doubling, and at a branch point."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.branches.arclength import CurvePoint
from stridemap.solver.branches.asking import Asking, asked
from stridemap.solver.branches.bifurcation import Special
from stridemap.solver.branches.curve import Correction, Curve
from stridemap.solver.options import ContinuationOptions

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Switched:
    """The beginning of a branch that leaves another one.

    Parameters
    ----------
    curve : Curve
        The curve on which it lies: of twice as many steps after a doubling.
    start : CurvePoint
        Its first point beyond the other branch, with the tangent that leads away.
    """

    curve: Curve
    start: CurvePoint


def doubled(curve: Curve, special: Special, options: ContinuationOptions) -> Asking[Switched | None]:
    """A search for the branch of twice the period that begins at a doubling; it may return None.

    At a doubling the multiplier is -1: a small displacement along the null vector w returns after one cycle
    with the opposite sign. So the doubled cycle is, to first order, the cycle at u + w and then at u - w.

    Parameters
    ----------
    curve : Curve
    special : Special
        A doubling on it.
    options : ContinuationOptions
    """
    double = curve.with_steps(2 * curve.chain.n_steps)
    w = np.real(special.null)
    x = np.append(np.tile(special.x[:-1], 2), special.x[-1])
    return _leaving(double, x, np.concatenate([w, -w, [0.0]]), options)


def crossing(
    curve: Curve, special: Special, options: ContinuationOptions, side: int = 1
) -> Asking[Switched | None]:
    """A search for the other branch at a branch point, to one side; it may return None.

    Parameters
    ----------
    curve : Curve
    special : Special
        A branch point on it.
    options : ContinuationOptions
    side : {1, -1}
    """
    return _leaving(curve, special.x, side * np.real(special.null), options)


def _leaving(
    curve: Curve, x: Array, direction: Array, options: ContinuationOptions
) -> Asking[Switched | None]:
    """The first point in a direction that leads away from a point, at the longest of ever shorter steps."""
    tangent = direction / curve.norm(direction)
    ds = options.ds
    while ds >= options.ds_min:
        guess = x + ds * tangent
        n_rk = curve.n_rk(guess)
        found = yield from asked(Correction(curve, guess, tangent, n_rk, options.max_corrections))
        if found.converged:
            there = CurvePoint.at(curve, found, tangent, n_rk)
            offset = there.x - x
            # A new branch is at a distance from the old one, and its tangent has hardly turned.
            if (
                curve.dot(there.tangent, tangent) > options.min_tangent_cosine
                and curve.norm(offset - ds * tangent) < 0.3 * ds
            ):
                return Switched(curve, there)
        ds *= options.step_shrink
    return None


def supercritical(special: Special, switched: Switched) -> bool:
    """Whether a doubled branch begins on the side on which the cycle that doubles is unstable.

    Parameters
    ----------
    special : Special
        The doubling: its slope is the change of the multiplier at -1 along the branch.
    switched : Switched
        The branch that begins there.
    """
    offset = switched.start.x[-1] - special.x[-1]
    return bool(offset * special.slope * special.direction < 0)
