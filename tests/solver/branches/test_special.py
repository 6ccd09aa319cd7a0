"""Bifurcations against values of independent programs, and against each other."""

import numpy as np
import pytest

import stridemap
from stridemap.errors import InputError

DOUBLINGS = (0.015088437940, 0.017669374862)
"""Slopes of the simplest walker's first two period doublings, from an event-driven integration with central
differences, to 1e-11."""

FIRST = (0.01508843794111952, 0.2371658635915794, -0.2319270764240146)
"""Slope, theta and dtheta of the first one: Taylor series with 26 digits (mpmath)."""


@pytest.fixture(scope="module")
def simplest():
    """Branches of the simplest walker with two doublings in a row."""
    return stridemap.branches("simplest_walker", "slope", (0.001, 0.018), cascade=2, seeds=3)


@pytest.mark.quick
def test_the_doublings_of_the_simplest_walker(simplest):
    one, two = (point for point in simplest.special if point.type == "pd")
    np.testing.assert_allclose([one.value, two.value], DOUBLINGS, rtol=0, atol=5e-12)
    np.testing.assert_allclose([one.value, *one.state.values()], FIRST, rtol=0, atol=1e-13)
    np.testing.assert_allclose(one.period, 3.9124092125, rtol=0, atol=1e-10)
    np.testing.assert_allclose([*one.multipliers], [-1.0, -0.297621], rtol=0, atol=1e-6)
    assert (one.period_n, two.period_n) == (1, 2)
    assert {one.criticality, two.criticality} == {"supercritical"}
    assert max(one.residual, two.residual) < 1e-11
    assert one.gait
    assert two.gait


def test_a_multiplier_changes_as_its_slope_says():
    """The multiplier that crosses -1, from the table, on either side of the doubling."""
    step = {"ds": 0.002, "ds_max": 0.004}
    found = stridemap.branches("simplest_walker", "slope", (0.0148, 0.0153), seeds=1, options=step)
    (doubling,) = found.special
    points = found.to_frame().query(f"branch == {doubling.branch}")
    before = points[points.slope < doubling.value].iloc[-1]
    after = points[points.slope > doubling.value].iloc[0]
    columns = [f"multiplier_{i}_re" for i in range(2)]
    crossing = columns[np.abs(before[columns].to_numpy() + 1).argmin()]
    rate = (after[crossing] - before[crossing]) / (after.arclength - before.arclength)
    assert rate == pytest.approx(doubling.crossing_slope, rel=1e-3)


def test_the_doubled_gait_is_stable_until_it_doubles_itself(simplest):
    first, second = (point.value for point in simplest.special)
    doubled = simplest.to_frame().query("period_n == 2")
    inside = (doubled.slope > first) & (doubled.slope < second)
    assert inside.sum() > 5
    assert doubled.stable[inside].all()
    assert not doubled.stable[doubled.slope > second].any()


def test_measures_are_over_the_whole_cycle(simplest):
    """On a slope all energy is gravity's: the cost of transport of any gait is the slope's sine."""
    points = simplest.to_frame()
    np.testing.assert_allclose(points.cot, np.sin(points.slope), rtol=1e-9)
    np.testing.assert_allclose(points.speed, points.step_length / points.period, rtol=1e-12)


def test_an_island_of_three_steps():
    """Born in a fold, so that no branch of one step leads to it; values of an independent program."""
    found = stridemap.branches("simplest_walker", "slope", (0.012, 0.0128), period_n=3, seeds=1)
    fold, doubling = found.special
    assert (fold.type, doubling.type) == ("fold", "pd")
    np.testing.assert_allclose([fold.value, doubling.value], [0.0122808216, 0.0126349598], rtol=0, atol=1e-10)
    np.testing.assert_allclose(
        [fold.period, doubling.period], [11.4704455955, 11.3821508242], rtol=0, atol=1e-9
    )
    steps = [found[0].x[:, :-1].reshape(-1, 3, 3)]
    thetas = np.concatenate(steps)[:, :, 0]
    assert np.abs(thetas - 0.2039357595).min() < 1e-3
    assert fold.criticality is None


@pytest.mark.parametrize("ds_max", [0.02, 0.05, 0.15])
def test_the_same_special_points_for_every_step_size(ds_max):
    found = stridemap.branches(
        "simplest_walker", "slope", (0.001, 0.018), seeds=1, options={"ds": 0.01, "ds_max": ds_max}
    )
    (doubling,) = found.special
    assert doubling.value == pytest.approx(FIRST[0], abs=1e-13)


def test_the_first_doubling_of_the_compass_gait():
    """At a slope of 4.390898249724 degrees, to 1e-9 (mu = 2, beta = 1)."""
    found = stridemap.branches("goswami_compass", "slope", (0.07, 0.08), {"mu": 2, "beta": 1}, seeds=1)
    (doubling,) = (point for point in found.special if point.type == "pd" and point.gait)
    assert np.degrees(doubling.value) == pytest.approx(4.390898249724, abs=1e-9)
    assert doubling.period * np.sqrt(1 / 9.81) == pytest.approx(0.7535239086, abs=1e-9)


def test_two_doublings_that_hide_each_other_are_found():
    """Between two points of the branch two multipliers cross -1, and then become a pair of complex ones."""
    found = stridemap.branches(
        "wobbling", "k", (9.0, 13.0), {"alpha": 0.25, "omega": 3.0}, seeds=1, search={"starts": 128}
    )
    stable = [point for point in found.special if point.type == "pd" and 10.9 < point.value < 11.5]
    np.testing.assert_allclose(
        sorted(point.value for point in stable), [11.0476914569, 11.3001683417], rtol=0, atol=1e-8
    )
    points = found.to_frame().query("gait and period < 1.23")
    assert points.stable[points.k < 11.04].all()
    assert not points.stable[points.k > 11.31].any()


# -- refusals --------------------------------------------------------------------------------------------


@pytest.mark.quick
@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ({"vary": "slop"}, ["slop", "slope"]),
        ({"range": (0.02, 0.01)}, ["0.02 0.01 of slope", "ascending"]),
        ({"range": (0.01, float("nan"))}, ["nan", "finite"]),
        ({"range": 3}, ["range 3 of slope", "two finite numbers"]),
        ({"params": {"slope": 0.01}}, ["slope", "leave it out"]),
        ({"period_n": 0}, ["period_n = 0", "1 to 64"]),
        ({"period_n": 32, "cascade": 3}, ["256 steps", "64"]),
        ({"cascade": -1}, ["cascade = -1"]),
        ({"seeds": 0}, ["seeds = 0"]),
        ({"friction_limit": 0}, ["friction_limit = 0", "above 0"]),
        ({"options": {"ds": 1.0}}, ["ds = 1", "ds_max"]),
        ({"options": {"stepsize": 1.0}}, ["stepsize", "ds_max"]),
    ],
)
def test_unusable_input_is_refused_in_one_sentence(arguments, words):
    with pytest.raises(InputError) as caught:
        stridemap.branches(
            **{"model": "simplest_walker", "vary": "slope", "range": (0.01, 0.02), **arguments}
        )
    message = str(caught.value)
    assert "\n" not in message
    assert [word for word in words if word not in message] == []
