"""Curves in the plane of two parameters: a bifurcation, or an end of gaits, of every cycle on them.

Every system is ``R(u, p) = 0`` of `solver.branches.equations` with one equation more, so that its solutions
are a curve, which `solver.branches.arclength` follows like a branch. With M(lambda) as in
`solver.branches.bordered`, lambda is a multiplier where the smallest singular value of M is zero; bordered by
its own singular vectors psi and w, the equation is

    g = -sigma,    dg = -psi' dM w,

which is the minimally augmented system with the borders renewed at every point (W. Govaerts, Numerical
Methods for Bifurcations of Dynamical Equilibria, 2000, chapters 4 and 8).
"""

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.branches.bordered import wrap
from stridemap.solver.branches.conditions import GaitConditions, GaitEnd
from stridemap.solver.branches.curve import ZeroCurve
from stridemap.solver.branches.equations import CycleEquations
from stridemap.solver.kernels.catalogue import CYCLE_N_RK

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]


@dataclass(frozen=True)
class Null:
    """Null vectors of M(lambda) at a point, and the equation that says that lambda is a multiplier.

    Parameters
    ----------
    matrix : ndarray, shape (N, N + f)
        Derivative of the cycle's equations.
    residual : ndarray, shape (N,)
    w : ndarray, shape (N,)
        Right null vector, of length 1 in terms of the scale.
    psi : ndarray, shape (N,)
        Left null vector, of length 1.
    g : float
    gradient : ndarray, shape (N + f,)
        Of g: real, or complex where lambda is.
    """

    matrix: Array
    residual: Array
    w: NDArray[Any]
    psi: NDArray[Any]
    g: float
    gradient: NDArray[Any]

    @classmethod
    def at(cls, equations: CycleEquations, x: Array, n_rk: int, multiplier: complex) -> "Null":
        """The null vectors for a multiplier at x, shape (N + f,), with `n_rk` RK steps per walking step.

        They are NaN where the cycle's equations are.
        """
        matrix, residual = equations.linearised(x, n_rk)
        size = equations.n_unknowns
        weave = wrap(equations)
        singular = (matrix[:, :size] + (1.0 - multiplier) * weave) * equations.scale[:size]
        if not np.isfinite(singular).all():
            nothing = np.full(size, np.nan)
            return cls(matrix, residual, nothing, nothing, np.nan, np.full(len(x), np.nan))
        left, values, right = np.linalg.svd(singular)
        psi, w = left[:, -1].conj(), right[-1].conj() * equations.scale[:size]
        along = np.append(w, np.zeros(len(equations.names)))
        return cls(matrix, residual, w, psi, -float(values[-1]), -psi @ equations.second(x, along, n_rk))

    def like(self, other: "Null") -> "Null":
        """The same with the vectors' signs chosen as those of another one nearby; real vectors only."""
        w = self.w if self.w @ other.w >= 0 else -self.w
        psi = self.psi if self.psi @ other.psi >= 0 else -self.psi
        return Null(self.matrix, self.residual, w, psi, self.g, self.gradient)


class BoundaryCurve(ZeroCurve):
    """A curve in the plane of two parameters."""

    def n_rk(self, x: Array) -> int:
        """Twice the RK steps per walking step that cycles near x need: second derivatives need more."""
        return min(2 * self.equations.n_rk(self.cycle(x)), CYCLE_N_RK[-1])

    def cycle(self, x: Array) -> Array:
        """Unknowns of the cycle and parameters at a point, shape (N + 2,)."""
        return x

    def at(self, cycle: Array, multipliers: Complex) -> Array | None:
        """Unknowns of this curve for those of a cycle near it; None where it cannot be near."""
        return cycle

    def others(self, x: Array, multipliers: Complex) -> Complex:
        """The multipliers without those that the curve holds on the unit circle."""
        return multipliers


@dataclass(frozen=True)
class MultiplierBoundary(BoundaryCurve):
    """Cycles with a real multiplier: folds have 1, doublings have -1.

    Parameters
    ----------
    equations : CycleEquations
        In two parameters.
    multiplier : {1.0, -1.0}
    """

    equations: CycleEquations
    multiplier: float

    @property
    def scale(self) -> Array:  # type: ignore[override]
        """What counts as 1 in each entry of x = (u, p), shape (N + 2,)."""
        return self.equations.scale

    def others(self, x: Array, multipliers: Complex) -> Complex:
        """The multipliers without that of the curve."""
        return np.delete(multipliers, np.abs(multipliers - self.multiplier).argmin())

    def linearised(self, x: Array, n_rk: int) -> tuple[Array, Array]:
        """Derivative, shape (N + 1, N + 2), and values, shape (N + 1,), of the equations."""
        null = Null.at(self.equations, x, n_rk, self.multiplier)
        return np.vstack([null.matrix, null.gradient]), np.append(null.residual, null.g)


@dataclass(frozen=True)
class TorusBoundary(BoundaryCurve):
    """Cycles with a pair of multipliers exp(+-i theta): x = (u, theta, p).

    It ends where theta is 0 or pi: at a resonance 1:1 or 1:2, beyond which the pair is real.

    Parameters
    ----------
    equations : CycleEquations
        In two parameters.
    """

    equations: CycleEquations

    @cached_property
    def scale(self) -> Array:  # type: ignore[override]
        """What counts as 1 in each entry of x, shape (N + 3,)."""
        return np.insert(self.equations.scale, self.equations.n_unknowns, np.pi)

    def cycle(self, x: Array) -> Array:
        """Unknowns of the cycle and parameters at a point, shape (N + 2,)."""
        return np.delete(x, self.equations.n_unknowns)

    def angle(self, x: Array) -> float:
        """The angle theta at a point."""
        return float(x[self.equations.n_unknowns])

    def at(self, cycle: Array, multipliers: Complex) -> Array | None:
        """Unknowns of this curve for those of a cycle near it; None where its multipliers are real."""
        pairs = multipliers[multipliers.imag > 0]
        if not len(pairs):
            return None
        theta = np.angle(pairs[np.abs(np.abs(pairs) - 1.0).argmin()])
        return np.insert(cycle, self.equations.n_unknowns, theta)

    def beyond(self, x: Array) -> bool:
        """Whether the angle has left the range from 0 to pi: from there on, the mirrored curve comes back."""
        return not 0.0 < self.angle(x) < np.pi

    def others(self, x: Array, multipliers: Complex) -> Complex:
        """The multipliers without the pair of the curve."""
        left = multipliers
        for one in np.exp(1j * self.angle(x) * np.array([1, -1])):  # which may both be near one multiplier
            left = np.delete(left, np.abs(left - one).argmin())
        return left

    def linearised(self, x: Array, n_rk: int) -> tuple[Array, Array]:
        """Derivative, shape (N + 2, N + 3), and values, shape (N + 2,), of the equations.

        The imaginary part is divided by sin theta, so that it stays regular towards the ends.
        """
        theta, size = self.angle(x), self.equations.n_unknowns
        root, sine = np.exp(1j * theta), np.sin(theta) or np.nan  # no solution: a shorter step is tried
        null = Null.at(self.equations, self.cycle(x), n_rk, root)
        turn = null.psi @ (1j * root * wrap(self.equations)) @ null.w
        gradient = np.insert(null.gradient.astype(np.complex128), size, turn)
        rows = np.vstack([np.insert(null.matrix, size, 0.0, axis=1), gradient.real, gradient.imag / sine])
        return rows, np.array([*null.residual, null.g, 0.0])


@dataclass(frozen=True)
class EndBoundary(BoundaryCurve):
    """Cycles at which one of the conditions of a gait is zero.

    The condition's derivative comes from differences: only the speed of Newton's method depends on it, not
    what it converges to.

    Parameters
    ----------
    equations : CycleEquations
        In two parameters.
    conditions : GaitConditions
    name : GaitEnd
    """

    equations: CycleEquations
    conditions: GaitConditions
    name: GaitEnd

    @property
    def scale(self) -> Array:  # type: ignore[override]
        """What counts as 1 in each entry of x = (u, p), shape (N + 2,)."""
        return self.equations.scale

    def condition(self, x: Array, n_rk: int) -> Array:
        """The condition at points, shape (m,), for x of shape (m, N + 2)."""
        size = self.equations.n_unknowns
        params = np.array([self.equations.point(values) for values in x[:, size:]])
        n = [min(2 * n_rk, 2 * CYCLE_N_RK[-1])] * len(x)
        return self.conditions.of_cycles(n, x[:, :size], params, self.chain.n_steps, [self.name])[self.name]

    def linearised(self, x: Array, n_rk: int) -> tuple[Array, Array]:
        """Derivative, shape (N + 1, N + 2), and values, shape (N + 1,), of the equations."""
        matrix, residual = self.equations.linearised(x, n_rk)
        steps = np.diag(DIFFERENCE * self.scale)
        values = self.condition(np.vstack([x, x + steps, x - steps]), n_rk)
        ahead, behind = np.split(values[1:], 2)
        gradient = (ahead - behind) / (2 * DIFFERENCE * self.scale)
        return np.vstack([matrix, gradient]), np.append(residual, values[0])


@dataclass(frozen=True)
class PeriodBoundary(BoundaryCurve):
    """Cycles of which one step takes as long as the range of periods allows, or as short.

    Parameters
    ----------
    equations : CycleEquations
        In two parameters.
    step : int
        Number of the step in the cycle.
    limit : float
    """

    equations: CycleEquations
    step: int
    limit: float

    @property
    def scale(self) -> Array:  # type: ignore[override]
        """What counts as 1 in each entry of x = (u, p), shape (N + 2,)."""
        return self.equations.scale

    def linearised(self, x: Array, n_rk: int) -> tuple[Array, Array]:
        """Derivative, shape (N + 1, N + 2), and values, shape (N + 1,), of the equations."""
        matrix, residual = self.equations.linearised(x, n_rk)
        at = (self.step + 1) * self.chain.width - 1
        gradient = np.zeros(len(x))
        gradient[at] = 1.0
        return np.vstack([matrix, gradient]), np.append(residual, x[at] - self.limit)


DIFFERENCE = 1e-6
"""Step of the differences, in terms of the scale: the error is of the order of 1e-9."""
