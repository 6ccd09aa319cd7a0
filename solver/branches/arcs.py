"""Arclength steps of many branches at a time, from one point of each to the next.

From a point x1 with the unit tangent tau a predictor leads along the parabola that bends as the branch did
in the arclength step before. Newton's method corrects in the plane across the tangent, with the derivative
at the predicted point. What comes out is as exact as a guess must be.

Where kernels work on several points per instruction, `arcs_in_lanes` does the same in C++, and lets no
branch wait for the others.
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.branches.heads import Heads, Points
from stridemap.solver.branches.stops import Stops
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.linear import solved
from stridemap.solver.model.scales import Scales
from stridemap.solver.options import ContinuationOptions

Array = NDArray[np.float64]
Index = NDArray[np.int64]
Mask = NDArray[np.bool_]

MODES = 16
"""Intervals of a line, in each of which the resolution is chosen for the faster of its ends."""

SHARP = 0.999
"""Cosine of the angle by which the tangent turns in an arclength step, below which the derivative at its end
is needed."""

TOLERANCE = 1e-4
"""Length of a correction that is the last. What comes out is a guess, to be converged; but with 1e-3, of 300
branches in steps as long as in sweeps 98 ended early, of which 70 are left. Sweeps take as long."""

CONTRACTION, CORRECTION_RATIO = 0.5, 0.5
"""Largest ratios of one correction to the one before, and of the first to the arclength step."""

SHORT = 0.02
"""Of an arclength step: a correction that is so small is the last, if it is below the tolerance."""

SIDEWAYS, TELLING = 0.004, 0.02
"""How far an arclength step may lead sideways, in terms of the scale, and how long it must be to tell: points
are not exact. But for terms of third order the way along an arc agrees with the mean of the tangents at its
ends; onto a curve that runs beside this one it leads sideways by the distance of the two."""


class Lines:
    """Lines of parameter space, one for each of m branches. Points on them are x = (u, s).

    Parameters
    ----------
    solver : Solver
    params, target : ndarray, shape (m, n_params)
        Parameters at the ends, s = 0 and s = 1.
    """

    def __init__(self, solver: Solver, params: Array, target: Array) -> None:
        self.kernels, self.resolution = solver.kernels, solver.resolution
        self.params, self.direction = params, target - params
        self.scale = np.array([*solver.model.spec.scales, Scales.of(solver.model).time, 1.0])
        ends = np.hstack([params, target])
        _, self.first, line = np.unique(ends, axis=0, return_index=True, return_inverse=True)
        self.number = line.ravel()
        self.modes = self._modes() if len(params) else np.empty((0, MODES))

    def system(self, at: Index, x: Array, n_rk: Index) -> tuple[Array, Array]:
        """Derivative of the residual with a last row to be filled in, shape (m, nz + 2, nz + 2); residual."""
        u, s = x[:, :-1], x[:, -1:]
        n = u.shape[1]
        jacobian, along, residual = self.kernels.jacobian_along(
            n_rk, u, self.point(at, s), self.direction[at]
        )
        matrix = np.zeros((len(x), n + 1, n + 1))
        matrix[:, :n, :n] = jacobian
        matrix[:, :n, n] = along
        return matrix, residual

    def residual(self, at: Index, u: Array, s: Array, n_rk: Index) -> Array:
        """Residuals at points, shape (k, nz + 1)."""
        return self.kernels.residual(n_rk, u, self.point(at, s))

    def point(self, at: Index, s: Array) -> Array:
        """Parameters at fractions of lines, shape (k, n_params)."""
        return np.asarray(self.params[at] + s * self.direction[at])

    def n_rk(self, at: Index, x: Array) -> Index:
        """RK steps of a walking step near points."""
        interval = np.clip(np.nan_to_num(x[:, -1]) * MODES, 0, MODES - 1).astype(np.int64)
        return self.resolution.branch_n_rk(x[:, -2], self.modes[at, interval])

    def tangent(self, matrix: Array, ahead: Array) -> Array:
        """Unit tangents on the same side as `ahead`."""
        matrix = matrix.copy()
        matrix[:, -1, :] = ahead / self.scale**2
        right = np.zeros(ahead.shape)
        right[:, -1] = 1.0
        tangent = solved(matrix, right)
        return tangent / self.norm(tangent)[:, None]

    def norm(self, x: Array) -> Array:
        """Lengths in terms of the scale."""
        return np.asarray(np.sqrt(((x / self.scale) ** 2).sum(axis=1)))

    def tangents(self, x: Array) -> tuple[Array, Array]:
        """Unit tangents towards s = 1, and the matrices whose last rows they are, in terms of the scale."""
        at, upwards = np.arange(len(x)), np.zeros_like(x)
        upwards[:, -1] = 1.0
        matrix = np.zeros((0, x.shape[1], x.shape[1]))
        if len(x):
            matrix, _ = self.system(at, x, self.n_rk(at, x))
        tangent = self.tangent(matrix, upwards)
        matrix[:, -1, :] = tangent / self.scale**2
        return tangent, matrix

    def _modes(self) -> Array:
        """The fastest mode in each interval of the line of each branch, shape (m, MODES)."""
        first, fractions = self.first, np.linspace(0, 1, MODES + 1)
        points = self.params[first, None] + fractions[:, None] * self.direction[first, None]
        modes = self.resolution.fastest_mode(points.reshape(-1, points.shape[2])).reshape(len(first), -1)
        return np.asarray(np.maximum(modes[:, 1:], modes[:, :-1])[self.number])


class Round(NamedTuple):
    """What comes of some arclength steps of each branch.

    Parameters
    ----------
    heads : Heads
        Those that may get on.
    passed : Points
        In their order along each branch.
    met : ndarray of int
        Beginnings of branches that were met from behind.
    """

    heads: Heads
    passed: Points
    met: Index


@dataclass(frozen=True)
class Arcs:
    """Takes arclength steps.

    Parameters
    ----------
    lines : Lines
        Of m branches.
    options : ContinuationOptions
    period_range : (float, float)
        A branch ends where it leaves it.
    stops : Stops
        Where branches end; the first m are their beginnings.
    beginnings : ndarray, shape (m, nz + 2)
        Tangents there.
    """

    lines: Lines
    options: ContinuationOptions
    period_range: tuple[float, float]
    stops: Stops
    beginnings: Array

    def going(self, heads: Heads) -> Heads:
        """Those that get on."""
        return heads.take((heads.ds >= self.options.ds_min) & (heads.steps < self.options.max_steps))

    def taken(self, heads: Heads, tries: int) -> Round:
        """Take arclength steps.

        Parameters
        ----------
        heads : Heads
        tries : int
            How many of each branch at most, failed ones included.
        """
        passed, met = [heads.take(np.arange(0)).points], [np.empty(0, dtype=np.int64)]
        for _ in range(tries):
            heads = self.going(heads)
            if not len(heads):
                break
            heads, good, behind = self._advanced(heads)
            passed.append(heads.take(good).points)
            met.append(behind)
        return Round(self.going(heads), Points.concatenate(passed), np.concatenate(met))

    def _advanced(self, heads: Heads) -> tuple[Heads, Mask, Index]:
        """Heads an arclength step later, which of them got on, and beginnings met from behind."""
        at, x, tangent, ds = heads.branch, heads.x, heads.tangent, heads.ds
        y, new, good, factor = self._step(at, x, tangent, heads.bend, ds)
        shortest, longest = self.period_range
        period, s = y[:, -2], y[:, -1]
        ended = ~((period > shortest) & (period <= longest)) | (s <= 0) | (s >= 1)
        row, stop = self.stops.between(
            self.lines.number[at[good]], x[good], y[good], tangent[good], new[good]
        )
        ended[np.flatnonzero(good)[row]] = True
        row, stop = row[stop < len(self.beginnings)], stop[stop < len(self.beginnings)]
        behind = (new[good][row] * self.beginnings[stop] / self.lines.scale**2).sum(axis=1) > 0
        with np.errstate(invalid="ignore", divide="ignore"):
            bend = (new - tangent) / self.lines.norm(y - x)[:, None]
        moved = good[:, None]
        heads = Heads(
            at,
            heads.ahead,
            np.where(moved, y, x),
            np.where(moved, new, tangent),
            np.where(moved, bend, heads.bend),
            np.where(good & ended, 0.0, np.minimum(factor * ds, self.options.ds_max)),
            heads.idle + np.where(good, ds, 0.0),
            heads.steps + 1,
        )
        return heads, good, stop[behind]

    def _step(
        self, at: Index, x: Array, tangent: Array, bend: Array, ds: Array
    ) -> tuple[Array, Array, Mask, Array]:
        """One arclength step, corrected: points and tangents, whether they hold, factors of the next step.

        The derivative at the predicted point serves for all corrections, and for the new tangent.
        """
        options = self.options
        y, across, length = self._predicted(x, tangent, bend, ds)
        n_rk = self.lines.n_rk(at, y)
        matrix, residual = self.lines.system(at, y, n_rk)
        new = self.lines.tangent(matrix, tangent)
        matrix[:, -1, :] = across
        change = solved(matrix, np.column_stack([-residual, np.zeros(len(at))]))
        y += change
        size = self.lines.norm(change)
        with np.errstate(invalid="ignore"):
            cosine = (new * tangent / self.lines.scale**2).sum(axis=1)
            near = (size < CORRECTION_RATIO * length) & (cosine > options.min_tangent_cosine)
        # Where steps are short, points must be as exact as these are short.
        small = np.minimum(TOLERANCE, SHORT * length)
        good = near & (size < small)
        easy = good.copy()
        open_ = np.flatnonzero(near & ~good)
        for attempt in range(options.max_corrections):
            if not len(open_):
                break
            residual = self.lines.residual(at[open_], y[open_, :-1], y[open_, -1:], n_rk[open_])
            change = solved(matrix[open_], np.column_stack([-residual, np.zeros(len(open_))]))
            y[open_] += change
            now = self.lines.norm(change)
            done = now < small[open_]
            good[open_[done]] = True
            easy[open_[done]] = attempt < options.max_corrections - 1
            with np.errstate(invalid="ignore"):
                shrinking = now < CONTRACTION * size[open_]
            size[open_] = now
            open_ = open_[~done & shrinking]
        sharp = np.flatnonzero(good & (cosine < SHARP))
        if len(sharp):
            new[sharp] = self._refined(at[sharp], y, across, tangent, n_rk, sharp)
        with np.errstate(invalid="ignore", divide="ignore"):
            good &= (self._sideways(x, y, tangent, new) < SIDEWAYS) | (length < TELLING)
            # The ratio of small angles, without a function that rounds otherwise elsewhere.
            wanted = np.sqrt((1 - options.easy_tangent_cosine) / np.maximum(1 - cosine, 0.0))
        factor = np.fmin(np.fmax(wanted, options.step_shrink), np.where(easy, options.step_growth, 1.0))
        return y, new, good, np.where(good, factor, options.step_shrink)

    def _sideways(self, x: Array, y: Array, tangent: Array, new: Array) -> Array:
        """How far from y one comes from x in the direction of the mean of their tangents."""
        way, mean = y - x, tangent + new
        return self.lines.norm(way - (self.lines.norm(way) / self.lines.norm(mean))[:, None] * mean)

    def _refined(self, at: Index, y: Array, across: Array, tangent: Array, n_rk: Index, rows: Index) -> Array:
        """Tangents of rows where they turn sharply, from derivatives there; corrects their points."""
        matrix, residual = self.lines.system(at, y[rows], n_rk[rows])
        new = self.lines.tangent(matrix, tangent[rows])
        matrix[:, -1, :] = across[rows]
        y[rows] += solved(matrix, np.column_stack([-residual, np.zeros(len(rows))]))
        return new

    def _predicted(self, x: Array, tangent: Array, bend: Array, ds: Array) -> tuple[Array, Array, Array]:
        """Points along parabolas, normals of the planes that corrections keep, and the arclength steps.

        An arclength step does not go beyond an end: to stop there, corrections keep s and not the plane.
        """
        s, slope = x[:, -1], tangent[:, -1]
        with np.errstate(divide="ignore", invalid="ignore"):
            left = np.where(slope > 0, (1 - s) / slope, np.where(slope < 0, -s / slope, np.inf))
        at_end = ds >= left
        length = np.minimum(ds, left)
        y = x + length[:, None] * tangent + 0.5 * length[:, None] ** 2 * bend
        end = np.where(at_end, slope > 0, y[:, -1] > 0.5)
        at_end |= (y[:, -1] < 0) | (y[:, -1] > 1)
        y[at_end, -1] = end[at_end]
        across = tangent / self.lines.scale**2
        across[at_end] = np.eye(x.shape[1])[-1]
        return y, across, length
