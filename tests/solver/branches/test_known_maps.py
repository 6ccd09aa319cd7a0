"""Branches, bifurcations and their ends on maps whose cycles are known in closed form."""

import itertools
from dataclasses import replace

import numpy as np
import pytest
import sympy as sp

from stridemap.solver.branches.arclength import EndReason, Window, advanced, at_value, both_ways, follow
from stridemap.solver.branches.asking import alone
from stridemap.solver.branches.bifurcation import SpecialType
from stridemap.solver.branches.special import special_points
from stridemap.solver.branches.survey import ending_there
from stridemap.solver.branches.switching import crossing, doubled, supercritical
from stridemap.solver.cycles.floquet import sorted_eigenvalues, step_map_derivative
from stridemap.solver.options import ContinuationOptions
from tests.oracles.maps import T, curve, p, x, y

pytestmark = pytest.mark.quick

OPTIONS = ContinuationOptions()


def window(low, high):
    return Window((low,), (high,), 0.5, 1.5)


def started(on, z, value):
    """The point of a curve near z, with the tangent towards larger p."""
    u = np.array([*np.atleast_1d(z), 1.0])
    found = at_value(on, np.append(u, value), value, np.eye(len(u) + 1)[-1], 20)
    assert found is not None
    return found


def traced(on, z, value, low, high, options=OPTIONS):
    """Points of the whole branch, and why it ends at either side."""
    return both_ways(on, started(on, z, value), window(low, high), options)


def shifted(f):
    """A map about 1/2 that is a map about 0 otherwise: a branch at 0 would be a walker that stands."""
    return HALF + f(x - HALF)


HALF = sp.Rational(1, 2)


def specials(on, points, options=OPTIONS):
    return [special for _, special in special_points(on, points, options)]


# -- bifurcations ------------------------------------------------------------------------------------------


def test_a_fold_is_passed_and_found():
    """Fixed points of x + p - x^2 are +-sqrt(p); along the curve d2p/dx2 = 2 at the fold."""
    on = curve(x + p - x**2, width=0.5)
    points, reasons = traced(on, 0.6, 0.36, -1.0, 0.8)
    z, value = np.array([[point.x[0], point.x[-1]] for point in points]).T
    assert reasons == (EndReason.RANGE, EndReason.RANGE)
    np.testing.assert_allclose(np.sort(z)[[0, -1]], [-np.sqrt(0.8), np.sqrt(0.8)], rtol=1e-12)
    np.testing.assert_allclose(value, z**2, rtol=0, atol=1e-11)
    assert (np.diff(z) * np.sign(z[-1] - z[0]) > 0).all()
    (fold,) = specials(on, points)
    assert fold.type is SpecialType.FOLD
    np.testing.assert_allclose(fold.x, [0.0, 1.0, 0.0], rtol=0, atol=1e-12)
    # dx/ds = 1 at the fold, in terms of the scale, and p is measured in widths.
    assert fold.slope == pytest.approx(2 / 0.5, rel=1e-9)


def logistic():
    return curve(p * x * (1 - x))


def test_the_doublings_of_the_logistic_map():
    """At 3 and at 1 + sqrt(6), onto cycles of two and of four."""
    on = logistic()
    points, _ = traced(on, 0.6, 2.5, 2.2, 3.6)
    (doubling,) = specials(on, points)
    assert doubling.type is SpecialType.PD
    np.testing.assert_allclose(doubling.x, [2 / 3, 1.0, 3.0], rtol=0, atol=1e-11)
    assert doubling.multiplier == -1
    assert doubling.slope == pytest.approx(-doubling.direction, rel=1e-8)  # the multiplier is 2 - p
    begins = alone(doubled(on, doubling, OPTIONS))
    assert begins.curve.chain.n_steps == 2
    assert supercritical(doubling, begins)
    both, reason = follow(begins.curve, begins.start, window(2.2, 3.6), OPTIONS)
    assert reason is EndReason.RANGE
    for point in both:
        one, _, other, _, value = point.x
        root = np.sqrt((value - 3) * (value + 1))
        exact = (value + 1 + np.array([-1, 1]) * root) / (2 * value)
        np.testing.assert_allclose(sorted([one, other]), exact, rtol=0, atol=1e-10)
        np.testing.assert_allclose(point.multipliers[0], 4 + 2 * value - value**2, rtol=0, atol=1e-8)
    (second,) = specials(begins.curve, both)
    assert second.type is SpecialType.PD
    assert second.x[-1] == pytest.approx(1 + np.sqrt(6), abs=1e-10)
    assert supercritical(second, alone(doubled(begins.curve, second, OPTIONS)))


@pytest.mark.parametrize(("cubic", "expected"), [(1, False), (-1, True)])
@pytest.mark.parametrize("ahead", [True, False])
def test_a_doubling_is_supercritical_where_the_single_cycle_is_unstable(cubic, expected, ahead):
    """-(1 + p) z - c z^3 has the cycle of two z^2 = -p / c; 0 is unstable for p > 0."""
    on = curve(shifted(lambda z: -(1 + p) * z - cubic * z**3))
    points, _ = traced(on, 0.5, -0.4, -0.5, 0.5)
    if not ahead:
        points = [point.reversed() for point in reversed(points)]
    (doubling,) = specials(on, points)
    assert doubling.x[-1] == pytest.approx(0.0, abs=1e-12)
    begins = alone(doubled(on, doubling, OPTIONS))
    one, _, other, _, value = begins.start.x - np.array([0.5, 0, 0.5, 0, 0])
    assert one == pytest.approx(-other, abs=1e-12)
    assert one**2 == pytest.approx(-value / cubic, abs=1e-11)
    assert supercritical(doubling, begins) == expected


def test_a_doubled_branch_ends_where_its_halves_are_one_cycle_again():
    """-(1 + r) z + z^3 with r = p (1 - p) doubles at p = 0 and at p = 1; between them two is z^2 = r."""
    on = curve(shifted(lambda z: -(1 + p * (1 - p)) * z + z**3))
    points, _ = traced(on, 0.5, -0.4, -0.5, 1.5)
    first, second = specials(on, points)
    begins = alone(doubled(on, first, OPTIONS))
    there, reason = follow(begins.curve, begins.start, window(-0.5, 1.5), OPTIONS)
    assert reason is EndReason.BRANCH_POINT
    passed = specials(begins.curve, there)
    assert SpecialType.BP in [one.type for one in passed]
    numbered = list(special_points(begins.curve, there, OPTIONS))
    kept, left = ending_there(begins.curve, there, numbered, -1)
    assert left == []
    x = np.array([point.x for point in kept])
    np.testing.assert_allclose(x[-1], [*second.x[:-1], *second.x], rtol=0, atol=1e-10)
    np.testing.assert_allclose((x[:, 0] - 0.5) ** 2, x[:, -1] * (1 - x[:, -1]), rtol=0, atol=1e-10)
    assert (np.diff(x[:, -1]) > 0).all()
    # The same from the other end.
    back = [point.reversed() for point in reversed(there)]
    kept, left = ending_there(begins.curve, back, list(special_points(begins.curve, back, OPTIONS)), 0)
    assert left == []
    np.testing.assert_allclose(kept[0].x, x[-1], rtol=0, atol=1e-10)
    np.testing.assert_allclose(kept[-1].x, x[0], rtol=0, atol=1e-10)


def test_the_torus_of_the_delayed_logistic_map():
    """At p = 2 a pair leaves the unit circle at an angle of pi / 3; its modulus is sqrt(p - 1)."""
    on = curve(p * x * (1 - y), x)
    points, _ = traced(on, [0.4, 0.4], 1.6, 1.55, 2.4)
    (torus,) = specials(on, points)
    assert torus.type is SpecialType.NS
    np.testing.assert_allclose(torus.x, [0.5, 0.5, 1.0, 2.0], rtol=0, atol=1e-11)
    assert torus.multiplier == pytest.approx(np.exp(1j * np.pi / 3), abs=1e-11)
    assert torus.slope == pytest.approx(0.5 * torus.direction, rel=1e-8)


def test_a_ball_that_bounces_on_a_table():
    """Once per oscillation A sin t of the table, with g = 1 and restitution 1/2: a fold and a doubling.

    The unknowns are the phase x at which it leaves the table, its velocity y, and the time T of its flight.
    """
    e, A = sp.Rational(1, 2), p
    lands = A * sp.sin(x) + y * T - T**2 / 2 - A * sp.sin(x + T)
    after = (1 + e) * A * sp.cos(x + T) - e * (y - T)
    on = curve(x + T - 2 * sp.pi, after, condition=lands)
    guess = np.array([np.arccos(np.pi / 3 / 1.3), np.pi, 2 * np.pi, 1.3])
    start = at_value(on, guess, 1.3, np.eye(4)[-1], 20)
    points, _ = both_ways(on, start, Window((1.0,), (1.7,), 5.0, 8.0), OPTIONS)
    found = {special.type: special for special in specials(on, points)}
    assert found.keys() == {SpecialType.FOLD, SpecialType.PD}
    ratio = np.pi * (1 - 0.5) / (1 + 0.5)
    assert found[SpecialType.FOLD].x[-1] == pytest.approx(ratio, abs=1e-12)
    doubling = np.hypot(ratio, 2 * (1 + 0.5**2) / (1 + 0.5) ** 2)
    assert found[SpecialType.PD].x[-1] == pytest.approx(doubling, abs=1e-12)
    for kind, expected in ((SpecialType.FOLD, (1, 0.25)), (SpecialType.PD, (-1, -0.25))):
        point = min(points, key=lambda one, x=found[kind].x: on.norm(one.x - x))
        there = on.linearised(found[kind].x, point.n_rk)[0]
        multipliers = sorted_eigenvalues(step_map_derivative(there[None, :3, :3]))[0]
        np.testing.assert_allclose(multipliers, expected, rtol=0, atol=1e-6)  # of a fold, a square root


def test_real_multipliers_whose_product_is_one_are_not_a_torus():
    on = curve(shifted(lambda z: 2 * z), p * y)
    points, _ = traced(on, [0.5, 0.0], 0.3, 0.2, 0.8)
    assert len(points) > 10
    assert specials(on, points) == []


def test_a_pitchfork_is_a_branch_point_from_which_both_sides_are_reached():
    """z + p z - z^3: the branch z = 0, crossed at p = 0 by p = z^2."""
    on = curve(shifted(lambda z: z + p * z - z**3))
    points, _ = traced(on, 0.5, -0.4, -0.5, 0.5)
    (meeting,) = specials(on, points)
    assert meeting.type is SpecialType.BP
    np.testing.assert_allclose(meeting.x, [0.5, 1.0, 0.0], rtol=0, atol=1e-11)
    ends = []
    for side in (1, -1):
        begins = alone(crossing(on, meeting, OPTIONS, side))
        assert begins is not None
        there, reason = follow(begins.curve, begins.start, window(-0.5, 0.5), OPTIONS)
        assert reason is EndReason.RANGE
        z, value = np.array([[point.x[0] - 0.5, point.x[-1]] for point in there]).T
        np.testing.assert_allclose(value, z**2, rtol=0, atol=1e-10)
        ends.append(z[-1])
    np.testing.assert_allclose(sorted(ends), [-np.sqrt(0.5), np.sqrt(0.5)], rtol=1e-10)


@pytest.mark.parametrize("apart", [0.1, 0.02, 0.004])
def test_two_doublings_between_two_points_are_both_found(apart):
    """Of two maps that know nothing of each other: the test function has the same sign before and after."""
    on = curve(shifted(lambda z: -(1 + p) * z), -(1 + p - apart) * y)
    coarse = ContinuationOptions(ds=0.3, ds_max=0.3)
    points, _ = traced(on, [0.5, 0.0], -0.4, -0.5, 0.5, coarse)
    found = specials(on, points, coarse)
    assert [special.type for special in found] == [SpecialType.PD] * 2
    np.testing.assert_allclose(sorted(s.x[-1] for s in found), [0.0, apart], rtol=0, atol=1e-11)


def test_a_fold_and_a_doubling_between_two_points_are_both_found():
    """The fold of one map, and the doubling of another just beside it."""
    on = curve(x + p - x**2, -(1 + x - sp.Rational(1, 100)) * y)
    coarse = ContinuationOptions(ds=0.05, ds_max=0.2)
    points, _ = traced(on, [0.6, 0.0], 0.36, -1.0, 0.8, coarse)
    found = {special.type: special for special in specials(on, points, coarse)}
    assert set(found) == {SpecialType.FOLD, SpecialType.PD}
    assert found[SpecialType.FOLD].x[-1] == pytest.approx(0.0, abs=1e-11)
    assert found[SpecialType.PD].x[0] == pytest.approx(0.01, abs=1e-11)


@pytest.mark.parametrize("error", [1e-6, 1e-4])
def test_special_points_are_refined_until_the_resolution_does_not_move_them(error):
    """The branch is off by this with 24 RK steps, and the special points of it by rounding only."""
    on = curve(x + p - x**2, error=error)
    points, _ = traced(on, 0.6, 0.36, -1.0, 0.8)
    assert points[0].x[-1] - points[0].x[0] ** 2 == pytest.approx(-error, rel=1e-3)
    (fold,) = specials(on, points)
    assert abs(fold.x[-1]) < 1e-12
    on = curve(p * x * (1 - x), error=error)
    points, _ = traced(on, 0.6, 2.5, 2.2, 3.6)
    (doubling,) = specials(on, points)
    assert abs(doubling.x[-1] - 3) < 1e-12


# -- points of branches --------------------------------------------------------------------------------------


def test_second_derivatives_are_differences_of_the_first():
    """Of a chain of two steps whose period depends on both, along real and complex directions."""
    one = curve(p * x * (1 - y) + p**2 * y, sp.sin(p * x) - y**2, period=1 + p * x * y)
    two = one.with_steps(2)
    rng = np.random.default_rng(8)
    at = rng.uniform(0.2, 0.9, 7)
    for v in (rng.normal(size=7), rng.normal(size=7) + 1j * rng.normal(size=7)):

        def along(place, v=v):
            return two.linearised(place, 24)[0] @ v

        size = 1e-5
        columns = [(along(at + size * e) - along(at - size * e)) / (2 * size) for e in np.eye(7)]
        np.testing.assert_allclose(two.equations.second(at, v, 24), np.array(columns).T, rtol=0, atol=1e-8)


def test_every_point_of_a_branch_closes_to_rounding():
    on = logistic()
    points, _ = traced(on, 0.6, 2.5, 1.2, 3.9, ContinuationOptions(ds=0.05, ds_max=0.3))
    assert len(points) > 8
    for point in points:
        assert abs(point.x[0] - (1 - 1 / point.x[-1])) < 2e-14
        assert abs(on.dot(point.tangent, point.tangent) - 1) < 1e-14


def wavy():
    """x = 1/2 + sin(80 p) / 50: tangents a whole wave apart are the same."""
    return curve(x + x - HALF - sp.sin(80 * p) / 50)


def test_the_tangent_turns_little_from_point_to_point():
    on = curve(x + x**2 + p**2 - sp.Rational(1, 4))
    for options in (OPTIONS, ContinuationOptions(ds=0.1, ds_max=0.4)):
        points, _ = traced(on, 0.5, 0.0, -1.0, 1.0, options)
        turns = [on.dot(a.tangent, b.tangent) for a, b in itertools.pairwise(points)]
        assert min(turns) >= options.min_tangent_cosine


def test_a_correction_that_leads_far_is_not_taken():
    """From p = 0 such a step along the tangent has the point a whole wave further on across its end."""
    on, wave = wavy(), 2 * np.pi / 80
    ds = wave / np.hypot(1, 80 / 50)
    here = started(on, 0.5, 0.0)
    there = advanced(on, here, ds, 10)
    assert there.x[-1] == pytest.approx(wave, abs=1e-12)  # so that only its distance speaks against it
    assert on.dot(there.tangent, here.tangent) == pytest.approx(1.0, abs=1e-12)
    options = ContinuationOptions(ds=ds, ds_max=ds, max_steps=8)
    points, _ = follow(on, here, window(-0.6, 0.6), options)
    assert 0 < points[1].x[-1] < 0.2 * wave


# -- where branches end --------------------------------------------------------------------------------------


def test_a_closed_curve_is_gone_round_once():
    """x^2 + p^2 = 1/4."""
    on = curve(x + x**2 + p**2 - sp.Rational(1, 4))
    points, reasons = traced(on, 0.5, 0.0, -1.0, 1.0)
    assert reasons == (EndReason.CLOSED, EndReason.CLOSED)
    angle = np.unwrap([np.arctan2(point.x[0], point.x[-1]) for point in points])
    assert 2 * np.pi <= abs(angle[-1] - angle[0]) < 2 * np.pi + 0.2
    assert [s.type for s in specials(on, points)].count(SpecialType.FOLD) == 2


def test_a_walker_that_stands_ends_a_branch_and_a_small_gait_does_not():
    """x = exp(p): it is followed while x is above 1e-4 of the scale."""
    on = curve(x + x - sp.exp(p), width=5.0)
    points, reasons = traced(on, 1.0, 0.0, -30.0, 0.5)
    assert reasons == (EndReason.STANDING, EndReason.RANGE)
    z = [point.x[0] for point in points[:2]]
    assert z[0] < 1e-4 <= z[1]


def test_a_branch_ends_far_outside_the_box():
    """x = 8 p, which is 4 at p = 1/2."""
    on = curve(x + x - 8 * p)
    room = replace(window(-0.2, 1.0), room=np.array([[-4.0, 4.0]]))
    points, reasons = both_ways(on, started(on, 0.8, 0.1), room, OPTIONS)
    assert reasons == (EndReason.RANGE, EndReason.REGION)
    assert points[-2].x[0] <= 4 < points[-1].x[0]


@pytest.mark.parametrize(("sign", "last"), [(1, 1.5), (-1, 0.5)])
def test_a_branch_ends_where_a_step_becomes_too_long_or_too_short(sign, last):
    on = curve(x + x - p - 1, period=1 + sign * p)
    points, reasons = traced(on, 1.0, 0.0, -0.2, 1.0)
    assert reasons == (EndReason.RANGE, EndReason.PERIOD)
    inside, outside = (sign * (point.x[1] - last) for point in points[-2:])
    assert inside <= 0 <= outside


def test_a_branch_that_does_not_go_on_stalls():
    """x = 1/2 + sqrt(p) ends at p = 0, with a tangent along x."""
    on = curve(x + x - sp.Rational(1, 2) - sp.sqrt(p))
    points, reasons = traced(on, 1.0, 0.25, -1.0, 0.3)
    assert reasons == (EndReason.STALLED, EndReason.RANGE)
    assert 0 <= points[0].x[-1] < 1e-3


def test_the_number_of_steps_is_bounded():
    on = curve(x + x - p)
    options = ContinuationOptions(max_steps=3)
    points, reasons = traced(on, 0.5, 0.5, 0.0, 1.0, options)
    assert reasons == (EndReason.STEPS, EndReason.STEPS)
    assert len(points) == 7


@pytest.mark.parametrize("gap", [0.1, 0.02, 0.01])
def test_a_branch_does_not_jump_to_another_one_that_passes_by(gap):
    """x^2 = p^2 + gap^2 has two branches, which are 2 gap apart at p = 0."""
    on = curve(x + x**2 - p**2 - gap**2)
    points, reasons = traced(on, 0.7, -0.7, -1.0, 1.0)
    assert reasons == (EndReason.RANGE, EndReason.RANGE)
    assert min(point.x[0] for point in points) > 0.9 * gap
