"""Limit cycles of the built-in benchmark models against published and closed-form values."""

import math

import numpy as np
import pytest

from stridemap import motion
from stridemap.solver.model.loading import load
from tests.oracles.walkers import cycle_near, cycles

# M. Garcia, A. Chatterjee, A. Ruina, M. Coleman, J. Biomech. Eng. 120 (1998) 281-288, slope 0.009: an
# independent computation with 45 digits; P. A. Bhounsule, Dyn. Cont. Disc. Impuls. Syst. B 21 (2014)
# 137-148 prints the same to 4e-12.
UNSTABLE = {
    "state": {"theta": 0.19393736981018181, "dtheta": -0.20386692744200693},
    "period": 3.09610586807816370,
    "multipliers": [4.00386435892970718, 0.45958958979767159],
}
STABLE = {
    "state": {"theta": 0.20031090054424709, "dtheta": -0.19983247300495235},
    "period": 3.88246375285137414,
    "multipliers": [
        -0.19009984106588815 + 0.55759877668206827j,
        -0.19009984106588815 - 0.55759877668206827j,
    ],
}


@pytest.fixture(scope="module")
def simplest():
    return cycles(load("simplest_walker"), slope=0.009)


@pytest.mark.parametrize(("which", "published"), [(0, UNSTABLE), (1, STABLE)], ids=["unstable", "stable"])
def test_simplest_walker(simplest, which, published):
    assert len(simplest) == 2
    orbit = simplest[which]
    assert dict(orbit.state) == pytest.approx(published["state"], abs=1e-11, rel=0)
    assert orbit.period == pytest.approx(published["period"], abs=1e-11, rel=0)
    assert orbit.multipliers == pytest.approx(published["multipliers"], abs=1e-11, rel=0)


@pytest.mark.parametrize(
    ("spokes", "lambda2", "slope"),
    [(6, 2 / 3, 0.2), (6, 2 / 3, 0.3), (8, 0.5, 0.12), (10, 0.9, 0.1), (5, 0.8, 0.4), (12, 1.0, 0.05)],
)
def test_rimless_wheel(spokes, lambda2, slope):
    (orbit,) = cycles(load("rimless_wheel"), spokes=spokes, lambda2=lambda2, slope=slope)
    half = math.pi / spokes
    mu = 1 + lambda2 * (math.cos(2 * half) - 1)
    rate = mu * math.sqrt(4 * lambda2 * math.sin(half) * math.sin(slope) / (1 - mu**2))
    assert orbit.state["dtheta"] == pytest.approx(rate, abs=1e-12, rel=0)
    assert orbit.state["theta"] == pytest.approx(-half, abs=1e-12, rel=0)
    assert orbit.multipliers == pytest.approx([mu**2, 0.0], abs=1e-12, rel=0)
    assert orbit.step_length == pytest.approx(2 * math.sin(half), abs=1e-12, rel=0)


def test_rimless_wheel_as_printed_in_the_closed_form():
    (orbit,) = cycles(load("rimless_wheel"))
    assert orbit.state["dtheta"] == pytest.approx(0.460341126609458, abs=1e-12, rel=0)
    assert orbit.spectral_radius == pytest.approx(4 / 9, abs=1e-12, rel=0)


def test_a_wheel_that_does_not_get_over_the_top_has_no_cycle():
    # Just after impact it needs dtheta^2 > 2 lambda2 (1 - cos(pi/n - slope)), which fails at this slope.
    assert cycles(load("rimless_wheel"), slope=0.05) == []


def test_compass_gait_doubles_its_period():
    # A. Goswami, B. Thuilot, B. Espiau, Int. J. Robotics Research 17 (1998) 1282-1301: with mu = 2 and
    # beta = 1 the first period doubling is near a slope of 4.4 degrees.
    model = load("goswami_compass")
    orbit = max(cycles(model, mu=2, beta=1, slope=math.radians(4.2)), key=lambda o: o.period)
    assert orbit.stable
    low, high = math.radians(4.2), math.radians(4.6)
    for _ in range(30):
        middle = 0.5 * (low + high)
        orbit = cycle_near(model, orbit.state, orbit.period, mu=2, beta=1, slope=middle)
        low, high = (middle, high) if orbit.stable else (low, middle)
    assert orbit.multipliers[0] == pytest.approx(-1.0, abs=1e-6)
    assert math.degrees(middle) == pytest.approx(4.4, abs=0.05)


ROUND_LONG = {
    "state": {"q1": 0.189438283253, "dq1": -0.239010987813, "dq2": -0.051397006345},
    "period": 2.427955842629,
    "multipliers": [0.4334448697, 0.3704653850 + 0.1837039158j, 0.3704653850 - 0.1837039158j],
}
ROUND_SHORT = {
    "state": {"q1": 0.170377197548, "dq1": -0.232652285601, "dq2": -0.023678647519},
    "period": 2.151258880007,
    "multipliers": [2.0227272029],
}


@pytest.mark.parametrize(("which", "right"), [(0, ROUND_SHORT), (1, ROUND_LONG)], ids=["short", "long"])
def test_round_feet(which, right):
    """An independent program: floating base, event-driven integration, the corrected heel strike."""
    found = cycles(load("round_feet"))
    assert len(found) == 2
    orbit, many = found[which], len(right["multipliers"])
    assert dict(orbit.state) == pytest.approx(right["state"], abs=2e-12, rel=0)
    assert orbit.period == pytest.approx(right["period"], abs=2e-12, rel=0)
    assert orbit.multipliers[:many] == pytest.approx(right["multipliers"], abs=1e-10, rel=0)


@pytest.mark.parametrize("name", ["simplest_walker", "goswami_compass", "rimless_wheel", "round_feet"])
def test_what_the_slope_gives_is_lost_at_the_impact(name):
    model = load(name)
    found = cycles(model)
    assert found
    for orbit in found:
        seen, p = motion(orbit, 3), model.point(orbit.params)
        before, after = (
            model.evaluate("kinetic_energy", q=seen.q[i], v=seen.v[i], p=p)["kinetic"] for i in (-1, 0)
        )
        weight = model.evaluate("total_mass", p=p)["weight"]
        descent = orbit.step_length * math.sin(orbit.params["slope"])
        assert before - after == pytest.approx(weight * descent, rel=1e-11)
        assert orbit.cot == pytest.approx(math.sin(orbit.params["slope"]), rel=1e-12)
        assert orbit.work == orbit.work_net == 0.0


@pytest.mark.parametrize("name", ["simplest_walker", "goswami_compass", "rimless_wheel", "round_feet"])
def test_the_event_driven_simulator_walks_the_same(name):
    from stridemap.solver.walks.simulator import walk

    model = load(name)
    for orbit in cycles(model):
        p, z = model.point(orbit.params), np.array(list(orbit.state.values()))
        (step,) = walk(model, p, z, 1).steps
        assert step.period == pytest.approx(orbit.period, abs=1e-10)
        assert step.step_length == pytest.approx(orbit.step_length, abs=1e-10)
        assert dict(step.state) == pytest.approx(dict(orbit.state), abs=1e-10)
