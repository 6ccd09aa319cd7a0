"""Boundaries and their double points against maps for which pencil and paper give them."""

import numpy as np
import pytest
import sympy as sp

from stridemap.solver.boundaries.codim2 import codim2_points, with_ends
from stridemap.solver.boundaries.systems import MultiplierBoundary, TorusBoundary
from stridemap.solver.branches.arclength import CurvePoint, Window, both_ways
from stridemap.solver.options import ContinuationOptions
from tests.oracles.maps import equations

pytestmark = pytest.mark.quick

x, y, a, b = sp.symbols("x y a b")
HENON = ([1 - a * x**2 + y, b * x], (x, y), (a, b))
WIDE = Window((-3.0, -1.5), (3.0, 1.5), 0.4, 1.6)


def followed(curve, start, window=WIDE, **options):
    """The boundary through a point, both ways, and its double points by type."""
    start = np.array(start, dtype=float)
    matrix, residual = curve.linearised(start, 24)
    assert np.abs(residual).max() < 1e-10
    across = np.linalg.svd(matrix * curve.scale)[2][-1] * curve.scale
    found = curve.corrected(start, across, 24, 10)
    point = CurvePoint.at(curve, found, across, 24)
    points, _ = both_ways(
        curve,
        point,
        window,
        ContinuationOptions(
            ds=0.05, ds_max=0.2, min_tangent_cosine=0.95, easy_tangent_cosine=0.98, **options
        ),
    )
    if isinstance(curve, TorusBoundary):
        points = with_ends(curve, points)
    double = {}
    for _, one in codim2_points(curve, points):
        double.setdefault(str(one.type), []).append(one)
        assert one.residual < 1e-9
    return points, double


def henon(a, b, sign=1.0):
    """A fixed point of the Henon map with a period 1."""
    first = (-(1 - b) + sign * np.sqrt(max((1 - b) ** 2 + 4 * a, 0.0))) / (2 * a)
    return [first, b * first, 1.0, a, b]


def test_the_folds_of_henon():
    """They lie at a = -(1 - b)^2 / 4; there, the other multiplier is -b."""
    curve = MultiplierBoundary(equations(*HENON), 1.0)
    window = Window((-10, -1.5), (10, 0.5), 0.4, 1.6)
    points, double = followed(curve, henon(-((1 - 0.3) ** 2) / 4, 0.3), window)
    plane = np.array([point.x[-2:] for point in points])
    assert np.ptp(plane[:, 1]) == pytest.approx(2.0)
    np.testing.assert_allclose(plane[:, 0], -((1 - plane[:, 1]) ** 2) / 4, atol=1e-12)
    (one,) = double["r1"]
    np.testing.assert_allclose(one.cycle, [1.0, -1.0, 1.0, -1.0, -1.0], atol=1e-10)
    assert list(double) == ["r1"]


def test_the_doublings_of_henon():
    """They lie at a = 3 (1 - b)^2 / 4; a double multiplier -1 at b = -1."""
    curve = MultiplierBoundary(equations(*HENON), -1.0)
    points, double = followed(curve, henon(0.75 * 0.7**2, 0.3), Window((-10, -2), (10, 0.9), 0.4, 1.6))
    plane = np.array([point.x[-2:] for point in points])
    np.testing.assert_allclose(plane[:, 0], 0.75 * (1 - plane[:, 1]) ** 2, atol=1e-12)
    (one,) = double["r2"]
    np.testing.assert_allclose(one.cycle[-2:], [3.0, -1.0], atol=1e-10)


def test_resonances_of_the_area_preserving_henon():
    """With b = -1 the multipliers lie on the unit circle: trace -2 a x = 2 cos(theta)."""
    u, v, p, q = sp.symbols("u v p q")
    delayed = ([v, p * v * (1 - u) + q * u * v**2], (u, v), (p, q))
    curve = TorusBoundary(equations(*delayed))
    # q = 0 is the delayed logistic map: a torus at p = 2, multipliers exp(+-i pi/3).
    start = [0.5, 0.5, 1.0, np.pi / 3, 2.0, 0.0]
    points, _ = followed(curve, start, Window((1.2, -2.0), (3.5, 2.0), 0.4, 1.6))
    for point in points[:: len(points) // 7]:
        z, theta, (p_, q_) = point.x[0], point.x[3], point.x[-2:]
        step = np.array([[0.0, 1.0], [-p_ * z + q_ * z**2, p_ * (1 - z) + 2 * q_ * z**2]])
        np.testing.assert_allclose(np.linalg.det(step), 1.0, atol=1e-11)
        np.testing.assert_allclose(np.trace(step), 2 * np.cos(theta), atol=1e-11)
        assert p_ * (1 - z) + q_ * z**2 == pytest.approx(1.0, abs=1e-11)


def test_angles_of_resonances():
    """A rotation by p about a point, stretched by 1 + q: a torus at q = 0."""
    u, v, p, q = sp.symbols("u v p q")
    left, up = u - sp.Rational(1, 3), v - sp.Rational(1, 4)
    f = [
        sp.Rational(1, 3) + (1 + q) * (sp.cos(p) * left - sp.sin(p) * up),
        sp.Rational(1, 4) + (1 + q) * (sp.sin(p) * left + sp.cos(p) * up),
    ]
    curve = TorusBoundary(equations(f, (u, v), (p, q)))
    start = [1 / 3, 1 / 4, 1.0, 1.0, 1.0, 0.0]
    _, double = followed(curve, start, Window((0.1, -1.0), (3.0, 1.0), 0.4, 1.6))
    assert {kind: [one.cycle[-2] for one in found] for kind, found in double.items()} == {
        "r4": [pytest.approx(np.pi / 2, abs=1e-12)],
        "r3": [pytest.approx(2 * np.pi / 3, abs=1e-12)],
    }


def test_a_torus_ends_at_resonances():
    """Trace t and determinant d as parameters: the torus d = 1 ends at 1:1 and 1:2, where t is 2 and -2."""
    u, v, t, d = sp.symbols("u v t d")
    shift = sp.Rational(1, 3)
    f = [v, t * (v - shift) - d * (u - shift) + shift + (v - shift) ** 2 / 5]
    curve = TorusBoundary(equations(f, (u, v), (t, d)))
    points, double = followed(curve, [1 / 3, 1 / 3, 1.0, np.pi / 2, 0.0, 1.0])
    assert {kind: [tuple(one.cycle[-2:]) for one in found] for kind, found in double.items()} == {
        "r1": [pytest.approx((2.0, 1.0), abs=1e-9)],
        "r2": [pytest.approx((-2.0, 1.0), abs=1e-9)],
        "r3": [pytest.approx((-1.0, 1.0), abs=1e-10)],
        "r4": [pytest.approx((0.0, 1.0), abs=1e-10)],
    }
    trace = [point.x[-2] for point in points]
    assert {min(trace), max(trace)} == {trace[0], trace[-1]}
    np.testing.assert_allclose(sorted([trace[0], trace[-1]]), [-2.0, 2.0], atol=1e-9)


def test_a_cusp():
    """x + p + q x - x^3 has its cusp at p = q = 0, and folds at p = +-2 (q/3)^(3/2)."""
    z, p, q = sp.symbols("z p q")
    curve = MultiplierBoundary(equations([z + p + q * z - z**3], (z,), (p, q)), 1.0)
    first = 0.5
    start = [first, 1.0, first**3 - 3 * first**2 * first, 3 * first**2]
    points, double = followed(curve, start)
    plane = np.array([point.x[-2:] for point in points])
    np.testing.assert_allclose(np.abs(plane[:, 0]), 2 * (np.maximum(plane[:, 1], 0) / 3) ** 1.5, atol=1e-11)
    (one,) = double["cusp"]
    np.testing.assert_allclose(one.cycle[[0, 2, 3]], 0.0, atol=1e-9)


def test_a_generalised_doubling():
    """-(1 + p) x + q x^3 - x^5 doubles at p = 0; its coefficient is q."""
    z, p, q = sp.symbols("z p q")
    shift = sp.Rational(1, 3)  # the cycle itself moves, so that quadratic terms matter
    w = z - shift
    f = [shift - (1 + p) * w + q * w**3 + sp.Rational(1, 2) * w**2 - w**5]
    curve = MultiplierBoundary(equations(f, (z,), (p, q)), -1.0)
    points, double = followed(curve, [1 / 3, 1.0, 0.0, 0.6])
    np.testing.assert_allclose([point.x[-2] for point in points], 0.0, atol=1e-12)
    (one,) = double["gpd"]
    # c = C/6 + B h with h = B/4, B = 1 and C = 6 q: zero at q = -1/4 (Kuznetsov's (1/4) f'' ^2 + f'''/6).
    assert one.cycle[-1] == pytest.approx(-0.25, abs=1e-9)


THIRD = sp.Rational(1, 3)
"""Where the cycles of the following maps are: at zero a walker would stand."""


@pytest.mark.parametrize("value", [1.0, -1.0])
def test_a_fold_flip(value):
    """Two maps side by side: one folds at p = 0, the other doubles at p + q = 1/2."""
    u, v, p, q = sp.symbols("u v p q")
    left, up = u - THIRD, v - THIRD
    f = [
        THIRD + left + p - left**2 + up**2 / 5,
        THIRD - (sp.Rational(1, 2) + p + q) * up + up**3,
    ]
    curve = MultiplierBoundary(equations(f, (u, v), (p, q)), value)
    start = [0.0, 0.1] if value > 0 else [0.16, 0.34]
    _, double = followed(curve, [1 / 3 + start[0] ** 0.5, 1 / 3, 1.0, *start])
    (one,) = double["fold_flip"]
    np.testing.assert_allclose(one.cycle, [1 / 3, 1 / 3, 1.0, 0.0, 0.5], atol=1e-8)


@pytest.mark.parametrize(("value", "kind"), [(1.0, "fold_ns"), (-1.0, "pd_ns")])
@pytest.mark.parametrize("on_torus", [False, True])
def test_a_pair_beside_a_real_multiplier(value, kind, on_torus):
    """A fold or a doubling at p = 0 beside a rotation that grows where q + p > 0."""
    u, v, w, p, q = sp.symbols("u v w p q")
    left, up, last = u - THIRD, v - THIRD, w - THIRD
    turned, angle = (1 + p + q), sp.Rational(11, 10)
    f = [
        THIRD + turned * (sp.cos(angle) * left - sp.sin(angle) * up),
        THIRD + turned * (sp.sin(angle) * left + sp.cos(angle) * up),
        THIRD + (last + p - last**2 if value > 0 else -(1 + p) * last + last**3),
    ]
    eq = equations(f, (u, v, w), (p, q))
    if on_torus:
        at = 1 / 3 + (0.3 if value > 0 else 0.0)
        _, double = followed(TorusBoundary(eq), [1 / 3, 1 / 3, at, 1.0, 1.1, 0.09, -0.09])
    else:
        _, double = followed(MultiplierBoundary(eq, value), [1 / 3, 1 / 3, 1 / 3, 1.0, 0.0, -0.2])
    (one,) = double[kind]
    np.testing.assert_allclose(one.cycle[-2:], 0.0, atol=1e-8)
