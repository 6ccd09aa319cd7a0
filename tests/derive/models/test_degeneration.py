"""Limits in which one model becomes another, with the rate at which it does."""

import numpy as np
import pytest

from stridemap.solver.model.loading import load
from stridemap.solver.walks.simulator import walk
from tests.oracles.walkers import cycle_near, cycles, derived


def test_light_feet_become_massless():
    # Linear in the foot's mass: a tenth of it leaves a tenth of the difference.
    model = derived("finite_feet")
    for limit in cycles(load("simplest_walker"), slope=0.009):
        start = {**limit.state, "dphi": (1 - np.cos(2 * limit.state["theta"])) * limit.state["dtheta"]}
        off = []
        for mass in (1e-4, 1e-5, 1e-6):
            orbit = cycle_near(model, start, limit.period, slope=0.009, foot_mass=mass)
            pairs = zip(orbit.multipliers[:2], limit.multipliers, strict=True)
            off.append(
                [
                    orbit.period - limit.period,
                    orbit.state["theta"] - limit.state["theta"],
                    *(abs(one - other) for one, other in pairs),
                ]
            )
            assert abs(orbit.multipliers[2]) < 1e-9
        off = np.array(off)
        assert np.abs(off[0]).min() > 1e-6  # there is something to vanish
        assert off[1] / off[0] == pytest.approx(np.full(4, 0.1), rel=0.01)
        assert off[2] / off[1] == pytest.approx(np.full(4, 0.1), rel=0.01)


def test_a_stiff_damped_spring_becomes_a_compass():
    # The mass then moves with the hip: the difference falls as 1/k. The damper takes what the impact
    # leaves in the spring, however stiff that is.
    model, (rigid,) = derived("damped"), cycles(load("compass"))
    off = []
    for k in (1000.0, 4000.0):
        orbit = cycle_near(model, rigid.state, rigid.period, k=k, alpha=0.25, zeta=1.0)
        off.append([orbit.period - rigid.period, orbit.cot - rigid.cot, orbit.d_max - rigid.d_max])
        assert orbit.multipliers[:2] == pytest.approx(rigid.multipliers[:2], abs=1.0 / k)
    off = np.array(off)
    assert np.abs(off[1]).max() < 2e-3
    assert off[1, :2] / off[0, :2] == pytest.approx([0.25, 0.25], rel=0.05)


def test_a_stiff_spring_becomes_a_compass_without_a_damper():
    # Away from resonance the cycle's own vibration dies out with the spring's compliance, as 1/k; its
    # multipliers, of modulus near 1, do not.
    (rigid,) = cycles(load("compass"))
    orbit = cycle_near(load("wobbling"), rigid.state, rigid.period, k=4000.0, alpha=0.25)
    assert orbit.period == pytest.approx(rigid.period, abs=5e-4)
    assert orbit.step_length == pytest.approx(rigid.step_length, abs=5e-4)
    assert sorted(abs(m) for m in orbit.multipliers)[1:3] == pytest.approx([0.463, 0.867], abs=5e-3)


def test_a_mass_that_vanishes_changes_nothing():
    # Linear in the mass, with a spring that keeps its natural frequency.
    (plain,) = cycles(load("compass"))
    off = []
    for alpha in (1e-4, 1e-5):
        orbit = cycle_near(load("wobbling"), plain.state, plain.period, k=alpha * (1 - alpha), alpha=alpha)
        off.append(orbit.period - plain.period)
    assert abs(off[0]) < 1e-3
    assert off[1] / off[0] == pytest.approx(0.1, rel=0.02)


def test_an_arc_of_no_radius_is_a_point():
    model = derived("rolling")
    (point,), (arc,) = cycles(load("compass")), cycles(model, radius=0.0)
    assert dict(arc.state) == pytest.approx(dict(point.state), abs=1e-11)
    assert arc.multipliers == pytest.approx(point.multipliers, abs=1e-10)
    for name in ("period", "step_length", "d_max", "work", "cot", "friction", "min_vertical_force"):
        assert getattr(arc, name) == pytest.approx(getattr(point, name), rel=1e-9), name


def test_small_arcs_come_near_it():
    # Linear in the radius.
    model, (point,) = derived("rolling"), cycles(load("compass"))
    off = []
    for radius in (1e-3, 1e-4):
        orbit = cycle_near(model, point.state, point.period, radius=radius)
        off.append([orbit.period - point.period, orbit.cot - point.cot])
    assert off[1][0] / off[0][0] == pytest.approx(0.1, rel=0.05)
    assert off[1][1] / off[0][1] == pytest.approx(0.1, rel=0.05)


def test_a_latch_makes_the_impact_that_of_a_compass():
    # A mass that is at rest against the hip before and after moves as if it were part of the hip.
    wobbling, compass = derived("latched"), load("compass")
    q, v = np.array([-0.11, -0.22, 0.07]), np.array([-0.4, -0.1, 0.0])
    after = wobbling.evaluate("impact_map", q=q, v=v, p=wobbling.point({}))["v_plus"]
    rigid = compass.evaluate("impact_map", q=q[:2], v=v[:2], p=compass.point({}))["v_plus"]
    assert after == pytest.approx([*rigid, 0.0], abs=1e-15)
    moving = np.array([-0.4, -0.1, 0.3])
    assert wobbling.evaluate("impact_map", q=q, v=moving, p=wobbling.point({}))["v_plus"][2] == 0.0


@pytest.mark.parametrize(
    ("name", "params"),
    [
        ("damped", {"k": 6.0, "zeta": 0.3}),
        ("rolling", {"radius": 0.3}),
        ("latched", {"k": 6.0}),
        ("locked", {"omega": 5.0}),
        ("two_motors", {"k": 7.0}),
    ],
)
def test_multipliers_are_the_simulators_differences(name, params):
    model = derived(name)
    found = [o for o in cycles(model, **params) if o.spectral_radius < 3 and o.min_vertical_force > 0]
    assert found
    p = model.point(params)
    for orbit in found[:2]:
        z = np.array(list(orbit.state.values()))

        def after(z):
            (step,) = walk(model, p, z, 1).steps
            return np.array(list(step.state.values()))

        assert after(z) == pytest.approx(z, abs=1e-10)
        size = 1e-5
        columns = [(after(z + size * e) - after(z - size * e)) / (2 * size) for e in np.eye(len(z))]
        differences = np.linalg.eigvals(np.array(columns).T)
        for value in orbit.multipliers:
            assert np.abs(differences - value).min() < 2e-6
