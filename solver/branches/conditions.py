"""What makes a cycle a gait that a walker could walk: conditions that are positive where they hold.

Each is a continuous function along a branch, so that the place where a gait ends is where one of them is
zero.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.backends.base import Kernels
from stridemap.solver.kernels.resolution import distinct
from stridemap.solver.observables.events import Brackets, Trace, brackets, locate, turning_brackets
from stridemap.solver.observables.reductions import extreme

Array = NDArray[np.float64]


class GaitEnd(StrEnum):
    """How a gait ends."""

    GRAZING = "grazing"
    """The swing foot reaches the ground without speed towards it."""
    EARLY_TOUCHDOWN = "early_touchdown"
    """The swing foot touches the ground before the end of the step."""
    BACKWARD = "backward"
    """The swing foot lands where a touchdown is not admissible: beside or behind the stance foot."""
    FALL = "fall"
    """The stance leg reaches the ground."""
    CONTACT = "contact"
    """The vertical ground force reaches zero."""
    FRICTION = "friction"
    """The friction that is needed reaches the limit."""
    PERIOD_LIMIT = "period_limit"
    """The period leaves the range that counts."""


@dataclass(frozen=True)
class GaitConditions:
    """The conditions of one model.

    Parameters
    ----------
    kernels : Kernels
    friction_limit : float or None
        Largest ratio of horizontal to vertical ground force.
    period_range : (float, float) or None
        Periods of a walking step that count.
    """

    kernels: Kernels
    friction_limit: float | None = None
    period_range: tuple[float, float] | None = None

    @property
    def names(self) -> tuple[GaitEnd, ...]:
        """Which conditions there are."""
        left_out = set()
        if self.friction_limit is None:
            left_out.add(GaitEnd.FRICTION)
        if self.period_range is None:
            left_out.add(GaitEnd.PERIOD_LIMIT)
        if self.kernels.model.stance_index is None:
            left_out.add(GaitEnd.FALL)
        return tuple(name for name in GaitEnd if name not in left_out)

    def of_steps(
        self, n_rk: int, u: Array, params: Array, names: Sequence[GaitEnd] | None = None
    ) -> dict[GaitEnd, Array]:
        """Conditions on walking steps, shape (m,) each: positive where they hold.

        Parameters
        ----------
        n_rk : int
            RK steps per walking step.
        u : ndarray, shape (m, nz + 1)
            Section points and periods.
        params : ndarray, shape (m, n_params)
        names : sequence of GaitEnd, optional
            Which of them; by default all.
        """
        trace = Trace.of(self.kernels, u, params, self.kernels.trace(n_rk, u, params))
        model, n = self.kernels.model, len(self.kernels.model.coordinates)
        q, v = trace.w[:, :, :n], trace.w[:, :, n : 2 * n]

        def value(name: GaitEnd) -> Array:
            """One of the conditions."""
            if name == GaitEnd.GRAZING:
                return trace.dg[:, -1, trace.row("touchdown")]
            if name == GaitEnd.EARLY_TOUCHDOWN:
                return _inner_touchdown_margin(trace)
            if name == GaitEnd.BACKWARD:
                last = {"q": q[:, -1:], "v": v[:, -1:], "p": params[:, None, :]}
                side: Array = model.evaluate("touchdown_condition", **last)["side"]
                return -side[:, -1]
            if name == GaitEnd.CONTACT:
                return -extreme(trace, "vertical_force", np.negative)
            if name == GaitEnd.FALL:
                fallen: Array = np.abs(q[:, :, model.stance_index]).max(axis=1)
                return 0.5 * np.pi - fallen
            if name == GaitEnd.PERIOD_LIMIT:
                assert self.period_range is not None
                shortest, longest = self.period_range
                within: Array = np.minimum(u[:, -1] - shortest, longest - u[:, -1])
                return within
            assert self.friction_limit is not None
            return self.friction_limit - extreme(trace, "friction", np.absolute)

        return {name: value(name) for name in (self.names if names is None else names)}

    def of_cycles(
        self,
        n_rk: Sequence[int],
        u: Array,
        params: Array,
        n_steps: int,
        names: Sequence[GaitEnd] | None = None,
    ) -> dict[GaitEnd, Array]:
        """Conditions on cycles of several steps, shape (m,) each: those of the worst step.

        Parameters
        ----------
        n_rk : sequence of int, length m
        u : ndarray, shape (m, n_steps * (nz + 1))
        params : ndarray, shape (m, n_params)
        n_steps : int
        names : sequence of GaitEnd, optional
            Which of them; by default all.
        """
        names = self.names if names is None else names
        resolution, out = np.asarray(n_rk), {name: np.empty(len(u)) for name in names}
        for n in distinct(resolution):
            at = np.flatnonzero(resolution == n)
            steps = u[at].reshape(len(at) * n_steps, -1)
            each = self.of_steps(n, steps, np.repeat(params[at], n_steps, axis=0), names)
            for name, values in each.items():
                out[name][at] = values.reshape(len(at), n_steps).min(axis=1)
        return out


def _inner_touchdown_margin(trace: Trace) -> Array:
    """How far every step is from a touchdown before its end, shape (n,): negative where there is one.

    The foot comes near the ground at turning points within the step. Where it stays above, its height counts,
    or by how much a touchdown is not admissible there; where it does not, what counts is where it passed the
    ground on its way down, and how high it was before. Where it was not above the ground before, it is by how
    much it was not. The least over all turning points is continuous where one reaches the ground, from above
    or from below, and where one becomes admissible. It is infinite where there is no turning point.
    """
    turns = turning_brackets(trace, "touchdown")
    lowest = turns.f_lower > turns.f_upper  # maxima of the condition
    found = turns.take(lowest)
    margin = np.full(len(trace.period), np.inf)
    if not len(found.orbit):
        return margin
    time, g, side = _located(trace, found)
    each = np.maximum(-g, side)
    below = np.flatnonzero(g > 0)
    if len(below):
        passed = brackets(trace, "touchdown")
        passed = passed.take(passed.f_lower < passed.f_upper)  # on the way down
        passing, _, beside = _located(trace, passed)
        # The last passage before the turning point, of the same step; without one, the foot was there before.
        order = np.argsort(_moment(trace, passed.orbit, passing))
        moments = _moment(trace, passed.orbit, passing)[order]
        before = np.searchsorted(moments, _moment(trace, found.orbit[below], time[below])) - 1
        known = before >= 0
        known[known] = passed.orbit[order][before[known]] == found.orbit[below][known]
        # Two passages just beside the turning point show at no node: it is as admissible as they are.
        just = trace.g[found.orbit[below], found.node[below], found.row] < 0
        each[below[~just]] = np.inf
        there = below[known & ~just]
        each[there] = np.maximum(-g[there], beside[order][before[known & ~just]])
        above = np.flatnonzero(lowest)[below] - 1
        turned = (above >= 0) & (turns.orbit[above] == found.orbit[below]) & ~lowest[above]
        if turned.any():
            there = below[turned]
            when, depth, beside = _located(trace, turns.take(above[turned]))
            last = np.full(len(below), -np.inf)
            last[known] = moments[before[known]]
            # Where it hardly comes up its passages may show at no node: they are where it is highest.
            passes = just[turned] | (last[turned] > _moment(trace, found.orbit[there], when))
            highest = np.maximum(beside, -g[there])
            each[there] = np.maximum(np.where(passes & (depth <= 0), each[there], highest), depth)
    # At the ends of the step the condition is zero: a turning point there is the beginning or the end itself.
    h = trace.h[found.orbit]
    inner = (time > 1e-3 * h) & (time < trace.period[found.orbit] - 1e-3 * h)
    np.minimum.at(margin, found.orbit[inner], each[inner])
    return margin


def _located(trace: Trace, found: Brackets) -> tuple[Array, Array, Array]:
    """Times, touchdown conditions, and what is negative where a touchdown is admissible, shape (m,) each."""
    time, w, g = locate(trace, found)
    model, n = trace.kernels.model, len(trace.kernels.model.coordinates)
    p = trace.params[found.orbit]
    side = model.evaluate("touchdown_condition", q=w[:, :n], v=w[:, n : 2 * n], p=p)["side"]
    return time, g[:, found.row], side


def _moment(trace: Trace, orbit: NDArray[np.int64], time: Array) -> Array:
    """Moments of all steps in one order: by step, then by time."""
    return orbit + 0.5 * time / trace.period[orbit]
