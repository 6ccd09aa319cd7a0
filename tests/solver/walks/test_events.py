"""The event that ends a swing phase, on a made-up walker whose touchdown condition is a known function."""

import numpy as np
import pytest
from numpy.polynomial import Polynomial
from scipy.integrate import DenseOutput

from stridemap.solver.walks.equations import Equations
from stridemap.solver.walks.events import SAMPLES, Watch, fallen
from stridemap.solver.walks.outcomes import Outcome
from tests.oracles.rewritten import light_model
from tests.oracles.walkers import walker


class Clockwork:
    """Its state is the time; the touchdown condition is a polynomial, and the foot is ahead at all times."""

    class model:
        stance_index = None

    autonomous = False

    def __init__(self, *zeros, sign=1):
        self.condition = sign * Polynomial.fromroots(zeros)
        self.rate = self.condition.deriv()

    def touchdown(self, y):
        return self.condition(y[0]), self.rate(y[0]), -1.0

    def in_double_support(self, y):
        return self.condition(y[0]) == 0.0

    def centre_of_mass(self, y):
        return [0.0, 1.0], [1.0, 0.0]

    def watch(self):
        return Watch(self, 0.0, np.zeros(1), True)


class Time(DenseOutput):
    """One step of an integrator, from 0 to 1, of a state that is the time."""

    def _call_impl(self, t):
        return np.atleast_1d(t)[None, :] if np.ndim(t) else np.array([t])


def event(walker):
    return walker.watch().event(Time(0.0, 1.0))


@pytest.mark.quick
def test_a_touchdown_between_two_samples_is_seen():
    """The foot is on the ground from 0.30 to 0.32, and samples are 0.125 apart."""
    assert 0.02 < 1 / SAMPLES
    outcome, t = event(Clockwork(0.30, 0.32, sign=-1))
    assert outcome is Outcome.WALKED
    assert t == pytest.approx(0.30, abs=1e-12)


@pytest.mark.quick
def test_a_foot_that_leaves_the_ground_does_not_touch_down():
    outcome, t = event(Clockwork(0.1, 0.7))
    assert outcome is Outcome.WALKED
    assert t == pytest.approx(0.7, abs=1e-12)
    # It lifts and comes down again between two samples.
    outcome, t = event(Clockwork(0.30, 0.32))
    assert outcome is Outcome.WALKED
    assert t == pytest.approx(0.32, abs=1e-12)
    assert event(Clockwork(0.4)) == (Outcome.WALKED, pytest.approx(0.4, abs=1e-12))
    assert event(Clockwork(0.4, sign=-1)) == (None, 1.0)


@pytest.mark.quick
def test_a_step_without_a_zero_has_no_event():
    assert event(Clockwork(1.5)) == (None, 1.0)
    assert event(Clockwork(1.5, sign=-1)) == (None, 1.0)


@pytest.mark.quick
@pytest.mark.parametrize("angle", [1.5, -1.5, 1.6, -1.6])
def test_a_leg_beyond_the_horizontal_has_fallen(angle):
    from stridemap.solver.model.loading import load

    model = load("compass")
    found = fallen(Equations(model, model.point({})), np.array([angle, 0.0, 0.0, 0.0]))
    # A leg that leans back has its hip behind.
    ways = {1.6: Outcome.FALLS_BACKWARD, -1.6: Outcome.FALLS_FORWARD}
    assert found is ways.get(angle)


def test_a_clock_that_is_not_reset_comes_round():
    """Whatever the phase before a touchdown, it is within one turn after it."""
    model = light_model(walker("locked"))
    equations = Equations(model, model.point({}))
    phase = model.coordinates.index("phase")
    y = np.zeros(2 * equations.n)
    y[: equations.n], y[phase] = [-0.1, -0.2, 0.0][: equations.n], 13.5
    z = equations.land(y)
    assert z[model.section.index("phase")] == pytest.approx(13.5 - 4 * np.pi, abs=1e-13)
