"""Limit cycles from guesses, on arrays of points: Newton, acceptance, multipliers, measures."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.backends.library import Kernels, load_kernels
from stridemap.solver.cycles.acceptance import INTEGRATION_TARGET, Batch
from stridemap.solver.cycles.orbit import Orbit
from stridemap.solver.kernels.catalogue import CYCLE_STEPS, SEARCH_STEPS
from stridemap.solver.kernels.runge_kutta import ORDER
from stridemap.solver.model.model import Model

Array = NDArray[np.float64]

SEARCH_RESIDUAL = 1e-4
"""What a search may leave open for Newton's method at full resolution."""

SEARCH_PHASE, CYCLE_PHASE = 1.5, 0.45
"""Phase of the fastest mode in one Runge-Kutta step at most. A search needs only to come near; but at twice
its phase, sweeps were seen to lose cycles with a stiff spring."""


@dataclass(frozen=True)
class Solver:
    """Finds limit cycles of one model.

    Parameters
    ----------
    model : Model
    kernels : Kernels
    """

    model: Model
    kernels: Kernels

    @classmethod
    def of(cls, model: Model) -> "Solver":
        """The solver of a model with its compiled kernels."""
        return cls(model, load_kernels(model))

    # -- resolution --------------------------------------------------------------------------------------

    def fastest_mode(self, params: Array) -> Array:
        """Largest modulus of an eigenvalue of the swing phase linearised upright at rest, shape (n,)."""
        unique, inverse = np.unique(params, axis=0, return_inverse=True)
        n = len(self.model.coordinates)
        rest = {"t": 0.0, "q": np.zeros(n), "v": np.zeros(n), "p": unique}
        dv_dq = self.model.evaluate("state_derivative_dq", **rest)["dv_dq"]
        dv_dv = self.model.evaluate("state_derivative_dv", **rest)["dv_dv"]
        kinematics = np.broadcast_to(np.eye(n, 2 * n, n), (len(unique), n, 2 * n))
        linear = np.concatenate([kinematics, np.concatenate([dv_dq, dv_dv], axis=2)], axis=1)
        # Beyond the range of numbers: any resolution will do, Newton's method fails at each.
        modes = np.full(len(unique), np.inf)
        finite = np.isfinite(linear).all(axis=(1, 2))
        modes[finite] = np.abs(np.linalg.eigvals(linear[finite])).max(axis=1)
        return modes[inverse.ravel()]

    def _phase(self, period: Array, params: Array) -> Array:
        """Phase of the fastest mode in a period; 0 for a period that is none, which no resolution helps."""
        with np.errstate(over="ignore", invalid="ignore"):
            phase: Array = self.fastest_mode(params) * np.abs(period)
        return np.nan_to_num(phase, posinf=0.0)

    @staticmethod
    def _resolution(phase: Array, choices: tuple[int, ...], per_step: float) -> NDArray[np.int64]:
        """Fewest Runge-Kutta steps of at most `per_step` of the fastest mode's phase each."""
        index = np.searchsorted(np.array(choices) * per_step, phase)
        return np.array(choices)[np.minimum(index, len(choices) - 1)]

    def cycle_steps(self, period: Array, params: Array) -> NDArray[np.int64]:
        """Runge-Kutta steps with which limit cycles of these periods are first computed, shape (n,)."""
        return self._resolution(self._phase(period, params), CYCLE_STEPS, per_step=CYCLE_PHASE)

    def search_steps(self, period: Array, params: Array) -> NDArray[np.int64]:
        """Runge-Kutta steps of a search near a period, shape (n,)."""
        return self._resolution(self._phase(period, params), SEARCH_STEPS, per_step=SEARCH_PHASE)

    # -- search ------------------------------------------------------------------------------------------

    def search(self, guesses: Array, params: Array) -> tuple[Array, NDArray[np.bool_]]:
        """Newton's method from rough guesses.

        Parameters
        ----------
        guesses : ndarray, shape (n, nz + 1)
            Section point and period.
        params : ndarray, shape (n, n_params)

        Returns
        -------
        u : ndarray, shape (n, nz + 1)
        closed : ndarray of bool, shape (n,)
            Whether Newton's method arrived at what can be a step, and not at a walker that hangs, goes
            backwards or turns over.
        """
        u = np.full(guesses.shape, np.nan)
        closed = np.zeros(len(guesses), dtype=bool)
        steps = self.search_steps(guesses[:, -1], params)
        for n in np.unique(steps):
            at = np.flatnonzero(steps == n)
            u[at], residual = self.kernels(f"search_{n}", guesses[at], params[at])
            closed[at] = np.abs(residual).max(axis=1) < SEARCH_RESIDUAL
        with np.errstate(invalid="ignore"):
            closed &= np.isfinite(u).all(axis=1) & (u[:, -1] > 0)
        u = self.model.wrapped(u)
        closed[closed] = self._can_be_a_step(u[closed], params[closed])
        return u, closed

    def _can_be_a_step(self, u: Array, params: Array) -> NDArray[np.bool_]:
        """Whether the swing foot lands on the admissible side, with the stance leg above the ground."""
        after = self.model.evaluate("section_state", z=u[:, :-1], p=params)
        before = self.model.evaluate("before_touchdown", q=after["q"], p=params)["q_minus"]
        side = self.model.evaluate("touchdown_condition", q=before, v=after["v"], p=params)["side"]
        can: NDArray[np.bool_] = side < 0
        if (stance_index := self.model.stance_index) is not None:
            can &= np.abs(before[:, stance_index]) < np.pi / 2
        return can

    # -- completion --------------------------------------------------------------------------------------

    def complete(self, guesses: Array, params: Array, period_range: tuple[float, float]) -> list[Orbit]:
        """Orbits from good guesses, with everything that is measured; failures carry their reason.

        Parameters
        ----------
        guesses : ndarray, shape (n, nz + 1)
        params : ndarray, shape (n, n_params)
        period_range : (float, float)
            Periods outside are marked `Status.OUT_OF_RANGE`.

        Returns
        -------
        list of Orbit, length n
        """
        orbits: list[Orbit | None] = [None] * len(guesses)
        u = guesses.copy()
        steps = self.cycle_steps(u[:, -1], params)
        for n in CYCLE_STEPS:
            at = np.flatnonzero(steps == n)
            if not len(at):
                continue
            batch = Batch.solve(self.model, self.kernels, n, u[at], params[at])
            refine = batch.closed & ~(batch.integration_error <= INTEGRATION_TARGET)
            if n < CYCLE_STEPS[-1]:
                # The error falls with the order's power of the resolution: go where it will be small enough.
                error = np.nan_to_num(batch.integration_error[refine], nan=1.0)
                finer = n * np.maximum(1.1 * (error / INTEGRATION_TARGET) ** (1 / ORDER), 1.01)
                steps[at[refine]] = self._resolution(finer, CYCLE_STEPS, per_step=1.0)
                u[at[refine]] = batch.u[refine]
            else:
                refine[:] = False
            done = np.flatnonzero(~refine)
            for i, orbit in zip(at[done], batch.take(done).orbits(period_range), strict=True):
                orbits[i] = orbit
        return [orbit for orbit in orbits if orbit is not None]
