"""A curve of solutions of one equation fewer than unknowns, and the curve of cycles over one parameter."""

from abc import ABC, abstractmethod
from collections.abc import Hashable, Sequence
from dataclasses import dataclass, replace
from typing import Self

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.branches.asking import Question
from stridemap.solver.branches.equations import CycleEquations, linearised, residuals
from stridemap.solver.cycles.chain import Chain
from stridemap.solver.linear import solved

Array = NDArray[np.float64]
Index = NDArray[np.int64]

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

    @property
    def family(self) -> Hashable:
        """What is asked of several curves of one family can be answered together."""
        return id(self)

    @classmethod
    def linearised_each(cls, curves: Sequence[Self], x: Array, n_rk: Index) -> tuple[Array, Array]:
        """The same on curves of one family, at a point of each: shapes (m, M, M + 1) and (m, M)."""
        parts = [curve.linearised(*at) for curve, *at in zip(curves, x, n_rk.tolist(), strict=True)]
        matrix, residual = zip(*parts, strict=True)
        return np.stack(matrix), np.stack(residual)

    @classmethod
    def nearly_linearised_each(
        cls, curves: Sequence[Self], x: Array, n_rk: Index, near: Array
    ) -> tuple[Array, Array]:
        """As `linearised_each`, but the derivatives may be those at points near by."""
        return cls.linearised_each(curves, x, n_rk)

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
            The derivative at a point near by, for `nearly_linearised_each`: then the one that comes with the
            result is not exact.
        """
        (found,) = Correction.answers([Correction(self, x, across, n_rk, iterations, near)])
        return found


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

    @property
    def family(self) -> Hashable:
        """Curves of one family differ at most in the parameters that do not vary."""
        return self.equations.family

    def linearised(self, x: Array, n_rk: int) -> tuple[Array, Array]:
        """Derivative of the residual with respect to x, shape (N, N + 1), and the residual, shape (N,)."""
        return self.equations.linearised(x, n_rk)

    @classmethod
    def linearised_each(cls, curves: Sequence[Self], x: Array, n_rk: Index) -> tuple[Array, Array]:
        """The same on curves of one family, at a point of each."""
        return linearised([curve.equations for curve in curves], x, n_rk)

    @classmethod
    def nearly_linearised_each(
        cls, curves: Sequence[Self], x: Array, n_rk: Index, near: Array
    ) -> tuple[Array, Array]:
        """Residuals, with the derivatives at points near by."""
        return near, residuals([curve.equations for curve in curves], x, n_rk)

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
    """

    x: Array
    matrix: Array
    residual: float

    @property
    def converged(self) -> bool:
        """Whether it is a point of the curve."""
        return self.residual < np.inf


@dataclass(frozen=True)
class Linearisation(Question[tuple[Array, Array]]):
    """Asks for a curve's derivative and F at a point: see `ZeroCurve.linearised`."""

    curve: ZeroCurve
    x: Array
    n_rk: int

    @property
    def kind(self) -> Hashable:
        """Curves of one family can be linearised together."""
        return type(self.curve), self.curve.family

    @classmethod
    def answers(cls, questions: Sequence[Self]) -> list[tuple[Array, Array]]:
        """Derivatives and F."""
        curves = [one.curve for one in questions]
        x, n_rk = np.array([one.x for one in questions]), np.array([one.n_rk for one in questions])
        return list(zip(*type(curves[0]).linearised_each(curves, x, n_rk), strict=True))


@dataclass(frozen=True)
class Correction(Question[Corrected]):
    """Asks for a point of a curve from one beside it: see `ZeroCurve.corrected`."""

    curve: ZeroCurve
    x: Array
    across: Array
    n_rk: int
    iterations: int
    near: Array | None = None

    @property
    def kind(self) -> Hashable:
        """Newton's method goes on in step for curves of one family, as long as one has not ended."""
        return type(self.curve), self.curve.family, self.iterations, self.near is None

    @classmethod
    def answers(cls, questions: Sequence[Self]) -> list[Corrected]:
        """Where Newton's method ends."""
        curves, family = [one.curve for one in questions], type(questions[0].curve)
        x, n_rk = np.array([one.x for one in questions]), np.array([one.n_rk for one in questions])
        scale = curves[0].scale
        across = np.array([one.across for one in questions]) / scale**2
        near = None if questions[0].near is None else np.array([one.near for one in questions])
        small = CORRECTED if near is None else NEARLY_CORRECTED
        matrices, residuals_ = np.empty((*x.shape[:1], x.shape[1] - 1, x.shape[1])), np.full(len(x), np.inf)
        open_, last = np.arange(len(x)), np.full(len(x), np.inf)
        for turn in range(questions[0].iterations + 1):
            some = [curves[i] for i in open_.tolist()]
            if near is None:
                matrix, residual = family.linearised_each(some, x[open_], n_rk[open_])
            else:
                matrix, residual = family.nearly_linearised_each(some, x[open_], n_rk[open_], near[open_])
            matrices[open_], error = matrix, np.abs(residual).max(axis=1)
            finite = np.isfinite(error) & np.isfinite(matrix).all(axis=(1, 2))
            done = finite & (error < CLOSED) & ((last[open_] < small) | (error < ROUNDING))
            residuals_[open_[done]] = error[done]
            rows = np.concatenate([matrix, across[open_, None]], axis=1)
            change = solved(rows, np.concatenate([-residual, np.zeros((len(open_), 1))], axis=1))
            length = np.sqrt(((change / scale) ** 2).sum(axis=1))
            go_on = finite & ~done & np.isfinite(length)
            if turn > 1:
                go_on &= ~((length > last[open_]) & (last[open_] > CORRECTED))
            open_, change = open_[go_on], change[go_on]
            if not len(open_):
                break
            x[open_] += change
            last[open_] = length[go_on]
        return [Corrected(*one) for one in zip(x, matrices, residuals_.tolist(), strict=True)]
