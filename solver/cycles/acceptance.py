"""Points solved at one resolution: acceptance, multipliers and measures, as orbits."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.backends.library import Kernels
from stridemap.solver.cycles import floquet
from stridemap.solver.cycles.orbit import Orbit, Status, group_letter
from stridemap.solver.model.model import Model
from stridemap.solver.observables import measures
from stridemap.solver.observables.events import Trace

Array = NDArray[np.float64]
Index = NDArray[np.int64]
Mask = NDArray[np.bool_]

RESIDUAL_LIMIT = 1e-11
INTEGRATION_LIMIT = 1e-9
INTEGRATION_TARGET = 1e-11
"""Orbits are refined until the integration error is below the target; one that stays above the limit is
marked. The target is lower, because near a fold the cycle amplifies it."""
STANDING = 1e-6
"""Stance angle at touchdown that is nothing but a walker standing still, which closes with any period."""


@dataclass(frozen=True)
class Batch:
    """Solutions of Newton's method at m points, and the traces of the c that closed.

    Parameters
    ----------
    model : Model
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

    model: Model
    params: Array
    u: Array
    jacobian: Array
    residual: Array
    integration_error: Array
    closed: Mask
    trace: Trace

    @classmethod
    def solve(cls, model: Model, kernels: Kernels, steps: int, guesses: Array, params: Array) -> "Batch":
        """Newton's method at `steps` Runge-Kutta steps from good guesses, checked at twice as many."""
        u, jacobian, closing = kernels(f"limit_cycle_{steps}", guesses, params)
        residual = np.abs(closing).max(axis=1)
        with np.errstate(invalid="ignore"):
            closed = np.isfinite(u).all(axis=1) & (u[:, -1] > 0) & (residual < RESIDUAL_LIMIT)
        at = np.flatnonzero(closed)
        w, g, dg, fine = kernels(f"trace_{2 * steps}", u[at], params[at])
        error = np.full(len(u), np.nan)
        error[at] = np.abs(fine - closing[at]).max(axis=1)
        trace = Trace(kernels, params[at], u[at, -1], w, g, dg)
        # A matrix comes column by column.
        return cls(model, params, u, jacobian.transpose(0, 2, 1), residual, error, closed, trace)

    def take(self, index: Index) -> "Batch":
        """Some of the points, in order."""
        if len(index) == len(self.u):
            return self  # traces are large
        row = np.cumsum(self.closed) - 1
        chosen = row[index[self.closed[index]]]
        return Batch(
            self.model,
            self.params[index],
            self.u[index],
            self.jacobian[index],
            self.residual[index],
            self.integration_error[index],
            self.closed[index],
            self.trace.take(chosen),
        )

    def orbits(self, period_range: tuple[float, float]) -> list[Orbit]:
        """An orbit a point; those that are none carry the reason."""
        verdicts = iter(self._verdict(period_range))
        status = [next(verdicts) if closed else Status.NOT_CONVERGED for closed in self.closed]
        found = np.flatnonzero([s.found for s in status])
        rows = iter(self.take(found)._measured())
        names = self.model.preset
        out = []
        for i, outcome in enumerate(status):
            values = next(rows) if outcome.found else {"residual": float(self.residual[i])}
            out.append(
                Orbit(
                    self.model.source,
                    dict(zip(names, self.params[i].tolist(), strict=True)),
                    outcome,
                    **values,
                )
            )
        return out

    def _verdict(self, period_range: tuple[float, float]) -> list[Status]:
        """Status of the points that closed."""
        trace, n = self.trace, len(self.model.coordinates)
        q, v = trace.w[:, :, :n], trace.w[:, :, n : 2 * n]
        side = self.model.evaluate("touchdown_condition", q=q, v=v, p=trace.params[:, None, :])["side"]
        descending = trace.dg[:, -1, trace.row("touchdown")] > 0
        step = descending & (side[:, -1] < -STANDING)
        if (stance_index := self.model.stance_index) is not None:
            stance = q[:, :, stance_index]
            step &= np.abs(stance).max(axis=1, initial=0.0) < np.pi / 2
        early = measures.earlier_touchdown(trace, side)
        inside = (trace.period > period_range[0]) & (trace.period <= period_range[1])
        accurate = self.integration_error[self.closed] < INTEGRATION_LIMIT
        conditions = [~step, early, ~inside, accurate]
        first = np.argmax(np.stack([*conditions, np.ones_like(step)]), axis=0)
        verdicts = (
            Status.NOT_A_STEP,
            Status.LATER_TOUCHDOWN,
            Status.OUT_OF_RANGE,
            Status.CONVERGED,
            Status.INACCURATE,
        )
        return [verdicts[i] for i in first]

    def _measured(self) -> list[dict[str, Any]]:
        """Arguments of `Orbit` for points that are all limit cycles."""
        model, trace, period = self.model, self.trace, self.u[:, -1]
        values = floquet.multipliers(self.jacobian)
        radius = np.abs(values).max(axis=1, initial=0.0)
        total, positive, net = measures.work(trace)
        start = model.evaluate("section_state", z=self.u[:, :-1], p=self.params)
        length = model.evaluate("step_length", **start, p=self.params)["length"]
        load = model.evaluate("total_mass", p=self.params)
        weight = load["weight"]
        # Down a slope gravity supplies energy; what it takes uphill is the actuators' to supply.
        energy = total + np.maximum(load["pull"], 0.0) * length
        lowest = -measures.extreme(trace, "vertical_force", np.negative)
        columns = {
            "period": period,
            "spectral_radius": radius,
            "stable": radius < 1.0,
            "step_length": length,
            "speed": length / period,
            # Without contact there is no zero moment point: it runs to infinity where the force vanishes.
            "d_max": np.where(lowest > 0, measures.extreme(trace, "d", np.absolute), np.nan),
            "work": total,
            "work_positive": positive,
            "work_net": net,
            "cot": energy / (weight * length),
            "cot_per_speed": energy * period / (weight * length),
            "min_vertical_force": lowest,
            "friction": np.where(lowest > 0, measures.extreme(trace, "friction", np.absolute), np.nan),
            "clearance": -measures.extreme(trace, "foot_height", np.negative),
            "peaks": measures.count_zeros(trace, "peak", falling_only=True),
            "residual": self.residual,
            "integration_error": self.integration_error,
        }
        if model.spec.wobbling:
            columns["x_zero_crossings"] = measures.count_zeros(trace, "wobble")
        rows = [
            dict(zip(columns, row, strict=True))
            for row in zip(*(c.tolist() for c in columns.values()), strict=True)
        ]
        for i, row in enumerate(rows):
            row["state"] = dict(zip(model.section, self.u[i, :-1].tolist(), strict=True))
            row["multipliers"] = tuple(values[i].tolist())
        if "spring_mode" in model.spec.functions:
            frequency = model.evaluate("spring_mode", p=self.params)["frequency"]
            for row, turns in zip(rows, frequency * period / (2 * np.pi), strict=True):
                row["group"] = group_letter(int(turns))
        return rows
