"""The small models, derived and printed afresh: the files are those that are committed."""

import filecmp

import pytest

from stridemap.codegen import write_model
from stridemap.derive.models import WALKERS
from stridemap.solver.model.files import GENERATED


@pytest.mark.parametrize(
    "name",
    [
        pytest.param("rimless_wheel", marks=pytest.mark.quick),
        "simplest_walker",
        pytest.param("compass", marks=pytest.mark.quick),
    ],
)
def test_derivation_and_kernels_are_what_is_committed(name, tmp_path):
    written = write_model(WALKERS[name], tmp_path)
    names = [path.name for path in written]
    assert {f"{name}.c", f"{name}.h", f"{name}.py", f"{name}_kernels.c", "manifest.json"} <= set(names)
    same, other, missing = filecmp.cmpfiles(tmp_path, GENERATED / name, names, shallow=False)
    assert (other, missing) == ([], [])
    assert len(same) == len(names)
