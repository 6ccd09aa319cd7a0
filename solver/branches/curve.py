"""A curve of solutions of one equation fewer than unknowns, and the curve of cycles over one parameter."""

from abc import ABC, abstractmethod
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.branches.equations import CycleEquations
from stridemap.solver.cycles.chain import Chain
from stridemap.solver.linear import solved

Array = NDArray[np.float64]

CLOSED, ROUNDING = 1e-11, 1e-14
"""Residuals at which a point is on the curve if the last correction was small, and in any case."""

CORRECTED, NEARLY_CORRECTED = 1e-8, 1e-11
"""A correction after which no other one is needed: the error left is of the order of its square, or with a
derivative that is not exact a small part of it."""


class ZeroCurve(ABC):
    """Solutions of ``F(x) = 0``, M equations for M + 1 unknowns, of which the last are parameters."""

    equations: CycleEquations
    """The cycles: their unknowns are the first entries of x, their parameters the last."""
    scale: Array
    """What counts as 1 in each entry of x, shape (M + 1,)."""

    @abstractmethod
    def linearised(self, x: Array, n_rk: int) -> tuple[Array, Array]:
        """Derivative of F, shape (M, M + 1), and F, shape (M,), with `n_rk` RK steps per walking step."""

    def nearly_linearised(self, x: Array, n_rk: int, near: Array) -> tuple[Array, Array]:
        """As `linearised`, but the derivative may be that at a point near x."""
        return self.linearised(x, n_rk)

    @abstractmethod
    def n_rk(self, x: Array) -> int:
        """RK steps per walking step that solutions near x need."""

    @property
    def chain(self) -> Chain:
        """The walking steps of a cycle."""
        return self.equations.chain

    def values(self, x: Array) -> Array:
        """The parameters that vary at x, shape (f,)."""
        return x[-len(self.equations.names) :]

    def beyond(self, x: Array) -> bool:
        """Whether x lies beyond an end that the equations do not show."""
        return False

    def multipliers(self, matrix: Array) -> NDArray[np.complex128]:
        """Floquet multipliers where F has a derivative, shape (nz,)."""
        size = self.equations.n_unknowns
        return self.chain.multipliers(matrix[None, :size, :size])[0]

    def tangent(self, matrix: Array, ahead: Array) -> Array:
        """Unit tangent on the same side as `ahead`, from the derivative of F."""
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

    def corrected(
        self, x: Array, across: Array, n_rk: int, iterations: int, near: Array | None = None
    ) -> "Corrected":
        """Newton's method from x in the plane across a direction.

        It stops where neither the residual nor the last correction can become smaller.

        Parameters
        ----------
        x : ndarray, shape (M + 1,)
        across : ndarray, shape (M + 1,)
            Normal of the plane, in terms of the scale.
        n_rk : int
        iterations : int
            Largest number of corrections.
        near : ndarray, shape (M, M + 1), optional
            The derivative at a point near by, for `nearly_linearised`: then the one that comes with the
            result is not exact.
        """
        x = x.copy()
        sizes: list[float] = []
        for _ in range(iterations + 1):
            if near is None:
                matrix, residual = self.linearised(x, n_rk)
            else:
                matrix, residual = self.nearly_linearised(x, n_rk, near)
            error = float(np.abs(residual).max())
            if not np.isfinite(error) or not np.isfinite(matrix).all():
                break
            small = CORRECTED if near is None else NEARLY_CORRECTED
            if error < CLOSED and ((sizes and sizes[-1] < small) or error < ROUNDING):
                return Corrected(x, matrix, error, tuple(sizes))
            right = np.append(-residual, 0.0)
            change = solved(np.vstack([matrix, across / self.scale**2]), right)
            sizes.append(self.norm(change))
            if not np.isfinite(sizes[-1]) or (len(sizes) > 2 and sizes[-1] > sizes[-2] > CORRECTED):
                break
            x += change
        return Corrected(x, matrix, np.inf, tuple(sizes))


@dataclass(frozen=True)
class Curve(ZeroCurve):
    """Cycles of one model over one parameter: x = (u, p) with ``R(x) = 0``.

    Parameters
    ----------
    equations : CycleEquations
        In one parameter.
    """

    equations: CycleEquations

    @classmethod
    def over(cls, chain: Chain, params: Array, parameter: str, width: float) -> "Curve":
        """The curve over a parameter, whose range has a width; `params` are all parameters."""
        return cls(CycleEquations(chain, params, (parameter,), (width,)))

    @property
    def scale(self) -> Array:  # type: ignore[override]
        """What counts as 1 in each entry of x, shape (N + 1,)."""
        return self.equations.scale

    @property
    def parameter(self) -> str:
        """Name of the parameter that varies."""
        return self.equations.names[0]

    def with_steps(self, n_steps: int) -> "Curve":
        """The curve of cycles of another number of steps."""
        return Curve(replace(self.equations, chain=Chain(self.chain.kernels, n_steps)))

    def linearised(self, x: Array, n_rk: int) -> tuple[Array, Array]:
        """Derivative of the residual with respect to x, shape (N, N + 1), and the residual, shape (N,)."""
        return self.equations.linearised(x, n_rk)

    def nearly_linearised(self, x: Array, n_rk: int, near: Array) -> tuple[Array, Array]:
        """The residual at x, with the derivative at a point near x."""
        size = self.equations.n_unknowns
        params = self.equations.point(x[size:])
        return near, self.chain.residual(n_rk, x[None, :size], params[None])[0]

    def second(self, x: Array, v: Array, n_rk: int) -> Array:
        """Derivative of ``DR[v]`` with respect to x, shape (N, N + 1): see `CycleEquations.second`."""
        return self.equations.second(x, v, n_rk)

    def n_rk(self, x: Array) -> int:
        """RK steps per walking step that cycles near x need."""
        return self.equations.n_rk(x)


@dataclass(frozen=True)
class Corrected:
    """Where Newton's method ended.

    Parameters
    ----------
    x : ndarray, shape (M + 1,)
    matrix : ndarray, shape (M, M + 1)
        Derivative of F there.
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
