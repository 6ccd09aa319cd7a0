"""Values that a report compares with, and its units: what is refused, and what is taken from other cycles."""

from dataclasses import replace

import pandas as pd
import pytest

from stridemap.errors import InputError
from stridemap.solver.model.loading import load
from stridemap.units import Units
from stridemap.views.notation import printed
from stridemap.views.report.references import Reference, checked, references_of
from stridemap.views.report.si import si_names, si_powers

MODEL = load("wobbling")
CONFIGURATION = {
    "grid": {"k": [6.0], "omega": [2.0, 3.0]},
    "params": {name: value for name, value in MODEL.preset.items() if name not in ("k", "omega")},
}
ORBITS = pd.DataFrame({"cot": [0.3], "stable": [True]})


def taken(*references):
    return checked(MODEL, CONFIGURATION, ORBITS, references)


def test_references_of_the_sweep_are_kept_and_others_left_out():
    here, everywhere = Reference("cot", 0.3, "robot", {"omega": 3.0}), Reference("cot", 0.3, "robot")
    elsewhere = Reference("cot", 0.3, "robot", {"beta": 3.0})
    assert taken(here, everywhere, elsewhere, Reference("speed", 1.0, "robot")) == [here, everywhere]


@pytest.mark.parametrize(
    ("reference", "said"),
    [
        (Reference("cot", 0.3, "two words"), "is not a word; give letters, digits and _ only"),
        (Reference("cot", 0.3, "<b>"), "is not a word"),
        (Reference("cot", 0.3, "cot"), "is the name of a column, of a parameter or of an operation"),
        (Reference("cot", 0.3, "omega"), "is the name of a column"),
        (Reference("cot", 0.3, "and"), "is the name of a column"),
        (Reference("cot", float("nan"), "robot"), "the reference robot of cot is not a finite number"),
        (Reference("cot", 0.3, "robot", {"omega": float("inf")}), "is not a finite number"),
        (Reference("cot", 0.3, "robot", {"mu": 3.0}), "is given at mu, which wobbling does not have"),
    ],
)
def test_what_is_no_reference_is_refused_in_one_sentence(reference, said):
    with pytest.raises(InputError) as refused:
        taken(reference)
    assert said in str(refused.value)


def test_of_several_cycles_the_most_stable_one_is_compared_with():
    orbits = pd.DataFrame(
        {
            "omega": [2.0, 2.0, 3.0, 3.0, 4.0],
            "stable": [True, True, False, True, False],
            "spectral_radius": [0.9, 0.5, 1.2, 0.7, 1.1],
            "cot": [0.1, 0.2, 0.3, 0.4, 0.5],
            "d_max": [0.1, float("nan"), 0.3, 0.4, 0.5],
            "residual": [0.0] * 5,
        }
    )
    found = {
        (one.quantity, one.parameters["omega"]): one.value
        for one in references_of(orbits, "compass", ["omega"])
    }
    assert found == {
        ("spectral_radius", 2.0): 0.5, ("cot", 2.0): 0.2, ("spectral_radius", 3.0): 0.7, ("cot", 3.0): 0.4,
        ("d_max", 3.0): 0.4,
    }  # fmt: skip


@pytest.mark.parametrize("name", ["wobbling", "compass", "goswami_compass"])
def test_units_are_those_of_the_units_helper(name):
    """Of every parameter, coordinate and rate, for a robot of another size."""
    spec, robot = load(name).spec, Units(leg_length=0.7, mass=31.0, gravity=3.7)
    powers, names = si_powers(spec), si_names(spec)
    units = [p.unit for p in spec.parameters]
    units += [unit for c in spec.coordinates for unit in (c.unit, c.rate_unit)]
    for unit in set(units) - {"1"}:
        mass, length, gravity = powers[printed(unit)]
        size = 31.0 ** (mass / 2) * 0.7 ** (length / 2) * 3.7 ** (gravity / 2)
        assert size == pytest.approx(robot.unit(unit), rel=1e-14)
    assert names["√(L/g)"] == "s"
    assert names["rad √(g/L)"] == "rad/s"
    if name == "wobbling":
        assert names["L √(g/L)"] == "m/s"


def test_of_models_in_units_of_their_own_nothing_is_known():
    spec = load("wobbling").spec
    other = replace(spec, units=replace(spec.units, mass="kg", length="m", time="s", energy="J"))
    assert si_powers(other) == {}
    assert si_names(other) == {}
