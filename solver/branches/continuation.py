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
from stridemap.solver.branches.arcs import Lines
from stridemap.solver.branches.arcs_in_lanes import arcs_for
from stridemap.solver.branches.heads import Heads, Points
from stridemap.solver.branches.stops import Stops
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.options import IN_SWEEPS, ContinuationOptions

Array = NDArray[np.float64]
Index = NDArray[np.int64]
Mask = NDArray[np.bool_]

PATIENCE = 2.0
"""Length along which a branch is followed without a gait on it."""

LOOK = 8
"""Arclength steps, failed ones included, after which a look is taken whether cycles may be gaits."""


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
    branches = _Branches(Lines(solver, params, target), options or IN_SWEEPS, period_range, may_be_gaits)
    x = np.column_stack([u, s])
    return branches.upwards(x) if upwards else branches.both_ways(x, known)


def _at_end(s: Array, slope: Array) -> Mask:
    """Whether points are at the end of their line to which their tangents point."""
    return ((s <= 0) & (slope < 0)) | ((s >= 1) & (slope > 0))


@dataclass(frozen=True)
class _Branches:
    """Branches that are being followed, each on its line."""

    lines: Lines
    options: ContinuationOptions
    period_range: tuple[float, float]
    may_be_gaits: Callable[[Array, Array], Mask] | None

    def both_ways(self, x: Array, known: Known) -> Followed:
        """Follow all one way first, and then those the other way that none of the others has come along."""
        points = np.concatenate([x, np.column_stack([known.u, known.s])])
        number = self.lines.number
        stops = Stops(points, np.concatenate([number, number[known.branch]]), self.lines.scale)
        return self._followed(x, self._oriented(x), stops, back=True)

    def upwards(self, x: Array) -> Followed:
        """Follow all towards s = 1 only, each to its own end."""
        tangent, _ = self.lines.tangents(x)
        return self._followed(x, tangent, Stops.none(self.lines.scale), back=False)

    def _oriented(self, x: Array) -> Array:
        """Unit tangents that point the same way all along a curve, folds included: by a determinant's sign.

        With tangents towards s = 1, what lies between two beginnings around a fold would be followed twice.
        """
        tangent, matrix = self.lines.tangents(x)
        with np.errstate(invalid="ignore"):
            return np.where(np.linalg.det(matrix)[:, None] < 0, -tangent, tangent)

    def _followed(self, x: Array, tangent: Array, stops: Stops, back: bool) -> Followed:
        """Follow branches ahead to their ends; with `back` then the other way.

        That way begins on each line when none is left on it, for those that no other one has come along.
        """
        line = self.lines.number
        arcs = arcs_for(self.lines, self.options, self.period_range, stops, tangent)
        came_along = np.zeros(len(x), dtype=bool)
        heads = self._beginning(np.arange(len(x)), x, tangent, ahead=True)
        passed = [heads.points]
        waiting = np.full(len(self.lines.first), back)  # lines whose way back has not begun
        while True:
            heads = arcs.going(heads)
            begins = waiting.copy()
            begins[line[heads.branch[heads.ahead]]] = False
            if begins.any():
                at = np.flatnonzero(begins[line] & ~came_along)
                begun = self._beginning(at, x[at], -tangent[at], ahead=False)
                passed.append(begun.points)
                heads, waiting = Heads.concatenate([heads, begun]), waiting & ~begins
                continue
            if not len(heads):
                break
            heads, points, met = arcs.taken(self._promising(heads), LOOK)
            passed.append(points)
            came_along[met] = True
        whole = Points.concatenate(passed)
        order = np.lexsort((whole.ahead, whole.branch))
        return Followed(
            self.lines.scale, whole.branch[order], whole.ahead[order], whole.x[order], whole.tangent[order]
        )

    def _beginning(self, at: Index, x: Array, tangent: Array, ahead: bool) -> Heads:
        """Branches at their beginnings; those that cannot be followed end there."""
        begins = np.isfinite(tangent).all(axis=1) & ~_at_end(x[:, -1], tangent[:, -1])
        return Heads.beginning(at, ahead, x, tangent, np.where(begins, self.options.ds, 0.0))

    def _promising(self, heads: Heads) -> Heads:
        """Those on whose branches there was a gait not long ago."""
        if self.may_be_gaits is None or not len(heads):
            return heads
        points = self.lines.point(heads.branch, heads.x[:, -1:])
        idle = np.where(self.may_be_gaits(heads.x[:, :-1], points), 0.0, heads.idle)
        return replace(heads, idle=idle).take(idle <= PATIENCE)
