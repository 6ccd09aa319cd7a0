"""The small models, derived and printed afresh: the files are those that are committed.

The large ones are in `test_stability`.
"""

import filecmp

import pytest

from stridemap.codegen import write_model
from stridemap.derive.models import WALKERS
from stridemap.solver.model.files import GENERATED

SMALL = ("rimless_wheel", "simplest_walker", "compass")
QUICK = ("rimless_wheel", "compass")


@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=pytest.mark.quick if name in QUICK else ()) for name in SMALL]
)
def test_derivation_and_kernels_are_what_is_committed(name, tmp_path):
    written = write_model(WALKERS[name], tmp_path)
    names = [path.name for path in written]
    assert {f"{name}.c", f"{name}.h", f"{name}.py", f"{name}_kernels.c", "manifest.json"} <= set(names)
    same, other, missing = filecmp.cmpfiles(tmp_path, GENERATED / name, names, shallow=False)
    assert (other, missing) == ([], [])
    assert len(same) == len(names)
