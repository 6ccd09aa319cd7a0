"""Kernels compiled and in the virtual machine, and every way in which compiling goes wrong."""

import os
import shutil
import stat
import warnings

import numpy as np
import pytest

from stridemap.errors import InputError
from stridemap.solver.backends.compiler import FLAGS, compile_shared, find_compiler
from stridemap.solver.backends.library import (
    CompiledKernels,
    InterpretedKernels,
    LockstepKernels,
    load_kernels,
)
from stridemap.solver.cycles import solver as limit_cycle
from stridemap.solver.cycles.search import SearchOptions, find_orbits
from stridemap.solver.kernels.catalogue import CYCLE_STEPS, SEARCH_STEPS
from stridemap.solver.model.loading import load
from stridemap.solver.model.model import Model

needs_compiler = pytest.mark.skipif(
    not any(map(shutil.which, ("cc", "gcc", "clang"))),
    reason="there is no C compiler to compile kernels with",
)
BARE = load_kernels.__wrapped__  # without its cache: every call loads anew


@pytest.fixture
def fresh_kernels():
    """Forget which kernels are loaded, before and after."""
    load_kernels.cache_clear()
    yield
    load_kernels.cache_clear()


@pytest.fixture
def own_cache(tmp_path, monkeypatch):
    """An empty cache of compiled kernels."""
    folder = tmp_path / "cache"
    monkeypatch.setenv("STRIDEMAP_CACHE", str(folder))
    return folder


def no_compiler(monkeypatch):
    monkeypatch.delenv("CC", raising=False)
    monkeypatch.setattr(shutil, "which", lambda *_args, **_kwargs: None)


def script(path, text):
    path.write_text(f"#!/bin/sh\n{text}\n")
    path.chmod(path.stat().st_mode | stat.S_IXUSR)
    return str(path)


def one_sentence(error):
    message = str(error.value)
    assert "\n" not in message
    return message


# -- the same numbers ------------------------------------------------------------------------------------


def assert_same_bits(compiled, interpreted):
    for a, b in zip(compiled, interpreted, strict=True):
        np.testing.assert_array_equal(np.isnan(a), np.isnan(b))
        numbers = ~np.isnan(a)
        np.testing.assert_array_equal(a[numbers].view(np.int64), b[numbers].view(np.int64))


@needs_compiler
@pytest.mark.parametrize("name", ["wobbling", "compass"])
@pytest.mark.parametrize("kernel", [f"search_{SEARCH_STEPS[0]}", f"limit_cycle_{CYCLE_STEPS[0]}", "trace_48"])
def test_virtual_machine_and_machine_code_agree_bit_for_bit(name, kernel):
    model = load(name)
    rng = np.random.default_rng(7)
    n, nz = 24, len(model.section)
    params = np.tile(model.point({}), (n, 1)) * rng.uniform(0.7, 1.3, (n, len(model.parameters)))
    u = np.hstack([rng.uniform(-0.2, 0.2, (n, nz)), rng.uniform(0.3, 3.0, (n, 1))])
    cycle = np.array([*(0.094, -0.146, -0.0026, 0.0029, 0.152)[:nz], 1.18])
    u[:8] = cycle * rng.uniform(0.98, 1.02, (8, nz + 1))
    u[20:] = [[np.nan] * (nz + 1), [np.inf] * (nz + 1), [0.0] * (nz + 1), [1e200] * (nz + 1)]
    compiled = CompiledKernels(model, find_compiler())(kernel, u, params)
    assert_same_bits(compiled, InterpretedKernels(model)(kernel, u, params))
    assert np.isfinite(compiled[0][:8]).all()
    assert np.isnan(compiled[-1][20]).all()


@needs_compiler
@pytest.mark.parametrize("name", ["wobbling", "compass"])
def test_part_of_a_step_agrees_bit_for_bit(name):
    model = load(name)
    rng = np.random.default_rng(8)
    n, size = 200, 2 * len(model.coordinates) + 1
    params = np.tile(model.point({}), (n, 1)) * rng.uniform(0.7, 1.3, (n, len(model.parameters)))
    w = rng.uniform(-0.3, 0.3, (n, size))
    w[0], w[1], w[2] = np.nan, np.inf, 1e160
    inputs = (rng.uniform(0, 2, (n, 1)), w, rng.uniform(0, 0.1, (n, 1)), params)
    compiled = CompiledKernels(model, find_compiler())("advance", *inputs)
    assert_same_bits(compiled, InterpretedKernels(model)("advance", *inputs))


def test_inputs_of_a_wrong_shape_are_refused():
    kernels = InterpretedKernels(load("compass"))
    with pytest.raises(ValueError, match=r"trace_48: input p has shape \(3, 5\), not \(3, 6\)"):
        kernels("trace_48", np.zeros((3, 4)), np.zeros((3, 5)))


def test_no_points_are_mapped_to_no_points():
    model = load("compass")
    w, *_, residual = load_kernels(model)("trace_48", np.zeros((0, 4)), np.zeros((0, 6)))
    assert (w.shape, residual.shape) == ((0, 49, 5), (0, 4))


# -- without a compiler ----------------------------------------------------------------------------------


@needs_compiler
def test_without_a_compiler_the_virtual_machine_finds_the_same_orbits(monkeypatch, fresh_kernels):
    model = load("wobbling")
    points = np.array([model.point({}), model.point({"k": 0.5})])
    options = SearchOptions(starts=48, seed=1)
    # One point at a time, to the last bit.
    monkeypatch.setattr(limit_cycle, "load_kernels", lambda m: CompiledKernels(m, find_compiler()))
    expected = find_orbits(model, points, options)
    monkeypatch.undo()
    assert all(expected)

    load_kernels.cache_clear()
    no_compiler(monkeypatch)
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        found = find_orbits(model, points, options)
        find_orbits(model, points, options)  # no second warning
    assert [w.category for w in caught] == [RuntimeWarning]
    assert "no C compiler found" in str(caught[0].message)
    assert isinstance(load_kernels(model), InterpretedKernels)
    assert "virtual machine" in load_kernels(model).compiler
    assert found == expected


# -- what goes wrong -------------------------------------------------------------------------------------


def test_cc_that_does_not_exist_is_named(monkeypatch, own_cache):
    monkeypatch.setenv("CC", "no-such-compiler -O2")
    with pytest.raises(InputError) as error:
        BARE(load("compass"))
    assert "CC names 'no-such-compiler -O2'" in one_sentence(error)


def test_compiler_that_fails_is_named_with_what_it_said(tmp_path, monkeypatch, own_cache):
    monkeypatch.setenv("CC", script(tmp_path / "badcc", "echo 'it is Sunday' >&2\necho more >&2\nexit 1"))
    with pytest.raises(InputError) as error:
        BARE(load("compass"))
    message = one_sentence(error)
    assert "badcc" in message
    assert "it is Sunday" in message
    assert list(own_cache.iterdir()) == []  # nothing half done is left


def test_compiler_that_says_nothing(tmp_path, monkeypatch, own_cache):
    monkeypatch.setenv("CC", script(tmp_path / "mute", "exit 1"))
    with pytest.raises(InputError) as error:
        BARE(load("compass"))
    assert "it said nothing" in one_sentence(error)


@needs_compiler
@pytest.mark.parametrize("below", ["", "deeper"])
def test_cache_that_cannot_be_written_is_named(tmp_path, monkeypatch, below):
    in_the_way = tmp_path / "file"
    in_the_way.write_text("not a folder")
    monkeypatch.setenv("STRIDEMAP_CACHE", str(in_the_way / below))
    monkeypatch.delenv("CC", raising=False)
    with pytest.raises(InputError) as error:
        BARE(load("compass"))
    message = one_sentence(error)
    assert str(in_the_way) in message
    assert "STRIDEMAP_CACHE" in message
    assert in_the_way.read_text() == "not a folder"


def test_edited_kernels_are_refused(tmp_path, monkeypatch, own_cache):
    folder = tmp_path / "compass"
    shutil.copytree(load("compass").folder, folder)
    kernels = folder / "compass_kernels.c"
    kernels.write_text(kernels.read_text("utf-8").replace("0.5", "0.6", 1), "utf-8")
    monkeypatch.setenv("CC", script(tmp_path / "cc", f"touch {tmp_path}/called"))
    with pytest.raises(InputError) as error:
        BARE(Model(folder))
    assert "compass_kernels.c is not the file that manifest.json names" in one_sentence(error)
    assert not list(own_cache.glob("*"))


# -- the cache -------------------------------------------------------------------------------------------


@needs_compiler
def test_second_load_does_not_compile_again(tmp_path, monkeypatch, own_cache):
    log = tmp_path / "log"
    compiler = shutil.which(os.environ.get("CC", "").split(" ")[0] or find_compiler())
    monkeypatch.setenv("CC", script(tmp_path / "counting", f'echo "$@" >> {log}\nexec {compiler} "$@"'))
    first = BARE(load("compass"))
    assert isinstance(first, LockstepKernels)
    assert log.read_text().count("compass_lockstep.cpp") == 1
    assert [path.suffix for path in own_cache.iterdir()] == [".so"]
    second = BARE(load("compass"))
    assert log.read_text().count("compass_lockstep.cpp") == 1
    CompiledKernels(load("compass"), find_compiler())
    compiled = [line for line in log.read_text().splitlines() if "compass_kernels.c" in line]
    assert len(compiled) == 1
    assert all(flag in compiled[0].split() for flag in FLAGS)
    u, p = np.array([[0.09, -0.17, -0.003, 1.2]]), load("compass").point({})[None]
    assert_same_bits(first("trace_48", u, p), second("trace_48", u, p))


@needs_compiler
def test_each_source_compiler_and_flags_have_a_library_of_their_own(tmp_path, own_cache):
    one, other = "double one(void) { return 1.0; }\n", "double one(void) { return 2.0; }\n"
    compiler = find_compiler()
    built = [
        compile_shared("one.c", one, compiler),
        compile_shared("one.c", one, f"{compiler} -DANOTHER"),
        compile_shared("one.c", one, compiler, [*FLAGS, "-DANOTHER"]),
        compile_shared("one.c", other, compiler),
    ]
    assert len(set(built)) == 4
    assert sorted(own_cache.iterdir()) == sorted(built)
    before = built[0].stat().st_mtime_ns
    assert compile_shared("one.c", one, compiler) == built[0]
    assert built[0].stat().st_mtime_ns == before
