"""The command line where generated files, the compiler or the cache of kernels are not as they should be."""

import json
import shutil
import sys

import pytest

from stridemap.solver.backends.selection import load_kernels
from stridemap.solver.model.files import GENERATED
from stridemap.spec import ModelSpec
from tests.oracles.sweeping import STRIDEMAP, content, ended, start

# -- generated files -----------------------------------------------------------------------------------------


@pytest.fixture
def copy(tmp_path, monkeypatch):
    """A copy of the generated folder in place of the package's own."""
    folder = tmp_path / "generated"
    shutil.copytree(GENERATED, folder, ignore=shutil.ignore_patterns("__pycache__"))
    monkeypatch.setattr("stridemap.solver.model.loading.GENERATED", folder)
    return folder


@pytest.mark.parametrize("name", ["compass_kernels.c", "compass.py"])
def test_an_edited_generated_file(refused, done, copy, name):
    path = copy / "compass" / name
    path.write_text(path.read_text() + "\n")
    before = content(done)
    for line in (["orbit", "--model", "compass"], ["sweep", done / "small.toml", "--out", done / "out"]):
        refused(line, path, "not the file that manifest.json names", "stridemap derive")
    assert content(done) == before


def test_a_missing_generated_file(refused, copy):
    (copy / "compass" / "compass_kernels.c").unlink()
    refused("orbit --model compass", "compass_kernels.c", "stridemap derive")


@pytest.mark.parametrize("text", ["{", '{"model": "compass"}', "[]", "\xff"])
def test_a_damaged_manifest(refused, copy, text):
    path = copy / "compass" / "manifest.json"
    path.write_bytes(text.encode("latin-1"))
    refused("orbit --model compass", path.parent, "manifest.json", "stridemap derive")


def emitted(walker, by, progress):
    """What a derivation gives, without deriving."""
    folder = GENERATED / walker.name
    spec = ModelSpec.from_manifest(json.loads((folder / "manifest.json").read_text("utf-8")))
    names = [name for name in spec.files if not name.endswith("_kernels.c")]
    return {name: (folder / name).read_text("utf-8") for name in names}, spec


def test_derive_cannot_write(refused, tmp_path, monkeypatch):
    (tmp_path / "file").write_text("mine")
    monkeypatch.setattr("stridemap.codegen.generated_folder", lambda: tmp_path / "file")
    monkeypatch.setattr("stridemap.codegen.emit", emitted)
    refused("derive", tmp_path / "file", "cannot write")
    assert (tmp_path / "file").read_text() == "mine"


# -- compilers -----------------------------------------------------------------------------------------------

SCRIPTS = {
    "fails": ("#!/bin/sh\necho 'out of ideas' >&2\nexit 1\n", ["failed", "out of ideas"]),
    "says-nothing": ("#!/bin/sh\nexit 3\n", ["failed", "without a message"]),
    "writes-nothing": ("#!/bin/sh\nexit 0\n", ["writes-nothing"]),
    "writes-junk": ('#!/bin/sh\nfor word; do case "$word" in *.so) echo junk > "$word";; esac; done\n', []),
    "is-no-program": ("just text\n", ["is-no-program"]),
}


@pytest.fixture
def no_kernels(tmp_path, monkeypatch):
    """An empty cache of compiled kernels, on disk and in memory."""
    monkeypatch.setenv("STRIDEMAP_CACHE", str(tmp_path / "cache"))
    load_kernels.cache_clear()
    yield tmp_path / "cache"
    load_kernels.cache_clear()


@pytest.mark.skipif(sys.platform == "win32", reason="shell scripts")
@pytest.mark.parametrize("kind", SCRIPTS)
def test_a_compiler_that_fails(refused, done, no_kernels, monkeypatch, kind):
    text, words = SCRIPTS[kind]
    script = done / kind
    script.write_text(text)
    script.chmod(0o755)
    monkeypatch.setenv("CC", str(script))
    before = content(done / "out")
    refused("orbit --model compass", script, "CC", *words)
    refused(["sweep", done / "small.toml", "--out", done / "out"], script)
    refused(["sweep", done / "small.toml", "--out", done / "new"], script)
    assert content(done / "out") == before
    assert not (done / "new").exists()
    assert [path for path in no_kernels.rglob("*") if path.is_file()] == []


@pytest.mark.parametrize("name", ["no-such-compiler -O2", "/nowhere/gcc", "'gcc"])
def test_cc_names_nothing(refused, no_kernels, monkeypatch, name):
    monkeypatch.setenv("CC", name)
    refused("orbit --model compass", "CC", name)


def test_the_cache_cannot_be_written(refused, no_kernels):
    no_kernels.write_text("mine")
    refused("orbit --model compass", no_kernels, "STRIDEMAP_CACHE")
    assert no_kernels.read_text() == "mine"


def test_a_damaged_cache_is_made_anew(no_kernels):
    """Half a library would end the process without a word: hence another process."""
    command = [*STRIDEMAP, "orbit", "--model", "rimless_wheel", "--starts", "16", "--json", "--quiet"]
    whole = ended(start(command))
    assert (whole[0], whole[2]) == (0, "")
    for size in (0, -1000):
        (compiled,) = no_kernels.glob("*.so")
        compiled.write_bytes(compiled.read_bytes()[:size])
        assert ended(start(command)) == whole
