"""Steps of any number of RK steps, chained from kernels of `BLOCK` RK steps each, on arrays of points.

A kernel is compiled per resolution, so there are few of them. Where a motion needs more RK steps than the
finest one has, such as one with a steep torque, its pieces are called one after another from here: all points
take their n-th piece at once. The arithmetic is that of the compiled kernels.
"""

from collections.abc import Mapping
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.kernels.catalogue import ADVANCE, BEGIN, END, OBSERVED_SWING, SWING, Kernel
from stridemap.solver.kernels.step_map import BLOCK
from stridemap.solver.linear import solved
from stridemap.solver.model.model import Model
from stridemap.solver.model.scales import Scales

Array = NDArray[np.float64]

ITERATIONS = 10
"""Newton steps at most."""

LAST_STEP = 1e-8
"""Newton's method ends after a step of this size, in terms of the model's scales: its error is the square."""


class Calls(Protocol):
    """Kernels that can be called on arrays of points: see `backends.base.Kernels`."""

    @property
    def model(self) -> Model:
        """The model whose kernels they are."""

    @property
    def functions(self) -> Mapping[Kernel, Any]:
        """The kernels as CasADi has them."""

    def call(self, kernel: Kernel, *inputs: Array) -> list[Array]:
        """Call a kernel at n points."""


def jacobian(kernels: Calls, n_rk: int, u: Array, p: Array) -> tuple[Array, Array]:
    """Derivatives of the residuals, as CasADi stores them, and the residuals.

    Parameters
    ----------
    kernels : Calls
    n_rk : int
        A multiple of `BLOCK`.
    u : ndarray, shape (n, nz + 1)
    p : ndarray, shape (n, n_params)
    """
    (y,) = kernels.call(BEGIN, u, p)
    h = u[:, -1] / n_rk
    for i in range(0, n_rk, BLOCK):
        (y,) = kernels.call(SWING, i / n_rk * u[:, -1], h, y, p)
    derivative, closing = kernels.call(END, y, u, p)
    return derivative, closing


def limit_cycle(kernels: Calls, n_rk: int, u: Array, p: Array) -> tuple[Array, Array, Array]:
    """Newton's method from good guesses: solutions, with derivatives and residuals there; see `jacobian`."""
    scale = Scales.of(kernels.model).unknowns
    u = u.copy()
    derivative, closing = jacobian(kernels, n_rk, u, p)
    moving: Any = np.isfinite(closing).all(axis=1) & np.isfinite(derivative).all(axis=(1, 2))
    for _ in range(ITERATIONS):
        at = np.flatnonzero(moving)
        if not len(at):
            break
        change = -solved(derivative[at].transpose(0, 2, 1), closing[at])
        moving[at] = np.isfinite(change).all(axis=1)
        at, change = at[moving[at]], change[moving[at]]
        u[at] += change
        derivative[at], closing[at] = jacobian(kernels, n_rk, u[at], p[at])
        with np.errstate(invalid="ignore"):
            moving[at] = np.abs(change / scale).max(axis=1) > LAST_STEP
        moving &= np.isfinite(closing).all(axis=1) & np.isfinite(derivative).all(axis=(1, 2))
    return u, derivative, closing


def trace(kernels: Calls, n_rk: int, u: Array, p: Array) -> tuple[Array, Array, Array, Array]:
    """States with net works, observables with their derivatives, and residuals; see `jacobian`."""
    nq = len(kernels.model.coordinates)
    (y,) = kernels.call(BEGIN, u, p)
    state = np.ascontiguousarray(y[:, 0])
    w = np.hstack([state, np.zeros((len(u), len(kernels.model.actuated)))])
    h = u[:, -1] / n_rk
    parts: list[list[Array]] = []
    for i in range(0, n_rk, BLOCK):
        w, *part = kernels.call(OBSERVED_SWING, i / n_rk * u[:, -1], h, w, p)
        parts.append(part)
    last = kernels.call(ADVANCE, u[:, -1], w, np.zeros(len(u)), p)
    parts.append([w[:, None, :], *(one[:, None, :] for one in last[1:])])
    nodes, g, dg = (np.concatenate(column, axis=1) for column in zip(*parts, strict=True))
    # The impact needs no tangents: any will do.
    ends = np.ascontiguousarray(np.concatenate([w[:, None, : 2 * nq], y[:, 1:]], axis=1))
    closing = kernels.call(END, ends, u, p)[1]
    return nodes, g, dg, closing
