"""Where gaits end along a branch, with conditions that are known functions of the cycle."""

import itertools

import numpy as np
import pytest
import sympy as sp
from scipy.linalg import expm
from scipy.optimize import brentq

from stridemap.solver.branches.bifurcation import SpecialType
from stridemap.solver.branches.conditions import GaitEnd
from stridemap.solver.branches.dips import with_dips
from stridemap.solver.branches.ends import conditions_along, gait_ends
from stridemap.solver.options import ContinuationOptions
from tests.oracles.maps import curve, p, x, y
from tests.solver.branches.test_known_maps import OPTIONS, shifted, specials, started, traced

pytestmark = pytest.mark.quick


class Conditions:
    """Conditions of gaits that are functions of the unknowns."""

    def __init__(self, **functions):
        self.functions = {GaitEnd(name): f for name, f in functions.items()}

    def of_cycles(self, n_rk, u, params, n_steps, names=None):
        assert len(n_rk) == len(u)
        return {name: np.array([f(*row) for row in u]) for name, f in self.functions.items()}


@pytest.mark.parametrize("turned", [False, True])
def test_a_gait_ends_at_the_condition_that_is_met_first(turned):
    """Along x = p: both are broken at the next point of the branch, the fall before the friction."""
    on = curve(x + x - p)
    coarse = ContinuationOptions(ds=0.2, ds_max=0.2)
    both = {"fall": lambda z, _: 0.5 - z, "friction": lambda z, _: np.exp(0.52 - z) - 1}
    conditions = Conditions(**dict(reversed(both.items())) if turned else both)
    for back in (False, True):
        points, _ = traced(on, 0.11, 0.11, 0.0, 1.0, coarse)
        points = [point.reversed() for point in reversed(points)] if back else points
        ((number, end),) = gait_ends(on, points, conditions_along(on, points, conditions), conditions, coarse)
        assert end.type is GaitEnd.FALL
        assert end.point.x[0] == pytest.approx(0.5, abs=1e-11)
        assert end.residual < 1e-11
        before, after = (points[number + i].x[0] for i in (0, 1))
        assert min(before, after) < 0.5 < max(before, after)


def test_a_condition_that_is_broken_on_both_sides_hides_others():
    on = curve(x + x - p)
    conditions = Conditions(fall=lambda z, _: 0.5 - z, friction=lambda z, _: 0.2 - z)
    points, _ = traced(on, 0.11, 0.11, 0.0, 1.0)
    ((number, end),) = gait_ends(on, points, conditions_along(on, points, conditions), conditions, OPTIONS)
    assert end.type is GaitEnd.FRICTION
    assert points[number].x[0] < end.point.x[0] < points[number + 1].x[0]


def ends_of_line(turned, back, **functions):
    """Ends of gaits between x = 0 and x = 1 on the line x = p, with conditions in either order."""
    on = curve(x + x - p)
    points = [started(on, z, z) for z in (0.0, 1.0)]
    points = [point.reversed() for point in reversed(points)] if back else points
    conditions = Conditions(**dict(reversed(functions.items())) if turned else functions)
    return list(gait_ends(on, points, conditions_along(on, points, conditions), conditions, OPTIONS))


BOTH_WAYS = pytest.mark.parametrize(("turned", "back"), [*itertools.product([False, True], repeat=2)])


@BOTH_WAYS
@pytest.mark.parametrize("zeros", [(0.3, 0.45, 0.7), (0.3, 0.5, 0.9), (0.35, 0.6, 0.8)])
def test_a_condition_that_is_met_several_times_ends_a_gait_where_it_is_met_first(turned, back, zeros):
    """It is broken before another one is, holds again, and is broken for good."""
    ((_, end),) = ends_of_line(
        turned,
        back,
        friction=lambda z, _: 0.4 - z,
        contact=lambda z, _: -np.prod([z - zero for zero in zeros]),
    )
    assert end.type is GaitEnd.CONTACT
    assert end.point.x[0] == pytest.approx(zeros[0], abs=1e-11)


@BOTH_WAYS
@pytest.mark.parametrize("apart", [1e-7, 1e-8])
def test_of_two_ends_near_each_other_the_first_one_counts(turned, back, apart):
    ((_, end),) = ends_of_line(
        turned, back, friction=lambda z, _: 0.4 - z, contact=lambda z, _: 0.4 - apart - z
    )
    assert end.type is GaitEnd.CONTACT
    assert end.point.x[0] == pytest.approx(0.4 - apart, abs=1e-11)


@BOTH_WAYS
@pytest.mark.parametrize(("jump", "found"), [(0.3, False), (0.6, True)])
def test_a_condition_that_jumps_hides_ends_behind_it(turned, back, jump, found):
    """The gait has ended where it jumps, which is not located."""
    ends = ends_of_line(
        turned, back, friction=lambda z, _: 0.4 - z, contact=lambda z, _: 1.0 if z < jump else -1.0
    )
    assert [end.type for _, end in ends] == [GaitEnd.FRICTION] * found


@pytest.mark.parametrize("wall", [0.7, 1.9])
def test_an_oscillator_grazes_a_wall(wall):
    """x'' + c x' + k x = A cos(w t) touches x = d at A = d sqrt((k - w^2)^2 + (c w)^2)."""
    c, k, w = 0.2, 1.5, 1.1
    size = np.hypot(k - w**2, c * w)
    lag = np.arctan2(c * w, k - w**2)  # x = A / size cos(w t - lag)
    flow = expm(np.array([[0, 1], [-k, -c]]) * 2 * np.pi / w)
    steady = sp.Matrix([np.cos(lag), w * np.sin(lag)]) * p / size
    z = sp.Matrix([x, y])
    on = curve(*(steady + sp.Matrix(flow) * (z - steady)))
    middle = 1.3 * wall * size
    points, _ = traced(on, [middle / size, 0.1], middle, 0.5 * wall * size, 1.6 * wall * size)
    modes, vectors = np.linalg.eig(np.array([[0, 1], [-k, -c]]))

    def largest(state, amplitude):
        """The largest excursion along an oscillation from a state."""
        start = amplitude / size * np.array([np.cos(lag), w * np.sin(lag)])
        apart = np.linalg.solve(vectors, state - start)

        def at(t):
            forced = amplitude / size * np.array([np.cos(w * t - lag), -w * np.sin(w * t - lag)])
            return forced + np.real(vectors @ (np.exp(modes * t) * apart))

        times = np.linspace(0, 2 * np.pi / w, 17)
        rates = [at(t)[1] for t in times]
        turns = [
            brentq(lambda t: at(t)[1], t0, t1, xtol=1e-14)
            for (t0, t1), (r0, r1) in zip(itertools.pairwise(times), itertools.pairwise(rates), strict=True)
            if r0 > 0 >= r1
        ]
        return max(at(t)[0] for t in turns)

    class Wall(Conditions):
        """The distance that is left to the wall."""

        def of_cycles(self, n_rk, u, params, n_steps, names=None):
            distances = [wall - largest(z[:2], amplitude) for z, (amplitude,) in zip(u, params, strict=True)]
            return {GaitEnd.GRAZING: np.array(distances)}

    ((_, end),) = gait_ends(on, points, conditions_along(on, points, Wall()), Wall(), OPTIONS)
    assert end.type is GaitEnd.GRAZING
    assert end.point.x[-1] == pytest.approx(wall * size, rel=1e-12)


def test_a_condition_that_jumps_has_no_end_on_the_branch():
    on = curve(x + x - p)
    conditions = Conditions(contact=lambda z, _: 1.0 if z < 0.5 else -1.0)
    points, _ = traced(on, 0.11, 0.11, 0.0, 1.0)
    assert list(gait_ends(on, points, conditions_along(on, points, conditions), conditions, OPTIONS)) == []


WITHIN_ONE_STEP = [(0.03, 0.047), (0.03, 0.1), (0.008, 0.05), (0.008, 0.07), (0.002, 0.03), (0.002, 0.1)]


@pytest.mark.parametrize(("apart", "ds"), WITHIN_ONE_STEP)
def test_a_multiplier_that_goes_beyond_minus_one_and_back_within_a_step_is_seen(apart, ds):
    """It is -(1 + apart^2 - p^2), and so -1 at p = -apart and p = apart."""
    on = curve(shifted(lambda z: -(1 + apart**2 - p**2) * z))
    coarse = ContinuationOptions(ds=ds, ds_max=ds)
    points, _ = traced(on, 0.5, -0.413, -0.5, 0.5, coarse)
    points = with_dips(on, points, Conditions(contact=lambda z, _: 1.0), coarse)
    found = specials(on, points, coarse)
    assert [special.type for special in found] == [SpecialType.PD] * 2
    np.testing.assert_allclose([special.x[-1] for special in found], [-apart, apart], rtol=0, atol=1e-10)


@pytest.mark.parametrize(("apart", "ds"), WITHIN_ONE_STEP)
def test_a_gait_that_ends_and_begins_again_within_a_step_is_seen(apart, ds):
    """Along x = p the force is (p - 1/2)^2 - apart^2."""
    on = curve(x + x - p)
    coarse = ContinuationOptions(ds=ds, ds_max=ds)
    points, _ = traced(on, 0.113, 0.113, 0.0, 1.0, coarse)
    conditions = Conditions(contact=lambda z, _: (z - 0.5) ** 2 - apart**2)
    points = with_dips(on, points, conditions, coarse)
    ends = list(gait_ends(on, points, conditions_along(on, points, conditions), conditions, coarse))
    assert [end.type for _, end in ends] == [GaitEnd.CONTACT] * 2
    places = [end.point.x[0] for _, end in ends]
    np.testing.assert_allclose(places, [0.5 - apart, 0.5 + apart], rtol=0, atol=1e-8)


def test_what_only_comes_near_zero_adds_no_point():
    on = curve(shifted(lambda z: -(1 - 1e-4 - p**2) * z))
    coarse = ContinuationOptions(ds=0.05, ds_max=0.05)
    points, _ = traced(on, 0.5, -0.413, -0.5, 0.5, coarse)
    assert with_dips(on, points, Conditions(contact=lambda z, _: 1.0), coarse) == points
    assert with_dips(on, points[:2], Conditions(contact=lambda z, _: 1.0), coarse) == points[:2]
