"""The C compiler and its cache: what is compiled once, and every way in which compiling goes wrong."""

import os
import shutil

import numpy as np
import pytest

from stridemap.errors import CompilerError, InputError, StorageError
from stridemap.solver.backends.compiler import FLAGS, compile_shared, find_compiler
from stridemap.solver.backends.lanes import Lanes
from stridemap.solver.backends.scalar import ScalarC
from stridemap.solver.backends.selection import load_kernels
from stridemap.solver.model.files import GENERATED, Folder
from stridemap.solver.model.loading import load
from stridemap.solver.model.model import Model
from tests.oracles.kernels import assert_same_bits, needs_compiler, one_sentence, script

BARE = load_kernels.__wrapped__  # without its cache: every call loads anew

# -- what goes wrong -------------------------------------------------------------------------------------


@pytest.mark.quick
def test_cc_that_does_not_exist_is_named(monkeypatch, own_cache):
    monkeypatch.setenv("CC", "no-such-compiler -O2")
    with pytest.raises(InputError) as error:
        BARE(load("compass"), None)
    assert "CC names 'no-such-compiler -O2'" in one_sentence(error)


@pytest.mark.quick
def test_compiler_that_fails_is_named_with_what_it_said(tmp_path, monkeypatch, own_cache):
    monkeypatch.setenv("CC", script(tmp_path / "badcc", "echo 'it is Sunday' >&2\necho more >&2\nexit 1"))
    with pytest.raises(CompilerError) as error:
        BARE(load("compass"), None)
    message = one_sentence(error)
    assert "badcc" in message
    assert "it is Sunday" in message
    assert list(own_cache.iterdir()) == []  # nothing half done is left


def test_compiler_that_says_nothing(tmp_path, monkeypatch, own_cache):
    monkeypatch.setenv("CC", script(tmp_path / "mute", "exit 1"))
    with pytest.raises(CompilerError) as error:
        BARE(load("compass"), None)
    assert "without a message" in one_sentence(error)


@needs_compiler
@pytest.mark.parametrize("below", ["", "deeper"])
def test_cache_that_cannot_be_written_is_named(tmp_path, monkeypatch, below):
    in_the_way = tmp_path / "file"
    in_the_way.write_text("not a folder")
    monkeypatch.setenv("STRIDEMAP_CACHE", str(in_the_way / below))
    monkeypatch.delenv("CC", raising=False)
    with pytest.raises(StorageError) as error:
        BARE(load("compass"), None)
    message = one_sentence(error)
    assert str(in_the_way) in message
    assert "STRIDEMAP_CACHE" in message
    assert in_the_way.read_text() == "not a folder"


@pytest.mark.quick
def test_edited_kernels_are_refused(tmp_path, monkeypatch, own_cache):
    folder = tmp_path / "compass"
    shutil.copytree(GENERATED / "compass", folder)
    kernels = folder / "compass_kernels.c"
    kernels.write_text(kernels.read_text("utf-8").replace("0.5", "0.6", 1), "utf-8")
    monkeypatch.setenv("CC", script(tmp_path / "cc", f"touch {tmp_path}/called"))
    with pytest.raises(InputError) as error:
        BARE(Model(Folder(folder), "mine"), None)
    assert "compass_kernels.c is not the file that manifest.json names" in one_sentence(error)
    assert not list(own_cache.glob("*"))


# -- the cache -------------------------------------------------------------------------------------------


@needs_compiler
def test_second_load_does_not_compile_again(tmp_path, monkeypatch, own_cache):
    log = tmp_path / "log"
    compiler = shutil.which(os.environ.get("CC", "").split(" ")[0] or find_compiler())
    monkeypatch.setenv("CC", script(tmp_path / "counting", f'echo "$@" >> {log}\nexec {compiler} "$@"'))
    first = BARE(load("compass"), None)
    assert isinstance(first.backend, Lanes)
    assert log.read_text().count("compass_lockstep.cpp") == 1
    assert [path.suffix for path in own_cache.iterdir()] == [".so"]
    second = BARE(load("compass"), None)
    assert log.read_text().count("compass_lockstep.cpp") == 1
    ScalarC().kernels(load("compass"))
    compiled = [line for line in log.read_text().splitlines() if "compass_kernels.c" in line]
    assert len(compiled) == 1
    assert all(flag in compiled[0].split() for flag in FLAGS)
    u, p = np.array([[0.09, -0.17, -0.003, 1.2]]), load("compass").point({})[None]
    assert_same_bits(first.trace(48, u, p), second.trace(48, u, p))


@pytest.mark.quick
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
