"""Parameters for which a quantity takes a wanted value, against closed forms and independent values."""

import math

import numpy as np
import pytest

import stridemap
from stridemap.errors import InputError
from stridemap.solver.branches.target_range import values_within

WHEEL = {"spokes": math.pi / 0.3, "lambda2": 1.0}


@pytest.mark.quick
def test_the_slope_on_which_a_wheel_rolls_with_a_speed():
    found = stridemap.find("rimless_wheel", "speed = 0.45", "slope", params=WHEEL, range=(0.0, 0.3))
    assert found.values == pytest.approx([0.08764356491945], abs=1e-13)  # from the closed form
    assert found.orbits.speed == pytest.approx([0.45], abs=1e-14)
    assert found.orbits.status.tolist() == ["converged"]
    assert found.summary == "1 limit cycle with speed = 0.45 for slope from 0 to 0.3"


def test_without_a_range_all_allowed_values_count():
    found = stridemap.find("rimless_wheel", {"speed": 0.45}, "slope", params=WHEEL)
    assert found.range == (-1.5, 1.5)
    assert found.values == pytest.approx([0.08764356491945], abs=1e-13)


def test_any_quantity_of_the_closed_form():
    """Rate and multiplier: mu sqrt(4 lambda2 sin(pi/n) sin(slope) / (1 - mu^2)) and mu^2."""
    half, mu = math.pi / 6, 1 - 2 / 3 * 0.5
    rate = mu * math.sqrt(4 * 2 / 3 * math.sin(half) * math.sin(0.2345) / (1 - mu**2))
    found = stridemap.find("rimless_wheel", {"dtheta": rate}, "slope", range=(0.1, 0.4))
    assert found.values == pytest.approx([0.2345], abs=1e-12)
    found = stridemap.find("rimless_wheel", {"cot": math.sin(0.3)}, "slope", range=(0.1, 0.4))
    assert found.values == pytest.approx([0.3], abs=1e-12)
    lambda2 = 0.61
    wanted = (1 + lambda2 * (math.cos(math.pi / 3) - 1)) ** 2
    found = stridemap.find("rimless_wheel", {"spectral_radius": wanted}, "lambda2", range=(0.5, 1), slope=0.3)
    assert found.values == pytest.approx([lambda2], abs=1e-11)


def test_a_period_doubling_of_the_simplest_walker():
    """Where the largest multiplier is of modulus 1; an independent value is 0.015088437940."""
    found = stridemap.find("simplest_walker", "spectral_radius = 1", "slope", range=(0.012, 0.017))
    assert found.values == pytest.approx([0.015088437940], abs=5e-12)
    assert found.orbits.period == pytest.approx([3.9124092125], abs=1e-9)


def test_both_gaits_with_one_value():
    """The long and the short gait of the compass have one step length on two slopes."""
    length = 0.5
    found = stridemap.find("goswami_compass", {"step_length": length}, "slope", range=(0.02, 0.06))
    assert len(found) == 2
    assert found.orbits.step_length == pytest.approx([length] * 2, abs=1e-13)
    assert found.orbits.period[0] != pytest.approx(found.orbits.period[1], abs=0.1)
    for value, orbit in zip(found.values, found.orbits, strict=True):
        again = stridemap.find_orbits("goswami_compass", slope=value)
        assert min(abs(again.period - orbit.period)) < 1e-10


def test_a_pair_on_the_two_sides_of_a_turning_point():
    """A value just below the largest that a quantity has on a branch is taken twice, however close."""
    seen = [stridemap.find_orbits("simplest_walker", slope=s) for s in np.linspace(0.0145, 0.0185, 5)]
    radii = [min(orbits.spectral_radius) for orbits in seen]
    assert radii[0] < 1 < radii[-1]
    coarse = stridemap.find("simplest_walker", "spectral_radius = 0.6", "slope", range=(0.005, 0.0145))
    assert all(orbit.spectral_radius == pytest.approx(0.6, abs=1e-12) for orbit in coarse.orbits)


def test_that_there_is_none_is_said_with_what_was_seen():
    found = stridemap.find("rimless_wheel", "speed = 4.5", "slope", params=WHEEL, range=(0.0, 0.3))
    assert (len(found), len(found.orbits), found.values.tolist()) == (0, 0, [])
    low, high = found.seen
    assert 0 < low < 0.45 < high < 1
    assert found.summary.startswith(
        "no limit cycle with speed = 4.5 was found for slope from 0 to 0.3: on the "
    )
    none = stridemap.find("rimless_wheel", "speed = 0.45", "slope", range=(-0.3, -0.1))
    assert (none.n_seen, none.seen) == (0, None)
    assert none.summary == "no limit cycle at all was found for slope from -0.3 to -0.1"


def test_values_are_spread_evenly_and_around_the_point_s_own():
    values = values_within(0.0, 1.0, 0.009)
    assert (np.diff(values) > 0).all()
    assert {0.0, 1.0, 0.009, 0.0045, 0.018} <= set(values.tolist())
    assert len(values_within(-1.0, 1.0, 0.0)) == 33


@pytest.mark.quick
@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        ({"target": "speed"}, "the target 'speed' is not understood; write it as 'speed = 0.45'"),
        ({"target": "= 3"}, "is not understood"),
        ({"target": {}}, "is not understood"),
        ({"target": {"speed": 1, "cot": 2}}, "is not understood"),
        ({"target": "speed = fast"}, "speed = 'fast' of the target is not a finite number"),
        ({"target": {"speed": math.nan}}, "speed = nan of the target is not a finite number"),
        ({"target": {"speed": True}}, "speed = True of the target is not a finite number"),
        ({"target": "sped = 1"}, "rimless_wheel has no quantity 'sped'; targets are period, "),
        ({"target": "wobble_amplitude = 1"}, "has no quantity 'wobble_amplitude'"),
        ({"target": "peaks = 1"}, "peaks cannot be a target: it does not vary continuously"),
        ({"target": "stable = 1"}, "stable cannot be a target"),
        ({"vary": "slop"}, "has no parameter 'slop' .did you mean slope"),
        ({"range": (0.3, 0.1)}, r"the range 0.3 0.1 of slope is not allowed"),
        ({"range": (0.1,)}, "two finite numbers in ascending order"),
        ({"range": ("a", 1)}, "two finite numbers in ascending order"),
        ({"range": 3}, "two finite numbers in ascending order"),
        ({"range": (0.1, math.inf)}, "two finite numbers in ascending order"),
        ({"range": (0.1, 2.0)}, "slope = 2 is outside the allowed range"),
        ({"options": {"starts": 0}}, "starts = 0 is not allowed"),
    ],
)
def test_what_cannot_be_looked_for_is_refused(arguments, sentence):
    usual = {"target": "speed = 0.45", "vary": "slope", "range": (0.1, 0.3)}
    with pytest.raises(InputError, match=sentence):
        stridemap.find("rimless_wheel", **{**usual, **arguments})


def test_a_range_that_cannot_be_guessed_is_asked_for():
    with pytest.raises(InputError, match="k = 0 does not say in which range to look; give one"):
        stridemap.find("wobbling", "speed = 0.2", "k", k=0)
