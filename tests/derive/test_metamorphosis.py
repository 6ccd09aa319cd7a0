"""The same walker in other coordinates has the same table: absolute, relative, shifted, turned and reordered.

Each column is compared but for those of the state, which are carried back to the old coordinates. What does
not agree depends on how a machine is written down, and is no property of it.
"""

import numpy as np
import pytest

import stridemap
from stridemap.codegen import declared
from stridemap.derive.models import WALKERS
from tests.oracles import walkers
from tests.oracles.rewritten import Change, carried_over, light_model, rewritten, states

pytestmark = pytest.mark.usefixtures("in_this_process")

TOLERANCE = 1e-10

ABSOLUTE = Change(("stance", "swing"), ((1, 0), (1, -1)), (0.0, 0.0))
"""Both legs from the vertical, in place of the swing leg from the stance leg."""
TURNED = Change(("swing", "stance"), ((0, -1), (1, -1)), (0.0, 0.25))
"""Both legs from the vertical, leaning ahead, the swing leg first and from another zero."""
RELABELLED = Change(("from_swing", "stance"), ((0, 1), (-1, 0)), (0.0, -0.5))
"""The angle between the legs counted from the swing leg, and the other order."""
FLIPPED = Change(("back",), ((-1,),), (0.0,))
SHIFTED = Change(("spoke",), ((1,),), (0.5,))
MIXED = Change(("body", "stance", "swing"), ((0, 1, 0), (0, 1, -1), (-1, 0, 0)), (0.0, 0.125, 0.0))
"""The body the other way and first, both legs from the vertical, the swing leg from another zero."""
CLOCKED = Change(("stance", "swing", "phase"), ((1, 0, 0), (1, -1, 0), (0, 0, 1)), (0.0, 0.0, 0.0))

BUILT_IN = [
    ("compass", RELABELLED),
    pytest.param("rimless_wheel", FLIPPED, marks=pytest.mark.quick),
    pytest.param("rimless_wheel", SHIFTED, marks=pytest.mark.quick),
    ("simplest_walker", ABSOLUTE),
    ("goswami_compass", TURNED),
    ("wobbling", MIXED),
]


def same(orbits, walker, change):
    """Compare the tables of cycles and of what they become in other coordinates."""
    model = light_model(rewritten(walker, change, "rewritten"))
    found = carried_over(orbits, change, model)
    assert len(orbits)
    assert orbits.found.all()
    assert list(found.status) == list(orbits.status)
    np.testing.assert_allclose(states(found, change), states(orbits), rtol=0, atol=TOLERANCE)
    old, new = orbits.to_frame(), found.to_frame()
    theirs, mine = set(orbits.model.section), set(model.section)
    assert [c for c in new if c not in mine] == [c for c in old if c not in theirs]
    for column in old:
        if column in theirs:
            continue
        if old[column].dtype == float:
            np.testing.assert_allclose(new[column], old[column], rtol=0, atol=TOLERANCE, err_msg=column)
        else:
            assert list(new[column].astype(str)) == list(old[column].astype(str)), column


@pytest.mark.parametrize(("name", "change"), BUILT_IN)
def test_built_in_walkers(name, change):
    same(stridemap.find_orbits(name), WALKERS[name], change)


@pytest.mark.parametrize(
    ("name", "change"),
    [("swinging_torso", MIXED), ("rolling_feet", ABSOLUTE), ("vertical_wobbling", MIXED)],
)
def test_example_files(name, change):
    path = walkers.example(name)
    same(stridemap.find_orbits(path, backend="interpreter", options={"starts": 128}), declared(path), change)


@pytest.mark.parametrize(
    ("name", "params", "change"),
    [("two_motors", {"k": 7.0}, MIXED), ("locked", {}, CLOCKED)],  # at its preset the first has no gait
)
def test_several_motors_and_a_clock_that_is_not_reset(name, params, change):
    orbits = stridemap.find_orbits(
        walkers.derived(name), params, backend="interpreter", options={"starts": 128}
    )
    same(orbits, walkers.walker(name), change)
