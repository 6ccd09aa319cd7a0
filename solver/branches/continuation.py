"""Branches of limit cycles followed from one parameter point to another, around folds, on arrays of points.

Pseudo-arclength continuation (H. B. Keller 1977; E. L. Allgower and K. Georg, Introduction to Numerical
Continuation Methods, 2003, chapters 2 and 6): a branch is a curve of points x = (u, s), with section point
and period u and the fraction s of the way from the parameters of the first point to those of the other. From
a point x1 with the unit tangent tau, the next one solves the residual's equation R(u, s) = 0 together with

    <u - u1, tau_u> + (s - s1) tau_s = ds,

which keeps it in the plane across the tangent at the arclength ds. So a fold, where the curve turns back in
s, is passed like any other point.

A branch ends where it has reached its target (s = 1), or back where it began (s = 0): there it has led around
a fold to the other cycle of a pair.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.cycles.solver import Solver
from stridemap.solver.linear import solved
from stridemap.solver.model.scales import Scales
from stridemap.solver.options import ContinuationOptions

Array = NDArray[np.float64]
Index = NDArray[np.int64]
Mask = NDArray[np.bool_]

DIFFERENCE = 1e-6
"""Of `s`, for the derivative with respect to it."""


@dataclass(frozen=True)
class BranchEnds:
    """Where branches ended; those that were given up are left out.

    Parameters
    ----------
    branch : ndarray of int, shape (k,)
        Row of each branch among those that were followed, ascending.
    u : ndarray, shape (k, nz + 1)
        Section point and period: a guess.
    reached : ndarray of bool, shape (k,)
        Whether at the target, or back at the branch's own parameter point.
    """

    branch: Index
    u: Array
    reached: Mask


def follow(
    solver: Solver,
    u: Array,
    params: Array,
    target: Array,
    period_range: tuple[float, float],
    options: ContinuationOptions | None = None,
) -> BranchEnds:
    """Follow branches from limit cycles to other parameter points.

    Parameters
    ----------
    solver : Solver
    u : ndarray, shape (m, nz + 1)
        Section points and periods of limit cycles.
    params, target : ndarray, shape (m, n_params)
        Their parameters, and those to be reached.
    period_range : (float, float)
        A branch that leaves it is given up.
    options : ContinuationOptions, optional

    Returns
    -------
    BranchEnds
    """
    if not len(u):
        return BranchEnds(np.empty(0, dtype=np.int64), u, np.empty(0, dtype=bool))
    return _Branches(solver, u, params, target, options or ContinuationOptions()).follow(period_range)


class _Branches:
    """Branches that are being followed. Points on them are x = (u, s), shape (m, nz + 2)."""

    def __init__(
        self, solver: Solver, u: Array, params: Array, target: Array, options: ContinuationOptions
    ) -> None:
        self.kernels, self.options = solver.kernels, options
        self.u, self.params, self.direction = u, params, target - params
        self.scale = np.array([*solver.model.spec.scales, Scales.of(solver.model).time, 1.0])
        choose = solver.resolution.search_n_rk
        self.n_rk = np.maximum(choose(u[:, -1], params), choose(u[:, -1], target))

    def follow(self, period_range: tuple[float, float]) -> BranchEnds:
        """Follow all of them to their ends."""
        options = self.options
        at, x = np.arange(len(self.u)), np.column_stack([self.u, np.zeros(len(self.u))])
        ahead = np.zeros_like(x)
        ahead[:, -1] = 1.0
        tangent = self._tangent(self._first_system(at, x), ahead)
        ds = np.where(np.isfinite(tangent).all(axis=1), options.ds_max, 0.0)
        ends = [(at[:0], x[:0, :-1], np.empty(0, dtype=bool))]
        for _ in range(options.max_steps):
            go_on = ds >= options.ds_min
            at, x, tangent, ds = at[go_on], x[go_on], tangent[go_on], ds[go_on]
            if not len(at):
                break
            y, new, good, easy = self._step(at, x, tangent, ds)
            s0, s1 = x[:, -1], y[:, -1]
            reached, back = good & (s1 >= 1), good & (s1 <= 0)
            over = reached | back
            # Where the plane across the tangent has led beyond: the point in between.
            part = (reached[over] - s0[over]) / (s1[over] - s0[over])
            ends.append((at[over], x[over, :-1] + part[:, None] * (y - x)[over, :-1], reached[over]))
            x, tangent = np.where(good[:, None], y, x), np.where(good[:, None], new, tangent)
            factor = np.where(good, np.where(easy, options.step_growth, 1.0), options.step_shrink)
            ds = np.minimum(factor * ds, options.ds_max)
            inside = (x[:, -2] > period_range[0]) & (x[:, -2] <= period_range[1])
            ds[over | ~inside] = 0.0
        branch, u, reached = (np.concatenate(column) for column in zip(*ends, strict=True))
        order = np.argsort(branch, kind="stable")
        return BranchEnds(branch[order], u[order], reached[order])

    def _step(self, at: Index, x: Array, tangent: Array, ds: Array) -> tuple[Array, Array, Mask, Mask]:
        """One arclength step, corrected: new points and tangents, whether they hold, and were easily found.

        The derivative at the predicted point serves for all corrections, and for the new tangent.
        """
        options = self.options
        y, across, length = self._predicted(x, tangent, ds)
        matrix, residual = self._system(at, y)
        new = self._tangent(matrix, tangent)
        matrix[:, -1, :] = across
        change = solved(matrix, np.column_stack([-residual, np.zeros(len(at))]))
        y += change
        size = self._norm(change)
        with np.errstate(invalid="ignore"):
            cosine = (new * tangent / self.scale**2).sum(axis=1)
            near = (size < options.max_correction_ratio * length) & (cosine > options.min_tangent_cosine)
        good, easy = near & (size < options.tolerance), np.zeros(len(at), dtype=bool)
        open_ = np.flatnonzero(near & ~good)
        for attempt in range(options.max_corrections):
            if not len(open_):
                break
            residual = self._residual(at[open_], y[open_, :-1], y[open_, -1:])
            change = solved(matrix[open_], np.column_stack([-residual, np.zeros(len(open_))]))
            y[open_] += change
            now = self._norm(change)
            done = now < options.tolerance
            good[open_[done]] = True
            easy[open_[done]] = attempt < options.max_corrections - 1
            with np.errstate(invalid="ignore"):
                shrinking = now < options.max_contraction * size[open_]
            size[open_] = now
            open_ = open_[~done & shrinking]
        return y, new, good, easy

    def _predicted(self, x: Array, tangent: Array, ds: Array) -> tuple[Array, Array, Array]:
        """Points along the tangents, normals of the planes that corrections keep, and the arclength steps.

        An arclength step does not go beyond an end: to stop there, corrections keep s and not the plane.
        """
        s, slope = x[:, -1], tangent[:, -1]
        with np.errstate(divide="ignore", invalid="ignore"):
            left = np.where(slope > 0, (1 - s) / slope, np.where(slope < 0, -s / slope, np.inf))
        at_end = ds >= left
        length = np.minimum(ds, left)
        y = x + length[:, None] * tangent
        y[at_end, -1] = np.where(slope[at_end] > 0, 1.0, 0.0)
        across = tangent / self.scale**2
        across[at_end] = np.eye(x.shape[1])[-1]
        return y, across, length

    def _system(self, at: Index, x: Array) -> tuple[Array, Array]:
        """Derivative of the residual with a last row to be filled in, shape (m, nz + 2, nz + 2); residual."""
        u, s = x[:, :-1], x[:, -1:]
        n = u.shape[1]
        jacobian, residual = self._evaluate(self.kernels.jacobian, at, u, s)
        shifted = self._residual(at, u, s + DIFFERENCE)
        matrix = np.zeros((len(x), n + 1, n + 1))
        matrix[:, :n, :n] = jacobian
        matrix[:, :n, n] = (shifted - residual) / DIFFERENCE
        return matrix, residual

    def _first_system(self, at: Index, x: Array) -> Array:
        """The same where branches begin: those that leave one cycle have one derivative in common."""
        _, first, same = np.unique(
            np.hstack([self.u, self.params, self.n_rk[:, None]]),
            axis=0, return_index=True, return_inverse=True,
        )  # fmt: skip
        matrix, residual = (part[same.ravel()] for part in self._system(at[first], x[first]))
        shifted = self._residual(at, x[:, :-1], x[:, -1:] + DIFFERENCE)
        matrix[:, :-1, -1] = (shifted - residual) / DIFFERENCE
        return matrix

    def _residual(self, at: Index, u: Array, s: Array) -> Array:
        return self._evaluate(lambda n_rk, u, p: (self.kernels.residual(n_rk, u, p),), at, u, s)[0]

    def _evaluate(
        self, kernel: Callable[[int, Array, Array], tuple[Array, ...]], at: Index, u: Array, s: Array
    ) -> list[Array]:
        """A kernel at points of branches, each at its own resolution."""
        params = self.params[at] + s * self.direction[at]
        n_rk = self.n_rk[at]
        groups = [np.flatnonzero(n_rk == n) for n in np.unique(n_rk)]
        parts = [kernel(n_rk[rows[0]].item(), u[rows], params[rows]) for rows in groups]
        back = np.argsort(np.concatenate(groups), kind="stable")
        return [np.concatenate(part)[back] for part in zip(*parts, strict=True)]

    def _tangent(self, matrix: Array, ahead: Array) -> Array:
        """Unit tangents on the same side as `ahead`."""
        matrix = matrix.copy()
        matrix[:, -1, :] = ahead / self.scale**2
        right = np.zeros(ahead.shape)
        right[:, -1] = 1.0
        tangent = solved(matrix, right)
        return tangent / self._norm(tangent)[:, None]

    def _norm(self, x: Array) -> Array:
        """Lengths in terms of the scale."""
        return np.sqrt(((x / self.scale) ** 2).sum(axis=1))
