"""The equations of cycles of n steps in some of the parameters, with their exact derivatives.

The unknowns are x = (u, p): those of a chain of n walking steps (`solver.cycles.chain`), and the values of
the parameters that vary.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.backends.base import Directional
from stridemap.solver.cycles.chain import Chain
from stridemap.solver.kernels.resolution import Resolution
from stridemap.solver.model.model import Model

Array = NDArray[np.float64]


@dataclass(frozen=True)
class CycleEquations:
    """Closing errors and touchdown conditions R(x) of cycles of one model.

    Parameters
    ----------
    chain : Chain
    params : ndarray, shape (n_params,)
        Values of all parameters; those of the ones that vary mean nothing.
    names : tuple of str, length f
        The parameters that vary.
    widths : tuple of float, length f
        Lengths of their ranges, by which distances are scaled.
    """

    chain: Chain
    params: Array
    names: tuple[str, ...]
    widths: tuple[float, ...]

    @property
    def model(self) -> Model:
        """The model."""
        return self.chain.kernels.model

    @property
    def n_unknowns(self) -> int:
        """Number N of unknowns of the chain."""
        return self.chain.n_steps * self.chain.width

    @cached_property
    def columns(self) -> list[int]:
        """Columns of the parameters that vary."""
        return [self.model.spec.names.index(name) for name in self.names]

    @cached_property
    def scale(self) -> Array:
        """What counts as 1 in each entry of x, shape (N + f,)."""
        shortest, longest = self.model.period_range
        step = [*self.model.spec.scales, longest - shortest]
        n = self.chain.n_steps
        return np.array([*(n**0.5 * np.tile(step, n)), *self.widths])

    def point(self, values: Array | float) -> Array:
        """All parameters where those that vary have values, shape (n_params,)."""
        params = self.params.copy()
        params[self.columns] = values
        return params

    def steps(self, x: Array) -> Array:
        """Section point and period of each step, shape (n, nz + 1)."""
        return x[: self.n_unknowns].reshape(self.chain.n_steps, self.chain.width)

    def n_rk(self, x: Array) -> int:
        """RK steps per walking step that cycles near x need."""
        periods = self.steps(x)[:, -1]
        params = np.repeat(self.point(x[self.n_unknowns :])[None, :], len(periods), axis=0)
        return int(Resolution(self.model).cycle_n_rk(periods, params).max())

    def linearised(self, x: Array, n_rk: int) -> tuple[Array, Array]:
        """Derivative of the residual with respect to x, shape (N, N + f), and the residual, shape (N,)."""
        count = len(self.names)
        u = np.broadcast_to(x[: self.n_unknowns], (count, self.n_unknowns))
        params = np.broadcast_to(self.point(x[self.n_unknowns :]), (count, len(self.params)))
        direction = self._directions[self.chain.width :, self.chain.width :]
        jacobian, along, residual = self.chain.jacobian_along(n_rk, u, params, direction)
        return np.column_stack([jacobian[0], along.T]), residual[0]

    def second(self, x: Array, v: Array, n_rk: int) -> Array:
        """Derivative of ``DR[v]`` with respect to x, shape (N, N + f), for v of shape (N + f,), real or not.

        A step's residual depends on the unknowns of that step alone, but for terms that are linear; so one
        direction serves the entries of all steps that stand in the same place.
        """
        if np.iscomplexobj(v):
            return self.second(x, v.real, n_rk) + 1j * self.second(x, v.imag, n_rk)
        n, width, size = self.chain.n_steps, self.chain.width, self.n_unknowns
        given = np.column_stack([self.steps(v), np.zeros((n, len(self.params)))])
        given[:, [width + column for column in self.columns]] = v[size:]
        entries = len(self._directions)
        mixed = self._directional(
            x, np.tile(given, (entries, 1)), np.repeat(self._directions, n, axis=0), n_rk
        ).mixed.reshape(entries, n, width)
        out = np.zeros((n, width, size + len(self.names)))
        for step in range(n):
            out[step, :, step * width : (step + 1) * width] = mixed[:width, step].T
            out[step, :, size:] = mixed[width:, step].T
        return out.reshape(size, -1)

    @cached_property
    def _directions(self) -> Array:
        """Changes of (u, params) of one step by 1 in each unknown, and in each parameter that varies."""
        width = self.chain.width
        columns = [width + column for column in self.columns]
        return np.eye(width + len(self.params))[[*range(width), *columns]]

    def _directional(self, x: Array, a: Array, b: Array, n_rk: int) -> Directional:
        """Derivatives of the residuals of all steps in the directions `a`, `b`, which may be repeated."""
        steps = self.steps(x)
        u = np.tile(steps, (len(a) // len(steps), 1))
        params = np.broadcast_to(self.point(x[self.n_unknowns :]), (len(a), len(self.params)))
        return self.chain.kernels.directional(n_rk, u, params, a, b)
