"""Cycles of n steps as a curve over one parameter: its equations, their exact derivatives, its tangent.

The points of the curve are x = (u, p): the unknowns of a chain of n walking steps (`solver.cycles.chain`) and
the value of the parameter that varies. They solve ``R(x) = 0``, one equation fewer than unknowns.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.backends.base import Directional
from stridemap.solver.cycles.chain import Chain
from stridemap.solver.kernels.resolution import Resolution
from stridemap.solver.linear import solved
from stridemap.solver.model.model import Model

Array = NDArray[np.float64]

CLOSED, ROUNDING = 1e-11, 1e-14
"""Residuals at which a point is on the curve if the last correction was small, and in any case."""

CORRECTED = 1e-8
"""A correction after which no other one is needed: the error left is of the order of its square."""


@dataclass(frozen=True)
class Curve:
    """Cycles of one model over one parameter.

    Parameters
    ----------
    chain : Chain
    params : ndarray, shape (n_params,)
        Values of all parameters; that of the one that varies means nothing.
    parameter : str
        Name of the parameter that varies.
    width : float
        Length of its range, by which distances along the curve are scaled.
    """

    chain: Chain
    params: Array
    parameter: str
    width: float

    @property
    def model(self) -> Model:
        """The model."""
        return self.chain.kernels.model

    @cached_property
    def column(self) -> int:
        """Column of the parameter that varies."""
        return self.model.spec.names.index(self.parameter)

    @cached_property
    def scale(self) -> Array:
        """What counts as 1 in each entry of x, shape (N + 1,)."""
        shortest, longest = self.model.period_range
        step = [*self.model.spec.scales, longest - shortest]
        return np.array([*(self.chain.n_steps**0.5 * np.tile(step, self.chain.n_steps)), self.width])

    @cached_property
    def middle(self) -> Array:
        """Middle of the search box, shape (nz,)."""
        return np.array([self.model.spec.search_box[name][0] for name in self.model.section])

    def with_steps(self, n_steps: int) -> "Curve":
        """The curve of cycles of another number of steps."""
        return Curve(Chain(self.chain.kernels, n_steps), self.params, self.parameter, self.width)

    def point(self, value: float) -> Array:
        """All parameters where the one that varies has a value, shape (n_params,)."""
        params = self.params.copy()
        params[self.column] = value
        return params

    def n_rk(self, x: Array) -> int:
        """RK steps per walking step that cycles near x need."""
        periods = x[self.chain.width - 1 : -1 : self.chain.width]
        params = np.repeat(self.point(x[-1])[None, :], len(periods), axis=0)
        return int(Resolution(self.model).cycle_n_rk(periods, params).max())

    # -- equations ---------------------------------------------------------------------------------------

    def linearised(self, x: Array, n_rk: int) -> tuple[Array, Array]:
        """Derivative of the residual with respect to x, shape (N, N + 1), and the residual, shape (N,)."""
        params = self.point(x[-1])[None, :]
        jacobian, residual = self.chain.jacobian(n_rk, x[None, :-1], params)
        direction = np.broadcast_to(self._directions[-1], (self.chain.n_steps, self._directions.shape[1]))
        along = self._directional(x, direction, direction, n_rk).along_a
        return np.column_stack([jacobian[0], along.ravel()]), residual[0]

    def second(self, x: Array, v: Array, n_rk: int) -> Array:
        """Derivative of ``DR[v]`` with respect to x, shape (N, N + 1), for v of shape (N + 1,), real or not.

        A step's residual depends on the unknowns of that step alone, but for terms that are linear; so one
        direction serves the entries of all steps that stand in the same place.
        """
        if np.iscomplexobj(v):
            return self.second(x, v.real, n_rk) + 1j * self.second(x, v.imag, n_rk)
        n, width = self.chain.n_steps, self.chain.width
        given = np.column_stack([v[:-1].reshape(n, width), np.zeros((n, len(self.params)))])
        given[:, width + self.column] = v[-1]
        entries = len(self._directions)
        mixed = self._directional(
            x, np.tile(given, (entries, 1)), np.repeat(self._directions, n, axis=0), n_rk
        ).mixed.reshape(entries, n, width)
        out = np.zeros((n, width, n * width + 1))
        for step in range(n):
            out[step, :, step * width : (step + 1) * width] = mixed[:-1, step].T
            out[step, :, -1] = mixed[-1, step]
        return out.reshape(n * width, n * width + 1)

    @cached_property
    def _directions(self) -> Array:
        """Changes of (u, params) of one step by 1 in each unknown, and in the parameter that varies."""
        width = self.chain.width
        return np.eye(width + len(self.params))[[*range(width), width + self.column]]

    def _directional(self, x: Array, a: Array, b: Array, n_rk: int) -> Directional:
        """Derivatives of the residuals of all steps in the directions `a`, `b`, which may be repeated."""
        steps = x[:-1].reshape(-1, self.chain.width)
        u = np.tile(steps, (len(a) // len(steps), 1))
        params = np.broadcast_to(self.point(x[-1]), (len(a), len(self.params)))
        return self.chain.kernels.directional(n_rk, u, params, a, b)

    # -- the curve ---------------------------------------------------------------------------------------

    def tangent(self, matrix: Array, ahead: Array) -> Array:
        """Unit tangent on the same side as `ahead`, from the derivative of the residual."""
        right = np.zeros(len(ahead))
        right[-1] = 1.0
        tangent = solved(np.vstack([matrix, ahead / self.scale**2]), right)
        return tangent / self.norm(tangent)

    def norm(self, x: Array) -> float:
        """Length in terms of the scale."""
        return float(np.sqrt(((x / self.scale) ** 2).sum()))

    def dot(self, x: Array, y: Array) -> float:
        """Scalar product in terms of the scale."""
        return float((x * y / self.scale**2).sum())

    def corrected(self, x: Array, across: Array, n_rk: int, iterations: int) -> "Corrected":
        """Newton's method from x in the plane across a direction.

        It stops where neither the residual nor the last correction can become smaller.

        Parameters
        ----------
        x : ndarray, shape (N + 1,)
        across : ndarray, shape (N + 1,)
            Normal of the plane, in terms of the scale.
        n_rk : int
        iterations : int
            Largest number of corrections.
        """
        x = x.copy()
        sizes: list[float] = []
        for _ in range(iterations + 1):
            matrix, residual = self.linearised(x, n_rk)
            error = float(np.abs(residual).max())
            if not np.isfinite(error) or not np.isfinite(matrix).all():
                break
            if error < CLOSED and ((sizes and sizes[-1] < CORRECTED) or error < ROUNDING):
                return Corrected(x, matrix, error, tuple(sizes))
            right = np.append(-residual, 0.0)
            change = solved(np.vstack([matrix, across / self.scale**2]), right)
            sizes.append(self.norm(change))
            if not np.isfinite(sizes[-1]) or (len(sizes) > 2 and sizes[-1] > sizes[-2] > CORRECTED):
                break
            x += change
        return Corrected(x, matrix, np.inf, tuple(sizes))


@dataclass(frozen=True)
class Corrected:
    """Where Newton's method ended.

    Parameters
    ----------
    x : ndarray, shape (N + 1,)
    matrix : ndarray, shape (N, N + 1)
        Derivative of the residual there.
    residual : float
        Its largest entry; infinite where it did not converge.
    sizes : tuple of float
        Lengths of the corrections, in terms of the scale.
    """

    x: Array
    matrix: Array
    residual: float
    sizes: tuple[float, ...]

    @property
    def converged(self) -> bool:
        """Whether it is a point of the curve."""
        return self.residual < np.inf
