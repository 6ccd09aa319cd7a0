"""The event-driven simulator: touchdowns, falls and what it keeps of a walk."""

import dataclasses
import math
import pickle

import numpy as np
import pytest

from stridemap.errors import InputError
from stridemap.solver.model.loading import load
from stridemap.solver.walks.outcomes import Outcome
from stridemap.solver.walks.simulator import walk
from stridemap.solver.walks.swing import swing
from tests.oracles.reference import LIFTING, REFERENCE, reference_name, section_point


def reference(index):
    entry = REFERENCE[index]
    model = load(entry["model"])
    return model, model.point(entry["params"]), section_point(entry), entry["period"]


@pytest.mark.quick
@pytest.mark.parametrize("entry", REFERENCE, ids=reference_name)
def test_reference_orbit_closes(entry):
    model, p = load(entry["model"]), load(entry["model"]).point(entry["params"])
    walked = walk(model, p, section_point(entry), 2)
    assert walked.outcome is Outcome.WALKED
    assert (walked.model, dict(walked.params)) == (entry["model"], entry["params"])
    for step in walked.steps:
        assert step.period == pytest.approx(entry["period"], abs=1e-12)
        np.testing.assert_allclose(section_point(step), section_point(entry), rtol=0, atol=1e-12)
        assert list(step.state) == list(model.section)
        assert step.step_length == pytest.approx(2 * math.sin(entry["state"]["theta1"]), abs=1e-12)
        assert step.contact


@pytest.mark.quick
def test_touchdown_is_located_to_rounding():
    model, p, z, _ = reference(1)
    phase = swing(model, p, 1.02 * z)
    condition = model.evaluate("touchdown_condition", q=phase.end[:3], v=phase.end[3:])
    assert abs(condition["h"]) < 1e-15
    assert condition["dh"] > 0
    assert condition["side"] < 0
    # The state is integrated up to it; the dense output is a little less accurate.
    np.testing.assert_allclose(phase(phase.duration), phase.end, rtol=0, atol=1e-10)
    np.testing.assert_allclose(phase(0.0)[:3], [1.02 * z[0], 2.04 * z[0], 1.02 * z[3]], rtol=0, atol=0)


@pytest.mark.quick
def test_a_coarse_integrator_comes_down_on_the_ground_all_the_same():
    """Its dense output is off by much more than rounding; the time of the touchdown is corrected for that."""
    model, p, z, _ = reference(1)
    phase = swing(model, p, z, rtol=1e-5, atol=1e-7)
    here, off = (
        model.evaluate("touchdown_condition", q=y[:3], v=y[3:])["h"]
        for y in (phase.end, phase(phase.begin + phase.duration))
    )
    assert abs(here) < 1e-14
    assert abs(off) > 1e-11


def test_scuff_does_not_end_the_step():
    """The foot passes below the ground near mid-stance, long before it comes up and lands."""
    model, p, z, period = reference(1)
    phase = swing(model, p, z)
    t = np.linspace(0, phase.duration, 2001)
    y = phase(t)
    h = model.evaluate("touchdown_condition", q=y[:, :3], v=y[:, 3:])["h"]
    assert h[0] == 0
    falls = t[1:][(h[1:] < 0) & (h[:-1] >= 0)]
    assert len(falls) == 1
    assert 0.3 * period < falls[0] < 0.9 * period
    assert t[-1] == pytest.approx(period, abs=1e-12)


def test_tolerance_is_kept():
    model, p, z, period = reference(3)
    errors = [abs(swing(model, p, z, rtol=r, atol=r / 100).duration - period) for r in (1e-6, 1e-9, 1e-12)]
    assert errors[2] < 1e-12 < errors[1] < 1e-7 < errors[0] + 1e-7
    assert errors[1] < errors[0] < 1e-4


def test_stable_cycle_attracts_and_unstable_one_does_not():
    model, p, stable, _ = reference(6)
    assert np.abs(section_point(walk(model, p, 1.01 * stable, 40).steps[-1]) - stable).max() < 1e-4
    model, p, unstable, _ = reference(4)
    start = unstable * (1 + 1e-6)
    end = section_point(walk(model, p, start, 20).steps[-1])
    assert np.abs(end - unstable).max() > 20 * np.abs(start - unstable).max()


def test_walk_is_its_steps_one_by_one():
    model, p, z, _ = reference(1)
    walked = walk(model, p, 1.01 * z, 3)
    state = 1.01 * z
    for step in walked.steps:
        (alone,) = walk(model, p, state, 1).steps
        assert alone == step
        state = section_point(alone)


def test_completed_steps_are_kept_when_the_walker_goes_no_further():
    """Beside an unstable cycle the steps grow longer and shorter until the energy of one does not suffice."""
    model, p, unstable, _ = reference(4)
    walked = walk(model, p, 1.06 * unstable, 100)
    assert walked.outcome is Outcome.ROCKS_BACK
    assert 3 < len(walked.steps) < 100


def test_time_limit_ends_a_swing_phase():
    model, p, z, period = reference(1)
    phase = swing(model, p, z, time_limit=0.5 * period)
    assert phase.outcome is Outcome.NO_TOUCHDOWN
    assert phase.duration == 0.5 * period
    np.testing.assert_allclose(phase.end, swing(model, p, z)(0.5 * period), rtol=0, atol=1e-10)


def test_lost_contact_is_reported_and_the_walk_goes_on():
    """A cycle whose ground force is negative for a while: the formulas hold, the foot would lift."""
    model = load("wobbling")
    p = model.point(LIFTING)
    z = np.array([0.02300591213819, -1.4194402302642, -0.00150227485472, 0.0774067689146, -7.4529883499897])
    walked = walk(model, p, z, 1)
    assert walked.outcome is Outcome.WALKED
    assert not walked.steps[0].contact
    assert walked.steps[0].min_vertical_force == pytest.approx(-0.87515, abs=1e-3)


@pytest.mark.parametrize(
    "state", [[0.1, 0.0], [[0.1] * 5], [0.1, np.nan, 0.0, 0.0, 0.0], [0.1, np.inf, 0.0, 0.0, 0.0]]
)
def test_state_is_checked(state):
    model = load("wobbling")
    with pytest.raises(InputError, match="takes 5 finite numbers"):
        walk(model, model.point({}), np.array(state), 1)


def test_number_of_steps_is_checked():
    model, p, z, _ = reference(1)
    with pytest.raises(InputError, match="at least 1 step"):
        walk(model, p, z, 0)


def test_walk_is_a_value():
    model, p, z, _ = reference(1)
    walked = walk(model, p, z, 2)
    assert pickle.loads(pickle.dumps(walked)) == walked
    with pytest.raises(dataclasses.FrozenInstanceError):
        walked.outcome = Outcome.STOPS
    with pytest.raises(TypeError):
        walked.steps[0].state["theta1"] = 0.0
