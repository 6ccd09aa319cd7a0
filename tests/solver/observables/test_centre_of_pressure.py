"""The centre of pressure along whole cycles: in the table, in the motion, and in pictures."""

import numpy as np
import pytest

import stridemap
from stridemap.views.scene import scene
from tests.oracles.walkers import cycle_near, derived


@pytest.fixture(scope="module")
def driven():
    """The gait of the compass that goes over into this one when the ankle's motor is turned up."""
    (_, gait) = stridemap.find_orbits("goswami_compass")
    state, period = dict(gait.state), gait.period
    for gain in (0.03, 0.06, 0.12):
        orbit = cycle_near(derived("ankled"), state, period, gain=gain)
        state, period = dict(orbit.state), orbit.period
    return orbit


def pushed(orbit, samples):
    """Torque over vertical force, from the declaration's formula and the force that carries the walker."""
    seen = stridemap.motion(orbit, samples)
    torque = -0.12 * np.sin(3 * seen.coordinate("theta1"))
    velocity = np.gradient(seen.com[:, 1], seen.t, edge_order=2)
    load = 4 * (np.gradient(velocity, seen.t, edge_order=2) + np.cos(0.05))  # hip 2, legs 1 each
    return seen, torque / load


def test_a_motor_at_the_ankle_moves_it(driven, uncompiled):
    seen, own = pushed(driven, 4001)
    inside = slice(5, -5)  # differences are poor at the ends
    assert np.abs(seen.cop - own)[inside].max() < 2e-7
    assert np.all(seen.contact == 0)
    assert driven.cop_max == pytest.approx(np.abs(seen.cop).max(), abs=1e-8)
    assert driven.cop_max == pytest.approx(0.031251743224084, abs=1e-10)
    assert driven.d_max > 3 * driven.cop_max  # who takes the foot's length from d wants three times as much


def test_it_passes_from_heel_to_toe(driven, uncompiled):
    seen = stridemap.motion(driven, 101)
    assert seen.cop[0] < -0.02
    assert seen.cop[-1] > 0.02


def test_pictures_draw_the_force_there(driven, uncompiled):
    pytest.importorskip("matplotlib")
    shown = scene(driven, 40)
    assert shown.cop[0] < 0 < shown.cop[-1]
    # The legs' length is the walker's height at most.
    np.testing.assert_allclose(shown.cop / shown.seen.cop, shown.step / driven.step_length, rtol=1e-12)
    np.testing.assert_allclose(shown.zmp / -shown.seen.d, shown.step / driven.step_length, rtol=1e-12)
    figure = driven.plot()
    labels = {text.get_text() for axes in figure.axes for text in (axes.get_legend() or figure).findobj()
              if hasattr(text, "get_text")}  # fmt: skip
    assert {"centre of pressure", "paper's $d$"} <= labels


@pytest.mark.parametrize(
    "name", ["compass", "goswami_compass", "simplest_walker", "rimless_wheel", "wobbling"]
)
def test_a_point_foot_without_a_motor_at_the_ankle_is_pushed_at_the_foot(name):
    options = stridemap.SearchOptions(starts=64)
    for orbit in stridemap.find_orbits(name, options=options):
        assert orbit.cop_max == 0
        assert not np.any(stridemap.motion(orbit, 21).cop)


def test_under_a_round_foot_it_is_the_contact():
    options = stridemap.SearchOptions(starts=64)
    for orbit in stridemap.find_orbits("round_feet", options=options):
        seen = stridemap.motion(orbit, 21)
        assert orbit.cop_max == 0
        np.testing.assert_allclose(seen.cop, -0.2 * seen.coordinate("q1"), rtol=0, atol=1e-15)
        np.testing.assert_array_equal(seen.cop, seen.contact)
        shown = scene(orbit, 20)
        np.testing.assert_allclose(
            shown.zmp, shown.contact - seen.d / orbit.step_length * shown.step, atol=1e-12
        )
