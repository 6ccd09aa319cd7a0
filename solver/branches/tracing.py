"""A branch of limit cycles traced point by point over one parameter, through folds, to both of its ends.

Pseudo-arclength continuation as in `stridemap.solver.branches.continuation`, of one branch at a time and with
every point kept: what is looked for along a branch needs the points in between, not only its ends.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.cycles.solver import Solver

Array = NDArray[np.float64]

DIFFERENCE = 1e-6
"""Of the parameter, in terms of its range, for the derivative with respect to it."""
CORRECTIONS = 20
"""Newton's corrections at one point; a few suffice, and more than this means that there is no such point."""
CLOSE = 1e-13
"""Largest correction, in terms of the scale, that is the last."""
FIRST, LONGEST, SHORTEST = 1e-3, 0.05, 1e-7
"""Arclength steps. The longest cuts the range of the parameter, or the search box, into at least twenty."""
GROWTH, SHRINKAGE = 1.5, 0.4
STRAIGHT = 0.95
"""Smallest cosine of the angle by which the tangent turns in one step."""
MAX_POINTS = 2000
"""Points in one direction: a branch across the whole range has about fifty."""


@dataclass(frozen=True)
class Line:
    """A line of parameter space along which one parameter varies.

    Parameters
    ----------
    solver : Solver
    point : ndarray, shape (n_params,)
        The other parameters.
    parameter : str
    low, high : float
        Ends of the parameter's range.
    period_range : (float, float)
    """

    solver: Solver
    point: Array
    parameter: str
    low: float
    high: float
    period_range: tuple[float, float]

    @property
    def column(self) -> int:
        """Place of the parameter among all."""
        return self.solver.model.spec.names.index(self.parameter)

    @property
    def scale(self) -> Array:
        """What counts as far in each entry of (section point, period, parameter)."""
        longest = self.period_range[1] - self.period_range[0]
        return np.array([*self.solver.model.spec.scales, longest, self.high - self.low])

    def params(self, values: Array) -> Array:
        """Parameter points at values of the parameter, shape (n, n_params)."""
        points = np.repeat(self.point[None, :], len(values), axis=0)
        points[:, self.column] = values
        return points

    def system(self, n_rk: int, x: Array) -> tuple[Array, Array]:
        """Derivative of the residual by x = (u, p), with a last row to be filled in, and the residual."""
        kernels, n, step = self.solver.kernels, len(x) - 1, DIFFERENCE * (self.high - self.low)
        points = self.params(x[-1] + np.array([0.0, step, -step]))
        jacobian, residual = kernels.jacobian(n_rk, x[None, :-1], points[:1])
        beside = kernels.residual(n_rk, np.repeat(x[None, :-1], 2, axis=0), points[1:])
        matrix = np.zeros((n + 1, n + 1))
        matrix[:n, :n], matrix[:n, n] = jacobian[0], (beside[0] - beside[1]) / (2 * step)
        return matrix, residual[0]

    def corrected(self, n_rk: int, x: Array, normal: Array, close: float = CLOSE) -> Array | None:
        """The point of the branch in the plane through x across `normal`; None where there is none."""
        first = x
        for _ in range(CORRECTIONS):
            matrix, residual = self.system(n_rk, x)
            matrix[-1] = normal
            change = _solved(matrix, np.append(residual, normal @ (x - first)))
            if change is None:
                return None
            x = x - change
            size = np.abs(change / self.scale).max()
            if size < close:
                return x
            if size > 1:
                return None
        return None

    def n_rk(self, x: Array) -> int:
        """RK steps at a point."""
        return int(self.solver.resolution.cycle_n_rk(x[-2:-1], self.params(x[-1:]))[0])


def traced(line: Line, u: Array, value: float) -> Array:
    """The branch through a limit cycle, from one end to the other.

    Parameters
    ----------
    line : Line
    u : ndarray, shape (nz + 1,)
        Section point and period.
    value : float
        The parameter's.

    Returns
    -------
    ndarray, shape (n, nz + 2)
        Section points, periods and values of the parameter, in order.
    """
    x = np.append(u, value)
    ahead = np.zeros_like(x)
    ahead[-1] = 1.0
    tangent = _tangent(line, line.n_rk(x), x, ahead)
    if tangent is None:
        return x[None, :]
    sides = [_one_way(line, x, direction * tangent) for direction in (-1.0, 1.0)]
    return np.array([*sides[0][::-1], x, *sides[1]])


def _one_way(line: Line, x: Array, tangent: Array) -> list[Array]:
    """Points of a branch in one direction, without the first."""
    out: list[Array] = []
    ds, start, scale = FIRST, x, line.scale
    while ds >= SHORTEST and len(out) < MAX_POINTS:
        guess = x + ds * tangent
        ended = not line.low <= guess[-1] <= line.high
        if ended:  # the last step leads to the end of the range, and no further
            end = line.low if guess[-1] < line.low else line.high
            guess = x + (end - x[-1]) / tangent[-1] * tangent
            guess[-1] = end
        normal = np.eye(len(x))[-1] if ended else tangent / scale**2
        y = line.corrected(line.n_rk(x), guess, normal, close=1e-9)
        new = None if y is None else _tangent(line, line.n_rk(x), y, tangent)
        good = y is not None and new is not None and float((new * tangent / scale**2).sum()) > STRAIGHT
        if not good or y is None or new is None or not line.low <= y[-1] <= line.high:
            ds *= SHRINKAGE
            continue
        out.append(y)
        inside = line.period_range[0] < y[-2] <= line.period_range[1]
        back = len(out) > 2 and np.abs((y - start) / scale).max() < 0.5 * ds
        if ended or not inside or back:
            break
        x, tangent, ds = y, new, min(GROWTH * ds, LONGEST)
    return out


def _tangent(line: Line, n_rk: int, x: Array, ahead: Array) -> Array | None:
    """Unit tangent on the same side as `ahead`."""
    matrix, _ = line.system(n_rk, x)
    matrix[-1] = ahead / line.scale**2
    tangent = _solved(matrix, np.eye(len(x))[-1])
    return None if tangent is None else tangent / float(np.sqrt(((tangent / line.scale) ** 2).sum()))


def _solved(matrix: Array, right: Array) -> Array | None:
    """Solution of a linear system; None where there is none."""
    if not (np.isfinite(matrix).all() and np.isfinite(right).all()):
        return None
    try:
        solution: Array = np.asarray(np.linalg.solve(matrix, right), dtype=np.float64)
    except np.linalg.LinAlgError:
        return None
    return solution
