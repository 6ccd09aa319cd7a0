"""Which cycles are on a branch already, so that every branch is followed once."""

import numpy as np
import pytest

import stridemap
from stridemap.solver.branches.arclength import Window, at_value, both_ways, follow
from stridemap.solver.branches.asking import alone
from stridemap.solver.branches.special import special_points
from stridemap.solver.branches.survey import Branch, on_branch
from stridemap.solver.branches.switching import doubled
from stridemap.solver.options import ContinuationOptions
from tests.oracles.maps import curve, p, x

OPTIONS = ContinuationOptions()


def branch(on, points, reasons=()):
    return Branch(on, points, reasons, [], [], {}, {})


@pytest.fixture(scope="module")
def fold():
    """x^2 = p with both its sheets."""
    on = curve(x + p - x**2)
    start = np.array([0.6, 1.0, 0.36])
    begin = at_value(on, start, 0.36, np.eye(3)[-1], 10)
    return branch(on, *both_ways(on, begin, Window((-1.0,), (0.8,), 0.5, 1.5), OPTIONS))


@pytest.mark.quick
def test_a_cycle_between_two_points_of_a_branch_is_on_it(fold):
    for value in np.linspace(0.01, 0.79, 14):
        for sign in (1, -1):
            assert on_branch(fold, np.array([sign * np.sqrt(value), 1.0, value]))


@pytest.mark.quick
def test_a_cycle_nearer_to_a_fold_than_the_points_about_it_is_on_the_branch(fold):
    """Neither of these points, nor any other, lies beyond the cycle's value of the parameter."""
    nearest = np.abs(fold.x[:, -1]).min()
    for value in (0.0, 0.01 * nearest, 0.5 * nearest):
        assert on_branch(fold, np.array([np.sqrt(value), 1.0, value]))


@pytest.mark.quick
def test_a_cycle_beside_a_branch_is_not_on_it(fold):
    for value in np.linspace(0.05, 0.79, 9):
        for off in (1e-3, -1e-3):
            assert not on_branch(fold, np.array([np.sqrt(value) + off, 1.0, value]))
            assert not on_branch(fold, np.array([np.sqrt(value), 1.0 + off, value]))
    assert not on_branch(fold, np.array([0.0, 1.0, -0.5]))  # where the branch has no cycle
    assert not on_branch(fold, np.array([0.5, 1.0, 0.5, 1.0, 0.25]))  # of two steps


@pytest.mark.quick
def test_a_cycle_of_two_steps_is_the_same_whichever_it_begins_with():
    on = curve(p * x * (1 - x))
    begin = at_value(on, np.array([0.6, 1.0, 2.5]), 2.5, np.eye(3)[-1], 10)
    window = Window((2.2,), (3.4,), 0.5, 1.5)
    points, _ = both_ways(on, begin, window, OPTIONS)
    ((_, doubling),) = special_points(on, points, OPTIONS)
    begins = alone(doubled(on, doubling, OPTIONS))
    two = branch(begins.curve, follow(begins.curve, begins.start, window, OPTIONS)[0])
    value = 3.2345
    one, other = (value + 1 + np.array([-1, 1]) * np.sqrt((value - 3) * (value + 1))) / (2 * value)
    assert on_branch(two, np.array([one, 1.0, other, 1.0, value]))
    assert on_branch(two, np.array([other, 1.0, one, 1.0, value]))
    assert not on_branch(two, np.array([one, 1.0, one, 1.0, value]))


@pytest.mark.quick
def test_every_branch_is_followed_once():
    """The simplest walker has two gaits at these slopes, whatever the number of values it is searched at."""
    for seeds in (1, 2):
        found = stridemap.branches(
            "simplest_walker", "slope", (0.005, 0.012), seeds=seeds, search={"starts": 64}
        )
        assert len(found) == 2


@pytest.mark.quick
@pytest.mark.parametrize(("cascade", "steps"), [(0, {1}), (1, {1, 2})])
def test_as_many_doublings_are_followed_as_are_asked_for(cascade, steps):
    found = stridemap.branches(
        "simplest_walker", "slope", (0.0148, 0.0153), seeds=1, cascade=cascade, search={"starts": 64}
    )
    assert {one.period_n for one in found} == steps


@pytest.mark.quick
def test_small_gaits_are_followed_to_the_end_of_the_range():
    """Where theta is .943976 and .970956 times the cube root of the slope (Garcia and others, 1998).

    The curve is ever steeper there: from afar the end of the range is not found on it.
    """
    found = stridemap.branches("simplest_walker", "slope", (1e-7, 0.009), seeds=1, search={"starts": 64})
    assert [one.x[0, -1] for one in found] == [1e-7, 1e-7]
    theta = sorted(one.x[0, 0] for one in found)
    np.testing.assert_allclose(np.array(theta) / 1e-7 ** (1 / 3), [0.943976, 0.970956], rtol=2e-5)
