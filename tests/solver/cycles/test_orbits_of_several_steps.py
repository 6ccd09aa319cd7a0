"""Limit cycles of several steps as values: their steps, their measures, what is drawn of them."""

import json

import numpy as np
import pytest
from PIL import Image

import stridemap
from stridemap.errors import InputError

SLOPE = 0.0124


@pytest.fixture(scope="module")
def three():
    return stridemap.find_orbits("simplest_walker", period_n=3, slope=SLOPE)


def test_the_stable_gait_of_three_steps(three):
    """Its periods are those of the walk that a simulation settles on."""
    assert [orbit.stable for orbit in three] == [True, False]
    gait = three[0]
    assert (gait.status, gait.period_n, len(gait.steps)) == ("converged", 3, 3)
    np.testing.assert_allclose(
        [step["period"] for step in gait.steps], [4.145346, 3.552517, 3.724043], atol=1e-6
    )
    assert gait.period == pytest.approx(sum(step["period"] for step in gait.steps), rel=1e-15)
    assert gait.state == {name: gait.steps[0][name] for name in ("theta", "dtheta")}


@pytest.mark.parametrize("number", [0, 1])
def test_the_simulator_repeats_it(three, number):
    """The event-driven integrator meets its section points again, and what it measures."""
    gait = three[number]
    walk = gait.simulate(3)
    assert len(walk.steps) == 3
    for i, step in enumerate(walk.steps):
        following = gait.steps[(i + 1) % 3]
        for name in ("theta", "dtheta"):
            assert step.state[name] == pytest.approx(following[name], abs=1e-9)
        assert step.period == pytest.approx(gait.steps[i]["period"], abs=1e-9)
    assert gait.step_length == pytest.approx(sum(step.step_length for step in walk.steps), abs=1e-9)
    lowest = min(step.min_vertical_force for step in walk.steps)
    assert gait.min_vertical_force == pytest.approx(lowest, abs=1e-6)
    assert gait.speed == pytest.approx(gait.step_length / gait.period, rel=1e-12)


def test_multipliers_are_those_of_the_walk(three):
    """By differences of the simulator's section point after three steps."""
    gait, step = three[0], 1e-6  # a large one leaves the basin: third derivatives are of the order of 1e7
    columns = []
    for name in ("theta", "dtheta"):
        ends = []
        for sign in (1, -1):
            start = {**gait.state, name: gait.state[name] + sign * step}
            walk = stridemap.simulate("simplest_walker", start, steps=3, slope=SLOPE)
            ends.append(np.array(list(walk.steps[-1].state.values())))
        columns.append((ends[0] - ends[1]) / (2 * step))
    found = np.linalg.eigvals(np.array(columns).T)
    np.testing.assert_allclose(np.sort_complex(found), np.sort_complex(gait.multipliers), atol=3e-5)


def test_gaits_of_one_step_are_not_among_those_of_two():
    assert len(stridemap.find_orbits("simplest_walker", period_n=2, slope=SLOPE)) == 0
    (two,) = stridemap.find_orbits("simplest_walker", period_n=2, slope=0.0175)
    assert two.stable


def test_tables_and_json(three, run):
    frame = three.to_frame()
    assert frame["period_n"].tolist() == [3, 3]
    plain = three[0].to_dict()
    assert plain["period_n"] == 3
    assert plain["steps"][0] == {**three[0].state, "period": three[0].steps[0]["period"]}
    line = f"orbit --model simplest_walker --slope {SLOPE} --period-n 3"
    status, out, _ = run(*line.split(), "--json")
    assert status == 0
    assert json.loads(out)["orbits"][0]["steps"] == plain["steps"]
    status, out, _ = run(*line.split())
    assert (status, out.splitlines()[2].split()[:3]) == (0, ["steps", "3", "3"])


def test_selections_keep_the_steps(three):
    assert three[three.known_stable][0] == three[0]
    assert (three[1:] + three[:1])[1] == three[0]
    single = stridemap.find_orbits("simplest_walker", slope=SLOPE)
    assert (single.period_n, single[0].period_n, single[0].steps) == (1, 1, ())
    with pytest.raises(InputError, match="different numbers of steps"):
        single + three


def test_its_motion_has_a_leading_axis(three):
    seen = three[0].motion(11)
    assert seen.q.shape == (3, 11, 2)
    step = seen.step(1)
    assert step.t[-1] == pytest.approx(three[0].steps[1]["period"], rel=1e-15)
    np.testing.assert_array_equal(step.coordinate("theta"), seen.coordinate("theta")[1])


def test_it_is_drawn_step_by_step(three, tmp_path):
    gait = three[0]
    panel = gait.plot().axes[0]
    x, y = panel.get_lines()[0].get_data()
    assert np.isnan(y).sum() == 2  # gaps at two touchdowns
    assert np.nanmax(x) == pytest.approx(gait.period)
    assert len(gait.plot("phase").axes[0].get_lines()) == 9
    path = gait.animate(tmp_path / "gait.gif", fps=2)
    with Image.open(path) as film:
        assert film.n_frames % 6 == 0
    with pytest.raises(InputError, match="steps = 4 is not allowed: a multiple of 6"):
        gait.animate(tmp_path / "gait.gif", steps=4)


@pytest.mark.quick
@pytest.mark.parametrize("period_n", [0, -1, 2.0, True, 65])
def test_numbers_of_steps_that_are_refused(period_n):
    with pytest.raises(InputError, match="period_n = .* is not allowed: a whole number from 1 to 64"):
        stridemap.find_orbits("simplest_walker", period_n=period_n)
