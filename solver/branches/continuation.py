"""Many branches of limit cycles followed along straight lines of parameter space, in lockstep.

Pseudo-arclength continuation (H. B. Keller 1977; E. L. Allgower and K. Georg, Introduction to Numerical
Continuation Methods, 2003, chapters 2 and 6): a branch is a curve of points x = (u, s), with section point
and period u and the fraction s of the way along its line. From a point x1 with the unit tangent tau, the next
one solves the residual's equation R(u, s) = 0 together with

    <u - u1, tau_u> + (s - s1) tau_s = ds,

which keeps it in the plane across the tangent at the arclength ds. So a fold, where the curve turns back in
s, is passed like any other point. Newton's method begins on the parabola that bends as the branch did in the
arclength step before. A branch ends with its line, at s = 0 or s = 1.

The points are as exact as a guess must be. Between two of them a branch is the cubic through both with their
tangents.

Where a branch arrives at the beginning of another one on its line, or at a cycle that is known, both are one
curve, and it need not be followed any further. All that begin on one curve set out the same way along it, so
that each stretch of it is followed by one of them.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.branches import cubics
from stridemap.solver.branches.heads import Heads
from stridemap.solver.branches.stops import Stops
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.linear import solved
from stridemap.solver.model.scales import Scales
from stridemap.solver.options import IN_SWEEPS, ContinuationOptions

Array = NDArray[np.float64]
Index = NDArray[np.int64]
Mask = NDArray[np.bool_]

MODES = 16
"""Intervals of a line, in each of which the resolution is chosen for the faster of its ends."""

SHARP = 0.999
"""Cosine of the angle by which the tangent turns in an arclength step, below which the derivative at its end
is needed."""

TOLERANCE = 1e-3
"""Length of a correction that is the last: what comes out is a guess, to be converged."""

CONTRACTION, CORRECTION_RATIO = 0.5, 0.5
"""Largest ratios of one correction to the one before, and of the first to the arclength step."""

PATIENCE = 2.0
"""Length along which a branch is followed without a gait on it."""

SHORT = 0.02
"""Of an arclength step: a correction that is so small is the last, if it is below the tolerance."""

SIDEWAYS, TELLING = 0.004, 0.02
"""How far an arclength step may lead sideways, in terms of the scale, and how long it must be to tell: points
are not exact. But for terms of third order the way along an arc agrees with the mean of the tangents at its
ends; onto a curve that runs beside this one it leads sideways by the distance of the two."""

LOOK = 8
"""Arclength steps after which a look is taken whether cycles may be gaits."""


@dataclass(frozen=True)
class Crossings:
    """Where branches pass positions on their lines.

    Parameters
    ----------
    branch : ndarray of int, shape (k,)
        Number of the branch, ascending.
    position : ndarray of int, shape (k,)
        Which of the positions.
    u : ndarray, shape (k, nz + 1)
        Section point and period: a guess. In their order along each branch.
    beyond : ndarray of bool, shape (k,)
        Whether the position is beyond a fold, so that the branch may not pass it after all.
    """

    branch: Index
    position: Index
    u: Array
    beyond: Mask


@dataclass(frozen=True)
class Followed:
    """Points of branches.

    Parameters
    ----------
    scale : ndarray, shape (nz + 2,)
        What counts as 1 in each entry of x.
    branch : ndarray of int, shape (k,)
        Number of the branch among those that were followed, ascending.
    ahead : ndarray of bool, shape (k,)
        Whether a point is ahead of where the branch begins, or behind it. The beginning stands on both sides.
    x, tangent : ndarray, shape (k, nz + 2)
        Points (u, s) and unit tangents. Those behind, from the beginning on, come before those ahead.
    """

    scale: Array
    branch: Index
    ahead: Mask
    x: Array
    tangent: Array

    def crossings(self, positions: Array, beyond: float = 0.0) -> Crossings:
        """Where the branches pass positions, those at which they begin left out.

        Parameters
        ----------
        positions : ndarray, shape (p,)
            Ascending, from 0 to 1.
        beyond : float
            The nearest position that is beyond a fold by no more than this is one that the branch may pass
            twice: where exactly it turns back is not known. Below the distance of two positions.
        """
        x, tangent = self.x, self.tangent
        same = (self.branch[:-1] == self.branch[1:]) & (self.ahead[:-1] == self.ahead[1:])
        begin = np.flatnonzero(same)
        curve = cubics.cubics(x[begin], x[begin + 1], tangent[begin], tangent[begin + 1], self.scale)
        piece, low, high = cubics.monotonic(curve[:, :, -1])
        # Ends that are points of the branch are taken as they are: they may be the end of the line.
        s_low = np.where(low == 0, x[begin[piece], -1], cubics.value(curve[piece, :, -1], low))
        s_high = np.where(high == 1, x[begin[piece] + 1, -1], cubics.value(curve[piece, :, -1], high))
        which, position = _passed(positions, s_low, s_high)
        at = piece[which]
        tau = cubics.root(curve[at, :, -1], positions[position], low[which], high[which])
        fold, beside, apart = _beyond_folds(
            positions, curve[piece, :, -1], low, s_low, s_high > s_low, beyond
        )
        at = np.concatenate([at, piece[fold], piece[fold]])
        is_beyond = np.arange(len(at)) >= len(tau)
        position = np.concatenate([position, beside, beside])
        tau = np.concatenate([tau, low[fold] - apart, low[fold] + apart])
        u = cubics.value(curve[at, :, :-1], tau[:, None])
        along = np.where(self.ahead[begin[at]], 1, -1) * (begin[at] + tau)
        order = np.lexsort((along, self.branch[begin[at]]))
        return Crossings(self.branch[begin[at]][order], position[order], u[order], is_beyond[order])


def _passed(positions: Array, start: Array, end: Array) -> tuple[Index, Index]:
    """Which positions are passed between pairs of ends, the first of them left out: pair and position."""
    rising = end > start
    first = np.where(
        rising, np.searchsorted(positions, start, "right"), np.searchsorted(positions, end, "left")
    )
    last = np.where(
        rising, np.searchsorted(positions, end, "right"), np.searchsorted(positions, start, "left")
    )
    count = np.maximum(last - first, 0)
    pair = np.repeat(np.arange(len(start)), count)
    return pair, np.repeat(first - (np.cumsum(count) - count), count) + np.arange(len(pair))


def _beyond_folds(
    positions: Array, curve: Array, low: Array, s_low: Array, rising: Mask, reach: float
) -> tuple[Index, Index, Array]:
    """Positions just beyond folds: piece that begins there, position, and how far from the fold to look.

    Pieces of the cubics begin at `low`, where the position is `s_low`, and rise from there or fall.
    """
    piece = np.flatnonzero((low > 0) & (low < 1) & (reach > 0))
    s, up = s_low[piece], rising[piece]
    first = np.searchsorted(positions, np.where(up, s - reach, s), "left")
    last = np.searchsorted(positions, np.where(up, s, s + reach), "right")
    one = np.flatnonzero(last > first)
    piece, position = piece[one], first[one]
    bend = np.abs(6 * curve[piece, 0] * low[piece] + 2 * curve[piece, 1])
    with np.errstate(divide="ignore", invalid="ignore"):
        apart = np.sqrt(2 * np.abs(positions[position] - s_low[piece]) / bend)
    good = apart < 1  # not where the cubic hardly bends
    return piece[good], position[good], apart[good]


class Known(NamedTuple):
    """Cycles that are known, where branches end: u, s, and a number of a branch that begins on their line."""

    u: Array
    s: Array
    branch: Index


def follow(
    solver: Solver,
    u: Array,
    s: Array,
    params: Array,
    target: Array,
    period_range: tuple[float, float],
    options: ContinuationOptions | None = None,
    *,
    may_be_gaits: Callable[[Array, Array], Mask] | None = None,
    known: Known | None = None,
    upwards: bool = False,
) -> Followed:
    """Follow branches from limit cycles along lines, both ways.

    Parameters
    ----------
    solver : Solver
    u : ndarray, shape (m, nz + 1)
        Section points and periods of limit cycles.
    s : ndarray, shape (m,)
        Where on their lines the cycles are, from 0 to 1.
    params, target : ndarray, shape (m, n_params)
        Parameters at the ends of the lines, s = 0 and s = 1.
    period_range : (float, float)
        A branch ends where it leaves it.
    options : ContinuationOptions, optional
    may_be_gaits : callable, optional
        (u, params) -> ndarray of bool, whether cycles may be gaits. A branch ends where there has been none
        for a length of `PATIENCE`.
    known : Known, optional
    upwards : bool
        Only the way that leads towards s = 1 at first, each branch to its own end whatever is known.

    Returns
    -------
    Followed
        What two of the branches have in common may be on one of them alone.
    """
    known = known or Known(u[:0], s[:0], np.empty(0, dtype=np.int64))
    lines = _Lines(solver, params, target, options or IN_SWEEPS, period_range, may_be_gaits)
    x = np.column_stack([u, s])
    return lines.upwards(x) if upwards else lines.both_ways(x, np.column_stack(known[:2]), known.branch)


def _at_end(s: Array, slope: Array) -> Mask:
    """Whether points are at the end of their line to which their tangents point."""
    return ((s <= 0) & (slope < 0)) | ((s >= 1) & (slope > 0))


class _Lines:
    """Branches that are being followed, one on each of m lines. Points on them are x = (u, s)."""

    def __init__(
        self,
        solver: Solver,
        params: Array,
        target: Array,
        options: ContinuationOptions,
        period_range: tuple[float, float],
        may_be_gaits: Callable[[Array, Array], Mask] | None,
    ) -> None:
        self.kernels, self.options, self.resolution = solver.kernels, options, solver.resolution
        self.params, self.direction = params, target - params
        self.period_range, self.may_be_gaits = period_range, may_be_gaits
        self.scale = np.array([*solver.model.spec.scales, Scales.of(solver.model).time, 1.0])
        ends = np.hstack([params, target])
        _, self.first, line = np.unique(ends, axis=0, return_index=True, return_inverse=True)
        self.line = line.ravel()
        self.modes = self._modes() if len(params) else np.empty((0, MODES))

    def both_ways(self, x: Array, known: Array, on_line_of: Index) -> Followed:
        """Follow all one way first, and then those the other way that none of the others has come along."""
        tangent = self._oriented(x)
        stops = Stops(
            np.concatenate([x, known]), np.concatenate([self.line, self.line[on_line_of]]), self.scale
        )
        return self._followed(x, tangent, stops, back=True)

    def upwards(self, x: Array) -> Followed:
        """Follow all towards s = 1 only, each to its own end."""
        tangent, _ = self._tangents(x)
        return self._followed(x, tangent, Stops(x[:0], self.line[:0], self.scale), back=False)

    def _tangents(self, x: Array) -> tuple[Array, Array]:
        """Unit tangents towards s = 1, and the matrices whose last rows they are, in terms of the scale."""
        at, upwards = np.arange(len(x)), np.zeros_like(x)
        upwards[:, -1] = 1.0
        matrix = np.zeros((0, x.shape[1], x.shape[1]))
        if len(x):
            matrix, _ = self._system(at, x, self._n_rk(at, x))
        tangent = self._tangent(matrix, upwards)
        matrix[:, -1, :] = tangent / self.scale**2
        return tangent, matrix

    def _oriented(self, x: Array) -> Array:
        """Unit tangents that point the same way all along a curve, folds included: by a determinant's sign.

        With tangents towards s = 1, what lies between two beginnings around a fold would be followed twice.
        """
        tangent, matrix = self._tangents(x)
        with np.errstate(invalid="ignore"):
            return np.where(np.linalg.det(matrix)[:, None] < 0, -tangent, tangent)

    def _followed(self, x: Array, tangent: Array, stops: Stops, back: bool) -> Followed:
        """Follow branches ahead to their ends; with `back` then the other way.

        That way begins on each line when none is left on it, for those that no other one has come along.
        """
        options = self.options
        came_along = np.zeros(len(x), dtype=bool)
        heads = self._beginning(np.arange(len(x)), x, tangent, ahead=True)
        passed = [heads.points]
        waiting = np.full(len(self.first), back)  # lines whose way back has not begun
        while True:
            heads = heads.take((heads.ds >= options.ds_min) & (heads.steps < options.max_steps))
            begins = waiting.copy()
            begins[self.line[heads.branch[heads.ahead]]] = False
            if begins.any():
                at = np.flatnonzero(begins[self.line] & ~came_along)
                begun = self._beginning(at, x[at], -tangent[at], ahead=False)
                passed.append(begun.points)
                heads, waiting = Heads.concatenate([heads, begun]), waiting & ~begins
                continue
            if not len(heads):
                break
            heads = self._promising(heads)
            heads, good, behind = self._advanced(heads, stops, tangent)
            passed.append(heads.take(good).points)
            came_along[behind] = True
        branch, ahead, points, tangents = (np.concatenate(parts) for parts in zip(*passed, strict=True))
        order = np.lexsort((ahead, branch))
        return Followed(self.scale, branch[order], ahead[order], points[order], tangents[order])

    def _beginning(self, at: Index, x: Array, tangent: Array, ahead: bool) -> Heads:
        """Branches at their beginnings; those that cannot be followed end there."""
        begins = np.isfinite(tangent).all(axis=1) & ~_at_end(x[:, -1], tangent[:, -1])
        return Heads.beginning(at, ahead, x, tangent, np.where(begins, self.options.ds, 0.0))

    def _promising(self, heads: Heads) -> Heads:
        """Those on whose branches there was a gait not long ago, as far as it is time for a look."""
        look = np.flatnonzero(heads.steps % LOOK == 0)
        if self.may_be_gaits is None or not len(look):
            return heads
        u, at = heads.x[look, :-1], heads.branch[look]
        idle = heads.idle.copy()
        idle[look[self.may_be_gaits(u, self._point(at, heads.x[look, -1:]))]] = 0.0
        given_up = np.zeros(len(heads), dtype=bool)
        given_up[look] = idle[look] > PATIENCE
        return replace(heads, idle=idle).take(~given_up)

    def _advanced(self, heads: Heads, stops: Stops, beginnings: Array) -> tuple[Heads, Mask, Index]:
        """Heads an arclength step later, which of them got on, and beginnings met from behind."""
        at, x, tangent, ds = heads.branch, heads.x, heads.tangent, heads.ds
        y, new, good, factor = self._step(at, x, tangent, heads.bend, ds)
        shortest, longest = self.period_range
        period, s = y[:, -2], y[:, -1]
        ended = ~((period > shortest) & (period <= longest)) | (s <= 0) | (s >= 1)
        row, stop = stops.between(self.line[at[good]], x[good], y[good], tangent[good], new[good])
        ended[np.flatnonzero(good)[row]] = True
        row, stop = row[stop < len(beginnings)], stop[stop < len(beginnings)]
        behind = (new[good][row] * beginnings[stop] / self.scale**2).sum(axis=1) > 0
        with np.errstate(invalid="ignore", divide="ignore"):
            bend = (new - tangent) / self._norm(y - x)[:, None]
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
        n_rk = self._n_rk(at, y)
        matrix, residual = self._system(at, y, n_rk)
        new = self._tangent(matrix, tangent)
        matrix[:, -1, :] = across
        change = solved(matrix, np.column_stack([-residual, np.zeros(len(at))]))
        y += change
        size = self._norm(change)
        with np.errstate(invalid="ignore"):
            cosine = (new * tangent / self.scale**2).sum(axis=1)
            near = (size < CORRECTION_RATIO * length) & (cosine > options.min_tangent_cosine)
        # Where steps are short, points must be as exact as these are short.
        small = np.minimum(TOLERANCE, SHORT * length)
        good = near & (size < small)
        easy = good.copy()
        open_ = np.flatnonzero(near & ~good)
        for attempt in range(options.max_corrections):
            if not len(open_):
                break
            residual = self._residual(at[open_], y[open_, :-1], y[open_, -1:], n_rk[open_])
            change = solved(matrix[open_], np.column_stack([-residual, np.zeros(len(open_))]))
            y[open_] += change
            now = self._norm(change)
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
            wanted = np.arccos(options.easy_tangent_cosine) / np.arccos(np.minimum(cosine, 1.0))
        factor = np.clip(wanted, options.step_shrink, np.where(easy, options.step_growth, 1.0))
        return y, new, good, np.where(good, factor, options.step_shrink)

    def _sideways(self, x: Array, y: Array, tangent: Array, new: Array) -> Array:
        """How far from y one comes from x in the direction of the mean of their tangents."""
        way, mean = y - x, tangent + new
        return self._norm(way - (self._norm(way) / self._norm(mean))[:, None] * mean)

    def _refined(self, at: Index, y: Array, across: Array, tangent: Array, n_rk: Index, rows: Index) -> Array:
        """Tangents of rows where they turn sharply, from derivatives there; corrects their points."""
        matrix, residual = self._system(at, y[rows], n_rk[rows])
        new = self._tangent(matrix, tangent[rows])
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
        across = tangent / self.scale**2
        across[at_end] = np.eye(x.shape[1])[-1]
        return y, across, length

    def _system(self, at: Index, x: Array, n_rk: Index) -> tuple[Array, Array]:
        """Derivative of the residual with a last row to be filled in, shape (m, nz + 2, nz + 2); residual."""
        u, s = x[:, :-1], x[:, -1:]
        n = u.shape[1]
        jacobian, along, residual = self.kernels.jacobian_along(
            n_rk, u, self._point(at, s), self.direction[at]
        )
        matrix = np.zeros((len(x), n + 1, n + 1))
        matrix[:, :n, :n] = jacobian
        matrix[:, :n, n] = along
        return matrix, residual

    def _residual(self, at: Index, u: Array, s: Array, n_rk: Index) -> Array:
        return self.kernels.residual(n_rk, u, self._point(at, s))

    def _point(self, at: Index, s: Array) -> Array:
        """Parameters at fractions of lines, shape (k, n_params)."""
        return np.asarray(self.params[at] + s * self.direction[at])

    def _modes(self) -> Array:
        """The fastest mode in each interval of the line of each branch, shape (m, MODES)."""
        first, fractions = self.first, np.linspace(0, 1, MODES + 1)
        points = self.params[first, None] + fractions[:, None] * self.direction[first, None]
        modes = self.resolution.fastest_mode(points.reshape(-1, points.shape[2])).reshape(len(first), -1)
        return np.asarray(np.maximum(modes[:, 1:], modes[:, :-1])[self.line])

    def _n_rk(self, at: Index, x: Array) -> Index:
        """RK steps of a walking step near points."""
        interval = np.clip(np.nan_to_num(x[:, -1]) * MODES, 0, MODES - 1).astype(np.int64)
        return self.resolution.branch_n_rk(x[:, -2], self.modes[at, interval])

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
        return np.asarray(np.sqrt(((x / self.scale) ** 2).sum(axis=1)))
