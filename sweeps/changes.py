"""Where something happens along branches that were followed: pieces between two points that differ.

The points of a branch are guesses. So is what is found here: which pieces are worth a closer look.
"""

from dataclasses import dataclass, fields

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.branches.conditions import GaitConditions, GaitEnd
from stridemap.solver.cycles import floquet
from stridemap.solver.cycles.acceptance import DOUBTFUL, clearly_no_gaits

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
Mask = NDArray[np.bool_]
Complex = NDArray[np.complex128]

POINTS = 512
"""So many points are looked at in one go: traces are large."""


@dataclass(frozen=True)
class Stretches:
    """Points of followed branches, in order along each.

    Parameters
    ----------
    cell : ndarray of int, shape (n,)
        A cell of the line of each.
    branch : ndarray of int, shape (n,)
        Number of the branch.
    stretch : ndarray of int, shape (n,)
        Points of one stretch, which follow one another, are neighbours along a branch.
    u : ndarray, shape (n, nz + 1)
        Section points and periods.
    params : ndarray, shape (n, n_params)
    tangent : ndarray, shape (n, nz + 2)
        Directions in the unknowns, and in the parameter that varies.
    n_rk : ndarray of int, shape (n,)
        RK steps with which they are looked at.
    """

    cell: Ints
    branch: Ints
    stretch: Ints
    u: Floats
    params: Floats
    tangent: Floats
    n_rk: Ints

    def __len__(self) -> int:
        return len(self.cell)

    def take(self, index: Mask) -> "Stretches":
        """Some of the points, in order."""
        return Stretches(*(getattr(self, column.name)[index] for column in fields(self)))

    @property
    def joined(self) -> Mask:
        """Whether a point and the next one are neighbours along a branch, shape (n - 1,)."""
        return np.asarray(self.stretch[:-1] == self.stretch[1:])


FOLD, BP, UNSTABLE, CYCLE, CONTACT = range(5)
"""Columns of the sides of points: on which side they are of a fold and of a branch point, how many
multipliers are outside the unit circle, whether it is a limit cycle, and whether that keeps contact.

There is none for doublings and tori: these change how many multipliers are outside. The sign of their own
tests changes elsewhere too, where a multiplier goes through infinity as the foot grazes the ground."""

UNKNOWN = -9
"""The side of a point that was not looked at."""


def changes(sides: Ints, others: Ints) -> Mask:
    """Whether something happens between pairs of points, shape (n,), by their sides, shape (n, 5)."""
    differ = sides != others
    cycle = (sides[:, CYCLE] > 0) | (others[:, CYCLE] > 0)
    return np.asarray(cycle & differ.any(axis=1))


def sides_of_guesses(stretches: Stretches, conditions: GaitConditions) -> Ints:
    """Sides of all points that may be limit cycles and of their neighbours, shape (n, 5)."""
    kernels = conditions.kernels
    may_be = np.zeros(len(stretches), dtype=bool)
    for at in _batches(stretches, np.arange(len(stretches))):
        codes = clearly_no_gaits(kernels, int(stretches.n_rk[at[0]]), stretches.u[at], stretches.params[at])
        may_be[at] = codes == DOUBTFUL
    begins = np.flatnonzero(stretches.joined & (may_be[:-1] | may_be[1:]))
    out = np.full((len(stretches), 5), UNKNOWN)
    for at in _batches(stretches, np.union1d(begins, begins + 1)):
        n_rk, u, params = int(stretches.n_rk[at[0]]), stretches.u[at], stretches.params[at]
        jacobian, _ = kernels.jacobian(n_rk, u, params)
        holds = conditions.of_steps(n_rk, u, params)
        out[at] = sides(stretches.tangent[at, -1], jacobian, floquet.multipliers(jacobian), holds)
    return out


def sides(ahead: Floats, jacobian: Floats, multipliers: Complex, conditions: dict[GaitEnd, Floats]) -> Ints:
    """Sides of points, shape (n, 5).

    Parameters
    ----------
    ahead : ndarray, shape (n,)
        Component of the tangent in the parameter.
    jacobian : ndarray, shape (n, nz + 1, nz + 1)
        Derivative of the residual.
    multipliers : ndarray of complex, shape (n, nz)
    conditions : dict of GaitEnd to ndarray, shape (n,)
        What is positive at a gait.
    """
    out = np.empty((len(ahead), 5), dtype=np.int64)
    with np.errstate(invalid="ignore"):
        out[:, FOLD] = ahead > 0
        # What is zero at a branch point is, up to a factor above 0, det(J) / ahead.
        out[:, BP] = np.linalg.slogdet(np.nan_to_num(jacobian))[0] * ahead > 0
        out[:, UNSTABLE] = (np.abs(multipliers) > 1.0).sum(axis=1)
        out[:, CONTACT] = conditions[GaitEnd.CONTACT] > 0
        out[:, CYCLE] = cycles(conditions)
    out[out[:, CYCLE] == 0, CONTACT] = 0
    return out


def cycles(conditions: dict[GaitEnd, Floats]) -> Mask:
    """Which points are limit cycles, whether or not they keep contact."""
    return np.asarray(np.all([v > 0 for name, v in conditions.items() if name != GaitEnd.CONTACT], axis=0))


def _batches(stretches: Stretches, points: Ints) -> list[Ints]:
    """Points in groups of one resolution each."""
    out: list[Ints] = []
    for n in np.unique(stretches.n_rk[points]).tolist():
        at = points[stretches.n_rk[points] == n]
        out += np.array_split(at, -(-len(at) // POINTS))
    return out
