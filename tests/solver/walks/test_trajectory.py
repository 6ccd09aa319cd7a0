"""The time series of a walk: evenly spaced, with both sides of each impact, as SciPy integrates it."""

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import stridemap
from stridemap.errors import InputError
from stridemap.solver.walks import trajectory as module

SLOPE = 0.009
STATE = {"theta": 0.2, "dtheta": -0.2}


@pytest.fixture(scope="module")
def walk():
    return stridemap.simulate("simplest_walker", STATE, steps=10, slope=SLOPE)


@pytest.fixture(scope="module")
def series(walk):
    return walk.trajectory(0.1)


def garcia(t, y):
    """The published equations of the simplest walker (Garcia and others, 1998)."""
    theta, phi, dtheta, dphi = y
    ddtheta = math.sin(theta - SLOPE)
    return [
        dtheta,
        dphi,
        ddtheta,
        ddtheta + dtheta**2 * math.sin(phi) - math.cos(theta - SLOPE) * math.sin(phi),
    ]


def by_scipy(steps):
    """The same walk with the published equations and SciPy's DOP853: (start, end, dense output) per step."""

    def strikes(t, y):
        return y[1] - 2 * y[0] if y[0] < -0.05 else -1.0

    strikes.terminal, strikes.direction = True, 1
    t, theta, dtheta = 0.0, STATE["theta"], STATE["dtheta"]
    for _ in range(steps):
        y = [theta, 2 * theta, dtheta, (1 - math.cos(2 * theta)) * dtheta]
        one = solve_ivp(
            garcia, (0, 10), y, "DOP853", dense_output=True, events=strikes, rtol=1e-13, atol=1e-15
        )
        (at,), (end,) = one.t_events[0], one.y_events[0]
        yield t, t + at, one.sol
        t += at
        theta, dtheta = -end[0], math.cos(2 * end[0]) * end[2]


@pytest.mark.quick
def test_it_is_scipy_s_dense_output(series):
    pieces = list(by_scipy(10))
    assert len(series.samples) == 1 + math.floor(pieces[-1][1] / 0.1)
    for i, (begin, end, dense) in enumerate(pieces, 1):
        mine = series.take((series.step == i) & (series.event == "sample"))
        assert ((mine.time >= begin) & (mine.time < end)).all()
        assert np.allclose(np.hstack([mine.q, mine.v]), dense(mine.time - begin).T, rtol=0, atol=1e-10)
        assert np.allclose(mine.step_time, mine.time - begin, rtol=0, atol=1e-11)
        before = series.take((series.step == i) & (series.event == "before_impact"))
        assert before.time[0] == pytest.approx(end, abs=1e-11)
        assert np.allclose(np.hstack([before.q, before.v])[0], dense(end - begin), rtol=0, atol=1e-10)


def test_samples_are_evenly_spaced(series):
    assert np.array_equal(series.samples.time, 0.1 * np.arange(len(series.samples)))
    assert (np.diff(series.time) >= 0).all()


def test_every_impact_has_two_sides(walk, series):
    before, after = (series.take(series.event == word) for word in ("before_impact", "after_impact"))
    assert len(before) == len(after) == 10
    assert np.array_equal(before.time, after.time)
    assert np.array_equal(after.step, before.step + 1)
    assert np.allclose(np.diff(before.time, prepend=0), [s.period for s in walk.steps], rtol=0, atol=1e-12)
    assert (before.stance_leg != after.stance_leg).all()
    for name in ("theta", "dtheta"):
        assert after.coordinate(name).tolist() == pytest.approx(
            [s.state[name] for s in walk.steps], abs=1e-14
        )
    assert np.array_equal(np.sort(np.unique(series.step)), np.arange(1, 12))


def test_the_legs_change_places(series):
    assert set(series.stance_leg[series.step % 2 == 1]) == {"left"}
    assert set(series.stance_leg[series.step % 2 == 0]) == {"right"}


def test_feet_stand_still_in_the_world(walk, series):
    """A stance foot does not move; the swing foot lands on the next foothold, where the old one lets go."""
    for i in range(1, 11):
        foot = series.stance_foot[series.step == i]
        assert (foot == foot[0]).all()
    steps = np.cumsum([step.step_length for step in walk.steps])
    before, after = (series.take(series.event == word) for word in ("before_impact", "after_impact"))
    assert np.allclose(before.swing_foot[:, 0], steps, rtol=0, atol=1e-12)
    assert np.allclose(after.stance_foot, before.swing_foot, rtol=0, atol=1e-12)
    assert np.allclose(after.swing_foot, before.stance_foot, rtol=0, atol=1e-12)
    assert np.allclose(series.stance_foot[:, 1], 0, atol=1e-12)


def test_round_feet_roll_in_the_world():
    """The centre of the arc is above its contact, and moves on by the radius times the angle."""
    walk = stridemap.simulate("round_feet", steps=3)
    series = walk.trajectory(0.05)
    assert np.allclose(series.stance_foot[:, 1], 0.2, atol=1e-12)
    for i in range(1, 4):
        one = series.take(series.step == i)
        rolled = one.stance_foot[:, 0] + 0.2 * one.coordinate("q1")
        assert np.ptp(rolled) < 1e-12
    before, after = (series.take(series.event == word) for word in ("before_impact", "after_impact"))
    assert np.allclose(after.stance_foot, before.swing_foot, rtol=0, atol=1e-12)
    assert np.allclose(after.swing_foot, before.stance_foot, rtol=0, atol=1e-12)


@pytest.mark.parametrize("dt", [0.5, 0.03, 7.0])
def test_any_spacing_gives_the_same_motion(walk, series, dt):
    other = walk.trajectory(dt)
    assert np.array_equal(other.samples.time, dt * np.arange(len(other.samples)))
    sides = [one.take(one.event == "before_impact") for one in (series, other)]
    assert np.array_equal(sides[0].q, sides[1].q)
    shared = np.isin(np.round(series.samples.time, 9), np.round(other.samples.time, 9))
    back = np.isin(np.round(other.samples.time, 9), np.round(series.samples.time, 9))
    assert np.allclose(series.samples.q[shared], other.samples.q[back], rtol=0, atol=1e-12)


def test_a_walk_that_breaks_off_ends_with_its_last_state():
    walk = stridemap.simulate("simplest_walker", {"theta": 0.2, "dtheta": -0.1}, slope=SLOPE)
    assert walk.outcome is stridemap.Outcome.ROCKS_BACK
    series = walk.trajectory(0.1)
    assert (series.event == "end").nonzero()[0].tolist() == [len(series) - 1]
    theta, phi = series.q[-1]
    assert phi == pytest.approx(2 * theta, abs=1e-9)
    assert series.coordinate("dtheta")[-1] > 0
    assert series.time[-1] >= series.samples.time[-1]


def test_a_walk_without_duration_has_a_series():
    walk = stridemap.simulate("simplest_walker", {"theta": 0.2, "dtheta": 0.1}, slope=SLOPE)
    assert walk.trajectory(0.1).event.tolist() == ["sample", "end"]


def test_a_sample_at_the_time_of_an_impact_is_the_state_after_it(walk):
    period = walk.steps[0].period
    series = walk.trajectory(period)
    second = series.samples.take(slice(1, 2))
    assert (second.step.tolist(), second.step_time.tolist()) == ([2], [0.0])
    assert second.coordinate("theta")[0] == pytest.approx(walk.steps[0].state["theta"], abs=1e-14)
    one = stridemap.simulate("simplest_walker", STATE, steps=1, slope=SLOPE)
    last = one.trajectory(period).take(slice(-1, None))
    assert (last.event.tolist(), last.step.tolist()) == (["sample"], [2])


@pytest.mark.parametrize("dt", [0, -1.0, math.nan, math.inf, "0.1", True, None])
def test_the_spacing_is_checked(walk, dt):
    with pytest.raises(InputError, match="dt = .* is not allowed: a number above 0 is needed"):
        walk.trajectory(dt)


def test_the_number_of_rows_has_a_bound(walk, monkeypatch):
    with pytest.raises(InputError, match="it gives more than 10,000,000 rows; take a larger one"):
        walk.trajectory(1e-9)
    monkeypatch.setattr(module, "MAX_ROWS", 100)
    with pytest.raises(InputError, match="more than 100 rows"):
        walk.trajectory(0.1)


def test_columns(series):
    frame = series.to_frame()
    assert list(frame.columns) == [
        "time", "step", "step_time", "stance_leg", "event", "theta", "phi", "dtheta", "dphi",
        "stance_foot_x", "stance_foot_y", "swing_foot_x", "swing_foot_y",
    ]  # fmt: skip
    assert len(frame) == len(series)
    with pytest.raises(InputError, match="has no coordinate 'x'; its coordinates are theta, phi"):
        series.coordinate("x")
    assert repr(series).startswith("<trajectory of simplest_walker: ")
