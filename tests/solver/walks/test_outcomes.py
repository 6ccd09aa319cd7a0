"""Every walk that ends early says truly how: rocks back, stops, goes uphill, falls ahead or behind."""

import math

import numpy as np
import pytest
from scipy.integrate import quad

from stridemap.solver.model.loading import load
from stridemap.solver.model.scales import Scales
from stridemap.solver.walks.outcomes import Outcome
from stridemap.solver.walks.simulator import walk
from stridemap.solver.walks.swing import TIME_LIMIT, swing


def outcome(name, params, state, steps=3):
    model = load(name)
    walked = walk(model, model.point(params), np.array(state, dtype=float), steps)
    return walked.outcome, len(walked.steps)


def wheel(spokes, lambda2, slope, theta, dtheta, steps=10):
    params = {"spokes": spokes, "lambda2": lambda2, "slope": slope}
    return outcome("rimless_wheel", params, (theta, dtheta), steps)


# -- the rimless wheel, whose energy says in closed form what it does ----------------------------------------


def needed(spokes, lambda2, slope):
    """Rate just after touchdown that takes the hub to the top, by the energy."""
    return math.sqrt(2 * lambda2 * (1 - math.cos(math.pi / spokes - slope)))


@pytest.mark.quick
def test_a_wheel_of_seven_spokes_takes_a_step_and_rocks_back():
    # l = 0.5 m, m = 0.5 kg, I = 0.01 kg m^2 on 3 degrees: just after touchdown it would need 0.379.
    lambda2, slope = 0.125 / (0.01 + 0.125), math.radians(3)
    assert needed(7, lambda2, slope) == pytest.approx(0.379, abs=2e-3)
    assert wheel(7, lambda2, slope, 0.0, 0.3193) == (Outcome.ROCKS_BACK, 1)


def test_a_wheel_of_eight_spokes_rolls():
    # A closed form: mu sqrt(4 lambda2 sin(pi/8) sin(.08) / (1 - mu^2)) with lambda2 = 1 and mu^2 = 1/2.
    assert wheel(8, 1.0, 0.08, -math.pi / 8, 0.349754367433, 20) == (Outcome.WALKED, 20)


@pytest.mark.parametrize("spokes", [5, 7, 10, 16])
@pytest.mark.parametrize("slope", [0.0, 0.05])
def test_the_energy_decides_whether_a_wheel_passes(spokes, slope):
    for lambda2 in (0.4, 1.0):
        top = needed(spokes, lambda2, slope)
        start = -math.pi / spokes
        assert wheel(spokes, lambda2, slope, start, 1.001 * top, 1) == (Outcome.WALKED, 1)
        assert wheel(spokes, lambda2, slope, start, 0.999 * top, 1) == (Outcome.ROCKS_BACK, 0)


def test_a_wheel_that_just_passes_takes_its_time():
    """With a part of 1e-9 more speed than it needs: 21.7 units of time, by the energy and quadrature."""
    top = needed(8, 1.0, 0.05)
    model = load("rimless_wheel")
    params = model.point({"spokes": 8, "lambda2": 1.0, "slope": 0.05})
    phase = swing(model, params, np.array([-math.pi / 8, (1 + 1e-9) * top]))
    assert phase.outcome is Outcome.WALKED
    start, end = -math.pi / 8 + 0.05, math.pi / 8 + 0.05
    excess = ((1 + 1e-9) ** 2 - 1) * top**2
    time = quad(
        lambda x: 1 / math.sqrt(excess + 4 * math.sin(x / 2) ** 2), start, end, points=[0.0], limit=400
    )[0]
    assert time > 20
    # The integrator's 1e-12 is a thousandth of the energy that is left at the top.
    assert phase.duration == pytest.approx(time, abs=1e-3)


@pytest.mark.parametrize(("slope", "said"), [(0.05, "uphill"), (0.0, "backward"), (-0.05, "backward")])
@pytest.mark.parametrize("theta", [-math.pi / 8, -0.3926, 0.1])
def test_a_wheel_that_starts_back_goes_uphill(slope, said, theta):
    assert wheel(8, 1.0, slope, theta, -0.4) == (Outcome(f"goes_{said}"), 0)


def test_a_wheel_that_stands_on_two_spokes_stops():
    assert wheel(8, 1.0, 0.05, -math.pi / 8, 0.0) == (Outcome.STOPS, 0)
    # On a slope of more than pi/8 it does not stand: it starts to roll.
    assert wheel(8, 1.0, 0.45, -math.pi / 8, 0.0, 1) == (Outcome.WALKED, 1)


def test_a_wheel_up_a_hill_walks_while_it_can():
    ended, steps = wheel(8, 1.0, -0.1, -math.pi / 8, 1.5)
    assert ended is Outcome.ROCKS_BACK
    assert steps >= 1
    mu, energy = 1 + (math.cos(math.pi / 4) - 1), 1.5**2
    expected = 0
    while energy > needed(8, 1.0, -0.1) ** 2:  # a step climbs 2 sin(pi/8) sin(.1); the impact takes its share
        energy = mu**2 * (energy - 4 * math.sin(math.pi / 8) * math.sin(0.1))
        expected += 1
    assert steps == expected


# -- two legs ------------------------------------------------------------------------------------------------


@pytest.mark.quick
@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize(
    ("params", "state", "expected"),
    [
        ({}, (0.1, 0.6, 0.0, 0.0, 0.0), Outcome.GOES_BACKWARD),
        ({}, (0.1, 50.0, 0.0, 0.0, 0.0), Outcome.GOES_BACKWARD),
        ({}, (0.1, -50.0, 0.0, 0.0, 0.0), Outcome.FALLS_FORWARD),
        ({"k": 0.0, "Kp": 0.0, "Kd": 0.0}, (0.0, 0.0, 0.0, 0.0, 0.0), Outcome.NO_TOUCHDOWN),  # upright
        ({}, (0.1, 1e200, 0.0, 0.0, 0.0), Outcome.GOES_BACKWARD),
        ({}, (0.1, -1e200, 0.0, 0.0, 0.0), Outcome.FAILED),
    ],
)
def test_the_paper_s_walker(params, state, expected):
    assert outcome("wobbling", params, state) == (expected, 0)
    model = load("wobbling")
    phase = swing(model, model.point(params), np.array(state))
    assert phase(phase.begin).shape == (6,)
    if expected is Outcome.FALLS_FORWARD:
        assert phase.end[0] < -math.pi / 2


def test_a_compass_without_energy_rocks_back():
    # Straight legs with little speed: the hip comes to rest before mid-stance and returns.
    assert outcome("simplest_walker", {"slope": 0.009}, (0.2, -0.1)) == (Outcome.ROCKS_BACK, 0)
    assert outcome("simplest_walker", {"slope": 0.009}, (0.2, -0.2), 5) == (Outcome.WALKED, 5)
    assert outcome("simplest_walker", {"slope": 0.009}, (0.2, 0.05)) == (Outcome.GOES_UPHILL, 0)
    assert outcome("simplest_walker", {"slope": -0.009}, (0.2, 0.05)) == (Outcome.GOES_BACKWARD, 0)


def test_what_balances_upright_stops():
    assert outcome("goswami_compass", {"slope": 0.0}, (0.0, 0.0, 0.0)) == (Outcome.STOPS, 0)


def test_a_fall_behind():
    """With the swing leg raised ahead, the walker falls over backward."""
    model = load("goswami_compass")
    start = {"theta1": 0.3, "theta2": -0.4, "dtheta1": 0.5, "dtheta2": 0.0}
    assert walk(model, model.point({}), None, 1, start=start).outcome is Outcome.FALLS_BACKWARD
    start = {"theta1": -0.3, "theta2": 0.4, "dtheta1": -0.5, "dtheta2": 0.0}
    assert walk(model, model.point({}), None, 1, start=start).outcome is Outcome.FALLS_FORWARD


def test_a_clock_that_waits_is_no_rest():
    """The paper's hip is driven by a clock: what stands for a moment is not at rest."""
    model = load("compass")
    phase = swing(model, model.point({"omega": 1e-3, "Kp": 0.0, "Kd": 0.0}), np.zeros(3))
    assert phase.outcome is Outcome.NO_TOUCHDOWN
    assert phase.duration == pytest.approx(TIME_LIMIT * Scales.of(model).time, rel=1e-14)


def test_every_outcome_is_said_in_words():
    assert Outcome.ROCKS_BACK.words == "rocks back"
    assert [one for one in Outcome if not one.sentence] == [Outcome.WALKED]
