"""What columns hold: units by hand, and complete for every table of every built-in model."""

import pytest

import stridemap
from stridemap.columns import columns_of, unit_value
from stridemap.quantities import KINDS
from stridemap.solver.model.loading import available
from stridemap.spec import UnitNames
from stridemap.sweeps.tables import cell_schema, orbit_schema
from tests.stridemap.test_units import SI_BASE


@pytest.mark.quick
@pytest.mark.parametrize("model", available())
def test_every_column_of_a_table_is_described(model):
    loaded = stridemap.load(model)
    known = columns_of(loaded.spec)
    names = {*orbit_schema(loaded).names, *cell_schema(loaded).names}
    assert names <= set(known)
    for name in names:
        one = known[name]
        assert one.label and one.name == name
        assert bool(one.unit) == bool(one.scale) == bool(one.si), name


@pytest.mark.parametrize("model", available())
def test_si_units_have_the_dimension_of_the_models_units(model):
    """With M = 2 kg, L = 4 m and g = 16 m/s^2 a unit of time is half a second."""
    bases = {**SI_BASE, "N m s": (1, 2, -1)}
    for one in columns_of(stridemap.load(model).spec).values():
        if one.scale:
            kilogram, metre, second = bases[one.si]
            value = unit_value(one.scale, {"M": 2.0, "L": 4.0, "g": 16.0, "rad": 1.0})
            assert value == 2.0**kilogram * 4.0**metre * 0.5**second, one


@pytest.mark.quick
def test_units_of_the_wobbling_walker():
    known = columns_of(stridemap.load("wobbling").spec)
    wanted = {
        "k": ("M g / L", "N/m"), "omega": ("sqrt(g/L)", "rad/s"), "beta": ("M", "kg"),
        "Kd": ("M g L sqrt(L/g)", "N m s"), "alpha": ("1", "1"), "theta1": ("rad", "rad"),
        "dtheta1": ("rad sqrt(g/L)", "rad/s"), "dx": ("L sqrt(g/L)", "m/s"), "period": ("sqrt(L/g)", "s"),
        "work": ("M g L", "J"), "peak_torque": ("M g L", "N m"), "cot": ("1", "1"), "group": ("", ""),
    }  # fmt: skip
    assert {name: (known[name].unit, known[name].si) for name in wanted} == wanted


@pytest.mark.quick
def test_models_in_other_units():
    from dataclasses import replace

    spec = stridemap.load("compass").spec
    si = columns_of(replace(spec, units=UnitNames("kg", "m", "s", "J")))
    assert (si["work"].unit, si["work"].si, si["speed"].unit) == ("J", "J", "m/s")
    strange = columns_of(replace(spec, units=UnitNames("g", "cm", "s", "erg")))
    assert (strange["speed"].unit, strange["speed"].scale) == ("cm s^-1", "")
    assert KINDS["speed"][0] == "sqrt(g L)"
