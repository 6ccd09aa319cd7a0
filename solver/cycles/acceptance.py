"""Solutions of Newton's method at one resolution: which of them are limit cycles, and what these measure."""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.backends.base import Kernels, Solved
from stridemap.solver.cycles import floquet
from stridemap.solver.cycles.batches import batches
from stridemap.solver.cycles.error_bars import error_bars
from stridemap.solver.cycles.errors import COARSE, ROUNDING, Correction, size
from stridemap.solver.cycles.orbits import Orbits, column
from stridemap.solver.cycles.precise import checked
from stridemap.solver.cycles.status import CODES, FOUND, Status
from stridemap.solver.kernels.catalogue import NEARLY
from stridemap.solver.model.scales import Scales
from stridemap.solver.observables.events import Trace
from stridemap.solver.observables.measures import Cycles, measured
from stridemap.solver.observables.reductions import earlier_touchdown
from stridemap.solver.options import AcceptanceOptions

Array = NDArray[np.float64]
Index = NDArray[np.int64]
Mask = NDArray[np.bool_]


RESOLVED = 0.1
"""Change of a residual at twice the resolution, in terms of the residual itself, below which a solution that
does not close is not a matter of the resolution."""

WORTHWHILE = 4.0
"""Error of the state, in terms of what rounding makes, from which on a finer resolution lowers it."""


@dataclass(frozen=True)
class Candidates:
    """Solutions of Newton's method at m points, and the traces of the c that closed.

    Errors and residuals are in terms of the model's scales.

    Parameters
    ----------
    options : AcceptanceOptions
    n_rk : int
        RK steps with which they were solved.
    params : ndarray, shape (m, n_params)
    u : ndarray, shape (m, nz + 1)
        Section point and period.
    jacobian : ndarray, shape (m, nz + 1, nz + 1)
        Derivative of the residual.
    residual, integration_error : ndarray, shape (m,)
    correction : Correction
        What twice as many RK steps change in `u`.
    closed : ndarray of bool, shape (m,)
    trace : Trace
        Of the points that closed, in their order.
    """

    options: AcceptanceOptions
    n_rk: int
    params: Array
    u: Array
    jacobian: Array
    residual: Array
    integration_error: Array
    correction: Correction
    closed: Mask
    trace: Trace

    @classmethod
    def solve(
        cls, kernels: Kernels, options: AcceptanceOptions, n_rk: int, guesses: Array, params: Array
    ) -> "Candidates":
        """Newton's method at `n_rk` RK steps from good guesses, checked at twice as many."""
        u, jacobian, closing = kernels.limit_cycle(n_rk, guesses, params)
        unit = Scales.of(kernels.model).residual
        residual = np.abs(closing / unit).max(axis=1)
        with np.errstate(invalid="ignore"):
            closed = np.isfinite(u).all(axis=1) & (u[:, -1] > 0) & (residual < options.max_residual)
        at = np.flatnonzero(closed)
        solved = Solved(u[at], jacobian[at], closing[at])
        solved, traced, correction = checked(kernels, n_rk, solved, params[at], 0.5 * options.max_state_error)
        u[at], jacobian[at], closing[at] = solved
        residual[at] = np.abs(closing[at] / unit).max(axis=1)
        error, corrections = np.full(len(u), np.nan), Correction.unknown(*u.shape)
        error[at] = np.abs((traced.residual - closing[at]) / unit).max(axis=1)
        corrections.put(at, correction)
        trace = Trace.of(kernels, u[at], params[at], traced)
        return cls(options, n_rk, params, u, jacobian, residual, error, corrections, closed, trace)

    @property
    def kernels(self) -> Kernels:
        """What solved them."""
        return self.trace.kernels

    def excess(self) -> Array:
        """By how much the errors are above their targets, shape (m,); above 1, it is worth to refine."""
        options = self.options
        state = size(self.correction.change, Scales.of(self.kernels.model).unknowns)
        # Rounding, amplified near a fold: there is nothing to gain.
        with np.errstate(invalid="ignore"):
            state[state < WORTHWHILE * self.correction.rounding] = 0.0
        # Half of the limit: rounding and what the estimate leaves out are to have room.
        state /= 0.5 * options.max_state_error
        integration = self.integration_error / options.target_integration_error
        with np.errstate(invalid="ignore"):
            made = self.integration_error < np.minimum(self.noise(), options.max_integration_error)
        integration[made] = 0.0
        excess = np.fmax(integration, state)
        # What is not a number at twice the resolution: as far from it as can be.
        excess[self.closed & np.isnan(self.integration_error)] = 1 / options.target_integration_error
        return np.where(self.closed, excess, 0.0)

    def noise(self) -> Array:
        """What rounding makes of residuals at twice the resolution, shape (m,): no finer one lowers it."""
        made = np.abs(self.jacobian) @ np.abs(self.u)[:, :, None]
        level = ROUNDING * math.sqrt(2 * self.n_rk / COARSE)
        noise: Array = level * (made[:, :, 0] / Scales.of(self.kernels.model).residual).max(axis=1)
        return noise

    def corrected(self) -> Array:
        """Section points and periods with what twice as many RK steps change, where they change little."""
        change = self.correction.change
        with np.errstate(invalid="ignore"):
            little = size(change, Scales.of(self.kernels.model).unknowns) < NEARLY
        return np.where(little[:, None], self.u + change, self.u)

    def unresolved(self) -> Mask:
        """Which of the points nearly closed, and may close at a finer resolution, shape (m,)."""
        with np.errstate(invalid="ignore"):
            near = ~self.closed & (self.residual < NEARLY) & (self.u[:, -1] > 0)
            near &= ~(self.residual < self.noise())
        at = np.flatnonzero(near & np.isfinite(self.u).all(axis=1))
        near[:] = False
        near[at] = depends_on_resolution(self.kernels, self.n_rk, self.u[at], self.params[at])
        return near

    def take(self, index: Index) -> "Candidates":
        """Some of the points, in order."""
        if len(index) == len(self.u):
            return self  # traces are large
        row = np.cumsum(self.closed) - 1
        chosen = row[index[self.closed[index]]]
        return Candidates(
            self.options,
            self.n_rk,
            self.params[index],
            self.u[index],
            self.jacobian[index],
            self.residual[index],
            self.integration_error[index],
            self.correction.take(index),
            self.closed[index],
            self.trace.take(chosen),
        )

    def orbits(self, period_range: tuple[float, float], unresolved: Mask | None = None) -> Orbits:
        """All of them, in order, measured where they are limit cycles; failures carry the reason.

        Parameters
        ----------
        period_range : (float, float)
        unresolved : ndarray of bool, shape (m,), optional
            Those that nearly closed at the finest resolution.
        """
        model = self.kernels.model
        m, nz = len(self.u), len(model.section)
        codes = np.full(m, Status.NOT_CONVERGED.code)
        if unresolved is not None:
            codes[unresolved] = Status.UNRESOLVED.code
        codes[self.closed] = self._verdict(period_range)
        multipliers = np.full((m, nz), np.nan + 0j)
        found = np.flatnonzero(np.isin(codes, FOUND))
        cycles = self.take(found)._cycles()
        codes[found[~(cycles.state_errors < self.options.max_state_error)]] = Status.INACCURATE.code
        multipliers[found] = cycles.multipliers
        measures = {
            name: column(model.measured[name], values, m, found) for name, values in measured(cycles).items()
        }
        measures["residual"][:] = self.residual
        return Orbits(model, self.params, self.u, codes, self.jacobian, multipliers, measures)

    def _verdict(self, period_range: tuple[float, float]) -> Index:
        """Codes of the statuses of the points that closed."""
        accurate = self.integration_error[self.closed] < self.options.max_integration_error
        return verdicts(self.trace, period_range, accurate, self.options)

    def _cycles(self) -> Cycles:
        """Points that are all limit cycles, to be measured."""
        state_error, multiplier_error = error_bars(
            self.kernels, self.n_rk, self.u, self.params, self.jacobian, self.correction
        )
        return Cycles(
            self.kernels.model,
            self.params,
            self.u,
            floquet.multipliers(self.jacobian),
            self.residual,
            self.integration_error,
            state_error,
            multiplier_error,
            self.trace,
        )


def verdicts(
    trace: Trace, period_range: tuple[float, float], accurate: Mask, options: AcceptanceOptions
) -> Index:
    """Codes of the statuses of steps that belong to closed motions, shape (m,).

    Parameters
    ----------
    trace : Trace
        Of m steps.
    period_range : (float, float)
    accurate : ndarray of bool, shape (m,)
        Whose integration error is small enough.
    options : AcceptanceOptions
    """
    model = trace.kernels.model
    n = len(model.coordinates)
    q, v = trace.w[:, :, :n], trace.w[:, :, n : 2 * n]
    side = model.evaluate("touchdown_condition", q=q, v=v, p=trace.params[:, None, :])["side"]
    descending = trace.dg[:, -1, trace.row("touchdown")] > 0
    step = descending & (side[:, -1] < -options.standing_angle * Scales.of(model).side)
    if model.stance_index is not None:
        stance = q[:, :, model.stance_index]
        step &= np.abs(stance).max(axis=1, initial=0.0) < np.pi / 2
    early = earlier_touchdown(trace, side)
    inside = (trace.period > period_range[0]) & (trace.period <= period_range[1])
    first = np.argmax(np.stack([~step, early, ~inside, accurate, np.ones_like(step)]), axis=0)
    return _VERDICTS[first]


def clearly_no_gaits(kernels: Kernels, n_rk: int, u: Array, params: Array) -> Index:
    """Codes of the statuses of rough solutions that are clearly not gaits, shape (m,); `DOUBTFUL` for others.

    Parameters
    ----------
    kernels : Kernels
    n_rk : int
        RK steps with which they are looked at.
    u : ndarray, shape (m, nz + 1)
    params : ndarray, shape (m, n_params)
    """
    parts = [_clearly(kernels, n_rk, u[at], params[at]) for at in batches(np.arange(len(u)), n_rk)]
    return np.concatenate([np.empty(0, dtype=np.int64), *parts])


def _clearly(kernels: Kernels, n_rk: int, u: Array, params: Array) -> Index:
    """What `clearly_no_gaits` says of so many as fit into memory."""
    model, scales = kernels.model, Scales.of(kernels.model)
    trace = Trace.of(kernels, u, params, kernels.trace(n_rk, u, params))
    n = len(model.coordinates)
    q, v = trace.w[:, :, :n], trace.w[:, :, n : 2 * n]
    side = model.evaluate("touchdown_condition", q=q, v=v, p=params[:, None, :])["side"] / scales.side
    height = -trace.observable("touchdown")[0] / scales.touchdown
    out = np.full(len(u), DOUBTFUL)
    # The foot passes the ground from above, and stays below it for a while, before the end of the step.
    ahead = (side[:, :-3] < -CLEARLY) & (side[:, 1:-2] < -CLEARLY)
    passes = ahead & (height[:, :-3] > 0) & (height[:, 1:-2] <= 0)
    deep = np.minimum(height[:, 1:-2], height[:, 2:-1]) < -DEEP
    out[(passes & deep).any(axis=1)] = Status.LATER_TOUCHDOWN.code
    rate = trace.dg[:, -1, trace.row("touchdown")] * scales.time / scales.touchdown
    falls = (side[:, -1] > CLEARLY) | (rate < -CLEARLY)
    if model.stance_index is not None:
        falls |= np.abs(q[:, :, model.stance_index]).max(axis=1) > np.pi / 2 + CLEARLY
    out[falls] = Status.NOT_A_STEP.code
    return out


DOUBTFUL = -1
"""Of a rough solution that may be a gait."""

CLEARLY = DEEP = 1e-3
"""By how much a rough solution must miss the conditions of a gait, in terms of the scales, not to be one, and
how far below the ground its foot must be. Its own error is a hundredth of that."""


def depends_on_resolution(kernels: Kernels, n_rk: int, u: Array, params: Array) -> Mask:
    """Whether the residual at points is much of the integration's making, shape (m,).

    Parameters
    ----------
    kernels : Kernels
    n_rk : int
        It is compared with that at twice as many RK steps.
    u : ndarray, shape (m, nz + 1)
    params : ndarray, shape (m, n_params)
    """
    scale = Scales.of(kernels.model).residual
    coarse, fine = (kernels.residual(n, u, params) / scale for n in (n_rk, 2 * n_rk))
    change, left = np.abs(fine - coarse).max(axis=1), np.abs(coarse).max(axis=1)
    return ~(change < RESOLVED * left) & ~(change < 1e-13)


_VERDICTS = np.array(
    [
        CODES[status]
        for status in (
            Status.NOT_A_STEP,
            Status.LATER_TOUCHDOWN,
            Status.OUT_OF_RANGE,
            Status.CONVERGED,
            Status.INACCURATE,
        )
    ]
)
"""In the order of the conditions that decide."""
