"""A bifurcation diagram: what is stable, where that changes, and the markers upon the curves."""

import numpy as np
import pytest

import stridemap
from stridemap.errors import InputError
from stridemap.views import style

DOUBLING = 0.0150884379411
"""Slope at which the simplest walker's gait doubles its period (tests/solver/branches/test_special.py)."""


@pytest.fixture(scope="module")
def branches():
    return stridemap.branches("simplest_walker", "slope", (0.014, 0.0165), cascade=1, seeds=2)


def curves(figure):
    """Lines and markers of the only axes, each with its colour, x and y."""
    lines = figure.axes[0].get_lines()
    found = {True: [], False: []}
    for line in lines:
        found[line.get_linestyle() == "None"].append((line.get_color(), *map(np.asarray, line.get_data())))
    return found[False], found[True]


@pytest.mark.parametrize("y", ["period", "theta", "speed", "multiplier_0_re"])
def test_stability_is_lost_at_the_doubling_and_its_marker_lies_on_the_curve(branches, y):
    (doubling,) = [one for one in branches.special if one.type == "pd" and one.period_n == 1]
    assert doubling.value == pytest.approx(DOUBLING, abs=1e-11)
    drawn, markers = curves(branches.plot(y))
    solid = [x for colour, x, _ in drawn if colour == style.BLUE]
    assert [x[-1] for x in solid if x[0] == 0.014] == [doubling.value]
    for _, x, heights in markers:
        for at, height in zip(x, heights, strict=True):
            assert any((at == xs).any() and (height == ys[at == xs]).any() for _, xs, ys in drawn)


def test_a_cycle_of_two_steps_is_drawn_at_both(branches):
    (number,) = [i for i, branch in enumerate(branches) if branch.period_n == 2]
    last = branches[number].x[-1]
    drawn, _ = curves(branches.plot("theta"))
    ends = [ys[-1] for _, xs, ys in drawn if xs[-1] == last[-1]]
    width = len(last) // 2
    for step in range(2):
        assert last[step * width] in ends


def test_only_gaits(branches):
    drawn, _ = curves(branches.plot("period", gaits_only=True))
    assert all(colour != style.GREY for colour, *_ in drawn)


def test_an_end_that_only_the_limits_of_following_make_has_a_mark_and_is_said():
    """With a shorter longest period one of the two branches ends within the range."""
    search = stridemap.SearchOptions(starts=64, period_max=3.91)
    found = stridemap.branches("simplest_walker", "slope", (0.012, 0.0165), seeds=2, search=search)
    (short,) = [one for one in found if "period_limit" in one.reasons]
    (mark,) = [line for line in found.plot().axes[0].get_lines() if line.get_marker() == "h"]
    assert mark.get_xdata() in short.x[[0, -1], -1]
    assert repr(found).count("it ends where a step becomes too short or too long") == 1


def test_what_cannot_be_drawn_is_refused(branches):
    with pytest.raises(InputError, match="what can be is theta"):
        branches.plot("wobble")
