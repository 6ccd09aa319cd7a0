"""Points on boundaries at which two things happen at once, each located by Newton's method on its own system.

The tests, which change their sign there, are functions of the null vectors psi and w of M(lambda) (see
`solver.boundaries.systems`), of the residual's second and third derivatives B and C, and of the multipliers
other than lambda:

- cusp of folds: ``psi' B(w, w)``;
- generalised doubling: ``psi' (C(w, w, w) / 6 + B(w, h))`` with ``J h = -B(w, w) / 2``, the coefficient of
  the doubled cycle's amplitude cubed (Liapunov-Schmidt reduction of the doubled chain, which the exchange of
  its halves leaves as it is);
- resonances 1:1 and 1:2, where lambda is a double multiplier: ``psi' W w``;
- resonances 1:3 and 1:4: the angle;
- fold-flip, and a pair on the circle beside a fold or a doubling: the other multipliers.

(Y. A. Kuznetsov, Elements of Applied Bifurcation Theory, 3rd ed., 2004, chapter 9.)
"""

import itertools
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from enum import StrEnum
from functools import partial

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.boundaries.systems import BoundaryCurve, MultiplierBoundary, Null, TorusBoundary
from stridemap.solver.branches.arclength import CurvePoint
from stridemap.solver.branches.bordered import wrap
from stridemap.solver.branches.equations import CycleEquations
from stridemap.solver.kernels.catalogue import CYCLE_N_RK
from stridemap.solver.linear import solved

Array = NDArray[np.float64]


class Codim2(StrEnum):
    """What happens at a point at which two things happen at once."""

    CUSP = "cusp"
    """Two folds meet."""
    R1 = "r1"
    """Resonance 1:1: a double multiplier 1."""
    R2 = "r2"
    """Resonance 1:2: a double multiplier -1."""
    R3 = "r3"
    """Resonance 1:3: multipliers exp(+-2 pi i / 3)."""
    R4 = "r4"
    """Resonance 1:4: multipliers +-i."""
    FOLD_FLIP = "fold_flip"
    """Multipliers 1 and -1."""
    GPD = "gpd"
    """Generalised doubling: from supercritical to subcritical."""
    FOLD_NS = "fold_ns"
    """A multiplier 1 beside a pair on the unit circle."""
    PD_NS = "pd_ns"
    """A multiplier -1 beside a pair on the unit circle."""


@dataclass(frozen=True)
class Codim2Point:
    """A point at which two things happen at once.

    Parameters
    ----------
    type : Codim2
    cycle : ndarray, shape (N + 2,)
        Unknowns of the chain, and the two parameters.
    multipliers : ndarray of complex, shape (nz,)
    residual : float
        Largest entry of its defining system.
    """

    type: Codim2
    cycle: Array
    multipliers: NDArray[np.complex128]
    residual: float


# -- tests along a curve -------------------------------------------------------------------------------------


def codim2_points(curve: BoundaryCurve, points: list[CurvePoint]) -> Iterator[tuple[int, Codim2Point]]:
    """Points at which two things happen at once, each with the number of the curve's point before it."""
    if isinstance(curve, MultiplierBoundary):
        tests = list(_multiplier_tests(curve, points))
    elif isinstance(curve, TorusBoundary):
        tests = [_torus_tests(curve, point) for point in points]
        yield from _at_ends(curve, points)
    else:
        return
    for number, (first, second) in enumerate(itertools.pairwise(tests)):
        for kind in first:
            if (first[kind] > 0) != (second[kind] > 0):
                part = first[kind] / (first[kind] - second[kind])
                one, other = points[number], points[number + 1]
                found = _located(curve, kind, one.x + part * (other.x - one.x), other.n_rk)
                if found is not None and _between(curve, one.x, other.x, found.cycle):
                    yield number, found


def with_ends(curve: TorusBoundary, points: list[CurvePoint]) -> list[CurvePoint]:
    """A curve of tori, its ends beyond a resonance 1:1 or 1:2 replaced by the resonance itself.

    Where the resonance is not found, the curve ends before it.
    """
    if len(points) < 2:
        return points
    first = [_end(curve, points[0], points[1])] if curve.beyond(points[0].x) else points[:1]
    last = [_end(curve, points[-1], points[-2])] if curve.beyond(points[-1].x) else points[-1:]
    return [point for point in [*first, *points[1:-1], *last] if point is not None]


def _end(curve: TorusBoundary, beyond: CurvePoint, inner: CurvePoint) -> CurvePoint | None:
    """The resonance between two points, with the tangent of the inner one."""
    theta, before = curve.angle(beyond.x), curve.angle(inner.x)
    limit = np.pi if theta >= np.pi else 0.0
    x = inner.x + (limit - before) / (theta - before) * (beyond.x - inner.x)
    double = MultiplierBoundary(curve.equations, 1.0 if limit == 0.0 else -1.0)
    found = _located(double, _DOUBLE[double.multiplier], curve.cycle(x), inner.n_rk)
    if found is None:
        return None
    x = np.insert(found.cycle, curve.equations.n_unknowns, limit)
    return CurvePoint(x, inner.tangent, inner.matrix, found.multipliers, inner.n_rk)


def _at_ends(curve: TorusBoundary, points: list[CurvePoint]) -> Iterator[tuple[int, Codim2Point]]:
    """The resonances at the ends of a curve of tori, as `with_ends` makes it."""
    for number, end in ((0, points[0]), (max(len(points) - 2, 0), points[-1])):
        if curve.beyond(end.x):
            cycle = curve.cycle(end.x)
            residual = float(np.abs(curve.equations.linearised(cycle, end.n_rk)[1]).max())
            kind = Codim2.R1 if curve.angle(end.x) == 0.0 else Codim2.R2
            yield number, Codim2Point(kind, cycle, end.multipliers, residual)


def _between(curve: BoundaryCurve, one: Array, other: Array, cycle: Array) -> bool:
    """Whether a cycle lies near a piece of the curve."""
    scale = curve.equations.scale
    first, second = curve.cycle(one) / scale, curve.cycle(other) / scale
    length = np.linalg.norm(second - first)
    distances = [np.linalg.norm(cycle / scale - end) for end in (first, second)]
    return bool(max(distances) < 1.5 * length + 1e-9)


def _multiplier_tests(curve: MultiplierBoundary, points: list[CurvePoint]) -> Iterator[dict[Codim2, float]]:
    """What changes its sign at each kind, at points of a curve of folds or doublings, in order."""
    null: Null | None = None
    for point in points:
        here = Null.at(curve.equations, point.x, point.n_rk, curve.multiplier)
        null = here if null is None else here.like(null)
        others = curve.others(point.x, point.multipliers)
        i, j = np.triu_indices(len(others), 1)
        pairs = float(np.prod(others[i] * others[j] - 1.0).real) if len(i) else 1.0
        flip = float(np.prod(others + curve.multiplier).real)
        tests = {_DOUBLE[curve.multiplier]: double_multiplier(curve.equations, null)}
        if curve.multiplier > 0:
            tests |= {Codim2.CUSP: cusp(curve.equations, null, point.x, point.n_rk), Codim2.FOLD_FLIP: flip}
            tests |= {Codim2.FOLD_NS: pairs}
        else:
            tests |= {Codim2.GPD: doubling_coefficient(curve.equations, null, point.x, point.n_rk)}
            tests |= {Codim2.FOLD_FLIP: flip, Codim2.PD_NS: pairs}
        yield tests


def _torus_tests(curve: TorusBoundary, point: CurvePoint) -> dict[Codim2, float]:
    """What changes its sign at each kind, at a point of a curve of tori."""
    theta = curve.angle(point.x)
    others = curve.others(point.x, point.multipliers)
    return {
        Codim2.R3: theta - 2 * np.pi / 3,
        Codim2.R4: theta - np.pi / 2,
        Codim2.FOLD_NS: float(np.prod(others - 1.0).real),
        Codim2.PD_NS: float(np.prod(others + 1.0).real),
    }


def double_multiplier(equations: CycleEquations, null: Null) -> float:
    """The scalar product psi' W w, zero where the multiplier is a double one."""
    return float(null.psi @ wrap(equations) @ null.w)


def cusp(equations: CycleEquations, null: Null, x: Array, n_rk: int) -> float:
    """The coefficient psi' B(w, w) of a fold, zero at a cusp."""
    return float(null.psi @ _bend(equations, null.w, x, n_rk))


def doubling_coefficient(equations: CycleEquations, null: Null, x: Array, n_rk: int) -> float:
    """The coefficient of a doubling that changes its sign where the doubled cycles change sides."""
    size = equations.n_unknowns
    h = solved(null.matrix[:, :size], -0.5 * _bend(equations, null.w, x, n_rk))
    mixed = equations.second(x, np.append(null.w, [0.0, 0.0]), n_rk)[:, :size] @ h
    ahead = np.append(null.w, [0.0, 0.0])
    bends = [_bend(equations, null.w, x + k * THIRD * ahead, n_rk) for k in (-3, -2, -1, 1, 2, 3)]
    third = np.array([-1, 9, -45, 45, -9, 1]) / (60 * THIRD) @ np.array(bends)
    return float(null.psi @ (third / 6 + mixed))


def _bend(equations: CycleEquations, w: Array, x: Array, n_rk: int) -> Array:
    """The second derivative of the residual along w, twice."""
    along = np.append(w, np.zeros(len(x) - len(w)))
    return equations.second(x, along, n_rk) @ along


# -- systems of their own ------------------------------------------------------------------------------------

System = Callable[[Array, int], tuple[Array, Array]]
"""Square derivative and value of a system at x, with so many RK steps per walking step."""


def _located(curve: BoundaryCurve, kind: Codim2, x: Array, n_rk: int) -> Codim2Point | None:
    """The point of a kind near x; None where Newton's method does not find it."""
    equations = curve.equations
    if kind in (Codim2.FOLD_NS, Codim2.PD_NS):
        torus = curve if isinstance(curve, TorusBoundary) else TorusBoundary(equations)
        if curve is not torus:
            matrix = equations.linearised(x, n_rk)[0]
            start = torus.at(x, torus.multipliers(matrix))
            if start is None:
                return None  # real multipliers whose product is 1
            x = start
        system: System = partial(_beside_pair, torus, 1.0 if kind == Codim2.FOLD_NS else -1.0)
        scale = torus.scale
    elif isinstance(curve, TorusBoundary):
        x, scale = curve.cycle(x), equations.scale
        system = partial(_resonance, curve, 2 * np.pi / (3 if kind == Codim2.R3 else 4))
    else:
        assert isinstance(curve, MultiplierBoundary)
        scale = equations.scale
        reference = Null.at(equations, x, n_rk, curve.multiplier)
        if kind == Codim2.FOLD_FLIP:
            system = partial(_fold_flip, equations)
        else:
            system = partial(_degenerate, curve, kind, reference)
    tolerance = GPD_RESIDUAL if kind == Codim2.GPD else RESIDUAL
    found = _newton(system, x, n_rk, scale, tolerance)
    if found is None:
        return None
    x, residual = found
    cycle = np.delete(x, equations.n_unknowns) if len(x) > len(equations.scale) else x
    return Codim2Point(kind, cycle, curve.multipliers(equations.linearised(cycle, n_rk)[0]), residual)


def _newton(
    system: System, x: Array, n_rk: int, scale: Array, tolerance: float
) -> tuple[Array, float] | None:
    """A zero of a system near x, with its residual, at ever finer resolutions; None where there is none."""
    found, last = None, None
    while True:
        for _ in range(ITERATIONS):
            matrix, value = system(x, n_rk)
            change = solved(matrix, -value)
            if not np.isfinite(change).all():
                return found
            size = float(np.abs(value).max())
            x = x + change
            if size < tolerance and np.linalg.norm(change / scale) < SETTLED:
                found = x, size
                break
        else:
            return found
        if n_rk >= CYCLE_N_RK[-1] or (last is not None and np.linalg.norm((x - last) / scale) < RESOLVED):
            return found
        last, n_rk = x, min(2 * n_rk, CYCLE_N_RK[-1])


def _degenerate(
    curve: MultiplierBoundary, kind: Codim2, reference: Null, x: Array, n_rk: int
) -> tuple[Array, Array]:
    """``R = 0, g = 0`` and the test of a kind, whose derivative comes from differences."""
    equations = curve.equations

    def test(at: Array) -> float:
        null = Null.at(equations, at, n_rk, curve.multiplier).like(reference)
        if kind == Codim2.CUSP:
            return cusp(equations, null, at, n_rk)
        if kind == Codim2.GPD:
            return doubling_coefficient(equations, null, at, n_rk)
        return double_multiplier(equations, null)

    matrix, value = curve.linearised(x, n_rk)
    steps = np.diag(DIFFERENCE * equations.scale)
    slopes = [(test(x + step) - test(x - step)) / (2 * step.max()) for step in steps]
    return np.vstack([matrix, slopes]), np.append(value, test(x))


def _fold_flip(equations: CycleEquations, x: Array, n_rk: int) -> tuple[Array, Array]:
    """``R = 0`` with multipliers 1 and -1."""
    one, other = (Null.at(equations, x, n_rk, value) for value in (1.0, -1.0))
    return np.vstack([one.matrix, one.gradient, other.gradient]), np.array([*one.residual, one.g, other.g])


def _resonance(curve: TorusBoundary, theta: float, x: Array, n_rk: int) -> tuple[Array, Array]:
    """``R = 0`` with the multipliers exp(+-i theta) of a given angle."""
    at = curve.equations.n_unknowns
    matrix, value = curve.linearised(np.insert(x, at, theta), n_rk)
    return np.delete(matrix, at, axis=1), value


def _beside_pair(curve: TorusBoundary, multiplier: float, x: Array, n_rk: int) -> tuple[Array, Array]:
    """``R = 0`` with a pair on the unit circle and a real multiplier."""
    matrix, value = curve.linearised(x, n_rk)
    null = Null.at(curve.equations, curve.cycle(x), n_rk, multiplier)
    row = np.insert(null.gradient, curve.equations.n_unknowns, 0.0)
    return np.vstack([matrix, row]), np.append(value, null.g)


_DOUBLE = {1.0: Codim2.R1, -1.0: Codim2.R2}
"""Where a multiplier on the unit circle is a double one."""

ITERATIONS = 15
"""Newton iterations at one resolution."""

RESIDUAL, GPD_RESIDUAL, SETTLED = 1e-11, 1e-9, 1e-7
"""Residual of a point, that of a generalised doubling, whose third derivative comes from differences, and the
size of a Newton step after which the next one would be lost in rounding, in terms of the scale."""

RESOLVED = 1e-11
"""Change of a point, in terms of the scale, at twice the resolution that needs no finer one."""

DIFFERENCE, THIRD = 1e-6, 5e-3
"""Steps of the differences, in terms of the scale: of a test, whose slope decides the speed of Newton's
method only, and of the second derivative, with central differences of sixth order."""
