"""One limit cycle as a value: it cannot be changed, and goes into JSON and pickles."""

import copy
import dataclasses
import json
import math
import pickle

import pytest

from stridemap.errors import InputError
from stridemap.quantities import MEASURED, QUANTITIES
from stridemap.solver.api.points import find_orbits
from stridemap.solver.cycles.orbit import Orbit
from stridemap.solver.cycles.status import Status
from stridemap.solver.model.loading import load
from tests.oracles.reference import GUESSES, TWO_CYCLES, continue_one

pytestmark = pytest.mark.quick


def test_orbit_cannot_be_changed():
    orbit = find_orbits("wobbling", TWO_CYCLES)[0]
    with pytest.raises(dataclasses.FrozenInstanceError):
        orbit.period = 1.0
    with pytest.raises(TypeError):
        orbit.state["theta1"] = 1.0
    for change in (
        lambda d: d.update(k=1.0), lambda d: d.pop("k"), lambda d: d.clear(), lambda d: d.__ior__({"k": 1.0}),
        lambda d: d.setdefault("new", 1.0), lambda d: d.__delitem__("k"), lambda d: d.popitem(),
    ):  # fmt: skip
        with pytest.raises(TypeError, match="cannot be changed"):
            change(orbit.params)
    with pytest.raises(TypeError, match="cannot be changed"):
        orbit.measures["cot"] = 1.0


def test_orbit_as_plain_dicts():
    orbit = find_orbits("wobbling", TWO_CYCLES)[0]
    fields = {field.name: getattr(orbit, field.name) for field in dataclasses.fields(orbit)}
    again = Orbit(
        **{name: dict(value) if isinstance(value, dict) else value for name, value in fields.items()}
    )
    assert again == orbit
    assert dataclasses.replace(orbit, measures={**orbit.measures, "stable": True}).state == orbit.state
    assert copy.deepcopy(orbit) == orbit
    assert copy.deepcopy(orbit).model is orbit.model
    assert json.loads(json.dumps(orbit.state)) == orbit.state


def test_every_measured_quantity_is_an_attribute():
    orbit = find_orbits("wobbling", TWO_CYCLES)[0]
    assert list(orbit.measures) == list(MEASURED)
    for name, quantity in QUANTITIES.items():
        value = getattr(orbit, name)
        assert isinstance(value, {"float": float, "int": int, "bool": bool, "str": str}[quantity.type]), name
        assert name in dir(orbit)
    with pytest.raises(AttributeError, match="an Orbit has no attribute 'speeed'; measured are .*speed"):
        orbit.speeed  # noqa: B018
    assert not hasattr(orbit, "__array__")


def test_what_was_not_measured_is_nan_or_none():
    orbit = Orbit(load("compass"), {}, Status.NOT_CONVERGED)
    for name in MEASURED:
        value, quantity = orbit.measures[name], QUANTITIES[name]
        if quantity.optional:
            assert value is None, name
        else:
            assert value in (0, False, "") or math.isnan(value), name
    assert "not_converged" in repr(orbit)
    with pytest.raises(InputError, match="not a limit cycle .status not_converged.; choose"):
        orbit.motion()


def test_an_orbit_offers_its_motion_and_a_walk():
    orbit = find_orbits("wobbling", TWO_CYCLES)[1]
    assert orbit.motion(11).t[-1] == orbit.period
    walk = orbit.simulate(steps=2)
    assert [step.period for step in walk.steps] == pytest.approx([orbit.period] * 2, abs=1e-9)


def test_repr_says_what_it_is():
    first, second = find_orbits("wobbling", TWO_CYCLES)
    assert repr(first).startswith("<wobbling: limit cycle, group B, period 1.154")
    assert "unstable (largest multiplier" in repr(first)
    assert ", stable (largest" in repr(second)
    (compass,) = find_orbits("compass")
    assert "group" not in repr(compass)


@pytest.mark.parametrize("status", [Status.CONVERGED, Status.NOT_CONVERGED])
def test_orbit_pickles(status):
    _, _, orbit = continue_one(*GUESSES[status])
    again = pickle.loads(pickle.dumps(orbit))
    assert repr(again) == repr(orbit)  # NaN is not equal to itself
    assert again.status is status
    assert (again == orbit) == status.found


@pytest.mark.parametrize("status", GUESSES)
def test_orbit_is_json_without_nan(status):
    _, _, orbit = continue_one(*GUESSES[status])
    entry = json.loads(json.dumps(orbit.to_dict(), allow_nan=False))
    assert list(entry) == ["status", "state", "period", "period_n", "multipliers", *MEASURED]
    assert entry["status"] == status.value
    if status.found:
        assert entry["state"] == dict(orbit.state)
        assert [complex(*pair) for pair in entry["multipliers"]] == list(orbit.multipliers)
        assert None not in entry.values()
    else:
        assert entry["period"] is None
