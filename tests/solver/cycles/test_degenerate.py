"""Why there is no limit cycle, where the equations say so."""

import json

import numpy as np
import pandas as pd
import pytest

import stridemap
from stridemap.solver.cycles.degenerate import have_no_cycle, why_no_cycle
from stridemap.solver.model.loading import available, load
from stridemap.sweeps.config import parse_config
from stridemap.sweeps.run import sweep
from tests.oracles.sweeping import Inline

pytestmark = pytest.mark.quick


@pytest.mark.parametrize("name", available())
def test_at_the_preset_there_is_nothing_to_say(name):
    model = load(name)
    assert why_no_cycle(model, model.point({})) is None


@pytest.mark.parametrize(
    ("name", "params", "begin"),
    [
        ("wobbling", {"k": 0}, "with k = 0 nothing holds x: "),
        ("wobbling", {"k": 0, "Kd": 0}, "with k = 0 nothing holds x: "),
        ("wobbling", {"k": 1e-6}, None),
        ("wobbling", {"Kp": 0, "Kd": 0}, None),
        ("wobbling", {"Kp": 1e15}, None),
        ("wobbling", {"omega": 1e300}, None),
        ("goswami_compass", {"beta": 0}, "with beta = 0 the mass matrix is singular: "),
        ("goswami_compass", {"mu": 0}, None),
        ("round_feet", {"hip_mass": 0, "inertia": 0, "radius": 0}, None),
        ("simplest_walker", {"slope": 0}, None),
    ],
)
def test_what_vanishes_at_an_end_of_a_range_is_named(name, params, begin):
    model = load(name)
    said = why_no_cycle(model, model.point(params))
    assert said is None if begin is None else said.startswith(begin)


@pytest.mark.parametrize("name", ["wobbling", "goswami_compass", "rimless_wheel"])
def test_many_points_at_once_are_judged_as_each_by_itself(name):
    """At random points, some of whose parameters are at an end of their range."""
    model, rng = load(name), np.random.default_rng(3)
    points = model.point({}) * rng.uniform(0.5, 1.5, (60, len(model.parameters)))
    ends = np.array([p.default if p.lower is None else p.lower for p in model.parameters])
    points = np.where(rng.uniform(size=points.shape) < 0.3, ends, points)
    each = [why_no_cycle(model, point) is not None for point in points]
    assert have_no_cycle(model, points).tolist() == each
    if name != "rimless_wheel":
        assert 5 < sum(each) < 55


def test_a_free_mass_can_be_shifted_in_a_walk_and_a_held_one_cannot():
    """By the event-driven integrator, which knows nothing of why."""
    options = stridemap.SearchOptions(starts=64)
    state = stridemap.find_orbits("wobbling", k=0.5, options=options)[0].state
    for k, same in ((0.0, True), (0.5, False)):
        one, other = (
            stridemap.simulate("wobbling", {**state, "x": state["x"] + shift}, steps=1, k=k).steps[0]
            for shift in (0.0, 0.1)
        )
        assert (abs(one.period - other.period) < 1e-10) == same
        assert (abs(other.state["x"] - one.state["x"] - 0.1) < 1e-10) == same


def test_the_command_says_why(run):
    status, out, err = run("orbit", "--k", "0")
    assert (status, out) == (1, "")
    assert err.startswith("no limit cycle found\n")
    assert "warning: with k = 0 nothing holds x: " in err
    assert "a free mass has no gait" in err
    status, out, _ = run("orbit", "--k", "0", "--json")
    assert status == 1
    (warning,) = json.loads(out)["search"]["warnings"]
    assert "a free mass has no gait" in warning
    with pytest.raises(stridemap.InputError, match="give a state .*a free mass has no gait"):
        stridemap.simulate("wobbling", k=0)


def test_the_cells_of_a_sweep_say_why(tmp_path):
    config = {"model": "wobbling", "grid": {"k": [0.0, 6.0]}, "search": {"starts": 32, "subgrid": 1}}
    sweep(parse_config(config), tmp_path, executor=Inline())
    cells = stridemap.read_cells(tmp_path)
    assert cells["status"].tolist() == ["empty", "found"]
    assert "nothing holds x" in cells["reason"][0]
    assert pd.isna(cells["reason"][1])
    assert np.isin(stridemap.read_orbits(tmp_path)["k"], [6.0]).all()
