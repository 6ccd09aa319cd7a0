"""Zeros and extrema of observables along traced steps, on arrays of orbits.

A trace holds nodes; between nodes, one Runge-Kutta step of the right size from the node on the left gives
the state at any time with the integrator's own accuracy, so zeros are located exactly and not by
interpolation.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.library import Kernels
from stridemap.solver.observe import OBSERVABLES

Array = NDArray[np.float64]
Index = NDArray[np.int64]

LOCATE_ITERATIONS = 30
LOCATE_TOLERANCE = 1e-5
"""Of the Runge-Kutta step. What is read off is stationary at these times: the error left is the square."""


@dataclass(frozen=True)
class Trace:
    """Traced steps of n orbits at N + 1 nodes each.

    Parameters
    ----------
    kernels : Kernels
    params : ndarray, shape (n, n_params)
    period : ndarray, shape (n,)
    w : ndarray, shape (n, N + 1, 2 n_q + 1)
        State and net work.
    g, dg : ndarray, shape (n, N + 1, len(OBSERVABLES))
        Observables and their time derivatives.
    """

    kernels: Kernels
    params: Array
    period: Array
    w: Array
    g: Array
    dg: Array

    @property
    def h(self) -> Array:
        """Size of the Runge-Kutta steps, shape (n,)."""
        return self.period / (self.w.shape[1] - 1)

    def observable(self, name: str) -> tuple[Array, Array]:
        """Values and time derivatives of one observable at the nodes, shape (n, N + 1) each."""
        row = OBSERVABLES.index(name)
        return self.g[:, :, row], self.dg[:, :, row]

    def take(self, index: Index) -> "Trace":
        """Some of the orbits."""
        parts = (self.params, self.period, self.w, self.g, self.dg)
        return Trace(self.kernels, *(a[index] for a in parts))

    def advance(self, orbit: Index, node: Index, tau: Array) -> tuple[Array, Array, Array]:
        """State with work, observables and derivatives at a time `tau` after a node."""
        t = node * self.h[orbit]
        w, g, dg = self.kernels("advance", t, self.w[orbit, node], tau, self.params[orbit])
        return w, g, dg


@dataclass(frozen=True)
class Brackets:
    """Intervals that hold one zero each, in the order of orbit, then time.

    Parameters
    ----------
    orbit, node : ndarray of int, shape (m,)
    row : int
        Observable.
    derivative : bool
        Whether the zero is one of its time derivative.
    lower, upper : ndarray, shape (m,)
        Times after the node.
    f_lower, f_upper : ndarray, shape (m,)
        Values there; of opposite signs.
    """

    orbit: Index
    node: Index
    row: int
    derivative: bool
    lower: Array
    upper: Array
    f_lower: Array
    f_upper: Array

    def take(self, index: Index | NDArray[np.bool_]) -> "Brackets":
        """Some of the brackets."""
        parts = (self.lower, self.upper, self.f_lower, self.f_upper)
        return Brackets(
            self.orbit[index], self.node[index], self.row, self.derivative, *(a[index] for a in parts)
        )


def brackets(trace: Trace, name: str, derivative: bool = False) -> Brackets:
    """Every zero of an observable, or of its derivative, as a bracket.

    A pair of zeros between two nodes shows no change of sign at the nodes; where the function turns
    towards zero and back inside an interval, its turning point is computed and the interval is split.

    Parameters
    ----------
    trace : Trace
    name : str
        One of `OBSERVABLES`.
    derivative : bool
    """
    row = OBSERVABLES.index(name)
    f, slope = trace.observable(name)
    if derivative:
        f, slope = slope, np.gradient(slope, axis=1) / trace.h[:, None]
    h = np.broadcast_to(trace.h[:, None], f[:, 1:].shape)
    left, right, s_left, s_right = f[:, :-1], f[:, 1:], slope[:, :-1], slope[:, 1:]
    change = (left < 0) != (right < 0)
    turn = ~change & (left * s_left < 0) & (right * s_right > 0)

    orbit, node = np.nonzero(change)
    zero = np.zeros(len(orbit))
    found = Brackets(orbit, node, row, derivative, zero, h[change], left[change], right[change])
    if not turn.any():
        return found
    # The turning point of the cubic through values and slopes at both ends.
    o, i = np.nonzero(turn)
    tau = _turning_point(left[turn], right[turn], s_left[turn], s_right[turn], h[turn])
    _, g, dg = trace.advance(o, i, tau)
    middle = (dg if derivative else g)[:, row]
    split = (middle < 0) != (left[turn] < 0)
    if not split.any():
        return found
    o, i, tau, middle = o[split], i[split], tau[split], middle[split]
    first = Brackets(o, i, row, derivative, np.zeros(len(o)), tau, f[o, i], middle)
    second = Brackets(o, i, row, derivative, tau, trace.h[o], middle, f[o, i + 1])
    return _merged(found, first, second)


def _turning_point(left: Array, right: Array, s_left: Array, s_right: Array, h: Array) -> Array:
    """Where the cubic Hermite interpolant's slope changes sign; s_left and s_right have opposite signs."""
    a = 3 * (s_left + s_right) - 6 * (right - left) / h
    b = -4 * s_left - 2 * s_right + 6 * (right - left) / h
    c = s_left
    root = np.sqrt(np.maximum(b * b - 4 * a * c, 0))
    # Of the quadratic's roots, the one in (0, 1), in the form that does not cancel.
    q = -0.5 * (b + np.copysign(root, b))
    with np.errstate(divide="ignore", invalid="ignore"):
        one, two = q / a, c / q
    fraction = np.where((one > 0) & (one < 1), one, two)
    return h * np.clip(np.nan_to_num(fraction, nan=0.5), 0.01, 0.99)


def _merged(*parts: Brackets) -> Brackets:
    columns = [
        np.concatenate([getattr(p, c) for p in parts])
        for c in ("orbit", "node", "lower", "upper", "f_lower", "f_upper")
    ]
    orbit, node, lower, upper, f_lower, f_upper = columns
    order = np.lexsort((lower, node, orbit))
    merged = Brackets(orbit, node, parts[0].row, parts[0].derivative, lower, upper, f_lower, f_upper)
    return merged.take(order)


def locate(trace: Trace, found: Brackets) -> tuple[Array, Array, Array]:
    """Shrink every bracket to its zero (regula falsi with the Illinois weights).

    Returns
    -------
    t : ndarray, shape (m,)
        Time of each zero within its step.
    w : ndarray, shape (m, 2 n_q + 1)
        State and net work there.
    g : ndarray, shape (m, len(OBSERVABLES))
        Observables there.
    """
    m = len(found.orbit)
    lower, upper = found.lower.copy(), found.upper.copy()
    f_lower, f_upper = found.f_lower.copy(), found.f_upper.copy()
    h = trace.h[found.orbit]
    tau, w, g = lower.copy(), np.full((m, trace.w.shape[2]), np.nan), np.full((m, len(OBSERVABLES)), np.nan)
    side = np.zeros(m, dtype=np.int64)
    active = np.arange(m)
    for _ in range(LOCATE_ITERATIONS):
        if not len(active):
            break
        a, b, fa, fb = lower[active], upper[active], f_lower[active], f_upper[active]
        with np.errstate(divide="ignore", invalid="ignore"):
            guess = (a * fb - b * fa) / (fb - fa)
        guess = np.where(np.isfinite(guess), np.clip(guess, a, b), 0.5 * (a + b))
        state, seen, slope = trace.advance(found.orbit[active], found.node[active], guess)
        f = (slope if found.derivative else seen)[:, found.row]
        moved = np.abs(guess - tau[active])
        tau[active], w[active], g[active] = guess, state, seen
        on_left = (f < 0) == (fa < 0)
        # Illinois: halve the weight of an end that stays twice in a row.
        halve = np.where(on_left, side[active] == 1, side[active] == -1)
        side[active] = np.where(on_left, 1, -1)
        lower[active], f_lower[active] = (
            np.where(on_left, guess, a),
            np.where(on_left, f, np.where(halve, 0.5 * fa, fa)),
        )
        upper[active], f_upper[active] = (
            np.where(on_left, b, guess),
            np.where(on_left, np.where(halve, 0.5 * fb, fb), f),
        )
        active = active[(moved > LOCATE_TOLERANCE * h[active]) & (f != 0)]
    return found.node * h + tau, w, g
