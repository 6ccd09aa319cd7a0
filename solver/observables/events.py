"""Zeros and extrema of observables along traced steps, on arrays of orbits.

A trace holds nodes; between nodes, one RK step of the right size from the node on the left gives
the state at any time with the integrator's own accuracy, so zeros are located exactly and not by
interpolation.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.backends.base import Advanced, Kernels, Traced
from stridemap.solver.kernels.observation import observables

Array = NDArray[np.float64]
Index = NDArray[np.int64]

LOCATE_ITERATIONS = 30
LOCATE_TOLERANCE = 1e-5
"""Of the RK step. What is read off is stationary at these times: the error left is the square."""


@dataclass(frozen=True)
class Trace:
    """Traced steps of n orbits at N + 1 nodes each.

    Parameters
    ----------
    kernels : Kernels
    params : ndarray, shape (n, n_params)
    period : ndarray, shape (n,)
    w : ndarray, shape (n, N + 1, 2 n_q + n_actuators)
        State and net work of each actuator.
    g, dg : ndarray, shape (n, N + 1, n_observables)
        Observables and their time derivatives.
    """

    kernels: Kernels
    params: Array
    period: Array
    w: Array
    g: Array
    dg: Array

    @classmethod
    def of(cls, kernels: Kernels, u: Array, params: Array, traced: Traced) -> "Trace":
        """What a kernel traced from section points with periods `u`."""
        return cls(kernels, params, u[:, -1], traced.w, traced.g, traced.dg)

    @property
    def h(self) -> Array:
        """Size of the RK steps, shape (n,)."""
        return self.period / (self.w.shape[1] - 1)

    def observable(self, name: str) -> tuple[Array, Array]:
        """Values and time derivatives of one observable at the nodes, shape (n, N + 1) each."""
        row = self.row(name)
        return self.g[:, :, row], self.dg[:, :, row]

    def row(self, name: str) -> int:
        """Row of an observable."""
        return observables(self.kernels.model).index(name)

    def take(self, index: Index) -> "Trace":
        """Some of the orbits, in order."""
        if len(index) == len(self.period):
            return self
        parts = (self.params, self.period, self.w, self.g, self.dg)
        return Trace(self.kernels, *(a[index] for a in parts))

    def advance(self, orbit: Index, node: Index, tau: Array) -> Advanced:
        """State with work, observables and derivatives at a time `tau` after a node."""
        t = node * self.h[orbit]
        return self.kernels.advance(t, self.w[orbit, node], tau, self.params[orbit])


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
    g_lower, g_upper, dg_lower, dg_upper : ndarray, shape (m,)
        The observable and its time derivative there.
    """

    orbit: Index
    node: Index
    row: int
    derivative: bool
    lower: Array
    upper: Array
    g_lower: Array
    g_upper: Array
    dg_lower: Array
    dg_upper: Array

    @property
    def f_lower(self) -> Array:
        """What has the zero, at the lower end."""
        return self.dg_lower if self.derivative else self.g_lower

    @property
    def f_upper(self) -> Array:
        """What has the zero, at the upper end; of the opposite sign."""
        return self.dg_upper if self.derivative else self.g_upper

    def take(self, index: Index | NDArray[np.bool_]) -> "Brackets":
        """Some of the brackets."""
        parts = (getattr(self, name)[index] for name in _COLUMNS)
        return Brackets(self.orbit[index], self.node[index], self.row, self.derivative, *parts)

    def guess(self) -> Array:
        """Where the cubic through values and slopes at both ends has the zero, shape (m,)."""
        h = self.upper - self.lower
        if self.derivative:
            return self.lower + _turning_point(self.g_lower, self.g_upper, self.dg_lower, self.dg_upper, h)
        return self.lower + _zero(self.g_lower, self.g_upper, self.dg_lower, self.dg_upper, h)


_COLUMNS = ("lower", "upper", "g_lower", "g_upper", "dg_lower", "dg_upper")


def brackets(trace: Trace, name: str) -> Brackets:
    """Every zero of an observable as a bracket.

    A pair of zeros between two nodes shows no change of sign at the nodes, and three zeros look like one;
    where the function may turn towards zero and back inside an interval, its turning points are computed
    and split the interval.

    Parameters
    ----------
    trace : Trace
    name : str
        One of `observables`.
    """
    row = trace.row(name)
    g, dg = trace.observable(name)
    below, falls = g < 0, dg < 0
    change = below[:, :-1] != below[:, 1:]

    # Signs leave few intervals, which are looked at more closely.
    parts = []
    may_turn = ~change & (below[:, :-1] != falls[:, :-1]) & (below[:, 1:] == falls[:, 1:])
    orbit, node = np.nonzero(may_turn)
    left, right, s_left, s_right = _ends(g, dg, orbit, node)
    turn = (left * s_left < 0) & (right * s_right > 0)
    if turn.any():
        orbit, node = orbit[turn], node[turn]
        h = trace.h[orbit]
        tau = _turning_point(left[turn], right[turn], s_left[turn], s_right[turn], h)
        parts.append(_split(trace, row, False, orbit, node, np.stack([0 * h, tau, h], axis=1)))
    # There and back again: the interpolant rises, falls and rises, or falls, rises and falls. Either
    # it ends on the other side of its beginning than its slopes lead to, or both are so near each other that
    # it stays within 2/3 of the largest slope times the interval of its beginning: near zero, if it crosses.
    reach = trace.h * np.abs(dg).max(axis=1)
    back = (np.diff(g, axis=1) < 0) != falls[:, :-1]
    back |= ~(np.abs(g[:, :-1]) > reach[:, None])
    back &= falls[:, :-1] == falls[:, 1:]
    orbit, node = np.nonzero(back)
    f0, f1, s0, s1 = _ends(g, dg, orbit, node)
    rise, h = f1 - f0, trace.h[orbit]
    small = (rise * s0 < 0) | (3 * np.abs(rise) < h * np.maximum(np.abs(s0), np.abs(s1)))
    small &= s0 * s1 > 0
    orbit, node = orbit[small], node[small]
    f0, f1, s0, s1 = f0[small], f1[small], s0[small], s1[small]
    tau = _turning_points(f0, f1, s0, s1, trace.h[orbit])
    column = (slice(None), None)
    value = _interpolated(f0[column], f1[column], s0[column], s1[column], trace.h[orbit][column], tau)
    with np.errstate(invalid="ignore"):
        crosses = ((value < 0) != (np.stack([f0, f1], axis=1) < 0)).any(axis=1)
    chosen = np.isfinite(tau).all(axis=1) & crosses
    if chosen.any():
        orbit, node, h = orbit[chosen], node[chosen], trace.h[orbit[chosen], None]
        change[orbit, node] = False
        times = np.concatenate([0 * h, tau[chosen], h], axis=1)
        parts.append(_split(trace, row, False, orbit, node, times))
    return _merged(_whole(trace, row, False, *np.nonzero(change)), *parts)


def _ends(g: Array, dg: Array, orbit: Index, node: Index) -> tuple[Array, Array, Array, Array]:
    """Values, then slopes, at both ends of some intervals."""
    return g[orbit, node], g[orbit, node + 1], dg[orbit, node], dg[orbit, node + 1]


def turning_brackets(trace: Trace, name: str, within: tuple[Index, Index] | None = None) -> Brackets:
    """Every zero of an observable's time derivative as a bracket; pairs between two nodes as in `brackets`.

    Parameters
    ----------
    trace : Trace
    name : str
        One of `observables`.
    within : (ndarray of int, ndarray of int), optional
        Orbits and nodes of the intervals that are looked at, in order; all of them if it is left out.
    """
    row = trace.row(name)
    _, dg = trace.observable(name)
    orbit, node = np.nonzero(np.ones((len(dg), dg.shape[1] - 1), dtype=bool)) if within is None else within
    left, right = dg[orbit, node], dg[orbit, node + 1]
    change = (left < 0) != (right < 0)
    parts = []
    # A pair of zeros: the derivative, on one side of zero at both nodes, turns between them.
    at = np.flatnonzero(~change)
    s_left, s_right = (_slope(dg, orbit[at], node[at] + end) / trace.h[orbit[at]] for end in (0, 1))
    pair = (left[at] * s_left < 0) & (right[at] * s_right > 0)
    if pair.any():
        at, s_left, s_right = at[pair], s_left[pair], s_right[pair]
        h = trace.h[orbit[at]]
        tau = _turning_point(left[at], right[at], s_left, s_right, h)
        parts.append(_split(trace, row, True, orbit[at], node[at], np.stack([0 * h, tau, h], axis=1)))
    return _merged(_whole(trace, row, True, orbit[change], node[change]), *parts)


def _slope(f: Array, orbit: Index, node: Index) -> Array:
    """Second-order differences of a function at nodes, per interval; at the ends one-sided."""
    last = f.shape[1] - 1
    first = np.clip(node - 1, 0, last - 2)
    a, b, c = (f[orbit, first + i] for i in range(3))
    begins, ends = -1.5 * a + 2.0 * b - 0.5 * c, 0.5 * a - 2.0 * b + 1.5 * c
    return np.where(node == 0, begins, np.where(node == last, ends, 0.5 * (c - a)))


def _whole(trace: Trace, row: int, derivative: bool, orbit: Index, node: Index) -> Brackets:
    """Whole intervals between nodes as brackets."""
    g, dg = trace.g[:, :, row], trace.dg[:, :, row]
    ends = (one[orbit, node + end] for one in (g, dg) for end in (0, 1))
    return Brackets(orbit, node, row, derivative, np.zeros(len(orbit)), trace.h[orbit], *ends)


def _split(trace: Trace, row: int, derivative: bool, orbit: Index, node: Index, times: Array) -> Brackets:
    """Those parts of intervals, cut at `times` after the node, at whose ends the signs differ."""
    g, dg = np.empty(times.shape), np.empty(times.shape)
    for side, end in ((0, 0), (-1, 1)):
        g[:, side], dg[:, side] = trace.g[orbit, node + end, row], trace.dg[orbit, node + end, row]
    for j in range(1, times.shape[1] - 1):
        _, seen, slope = trace.advance(orbit, node, times[:, j])
        g[:, j], dg[:, j] = seen[:, row], slope[:, row]
    f = dg if derivative else g
    k, part = np.nonzero((f[:, :-1] < 0) != (f[:, 1:] < 0))
    columns = (a[k, at] for a in (times, g, dg) for at in (part, part + 1))
    return Brackets(orbit[k], node[k], row, derivative, *columns)


def _turning_points(left: Array, right: Array, s_left: Array, s_right: Array, h: Array) -> Array:
    """Both turning points of the cubic Hermite interpolant inside the interval, shape (m, 2), or NaN."""
    a = 3 * h * (s_left + s_right) - 6 * (right - left)
    b = -2 * h * (2 * s_left + s_right) + 6 * (right - left)
    with np.errstate(divide="ignore", invalid="ignore"):
        q = -0.5 * (b + np.copysign(np.sqrt(b * b - 4 * a * h * s_left), b))
        fractions = np.sort(np.stack([q / a, h * s_left / q], axis=1), axis=1)
    inside = ((fractions > 0) & (fractions < 1)).all(axis=1, keepdims=True)
    return np.where(inside, fractions * h[:, None], np.nan)


def _interpolated(left: Array, right: Array, s_left: Array, s_right: Array, h: Array, tau: Array) -> Array:
    """The cubic Hermite interpolant at a time `tau` after the left end."""
    x = tau / h
    a = h * (s_left + s_right) + 2 * (left - right)
    b = 3 * (right - left) - h * (2 * s_left + s_right)
    return ((a * x + b) * x + h * s_left) * x + left


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
    return h * np.clip(np.nan_to_num(fraction, nan=0.5), 0.0, 1.0)


def _zero(left: Array, right: Array, s_left: Array, s_right: Array, h: Array) -> Array:
    """Zero of the cubic Hermite interpolant; left and right have opposite signs."""
    a = h * (s_left + s_right) + 2 * (left - right)
    b = 3 * (right - left) - h * (2 * s_left + s_right)
    c, d = h * s_left, left
    with np.errstate(divide="ignore", invalid="ignore"):
        x = left / (left - right)
        for _ in range(3):
            x = np.clip(x - (((a * x + b) * x + c) * x + d) / ((3 * a * x + 2 * b) * x + c), 0.0, 1.0)
    return h * np.where(np.isfinite(x), x, 0.5)


def _merged(*parts: Brackets) -> Brackets:
    if len(parts) == 1:
        return parts[0]
    orbit, node, *columns = (
        np.concatenate([getattr(p, name) for p in parts]) for name in ("orbit", "node", *_COLUMNS)
    )
    order = np.lexsort((columns[0], node, orbit))
    return Brackets(orbit, node, parts[0].row, parts[0].derivative, *columns).take(order)


def locate(trace: Trace, found: Brackets) -> tuple[Array, Array, Array]:
    """Shrink every bracket to its zero: the cubic's zero splits it, until it is near enough.

    Returns
    -------
    t : ndarray, shape (m,)
        Time of each zero within its step.
    w : ndarray, shape (m, 2 n_q + n_actuators)
        State and net works there.
    g : ndarray, shape (m, n_observables)
        Observables there.
    """
    m, row = len(found.orbit), found.row
    h = trace.h[found.orbit]
    tau, w = found.lower.copy(), np.full((m, trace.w.shape[2]), np.nan)
    g = np.full((m, trace.g.shape[2]), np.nan)
    active, left = np.arange(m), found
    for turn in range(LOCATE_ITERATIONS):
        if not len(active):
            break
        # A bracket that the cubics do not shrink is halved.
        guess = left.guess() if turn % 4 < 3 else 0.5 * (left.lower + left.upper)
        state, seen, slope = trace.advance(left.orbit, left.node, guess)
        tau[active], w[active], g[active] = guess, state, seen
        f = (slope if found.derivative else seen)[:, row]
        with np.errstate(divide="ignore", invalid="ignore"):
            if found.derivative:
                missing = np.abs(f * (left.upper - left.lower) / (left.f_upper - left.f_lower))
            else:
                missing = np.abs(f / slope[:, row])
        below = (f < 0) == (left.f_lower < 0)
        ends = (guess, seen[:, row], slope[:, row])
        lower = (
            np.where(below, new, old)
            for new, old in zip(ends, (left.lower, left.g_lower, left.dg_lower), strict=True)
        )
        upper = (
            np.where(below, old, new)
            for new, old in zip(ends, (left.upper, left.g_upper, left.dg_upper), strict=True)
        )
        (t0, g0, d0), (t1, g1, d1) = lower, upper
        go_on = ~(missing < LOCATE_TOLERANCE * h[active]) & (f != 0) & (t1 - t0 > 1e-9 * h[active])
        left = Brackets(left.orbit, left.node, row, found.derivative, t0, t1, g0, g1, d0, d1).take(go_on)
        active = active[go_on]
    return found.node * h + tau, w, g
