"""Bifurcations of cycles on a curve, each located by Newton's method on a system of its own.

With the derivative J of a chain's residual, W the part of it that leads from the last step back to the first,
and

    M(lambda) = J + (1 - lambda) W,

lambda is a Floquet multiplier of the cycle where M(lambda) is singular. Bordered by any two vectors b and c,

    [ M  b ] [ w ]   [ 0 ]
    [ c' 0 ] [ g ] = [ 1 ]

g is zero there and smooth, and its derivative is ``-psi' dM w`` with the solution psi of the transposed
system (W. Govaerts, Numerical Methods for Bifurcations of Dynamical Equilibria, 2000, chapter 3). So ``R = 0,
g = 0`` is a regular system for a fold (lambda = 1), a period doubling (-1), and, with the angle as one more
unknown and g complex, a torus (exp(i theta)). At a branch point the augmented system of H. D. Mittelmann and
H. Weber (1980) is regular: ``R + mu psi = 0, DR' psi = 0, |psi| = 1``.
"""

import itertools
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from enum import StrEnum

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.branches.arclength import CurvePoint
from stridemap.solver.branches.curve import Curve
from stridemap.solver.branches.equations import CycleEquations
from stridemap.solver.kernels.catalogue import CYCLE_N_RK
from stridemap.solver.linear import solved
from stridemap.solver.options import ContinuationOptions

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]


BISECTIONS = 24
"""How often the bracket of one special point is halved before Newton's method must succeed."""


class SpecialType(StrEnum):
    """What happens at a special point."""

    FOLD = "fold"
    PD = "pd"
    NS = "ns"
    BP = "bp"


@dataclass(frozen=True)
class Special:
    """A special point.

    Parameters
    ----------
    type : SpecialType
    x : ndarray, shape (N + 1,)
        Unknowns of the chain, and the parameter.
    multipliers : ndarray of complex, shape (nz,)
    null : ndarray, shape (N,) or (N + 1,)
        The direction that neither grows nor shrinks, in the unknowns of all steps; of a branch point, the
        second tangent, with that of the parameter.
    residual : float
        Largest entry of its defining system.
    slope : float
        Change along the branch, per unit of arclength, of what passes through a value there: of a doubling's
        multiplier, of the modulus of a torus's; of a fold, of the parameter's share in the tangent. A special
        point whose slope is not zero is truly crossed.
    multiplier : complex
        The one that crosses the unit circle.
    direction : float
        Change of the parameter per unit of arclength.
    """

    type: SpecialType
    x: Array
    multipliers: Complex
    null: NDArray[np.complex128] | Array
    residual: float
    slope: float
    multiplier: complex
    direction: float


# -- test functions --------------------------------------------------------------------------------------


def unstable_count(point: CurvePoint) -> int:
    """Number of multipliers outside the unit circle."""
    return int((np.abs(point.multipliers) > 1.0).sum())


def tests(curve: Curve, point: CurvePoint) -> dict[SpecialType, float]:
    """What changes its sign at each type of special point."""
    multipliers = point.multipliers
    i, j = np.triu_indices(len(multipliers), 1)
    square = np.vstack([point.matrix * curve.scale, point.tangent / curve.scale])
    return {
        SpecialType.FOLD: float(point.tangent[-1]),
        SpecialType.PD: float(np.prod(1.0 + multipliers).real),
        SpecialType.NS: float(np.prod(multipliers[i] * multipliers[j] - 1.0).real) if len(i) else 1.0,
        SpecialType.BP: float(np.linalg.slogdet(square)[0]),
    }


def special_points(
    curve: Curve, points: list[CurvePoint], options: ContinuationOptions
) -> Iterator[tuple[int, Special]]:
    """Bifurcations between neighbouring points of a curve, each with the number of the point before it."""
    for number, (one, other) in enumerate(itertools.pairwise(points)):
        for special in _between(curve, one, other, options, SUBDIVISIONS):
            yield number, special


def _between(
    curve: Curve, one: CurvePoint, other: CurvePoint, options: ContinuationOptions, depth: int
) -> list[Special]:
    """Bifurcations between two points of a curve, in order."""
    first, second = tests(curve, one), tests(curve, other)
    crossed = [kind for kind in SpecialType if first[kind] * second[kind] < 0]
    change = abs(unstable_count(other) - unstable_count(one))
    if not change and (not crossed or _hollow(crossed, one, other)):
        return []
    found = [located(curve, kind, one, other, options) for kind in crossed] if len(crossed) < 2 else []
    specials = [special for special in found if special is not None]
    explained = sum(CHANGES[special.type] for special in specials)
    # Two doublings leave the sign of their test as it was: what the count of multipliers says must add up.
    if len(crossed) < 2 and change <= explained and (explained - change) % 2 == 0:
        return specials
    middle = point_between(curve, one, other, options) if depth else None
    if middle is not None:
        return [
            *_between(curve, one, middle, options, depth - 1),
            *_between(curve, middle, other, options, depth - 1),
        ]
    halvings = BISECTIONS - 2 * (SUBDIVISIONS - depth)
    found = [located(curve, kind, one, other, options, halvings) for kind in crossed]
    return [special for special in found if special is not None]


def _hollow(crossed: list[SpecialType], one: CurvePoint, other: CurvePoint) -> bool:
    """Whether the only sign that changes between two points, as many multipliers outside, means nothing.

    A multiplier goes through infinity where the foot grazes the ground, and two real ones can have the
    product 1. A doubling would change how many are outside, and so would a torus, which needs a pair.
    """
    real = not (one.multipliers.imag.any() or other.multipliers.imag.any())
    return crossed == [SpecialType.PD] or (crossed == [SpecialType.NS] and real)


CHANGES = {SpecialType.FOLD: 1, SpecialType.PD: 1, SpecialType.NS: 2, SpecialType.BP: 1}
"""By how much each changes the number of multipliers outside the unit circle."""


def point_between(
    curve: Curve, one: CurvePoint, other: CurvePoint, options: ContinuationOptions, part: float = 0.5
) -> CurvePoint | None:
    """A point of the curve between two."""
    if not curve.dot(other.x - one.x, one.tangent) > 0:
        return None
    n_rk = max(one.n_rk, other.n_rk)
    guess = one.x + part * (other.x - one.x)
    found = curve.corrected(guess, one.tangent, n_rk, options.max_corrections + 3)
    return CurvePoint.at(curve, found, one.tangent, n_rk) if found.converged else None


def located(
    curve: Curve,
    kind: SpecialType,
    one: CurvePoint,
    other: CurvePoint,
    options: ContinuationOptions,
    halvings: int = BISECTIONS,
) -> Special | None:
    """The special point of a type between two points of a curve; None where there is none after all.

    Newton's method starts from a bracket that is halved until it converges to a point within.
    """
    sign, growing, real = tests(curve, one)[kind], 0, 0
    for _ in range(halvings):
        guess = _likeliest(curve, kind, one, other)
        special = _SOLVERS[kind](curve, guess)
        if special is not None and _within(curve, one, other, special.x):
            return _refined(curve, special, guess)
        middle = point_between(curve, one, other, options)
        if middle is None:
            return None
        largest = max(abs(tests(curve, one)[kind]), abs(tests(curve, other)[kind]))
        growing = growing + 1 if abs(tests(curve, middle)[kind]) > largest else 0
        real += kind == SpecialType.NS and not any(p.multipliers.imag.any() for p in (one, middle, other))
        if POLE in (growing, real):
            return None  # it goes through infinity, where the foot grazes the ground; or there is no pair
        one, other = (middle, other) if tests(curve, middle)[kind] * sign > 0 else (one, middle)
    return None


def _refined(curve: Curve, special: Special, guess: CurvePoint) -> Special:
    """The same special point at ever finer resolutions, until it does not change any more."""
    n_rk = _finer(guess.n_rk)
    while n_rk < CYCLE_N_RK[-1]:
        guess = CurvePoint(special.x, guess.tangent, guess.matrix, special.multipliers, n_rk)
        finer = _SOLVERS[special.type](curve, guess)
        if finer is None:
            break
        change = curve.norm(finer.x - special.x)
        special, n_rk = finer, _finer(n_rk)
        if change < RESOLVED * GAIN:
            break
    return special


def _likeliest(curve: Curve, kind: SpecialType, one: CurvePoint, other: CurvePoint) -> CurvePoint:
    """The end of a bracket that is nearer to the special point, moved there linearly."""
    before, after = abs(tests(curve, one)[kind]), abs(tests(curve, other)[kind])
    part = before / (before + after) if before + after > 0 else 0.5
    near = one if part < 0.5 else other
    return CurvePoint(
        one.x + part * (other.x - one.x), near.tangent, near.matrix, near.multipliers, near.n_rk
    )


def _within(curve: Curve, one: CurvePoint, other: CurvePoint, x: Array) -> bool:
    """Whether a point lies between two others, or hardly beyond them."""
    length = curve.norm(other.x - one.x)
    slack = 1e-3 * length + 1e-9
    return (
        curve.dot(x - one.x, one.tangent) > -slack
        and curve.dot(other.x - x, other.tangent) > -slack
        and curve.norm(x - one.x) < 1.5 * length + 1e-9
    )


# -- systems ---------------------------------------------------------------------------------------------


def wrap(equations: CycleEquations) -> Array:
    """The matrix W: what leads from the first point to the residual of the last step, shape (N, N)."""
    width, nz = equations.chain.width, equations.chain.width - 1
    size = equations.n_unknowns
    matrix = np.zeros((size, size))
    matrix[np.arange(size - width, size - 1), np.arange(nz)] = 1.0
    return matrix


@dataclass(frozen=True)
class Bordered:
    """The bordered system of M(lambda) at a point.

    Parameters
    ----------
    w, psi : ndarray, shape (N,)
        Solutions of the system and of its transpose.
    g : complex or float
    """

    w: Array | Complex
    psi: Array | Complex
    g: complex

    @classmethod
    def of(cls, matrix: Array | Complex, b: Array | Complex, c: Array | Complex) -> "Bordered":
        """Solve the system with borders b and c."""
        size = len(matrix)
        whole = np.zeros((size + 1, size + 1), dtype=matrix.dtype)
        whole[:size, :size], whole[:size, size], whole[size, :size] = matrix, b, c
        right = np.zeros(size + 1, dtype=matrix.dtype)
        right[size] = 1.0
        one, other = solved(whole, right), solved(whole.T, right)
        return cls(one[:size], other[:size], one[size])


def _borders(matrix: Array | Complex) -> tuple[Array, Array]:
    """The singular vectors of the smallest singular value: borders that make the system best conditioned."""
    u, _, vh = np.linalg.svd(matrix)
    return u[:, -1], vh[-1].conj() if np.iscomplexobj(vh) else vh[-1]


def _finer(n_rk: int) -> int:
    """Twice a resolution, or the finest that there is."""
    return min(2 * n_rk, CYCLE_N_RK[-1])


def _real_multiplier(kind: SpecialType, value: float) -> Callable[[Curve, CurvePoint], Special | None]:
    """A solver of ``R = 0, g = 0`` for a fixed real multiplier."""

    def solve(curve: Curve, guess: CurvePoint) -> Special | None:
        x, turned, parts = guess.x.copy(), (1.0 - value) * wrap(curve.equations), None
        n_rk = _finer(guess.n_rk)
        for _ in range(ITERATIONS):
            matrix, residual = curve.linearised(x, n_rk)
            if not np.isfinite(matrix).all():
                return None
            singular = (matrix[:, :-1] + turned) * curve.scale[:-1]
            parts = parts or _borders(singular)
            solution = Bordered.of(singular, *parts)
            w = solution.w * curve.scale[:-1]
            gradient = -solution.psi @ curve.second(x, np.append(w, 0.0), n_rk)
            size = max(np.abs(residual).max(), abs(solution.g))
            change = solved(np.vstack([matrix, gradient]), -np.append(residual, solution.g))
            if not np.isfinite(change).all():
                return None
            if size < SPECIAL_RESIDUAL and curve.norm(change) < SETTLED:
                x += change
                tangent = curve.tangent(matrix, guess.tangent)
                if kind == SpecialType.FOLD:
                    slope = _fold_curvature(curve, x, np.real(w), solution, n_rk)
                else:  # M w = 0 along the curve: the multiplier's change is psi' dM w / psi' W w
                    slope = float(-(gradient @ tangent) / (solution.psi @ wrap(curve.equations) @ w))
                multipliers = curve.multipliers(matrix)
                return Special(kind, x, multipliers, w, size, slope, complex(value), tangent[-1])
            x += change
        return None

    return solve


def _fold_curvature(curve: Curve, x: Array, w: Array, solution: Bordered, n_rk: int) -> float:
    """Change of the tangent's parameter per arclength at a fold: not zero where the curve turns back."""
    v = np.append(w, 0.0) / curve.norm(np.append(w, 0.0))
    along = curve.linearised(x, n_rk)[0][:, -1]
    bend = curve.second(x, v, n_rk) @ v
    return float(-(solution.psi @ bend) / (solution.psi @ along) / curve.scale[-1])


def _torus(curve: Curve, guess: CurvePoint) -> Special | None:
    """A solver of ``R = 0, g(theta) = 0`` with complex g."""
    x, weave = guess.x.copy(), wrap(curve.equations)
    complex_ones = guess.multipliers[guess.multipliers.imag > 0]
    if not len(complex_ones):
        return None  # a pair of real multipliers whose product is 1
    theta = float(np.angle(complex_ones[np.abs(np.abs(complex_ones) - 1.0).argmin()]))
    n_rk, parts = (_finer(guess.n_rk)), None
    for _ in range(ITERATIONS):
        matrix, residual = curve.linearised(x, n_rk)
        if not np.isfinite(matrix).all():
            return None
        root = np.exp(1j * theta)
        singular = (matrix[:, :-1] + (1.0 - root) * weave) * curve.scale[:-1]
        if parts is None:
            b, c = _borders(singular)
            parts = b, c.conj()
        solution = Bordered.of(singular, *parts)
        w = solution.w * curve.scale[:-1]
        gradient = -solution.psi @ curve.second(x, np.append(w, 0.0), n_rk)
        turn = solution.psi @ (1j * root * weave) @ w
        rows = np.vstack(
            [
                np.column_stack([matrix, np.zeros(len(matrix))]),
                np.append(gradient.real, turn.real),
                np.append(gradient.imag, turn.imag),
            ]
        )
        g = complex(solution.g)
        size = max(np.abs(residual).max(), abs(g))
        change = solved(rows, -np.array([*residual, g.real, g.imag]))
        if not np.isfinite(change).all():
            return None
        if size < SPECIAL_RESIDUAL and curve.norm(change[:-1]) < SETTLED:
            x += change[:-1]
            if not 1e-6 < theta < np.pi - 1e-6:
                return None
            multipliers = curve.multipliers(matrix)
            tangent = curve.tangent(matrix, guess.tangent)
            # dlambda = psi' dM w / psi' W w; its component along lambda is the change of the modulus.
            growth = -(gradient @ tangent) / (solution.psi @ weave @ w)
            slope = float((growth / root).real)
            return Special(SpecialType.NS, x, multipliers, w, size, slope, complex(root), tangent[-1])
        x += change[:-1]
        theta += change[-1]
    return None


def _branch_point(curve: Curve, guess: CurvePoint) -> Special | None:
    """A solver of ``R + mu psi = 0, DR' psi = 0, |psi| = 1``."""
    x, n_rk = guess.x.copy(), _finer(guess.n_rk)
    matrix, _ = curve.linearised(x, n_rk)
    psi, mu = np.linalg.svd(matrix * curve.scale)[0][:, -1], 0.0
    size = len(psi)
    for _ in range(ITERATIONS):
        matrix, residual = curve.linearised(x, n_rk)
        if not np.isfinite(matrix).all():
            return None
        contracted = np.stack([psi @ curve.second(x, one, n_rk) for one in np.eye(size + 1)])
        rows = np.zeros((2 * size + 2, 2 * size + 2))
        rows[:size, : size + 1], rows[:size, size + 1], rows[:size, size + 2 :] = (
            matrix,
            psi,
            mu * np.eye(size),
        )
        rows[size : 2 * size + 1, : size + 1] = contracted
        rows[size : 2 * size + 1, size + 2 :] = matrix.T
        rows[-1, size + 2 :] = 2 * psi
        right = np.concatenate([residual + mu * psi, matrix.T @ psi, [psi @ psi - 1.0]])
        change = solved(rows, -right)
        if not np.isfinite(change).all():
            return None
        error = float(np.abs(right).max())
        if (
            error < SPECIAL_RESIDUAL
            and abs(mu) < SPECIAL_RESIDUAL
            and curve.norm(change[: size + 1]) < SETTLED
        ):
            return _branch_point_at(curve, x, matrix, guess, max(error, abs(mu)))
        x, mu, psi = x + change[: size + 1], mu + float(change[size + 1]), psi + change[size + 2 :]
    return None


def _branch_point_at(
    curve: Curve, x: Array, matrix: Array, guess: CurvePoint, error: float
) -> Special | None:
    """A branch point with the direction across the curve in the plane of its two tangents."""
    kernel = np.linalg.svd(matrix * curve.scale)[2][-2:]
    along = kernel @ (guess.tangent / curve.scale)
    across = np.array([-along[1], along[0]]) @ kernel
    multipliers = curve.multipliers(matrix)
    singular = np.linalg.svd(matrix * curve.scale, compute_uv=False)
    slope = float(singular[-2]) if len(singular) > 1 else 1.0
    return Special(
        SpecialType.BP, x, multipliers, across * curve.scale, error, slope, 1.0 + 0.0j, guess.tangent[-1]
    )


_SOLVERS = {
    SpecialType.FOLD: _real_multiplier(SpecialType.FOLD, 1.0),
    SpecialType.PD: _real_multiplier(SpecialType.PD, -1.0),
    SpecialType.NS: _torus,
    SpecialType.BP: _branch_point,
}

SUBDIVISIONS = 8
"""How often a part of a curve is halved in which several things happen at once."""

POLE = 4
"""Halvings at which a test function grows, after which it has a pole and not a zero; also those at which
there are real multipliers only, after which two of them have the product 1 and do not make a torus."""

ITERATIONS = 15
"""Newton iterations of one attempt."""

RESOLVED, GAIN = 1e-12, 32.0
"""Error of a special point, in terms of the scale, that needs no finer resolution, and by which factor at
least it is smaller than what twice the resolution has changed: 256 with a method of order 8."""

SPECIAL_RESIDUAL, SETTLED = 1e-11, 1e-7
"""Residual of a special point, and the size of a Newton step after which the next one would be lost in
rounding, in terms of the scale."""
