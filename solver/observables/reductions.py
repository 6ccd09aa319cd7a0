"""From a traced step to one number per cycle: extrema in continuous time, works, counts of zeros.

Extrema include the ends of the step; the work is split at the zeros of the power.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.kernels.observation import power
from stridemap.solver.observables.events import Brackets, Trace, brackets, locate, turning_brackets

Array = NDArray[np.float64]


def extreme(trace: Trace, name: str, score: np.ufunc | None = None) -> Array:
    """Largest value of ``score(g)`` of an observable over a step, ends included, shape (n,).

    Parameters
    ----------
    trace : Trace
    name : str
        One of `observables`.
    score : numpy ufunc, optional
        ``numpy.absolute`` or ``numpy.negative``; the value itself if it is left out.
    """
    value = score or np.positive
    g, slope = trace.observable(name)
    scores = value(g)
    best = scores.max(axis=1)
    # Only a turning point next to the best nodes can beat them: generous bounds on what it can gain, first
    # one for all of an orbit.
    reach = best - trace.h * np.abs(slope).max(axis=1)
    near = ~(scores < reach[:, None])
    orbit, node = np.nonzero(near[:, :-1] | near[:, 1:])
    gain = np.maximum(np.abs(slope[orbit, node]), np.abs(slope[orbit, node + 1])) * trace.h[orbit]
    near = np.maximum(scores[orbit, node], scores[orbit, node + 1]) + gain >= best[orbit]
    turns = turning_brackets(trace, name, (orbit[near], node[near]))
    _, _, seen = locate(trace, turns)
    np.maximum.at(best, turns.orbit, value(seen[:, turns.row]))
    return best


class Works(NamedTuple):
    """Work of each motor over a step; all have the shape (n, n_motors).

    Parameters
    ----------
    absolute, positive, net : ndarray
        Integrals of the power's absolute value, of its positive part, and of itself.
    """

    absolute: Array
    positive: Array
    net: Array


def works(trace: Trace) -> Works:
    """Absolute, positive and net work of each motor over a step."""
    model = trace.kernels.model
    absolute, net = (np.zeros((len(trace.period), len(model.actuated))) for _ in range(2))
    for i, name in enumerate(model.actuated):
        absolute[:, i], net[:, i] = _work_of(trace, power(name), 2 * len(model.coordinates) + i)
    return Works(absolute, 0.5 * (absolute + net), net)


def _work_of(trace: Trace, observable: str, column: int) -> tuple[Array, Array]:
    """Absolute and net work of one motor.

    The net work is integrated with the state; between two zeros of the power its change has one sign.
    """
    kinks = brackets(trace, observable)
    _, w, _ = locate(trace, kinks)
    n = len(trace.period)
    net = trace.w[:, -1, column] - trace.w[:, 0, column]
    # Rows (orbit, work so far): start, kinks in order of time, end.
    orbit = np.concatenate([np.arange(n), kinks.orbit, np.arange(n)])
    so_far = np.concatenate([trace.w[:, 0, column], w[:, column], trace.w[:, -1, column]])
    order = np.argsort(orbit, kind="stable")
    orbit, so_far = orbit[order], so_far[order]
    same = orbit[1:] == orbit[:-1]
    pieces = np.diff(so_far)[same]
    total = np.zeros(n)
    np.add.at(total, orbit[1:][same], np.abs(pieces))
    return total, net


def count_zeros(trace: Trace, name: str, falling: NDArray[np.bool_] | None = None) -> NDArray[np.int64]:
    """Number of zeros of an observable strictly within a step, shape (n,).

    Parameters
    ----------
    trace : Trace
    name : str
        One of `observables`.
    falling : ndarray of bool, shape (n,), optional
        Whether falling or rising zeros are counted; both if it is left out.
    """
    found = brackets(trace, name)
    if falling is not None:
        found = found.take((found.f_lower > found.f_upper) == falling[found.orbit])
    return np.bincount(found.orbit, minlength=len(trace.period))


def earlier_touchdown(trace: Trace, side: Array) -> NDArray[np.bool_]:
    """Whether the swing foot touches down before the end of the step, shape (n,).

    Parameters
    ----------
    trace : Trace
    side : ndarray, shape (n, N + 1)
        Negative where a touchdown is admissible.
    """
    found = brackets(trace, "touchdown")
    rising = found.take(found.f_lower < found.f_upper)
    last = trace.w.shape[1] - 2
    rising = rising.take(~_is_the_touchdown(rising, trace, last))
    left, right = side[rising.orbit, rising.node] < 0, side[rising.orbit, rising.node + 1] < 0
    # Where the stance leg passes the vertical in the same interval, the zero itself decides.
    doubtful = np.flatnonzero(left != right)
    if len(doubtful):
        model = trace.kernels.model
        n = len(model.coordinates)
        _, w, _ = locate(trace, rising.take(doubtful))
        q, v, p = w[:, :n], w[:, n : 2 * n], trace.params[rising.orbit[doubtful]]
        right[doubtful] = model.evaluate("touchdown_condition", q=q, v=v, p=p)["side"] < 0
    return np.bincount(rising.orbit[right], minlength=len(trace.period)) > 0


def _is_the_touchdown(found: Brackets, trace: Trace, last: int) -> NDArray[np.bool_]:
    """Whether a bracket ends where the step ends: the condition is zero there but for rounding."""
    row = trace.row("touchdown")
    end_slope = np.abs(trace.dg[found.orbit, -1, row])
    near_zero = np.abs(trace.g[found.orbit, -1, row]) < 1e-6 * end_slope * trace.h[found.orbit]
    return (found.node == last) & near_zero & (found.upper == trace.h[found.orbit])
