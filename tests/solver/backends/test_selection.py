"""Which backend runs: by name, as an argument, or what the machine has."""

import shutil
import warnings

import numpy as np
import pytest

import stridemap
from stridemap.errors import InputError
from stridemap.solver.backends.compiler import find_compiler
from stridemap.solver.backends.interpreter import Interpreter
from stridemap.solver.backends.lanes import Lanes
from stridemap.solver.backends.scalar import ScalarC
from stridemap.solver.backends.selection import BACKENDS, load_kernels, named_backend
from stridemap.solver.cycles.search import find_all
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.model.loading import load
from stridemap.solver.options import SearchOptions
from tests.oracles.kernels import needs_compiler, script


@pytest.mark.quick
def test_names():
    assert {name: named_backend(name) for name in BACKENDS} == {
        "lanes": Lanes(), "scalar": ScalarC(), "interpreter": Interpreter(),
    }  # fmt: skip
    assert named_backend(None) is None
    mine = Lanes(instructions=())
    assert named_backend(mine) is mine
    with pytest.raises(InputError, match="unknown backend 'gpu'; choose one of lanes, scalar, interpreter"):
        named_backend("gpu")
    with pytest.raises(InputError, match="unknown backend 'gpu'"):
        stridemap.find_orbits("compass", backend="gpu")


@needs_compiler
def test_lanes_are_what_runs_where_they_can():
    assert isinstance(load_kernels(load("wobbling"), None).backend, Lanes)
    assert "contract=off" in load_kernels(load("wobbling"), None).compiler


@needs_compiler
def test_compiler_without_cpp_gives_one_point_at_a_time(tmp_path, monkeypatch, own_cache):
    compiler = shutil.which(find_compiler())
    only_c = script(
        tmp_path / "onlyc", f'case "$*" in *c++*) echo "no C++ here" >&2; exit 1;; esac\nexec {compiler} "$@"'
    )
    monkeypatch.setenv("CC", only_c)
    assert isinstance(load_kernels(load("compass"), None).backend, ScalarC)


@needs_compiler
def test_backends_of_equal_arithmetic_find_the_same_orbits_to_the_last_bit():
    points = [{"k": 0.5}, {"k": 6.0}]
    for params in points:
        search = {"options": SearchOptions(starts=48, seed=1), "params": params}
        scalar, virtual = (
            stridemap.find_orbits("wobbling", backend=one, **search) for one in ("scalar", Interpreter())
        )
        assert len(scalar) >= 1
        for name, column in scalar.columns().items():
            np.testing.assert_array_equal(column, virtual.columns()[name])
        assert list(scalar) == list(virtual)
        lanes = stridemap.find_orbits("wobbling", backend=Lanes(), **search)
        np.testing.assert_allclose(lanes.u, scalar.u, rtol=0, atol=1e-11)


@pytest.mark.quick
@needs_compiler
def test_without_a_compiler_the_virtual_machine_runs_with_one_warning(no_compiler):
    model = load("compass")
    points, options = model.point({})[None], SearchOptions(starts=48, seed=1)
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        _, found = find_all(Solver.for_model(model), points, options)
        find_all(Solver.for_model(model), points, options)  # no second warning
    assert [w.category for w in caught] == [RuntimeWarning]
    assert "no C compiler found" in str(caught[0].message)
    assert load_kernels(model, None).backend == Interpreter()
    assert "virtual machine" in load_kernels(model, None).compiler
    _, asked_for = find_all(Solver.for_model(model, Interpreter()), points, options)
    assert list(found) == list(asked_for)
    assert len(found) >= 1
