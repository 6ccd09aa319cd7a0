"""The equations of cycles of n steps in some of the parameters, with their exact derivatives.

The unknowns are x = (u, p): those of a chain of n walking steps (`solver.cycles.chain`), and the values of
the parameters that vary.
"""

from collections.abc import Hashable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.cycles.chain import Chain
from stridemap.solver.kernels.resolution import Resolution, distinct
from stridemap.solver.model.model import Model

Array = NDArray[np.float64]
Index = NDArray[np.int64]


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
        matrix, residual = linearised([self], x[None], np.array([n_rk]))
        return matrix[0], residual[0]

    def second(self, x: Array, v: Array, n_rk: int) -> Array:
        """Derivative of ``DR[v]`` with respect to x, shape (N, N + f): see the function."""
        return second([self], x[None], v[None], np.array([n_rk]))[0]

    @cached_property
    def directions(self) -> Array:
        """Changes of (u, params) of one step by 1 in each unknown, and in each parameter that varies."""
        width = self.chain.width
        columns = [width + column for column in self.columns]
        return np.eye(width + len(self.params))[[*range(width), *columns]]

    @cached_property
    def family(self) -> Hashable:
        """Equations of one family differ at most in the parameters that do not vary."""
        return id(self.chain.kernels), self.chain.n_steps, self.names, self.widths


def linearised(equations: Sequence[CycleEquations], x: Array, n_rk: Index) -> tuple[Array, Array]:
    """Derivatives of residuals with respect to x, and the residuals, each of its own equations.

    Parameters
    ----------
    equations : sequence of CycleEquations, length m
        Of one family.
    x : ndarray, shape (m, N + f)
    n_rk : ndarray of int, shape (m,)
        RK steps per walking step.

    Returns
    -------
    ndarray, shape (m, N, N + f)
    ndarray, shape (m, N)
    """
    one, m = equations[0], len(equations)
    size, count, width = one.n_unknowns, len(one.names), one.chain.width
    u, params = (np.repeat(rows, count, axis=0) for rows in (x[:, :size], points(equations, x)))
    direction = np.tile(one.directions[width:, width:], (m, 1))
    jacobian, along, residual = one.chain.jacobian_along(np.repeat(n_rk, count), u, params, direction)
    along = along.reshape(m, count, size).transpose(0, 2, 1)
    return np.concatenate([jacobian[::count], along], axis=2), residual[::count]


def residuals(equations: Sequence[CycleEquations], x: Array, n_rk: Index) -> Array:
    """Residuals alone, shape (m, N); parameters as for `linearised`."""
    one = equations[0]
    return one.chain.residual(n_rk, x[:, : one.n_unknowns], points(equations, x))


def second(equations: Sequence[CycleEquations], x: Array, v: NDArray[Any], n_rk: Index) -> NDArray[Any]:
    """Derivatives of ``DR[v]`` with respect to x, shape (m, N, N + f), for v of shape (m, N + f).

    v is real or complex. A step's residual depends on the unknowns of that step alone, but for terms that
    are linear; so one direction serves the entries of all steps that stand in the same place. Parameters as
    for `linearised`.
    """
    m = len(equations)
    if np.iscomplexobj(v):
        both = np.concatenate([v.real, v.imag])
        parts = second([*equations, *equations], np.tile(x, (2, 1)), both, np.tile(n_rk, 2))
        return parts[:m] + 1j * parts[m:]
    one = equations[0]
    n, width, size, entries = one.chain.n_steps, one.chain.width, one.n_unknowns, len(one.directions)
    params = points(equations, x)
    given = np.zeros((m, n, width + params.shape[1]))
    given[:, :, :width] = v[:, :size].reshape(m, n, width)
    given[:, :, [width + column for column in one.columns]] = v[:, None, size:]
    mixed = np.empty((m, entries, n, width))
    for level in distinct(n_rk):
        at = np.flatnonzero(n_rk == level)
        shape = (len(at), entries, n, -1)
        u, p, a = (
            np.broadcast_to(rows, shape[:3] + rows.shape[-1:]).reshape(-1, rows.shape[-1])
            for rows in (
                x[at, None, :size].reshape(len(at), 1, n, width),
                params[at, None, None, :],
                given[at, None],
            )
        )
        b = np.broadcast_to(one.directions[:, None, :], shape[:3] + a.shape[-1:]).reshape(-1, a.shape[-1])
        mixed[at] = one.chain.kernels.directional(level, u, p, a, b).mixed.reshape(shape)
    out = np.zeros((m, n, width, size + len(one.names)))
    for step in range(n):
        rows = mixed[:, :, step].transpose(0, 2, 1)
        out[:, step, :, step * width : (step + 1) * width] = rows[:, :, :width]
        out[:, step, :, size:] = rows[:, :, width:]
    return out.reshape(m, size, -1)


def points(equations: Sequence[CycleEquations], x: Array) -> Array:
    """All parameters at x, shape (m, n_params)."""
    params = np.array([one.params for one in equations])
    params[:, equations[0].columns] = x[:, equations[0].n_unknowns :]
    return params
