"""Solutions of Newton's method at one resolution: which of them are limit cycles, and what these measure."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.backends.base import Kernels
from stridemap.solver.cycles import floquet
from stridemap.solver.cycles.orbits import Orbits, column
from stridemap.solver.cycles.status import CODES, FOUND, Status
from stridemap.solver.observables.events import Trace
from stridemap.solver.observables.measures import Cycles, measured
from stridemap.solver.observables.reductions import earlier_touchdown
from stridemap.solver.options import AcceptanceOptions

Array = NDArray[np.float64]
Index = NDArray[np.int64]
Mask = NDArray[np.bool_]


@dataclass(frozen=True)
class Candidates:
    """Solutions of Newton's method at m points, and the traces of the c that closed.

    Parameters
    ----------
    options : AcceptanceOptions
    params : ndarray, shape (m, n_params)
    u : ndarray, shape (m, nz + 1)
        Section point and period.
    jacobian : ndarray, shape (m, nz + 1, nz + 1)
        Derivative of the residual.
    residual, integration_error : ndarray, shape (m,)
    closed : ndarray of bool, shape (m,)
    trace : Trace
        Of the points that closed, in their order.
    """

    options: AcceptanceOptions
    params: Array
    u: Array
    jacobian: Array
    residual: Array
    integration_error: Array
    closed: Mask
    trace: Trace

    @classmethod
    def solve(
        cls, kernels: Kernels, options: AcceptanceOptions, n_rk: int, guesses: Array, params: Array
    ) -> "Candidates":
        """Newton's method at `n_rk` RK steps from good guesses, checked at twice as many."""
        u, jacobian, closing = kernels.limit_cycle(n_rk, guesses, params)
        residual = np.abs(closing).max(axis=1)
        with np.errstate(invalid="ignore"):
            closed = np.isfinite(u).all(axis=1) & (u[:, -1] > 0) & (residual < options.max_residual)
        at = np.flatnonzero(closed)
        traced = kernels.trace(2 * n_rk, u[at], params[at])
        error = np.full(len(u), np.nan)
        error[at] = np.abs(traced.residual - closing[at]).max(axis=1)
        trace = Trace.of(kernels, u[at], params[at], traced)
        return cls(options, params, u, jacobian, residual, error, closed, trace)

    def take(self, index: Index) -> "Candidates":
        """Some of the points, in order."""
        if len(index) == len(self.u):
            return self  # traces are large
        row = np.cumsum(self.closed) - 1
        chosen = row[index[self.closed[index]]]
        return Candidates(
            self.options,
            self.params[index],
            self.u[index],
            self.jacobian[index],
            self.residual[index],
            self.integration_error[index],
            self.closed[index],
            self.trace.take(chosen),
        )

    def orbits(self, period_range: tuple[float, float]) -> Orbits:
        """All of them, in order, measured where they are limit cycles; failures carry the reason."""
        model = self.trace.kernels.model
        m, nz = len(self.u), len(model.section)
        codes = np.full(m, Status.NOT_CONVERGED.code)
        codes[self.closed] = self._verdict(period_range)
        multipliers = np.full((m, nz), np.nan + 0j)
        found = np.flatnonzero(np.isin(codes, FOUND))
        cycles = self.take(found)._cycles()
        multipliers[found] = cycles.multipliers
        measures = {
            name: column(model.measured[name], values, m, found) for name, values in measured(cycles).items()
        }
        measures["residual"][:] = self.residual
        return Orbits(model, self.params, self.u, codes, self.jacobian, multipliers, measures)

    def _verdict(self, period_range: tuple[float, float]) -> Index:
        """Codes of the statuses of the points that closed."""
        trace, model = self.trace, self.trace.kernels.model
        n = len(model.coordinates)
        q, v = trace.w[:, :, :n], trace.w[:, :, n : 2 * n]
        side = model.evaluate("touchdown_condition", q=q, v=v, p=trace.params[:, None, :])["side"]
        descending = trace.dg[:, -1, trace.row("touchdown")] > 0
        step = descending & (side[:, -1] < -self.options.standing_angle)
        if model.stance_index is not None:
            stance = q[:, :, model.stance_index]
            step &= np.abs(stance).max(axis=1, initial=0.0) < np.pi / 2
        early = earlier_touchdown(trace, side)
        inside = (trace.period > period_range[0]) & (trace.period <= period_range[1])
        accurate = self.integration_error[self.closed] < self.options.max_integration_error
        conditions = [~step, early, ~inside, accurate]
        first = np.argmax(np.stack([*conditions, np.ones_like(step)]), axis=0)
        return _VERDICTS[first]

    def _cycles(self) -> Cycles:
        """Points that are all limit cycles, to be measured."""
        return Cycles(
            self.trace.kernels.model,
            self.params,
            self.u,
            floquet.multipliers(self.jacobian),
            self.residual,
            self.integration_error,
            self.trace,
        )


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
