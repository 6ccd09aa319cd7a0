"""Walks that begin within a step."""

import math

import numpy as np
import pytest

import stridemap
from stridemap.errors import InputError
from stridemap.solver.model.loading import load
from stridemap.solver.walks.equations import Equations
from stridemap.solver.walks.swing import swing
from tests.oracles.reference import REFERENCE, reference_name, section_point


def within(model, y, t):
    names = [*model.coordinates, *(f"d{name}" for name in model.coordinates)]
    return {"t": t, **dict(zip(names, y.tolist(), strict=True))}


@pytest.mark.parametrize("entry", REFERENCE, ids=reference_name)
@pytest.mark.parametrize("share", [0.05, 0.97])
def test_from_a_point_of_a_step_the_walk_is_the_same(entry, share):
    """The clock goes on too: the hip of these models is driven by one."""
    model = load(entry["model"])
    phase = swing(model, model.point(entry["params"]), section_point(entry))
    t = share * phase.duration
    walk = stridemap.simulate(model, start=within(model, phase(t), t), steps=2, params=entry["params"])
    for step in walk.steps:
        assert step.period == pytest.approx(entry["period"], abs=1e-9)
        assert dict(step.state) == pytest.approx(entry["state"], abs=1e-9)
    assert walk.start["t"] == t
    series = walk.trajectory(0.01)
    assert (series.time[0], series.step_time[0]) == (0.0, t)
    assert series.time[series.event == "before_impact"][0] == pytest.approx(entry["period"] - t, abs=1e-9)
    assert np.allclose(series.q[0], phase(t)[: len(model.coordinates)], rtol=0, atol=0)


def test_published_examples_start_at_mid_stance():
    """Both legs upright, rates 0.4 and -2 per second; feet at one height are above the ground."""
    start = {"theta1": 0.0, "theta2": 0.0, "dtheta1": -0.1277, "dtheta2": 0.5108}
    walk = stridemap.simulate("goswami_compass", start=start, slope=0.0525)
    assert walk.outcome is stridemap.Outcome.FALLS_FORWARD
    mirrored = {**start, "dtheta2": -0.8}  # the swing leg goes ahead
    assert stridemap.simulate("goswami_compass", start=mirrored, slope=0.0525).outcome.words != "failed"


GOOD = {"theta1": 0.0, "theta2": -0.3, "dtheta1": -0.3, "dtheta2": -0.5}


@pytest.mark.quick
@pytest.mark.parametrize(
    ("changes", "sentence"),
    [
        ({"theta1": 0.2, "theta2": 0.1}, "its swing foot is 0.0149376 L below the ground"),
        ({"theta1": -0.2, "theta2": -0.2}, "its swing foot is 0.0199334 L below the ground"),
        ({"theta1": 1.6}, "theta1 = 1.6 of the start is not allowed: the stance leg is beyond"),
        ({"theta1": math.nan}, "theta1 = nan of the start is not a finite number"),
        ({"theta1": "0.1"}, "theta1 = '0.1' of the start is not a finite number"),
        ({"theta1": True}, "theta1 = True of the start is not a finite number"),
        ({"t": -1.0}, "t = -1 of the start is not allowed"),
        ({"t": math.inf}, "t = inf of the start is not a finite number"),
        ({"x": 0.0}, "needs theta1, theta2, dtheta1, dtheta2, and may say t.*unknown: x"),
    ],
)
def test_starts_are_checked(changes, sentence):
    with pytest.raises(InputError, match=sentence):
        stridemap.simulate("goswami_compass", start={**GOOD, **changes})


def test_what_is_missing_is_named():
    with pytest.raises(InputError, match="missing: dtheta1, dtheta2"):
        stridemap.simulate("goswami_compass", start={"theta1": 0.0, "theta2": -0.3})
    with pytest.raises(InputError, match="two ways to say where a walk begins"):
        stridemap.simulate("goswami_compass", {"theta1": 0.2, "dtheta1": 0, "dtheta2": 0}, start=GOOD)
    for wrong in ([1, 2], 3):
        with pytest.raises(InputError, match="is not a mapping"):
            stridemap.simulate("goswami_compass", start=wrong)


def test_on_a_wheel_the_next_spoke_is_the_swing_foot():
    walk = stridemap.simulate("rimless_wheel", start={"theta": 0.3, "dtheta": 0.4}, steps=1)
    assert walk.outcome is stridemap.Outcome.WALKED
    with pytest.raises(InputError, match="below the ground"):
        stridemap.simulate("rimless_wheel", start={"theta": 0.6, "dtheta": 0.4}, steps=1)


@pytest.mark.parametrize(("name", "height"), [("compass", 0.0), ("rimless_wheel", 0.0), ("round_feet", 0.2)])
def test_the_ground_is_where_the_feet_come_down(name, height):
    model = load(name)
    assert Equations(model, model.point({})).ground == pytest.approx(height, abs=1e-12)
