"""How far a computed limit cycle and its multipliers are from the exact ones.

The residual at twice the resolution is, but for 1/256 of it, the residual R of the exact step map. The cycle
moves by -J^-1 R when it is corrected for it, with J the Jacobian of the residual, which holds the step map's
derivative: near a fold J is nearly singular, and a small residual is a large error. The multipliers there are
compared with those at a finer resolution at the corrected cycle.

Rounding adds to both: what the residual's own rounding comes to through |J^-1|, and that of the derivative
through the condition of each eigenvalue. Where the former is much, it is measured: see `precise`.
"""

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.cycles.floquet import sorted_eigenvalues, step_map_derivative
from stridemap.solver.linear import inverted

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

ROUNDING = 0.5 * float(np.finfo(float).eps)
"""Rounding of the residual and of the derivative, in terms of what they are computed from: measured."""

COARSE = 24
"""RK steps with which they are so much."""

BALANCINGS = 4
"""Rounds of it: what is left of the imbalance is a factor of some few."""


@dataclass(frozen=True)
class Correction:
    """What the exact step map would change in solutions of Newton's method.

    Parameters
    ----------
    change : ndarray, shape (n, nz + 1)
        Of the section point and the period.
    rounding : ndarray, shape (n,)
        What rounding may have added to the error, in terms of the scales.
    spread : ndarray, shape (n, nz + 1)
        The same as a change of the unknowns: where they move to most easily, on the side of `change`.
    """

    change: Array
    rounding: Array
    spread: Array

    @classmethod
    def of(cls, jacobian: Array, residual: Array, u: Array, scale: Array, n_rk: int = COARSE) -> "Correction":
        """The correction for a residual.

        Parameters
        ----------
        jacobian : ndarray, shape (n, nz + 1, nz + 1)
        residual : ndarray, shape (n, nz + 1)
            At a higher resolution than the one at which `u` was solved.
        u : ndarray, shape (n, nz + 1)
        scale : ndarray, shape (nz + 1,)
        n_rk : int, optional
            RK steps whose rounding adds up, as in a random walk.
        """
        inverse = inverted(jacobian)
        change = -(inverse @ residual[:, :, None])[:, :, 0]
        # A row of the residual is rounded as the number that it is the difference of.
        level = ROUNDING * math.sqrt(n_rk / COARSE) * np.maximum(np.abs(u), scale)
        with np.errstate(invalid="ignore"):
            level[:, -1] = ROUNDING * np.abs(jacobian[:, -1, -1]) * scale[-1]
            moved = inverse * level[:, None, :]
            rounding = np.sqrt((moved**2).sum(axis=2)) / scale
            # Near a fold all columns of the inverse point along the branch.
            column = np.nan_to_num(np.abs(moved / scale[:, None]).max(axis=1)).argmax(axis=1)
            spread = np.take_along_axis(moved, column[:, None, None], axis=2)[:, :, 0]
            side = np.where((spread * change / scale**2).sum(axis=1) < 0, -1.0, 1.0)
        return cls(change, rounding.max(axis=1, initial=0.0), side[:, None] * spread)

    @classmethod
    def unknown(cls, n: int, width: int) -> "Correction":
        """None for n solutions: not a number."""
        return cls(np.full((n, width), np.nan), np.full(n, np.nan), np.full((n, width), np.nan))

    @property
    def exact(self) -> NDArray[np.bool_]:
        """For which of them the change is that of this very rounding, shape (n,)."""
        none: NDArray[np.bool_] = self.rounding == 0
        return none

    def take(self, index: NDArray[Any]) -> "Correction":
        """Some of the solutions."""
        return Correction(self.change[index], self.rounding[index], self.spread[index])

    def put(self, index: NDArray[Any], other: "Correction") -> None:
        """Those of some of the solutions."""
        self.change[index], self.rounding[index], self.spread[index] = (
            other.change,
            other.rounding,
            other.spread,
        )


def size(change: Array, scale: Array) -> Array:
    """Largest entry of changes in terms of the scales, shape (n,); NaN where one is not a number."""
    return np.abs(change / scale).max(axis=1, initial=0.0)


def multiplier_error(jacobian: Array, refined: Array, scale: Array, n_rk: int = COARSE) -> Array:
    """Largest error of a multiplier, shape (n,).

    Parameters
    ----------
    jacobian : ndarray, shape (n, nz + 1, nz + 1)
        That whose multipliers are given.
    refined : ndarray, shape (n, nz + 1, nz + 1)
        At twice the resolution, at the corrected cycle.
    scale : ndarray, shape (nz + 1,)
    n_rk : int, optional
        RK steps of `jacobian`.
    """
    derivative = step_map_derivative(jacobian)
    values, others = sorted_eigenvalues(derivative), sorted_eigenvalues(step_map_derivative(refined))
    return np.hypot(differences(values, others), _rounding(derivative, scale[:-1], n_rk))


def differences(values: Complex, others: Complex) -> Array:
    """Largest difference of two sets of eigenvalues, each matched with its own, shape (n,).

    Parameters
    ----------
    values, others : ndarray of complex, shape (n, m)
    """
    apart = np.abs(values - others).max(axis=1, initial=0.0)
    # Their order by modulus may differ where two of them are nearly of one modulus.
    doubtful = np.flatnonzero(apart > 1e-12 * (1 + np.abs(values).max(axis=1, initial=0.0)))
    for i in doubtful.tolist():
        distance = np.abs(values[i][:, None] - others[i])
        own = np.diagonal(distance)
        if not (own <= distance.min(axis=1)).all():  # else there is no better match than by their order
            from scipy.optimize import linear_sum_assignment  # takes half a second to load

            own = distance[linear_sum_assignment(distance)]
        apart[i] = min(apart[i], own.max())
    return apart


def _rounding(derivative: Array, scale: Array, n_rk: int) -> Array:
    """What rounding may have done to the worst conditioned eigenvalue of each matrix.

    To first order the matrix' rounding times the eigenvalue's condition, both after balancing. That is
    infinite for a defective eigenvalue, whose error is the root of the rounding; of order m for m that
    coincide.
    """
    n, m = derivative.shape[:2]
    out = np.full(n, np.nan)
    good = np.flatnonzero(np.isfinite(derivative).all(axis=(1, 2)))
    if not len(good) or not m:
        return out if m else np.zeros(n)
    scaled = _balanced(derivative[good] * scale[None, None, :] / scale[None, :, None])
    values, right = np.linalg.eig(scaled)
    norm = np.maximum(np.linalg.norm(scaled, axis=(1, 2)), 1.0)
    level = ROUNDING * math.sqrt(n_rk / COARSE)
    with np.errstate(all="ignore"):
        left = inverted(right)
        condition = np.linalg.norm(left, axis=2) * np.linalg.norm(right, axis=1)
        first_order = level * norm[:, None] * condition
        root = norm[:, None] * level ** (1 / np.arange(1, m + 1))
    # How many coincide: those that are nearer than the root of the rounding.
    near = np.abs(values[:, :, None] - values[:, None, :]) < norm[:, None, None] * level ** (1 / 3)
    several = near.sum(axis=2)
    bound = np.take_along_axis(root, np.maximum(several - 1, 0), axis=1)
    first_order = np.where(np.isfinite(first_order), first_order, np.inf)
    out[good] = np.minimum(first_order, np.where(several > 1, bound, np.inf)).max(axis=1)
    return out


def _balanced(matrices: Array) -> Array:
    """Matrices in units in which each row is about as long as the column of its number.

    A walker's coordinates may differ in size far more than the scales tell, and so may the matrix' entries;
    the eigenvalues and their rounding do not depend on that.
    """
    outside = 1.0 - np.eye(matrices.shape[1])
    for _ in range(BALANCINGS):
        square = matrices**2 * outside
        with np.errstate(all="ignore"):
            unit = (square.sum(axis=2) / square.sum(axis=1)) ** 0.25
        unit[~(np.isfinite(unit) & (unit > 0))] = 1.0
        matrices = matrices * unit[:, None, :] / unit[:, :, None]
    return matrices
