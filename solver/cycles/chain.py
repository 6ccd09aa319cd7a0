"""A cycle as a chain of walking steps: the unknowns, the residual and the multipliers of n steps that close.

Each step of the chain has a section point and a period of its own, so that no step is integrated from where
another one ended (multiple shooting: J. Stoer and R. Bulirsch, Introduction to Numerical Analysis, section
7.3.5). One step is the shortest chain; a chain of two closes after a left and a right step that differ.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.backends.base import Kernels, Linearised, LinearisedAlong
from stridemap.solver.cycles.floquet import sorted_eigenvalues, step_map_derivative
from stridemap.solver.linear import solved
from stridemap.solver.model.scales import Scales

Array = NDArray[np.float64]
Index = NDArray[np.int64]


@dataclass(frozen=True)
class Chain:
    """n walking steps in a row, of which the last leads back to the first.

    The unknowns are ``u = (z_1, T_1, ..., z_n, T_n)``, section points and periods; the residual is

        ( P(z_i, T_i) - z_(i+1),  h(z_i, T_i) )   for i = 1 ... n, with z_(n+1) = z_1.

    Parameters
    ----------
    kernels : Kernels
    n_steps : int
        Number of walking steps.
    """

    kernels: Kernels
    n_steps: int = 1

    @property
    def width(self) -> int:
        """Number of unknowns per step."""
        return len(self.kernels.model.section) + 1

    def residual(self, n_rk: int | Index, u: Array, p: Array) -> Array:
        """Closing errors with the touchdown conditions, shape (m, n_steps * (nz + 1)).

        Parameters
        ----------
        n_rk : int or ndarray of int, shape (m,)
            RK steps per walking step.
        u : ndarray, shape (m, n_steps * (nz + 1))
        p : ndarray, shape (m, n_params)
        """
        steps, params = self._steps(u, p)
        closing = self.kernels.residual(self._each(n_rk), steps, params)
        return (closing + self._change(steps)).reshape(len(u), -1)

    def jacobian(self, n_rk: int, u: Array, p: Array) -> Linearised:
        """Residuals with their derivatives with respect to u; parameters as for `residual`."""
        steps, params = self._steps(u, p)
        return self._whole(steps, *self.kernels.jacobian(n_rk, steps, params))

    def jacobian_along(self, n_rk: int | Index, u: Array, p: Array, d: Array) -> LinearisedAlong:
        """The same with the derivatives in directions of the parameters.

        Parameters
        ----------
        n_rk : int or ndarray of int, shape (m,)
        u : ndarray, shape (m, n_steps * (nz + 1))
        p, d : ndarray, shape (m, n_params)
        """
        steps, params = self._steps(u, p)
        jacobian, along, closing = self.kernels.jacobian_along(
            self._each(n_rk), steps, params, np.repeat(d, self.n_steps, axis=0)
        )
        whole = self._whole(steps, jacobian, closing)
        return LinearisedAlong(whole.jacobian, along.reshape(len(u), -1), whole.residual)

    def _whole(self, steps: Array, jacobian: Array, closing: Array) -> Linearised:
        """Residuals and derivatives of whole chains from those of their steps."""
        n, width, nz = self.n_steps, self.width, self.width - 1
        m = len(steps) // n
        blocks = jacobian.reshape(-1, n, width, width)
        full = np.zeros((m, n, width, n, width))
        at = np.arange(n)
        # The kernel's block is that of a step that closes by itself: its -1 belongs to the next point.
        full[:, at, :, at, :] = blocks.transpose(1, 0, 2, 3)
        if n > 1:
            full[:, at, :nz, at, :nz] += np.eye(nz)
            full[:, at, :nz, (at + 1) % n, :nz] -= np.eye(nz)
        closing = (closing + self._change(steps)).reshape(m, -1)
        return Linearised(full.reshape(m, n * width, n * width), closing)

    def newton(self, n_rk: int, u: Array, p: Array, tolerance: float = 1e-12, iterations: int = 12) -> Array:
        """Newton's method from guesses; NaN where it does not converge. Parameters as for `residual`.

        The tolerance is in terms of the model's scales.
        """
        u, done = u.copy(), np.zeros(len(u), dtype=bool)
        scale = np.tile(Scales.of(self.kernels.model).residual, self.n_steps)
        for _ in range(iterations):
            open_ = np.flatnonzero(~done & np.isfinite(u).all(axis=1))
            if not len(open_):
                break
            matrix, closing = self.jacobian(n_rk, u[open_], p[open_])
            finite = np.isfinite(matrix).all(axis=(1, 2)) & np.isfinite(closing).all(axis=1)
            u[open_[~finite]] = np.nan
            open_, matrix, closing = open_[finite], matrix[finite], closing[finite]
            done[open_] = np.abs(closing / scale).max(axis=1) < tolerance
            correct = ~done[open_]
            u[open_[correct]] -= solved(matrix[correct], closing[correct])
        u[~done] = np.nan
        return u

    def multipliers(self, jacobian: Array) -> NDArray[np.complex128]:
        """Floquet multipliers of the whole chain by falling modulus, shape (m, nz).

        Parameters
        ----------
        jacobian : ndarray, shape (m, n_steps * (nz + 1), n_steps * (nz + 1))
            As from `jacobian`.
        """
        n, width, nz = self.n_steps, self.width, self.width - 1
        blocks = jacobian.reshape(-1, n, width, n, width)
        product = np.broadcast_to(np.eye(nz), (len(jacobian), nz, nz))
        for i in range(n):
            step = blocks[:, i, :, i, :].copy()
            if n > 1:
                step[:, :nz, :nz] -= np.eye(nz)  # as `step_map_derivative` takes it
            with np.errstate(invalid="ignore"):  # of a step that has none
                product = step_map_derivative(step) @ product
        return sorted_eigenvalues(product)

    def _steps(self, u: Array, p: Array) -> tuple[Array, Array]:
        """Every step of every chain with its parameters."""
        return u.reshape(-1, self.width), np.repeat(p, self.n_steps, axis=0)

    def _each(self, n_rk: int | Index) -> int | Index:
        """The resolution of every step, where those of chains differ."""
        return np.repeat(n_rk, self.n_steps) if isinstance(n_rk, np.ndarray) else n_rk

    def _change(self, steps: Array) -> Array:
        """Section points minus the next ones: what a step that closes by itself has not got."""
        if self.n_steps == 1:
            return np.zeros((1, 1))
        points = steps.reshape(-1, self.n_steps, self.width)
        change = points - np.roll(points, -1, axis=1)
        change[:, :, -1] = 0.0  # the touchdown condition stays as it is
        return change.reshape(steps.shape)
