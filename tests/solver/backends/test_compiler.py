"""The C compiler and its cache: what is compiled once, and every way in which compiling goes wrong."""

import os
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pytest

from stridemap.errors import CompilerError, InputError, StorageError, StridemapError
from stridemap.solver.backends import scratch, self_check
from stridemap.solver.backends.compiler import FLAGS, compile_shared, find_compiler
from stridemap.solver.backends.lanes import Lanes
from stridemap.solver.backends.scalar import ScalarC
from stridemap.solver.backends.selection import load_kernels
from stridemap.solver.model.files import GENERATED, Folder
from stridemap.solver.model.loading import available, load
from stridemap.solver.model.model import Model
from tests.oracles.kernels import assert_same_bits, needs_compiler, one_sentence, script

ROOT = Path(__file__).resolve().parents[3]
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


ARITHMETIC = (
    "-ffast-math", "-Ofast", "-funsafe-math-optimizations", "-ffinite-math-only", "-ffp-contract=fast",
    "-mfpmath=387", "-fassociative-math", "-freciprocal-math", "-fno-signed-zeros", "-ffp-model=fast",
)  # fmt: skip


@needs_compiler
@pytest.mark.parametrize("flag", ARITHMETIC)
def test_flags_that_change_arithmetic_are_refused(monkeypatch, own_cache, flag):
    monkeypatch.setenv("CC", f"{find_compiler()} -O3 {flag}")
    with pytest.raises(InputError) as error:
        BARE(load("compass"), None)
    assert f"has the option '{flag}', which changes the arithmetic" in one_sentence(error)
    assert not own_cache.exists()
    with pytest.raises(InputError, match="changes the arithmetic"):
        ScalarC(f"cc {flag}").kernels(load("compass"))


def somewhere():
    """A section point of the rimless wheel with a period, and its parameters."""
    return np.array([[-0.52, 0.46, 2.3]]), load("rimless_wheel").point({})[None]


@pytest.fixture(scope="module")
def usual():
    """What kernels that are compiled as usual compute there."""
    return BARE(load("rimless_wheel"), None).trace(48, *somewhere())


@needs_compiler
@pytest.mark.parametrize("flags", ["-O3", "-g -march=native", "-ffp-contract=off -mfpmath=sse -m64"])
def test_flags_that_keep_it_give_the_same_bits(monkeypatch, usual, own_cache, few_kernels, flags):
    monkeypatch.setenv("CC", f"{shutil.which(find_compiler())} {flags}")
    assert_same_bits(usual, BARE(load("rimless_wheel"), None).trace(48, *somewhere()))


LOADED = """
import sys
sys.path.insert(0, sys.argv[2])
from stridemap.errors import CompilerError
from stridemap.solver.backends import lanes
from stridemap.solver.backends.selection import load_kernels, named_backend
from stridemap.solver.model.loading import load
from tests.oracles.kernels import few
lanes.source = lambda model, whole=lanes.source: few(whole(model))
try:
    load_kernels(load("rimless_wheel"), named_backend(sys.argv[1] or None))
except CompilerError as error:
    print(error)
"""


@needs_compiler
@pytest.mark.parametrize(
    ("backend", "flag"),
    [
        ("lanes", "-O2 -ffp-contract=fast -march=native"),
        ("scalar", "-O2 -ffp-contract=fast -march=native"),
        ("scalar", "-ffast-math"),
        ("", "-ffast-math"),  # by default lanes are taken
    ],
)
def test_kernels_find_out_themselves(tmp_path, own_cache, backend, flag):
    """A wrapper hides the flag behind a name, and puts it after ours.

    In a process of its own: a library that is linked with -ffast-math switches off the smallest numbers of
    the whole process.
    """
    wrapper = script(tmp_path / "wrapped", f'exec {shutil.which(find_compiler())} "$@" {flag}')
    command = [sys.executable, "-c", LOADED, backend, str(ROOT)]
    run = subprocess.run(
        command, env={**os.environ, "CC": wrapper}, capture_output=True, text=True, check=False
    )
    assert "do not compute as they were written" in run.stdout, run.stderr
    assert not list(own_cache.glob("*.checked"))


@needs_compiler
def test_they_are_looked_at_once(monkeypatch, own_cache, few_kernels):
    BARE(load("rimless_wheel"), None)
    monkeypatch.setattr(self_check, "check_arithmetic", lambda _: pytest.fail("looked at again"))
    BARE(load("rimless_wheel"), None)


@needs_compiler
@pytest.mark.parametrize(
    ("backend", "name"),
    [
        *((Lanes(), name) for name in available()),
        (Lanes(instructions=()), "compass"),
        *((ScalarC(), name) for name in ("compass", "wobbling")),
    ],
    ids=str,
)
def test_python_computes_the_same_bits(backend, name):
    """Every operation of a residual is known, so that the comparison is one of bits.

    All models as they are used, and some of them, which other tests need as well, in each other way.
    """
    compare(backend, name)


@needs_compiler
def test_python_computes_the_same_bits_without_wide_instructions(few_kernels):
    compare(Lanes(instructions=()), "wobbling")


def compare(backend, name):
    kernels = backend.kernels(load(name))
    u, p = self_check._points(kernels.model)
    function = kernels.functions[self_check.KERNEL].expand()
    exact = self_check._exact(function, u, p, not isinstance(backend, ScalarC))
    assert np.isfinite(exact).any()
    assert_same_bits([kernels.residual(12, u, p)], [exact])


# -- compilers that are something else -------------------------------------------------------------------


@pytest.mark.parametrize(
    "text", ["exec cat", "exec yes", "exec sleep 1000"], ids=["reads", "prints", "waits"]
)
def test_a_compiler_that_does_not_end_is_ended(tmp_path, monkeypatch, own_cache, text):
    monkeypatch.setattr("stridemap.solver.backends.compiler.COMPILE_SECONDS", 2.0)
    monkeypatch.setattr("stridemap.solver.backends.compiler.VERSION_SECONDS", 2.0)
    monkeypatch.setenv("CC", script(tmp_path / "odd", text))
    with pytest.raises(CompilerError) as error:
        BARE(load("compass"), None)
    assert len(one_sentence(error)) < 600


@pytest.mark.parametrize("value", ['""', "'", "\\", "cc 'x", "a" * 5000, "/", "/dev/null"])
def test_a_compiler_that_is_no_command(monkeypatch, own_cache, value):
    monkeypatch.setenv("CC", value)
    with pytest.raises(StridemapError) as error:
        BARE(load("compass"), None)
    assert "CC" in one_sentence(error)
    assert len(str(error.value)) < 600


# -- what lies in the cache ------------------------------------------------------------------------------


@needs_compiler
@pytest.mark.parametrize("kind", ["folder", "pipe", "device", "dangling"])
def test_what_is_no_library_is_not_taken_for_one(own_cache, kind):
    library = compile_shared("one.c", "double one(void) { return 1.0; }\n", find_compiler())
    library.unlink()
    if kind == "folder":
        library.mkdir()
    elif kind == "pipe":
        os.mkfifo(library)
    else:
        library.symlink_to("/dev/zero" if kind == "device" else "/nowhere/at/all")
    try:
        built = compile_shared("one.c", "double one(void) { return 1.0; }\n", find_compiler())
    except StorageError as error:
        assert kind == "folder"
        assert str(own_cache) in str(error)
    else:
        assert built.is_file()


@needs_compiler
def test_a_cache_whose_name_is_too_long(monkeypatch, own_cache):
    monkeypatch.setenv("STRIDEMAP_CACHE", "/tmp/" + "x" * 5000)
    with pytest.raises(StorageError, match="File name too long"):
        BARE(load("compass"), None)


# -- the cache -------------------------------------------------------------------------------------------


@needs_compiler
def test_second_load_does_not_compile_again(tmp_path, monkeypatch, own_cache, few_kernels):
    log = tmp_path / "log"
    compiler = shutil.which(os.environ.get("CC", "").split(" ")[0] or find_compiler())
    monkeypatch.setenv("CC", script(tmp_path / "counting", f'echo "$@" >> {log}\nexec {compiler} "$@"'))
    first = BARE(load("rimless_wheel"), None)
    assert isinstance(first.backend, Lanes)
    assert log.read_text().count("rimless_wheel_lockstep.cpp") == 1
    assert sorted(path.suffix for path in own_cache.iterdir()) == [".checked", ".so"]
    second = BARE(load("rimless_wheel"), None)
    assert log.read_text().count("rimless_wheel_lockstep.cpp") == 1
    ScalarC().kernels(load("rimless_wheel"))
    compiled = [line for line in log.read_text().splitlines() if "rimless_wheel_kernels.c" in line]
    assert len(compiled) == 1
    assert all(flag in compiled[0].split() for flag in FLAGS)
    assert_same_bits(first.trace(48, *somewhere()), second.trace(48, *somewhere()))


@needs_compiler
@pytest.mark.parametrize("at_once", [3, 1], ids=["with locks", "without"])
def test_what_several_need_at_once_is_compiled_once(tmp_path, monkeypatch, own_cache, at_once):
    """Also where one that was killed has left its folder."""
    log = tmp_path / "log"
    counting = script(tmp_path / "cc", f'echo "$@" >> {log}\nsleep 0.2\nexec {find_compiler()} "$@"')
    text = "double one(void) { return 1.0; }\n"
    first = compile_shared("one.c", text, counting)
    first.unlink()
    if at_once > 1:
        (own_cache / first.stem.rpartition("-")[0]).mkdir()
    else:
        monkeypatch.setattr(scratch, "fcntl", None)
    with ThreadPoolExecutor(at_once) as pool:
        built = set(pool.map(lambda _: compile_shared("one.c", text, counting), range(at_once)))
    assert built == {first}
    assert sorted(own_cache.iterdir()) == [first]
    assert log.read_text().count("/one.c") == 2  # one for each time that it was not there


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
