"""Quantities that a model file declares: measured and shown like the others, or refused."""

import numpy as np
import pytest

import stridemap
from stridemap.derive import Measured
from stridemap.derive.models.simplest_walker import PHI, THETA
from stridemap.derive.models.simplest_walker import WALKER as SIMPLEST
from stridemap.errors import InputError
from stridemap.sweeps.tables import orbit_schema
from stridemap.views.report.payload import payload
from tests.oracles.remembered import remembered

theta, phi = THETA.symbol, PHI.symbol

OWN = (
    Measured("spread", phi, "amplitude", "spread", "Largest angle between the legs either way.", "angle"),
    Measured("leaning", theta, "minimum", "leaning", "Least angle of the stance leg.", "angle"),
    Measured("product", theta * phi, "maximum", "product", "Largest product of both angles."),
    Measured("last_rate", PHI.rate, "final", "last rate", "Rate just before touchdown.", "angular frequency"),
)


@pytest.fixture(scope="module")
def model():
    with remembered():
        return stridemap.derive_model(SIMPLEST.with_(name="own_quantities", quantities=OWN))


def found(model):
    """Its cycles, without a C compiler, which takes longer than the virtual machine for so few."""
    return stridemap.find_orbits(model, backend="interpreter", options={"starts": 128})


@pytest.fixture(scope="module")
def orbits(model):
    return found(model)


def test_they_are_what_a_dense_motion_shows(orbits):
    assert len(orbits) == 2
    for orbit in orbits:
        motion = orbit.motion(20001)
        angle, between = motion.coordinate(THETA.name), motion.coordinate(PHI.name)
        assert orbit.spread == pytest.approx(np.abs(between).max(), abs=1e-7)
        assert orbit.leaning == pytest.approx(angle.min(), abs=1e-7)
        assert orbit.product == pytest.approx((angle * between).max(), abs=1e-7)
        assert orbit.last_rate == pytest.approx(motion.coordinate(f"d{PHI.name}")[-1], abs=1e-9)


def test_nothing_else_changes(orbits):
    plain = found("simplest_walker")
    own = {one.name for one in OWN}
    for one, other in zip(orbits, plain, strict=True):
        shared = {name: value for name, value in one.to_dict().items() if name not in own}
        assert list(one.to_dict())[-len(OWN) :] == [quantity.name for quantity in OWN]
        assert repr(shared) == repr(other.to_dict())  # to the last bit, NaN included


def test_they_are_columns_of_tables_and_of_the_report(model, orbits):
    names = [one.name for one in OWN]
    assert orbit_schema(model).names[-len(OWN) :] == names
    frame = orbits.to_frame()
    back = stridemap.Orbits.from_columns(model, {name: frame[name] for name in frame})
    np.testing.assert_array_equal(back.spread, orbits.spread)
    frame.insert(0, "cell", 0)
    configuration = {"grid": {"slope": [0.009]}, "params": {}}
    cells = frame[["status"]].assign(reason=None)
    shown = {one["name"]: one for one in payload(model, configuration, frame, cells)["measures"]}
    assert [shown[name]["label"] for name in names] == [one.label for one in OWN]
    assert shown["last_rate"]["unit"] == "√(g/L)"


def test_units_convert_them(model, orbits):
    robot = stridemap.Units(leg_length=2.0, mass=10.0, gravity=8.0)
    assert robot.measures(orbits[0])["last_rate"] == pytest.approx(2.0 * orbits[0].last_rate)


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"reduction": "mean"}, "the reduction of the quantity spread is 'mean'; it must be one of maximum,"),
        ({"kind": "sadness"}, "the kind of the quantity spread is 'sadness'; it must be one of number,"),
        ({"name": "cot"}, "the quantity cot has the name of a column"),
        ({"name": "two words"}, "the quantity 'two words' cannot be a name in generated code"),
        ({"expression": "phi"}, "the expression of the quantity spread is 'phi'"),
    ],
)
def test_what_makes_no_sense_is_refused(changes, said):
    words = {"name": "spread", "expression": phi, "reduction": "maximum", "label": "l", "definition": "d."}
    with pytest.raises(InputError) as error:
        SIMPLEST.with_(quantities=(Measured(**{**words, **changes}),))
    assert said in str(error.value)
    assert "\n" not in str(error.value)
