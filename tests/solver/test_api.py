"""The solver's functions for one point: parameters given either way, words that are free, backends."""

import numpy as np
import pytest

import stridemap
from stridemap.errors import InputError
from stridemap.solver.options import AcceptanceOptions, SearchOptions
from tests.oracles.reference import TWO_CYCLES

pytestmark = pytest.mark.quick


def test_parameters_as_a_mapping_as_keywords_or_both():
    wanted = list(stridemap.find_orbits("wobbling", TWO_CYCLES))
    assert len(wanted) == 2
    for given in (
        {"params": TWO_CYCLES}, TWO_CYCLES, {"params": {"k": 6}, "alpha": 0.25, "omega": 3},
        {"params": {}, **TWO_CYCLES}, {"params": None, **TWO_CYCLES},
    ):  # fmt: skip
        assert list(stridemap.find_orbits("wobbling", **given)) == wanted
    assert list(stridemap.find_orbits("wobbling", wanted[0].params)) == wanted  # an orbit's own


@pytest.mark.parametrize("function", [stridemap.find_orbits, stridemap.simulate])
def test_what_is_given_twice_is_refused(function):
    with pytest.raises(InputError, match=r"^k, omega is given twice, in params and as a keyword"):
        function("wobbling", params={"k": 6, "omega": 3}, k=6, omega=3)
    for wrong in (6, "k=6", [("k", 6)]):
        with pytest.raises(InputError, match=r"is not a mapping; write params=\{'name': value\}"):
            function("wobbling", params=wrong)


def test_simulate_takes_parameters_either_way():
    orbit = stridemap.find_orbits("wobbling", TWO_CYCLES)[1]
    one = stridemap.simulate("wobbling", orbit.state, steps=2, params=TWO_CYCLES)
    assert stridemap.simulate("wobbling", orbit.state, steps=2, **TWO_CYCLES) == one
    assert orbit.simulate(2) == one


def test_options_and_acceptance_are_handed_on():
    few = stridemap.find_orbits("wobbling", TWO_CYCLES, options=SearchOptions(starts=1, max_starts=1))
    assert len(few) < 2
    strict = AcceptanceOptions(max_residual=1e-30)
    assert len(stridemap.find_orbits("wobbling", TWO_CYCLES, acceptance=strict)) == 0


def test_the_answer_is_orbits():
    orbits = stridemap.find_orbits("wobbling", TWO_CYCLES)
    assert isinstance(orbits, stridemap.Orbits)
    assert orbits.model is stridemap.load("wobbling")
    assert (np.diff(orbits.period) > 0).all()
    none = stridemap.find_orbits("wobbling", Kp=0, Kd=0)
    assert (len(none), list(none)) == (0, [])
    with pytest.raises(InputError, match="no limit cycle to start from at this point; give a state"):
        stridemap.simulate("wobbling", Kp=0, Kd=0)


def test_a_model_stands_for_its_name():
    model = stridemap.load("wobbling")
    assert list(stridemap.find_orbits(model, TWO_CYCLES)) == list(
        stridemap.find_orbits("wobbling", TWO_CYCLES)
    )
    orbit = stridemap.find_orbits(model, TWO_CYCLES)[0]
    assert stridemap.motion(orbit, 5).t.tolist() == orbit.motion(5).t.tolist()
