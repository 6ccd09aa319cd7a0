"""A derivation says how far it is, and what the cache has is not derived again."""

from itertools import count

import pytest

import stridemap
from stridemap import codegen
from stridemap.cli import progress
from stridemap.derive.functions import Functions
from stridemap.derive.models import WALKERS

WHEEL = WALKERS["rimless_wheel"].with_(name="own_wheel")
pytestmark = pytest.mark.quick


def test_what_is_in_the_cache_is_copied_and_not_derived_again(tmp_path, monkeypatch):
    monkeypatch.setenv("STRIDEMAP_CACHE", str(tmp_path / "cache"))
    stridemap.derive_model(WHEEL)
    monkeypatch.setattr(codegen, "emit", None)  # calling it would fail
    stridemap.derive_model(WHEEL, tmp_path / "out")
    (cached,) = (tmp_path / "cache" / "models").iterdir()
    assert {p.name: p.read_bytes() for p in (tmp_path / "out").iterdir()} == {
        p.name: p.read_bytes() for p in cached.iterdir()
    }


def test_without_a_cache_that_can_be_written_the_folder_is_written_all_the_same(tmp_path, monkeypatch):
    (tmp_path / "cache").write_text("in the way")
    monkeypatch.setenv("STRIDEMAP_CACHE", str(tmp_path / "cache"))
    assert stridemap.derive_model(WHEEL, tmp_path / "out").name == "own_wheel"


def test_functions_are_counted_before_they_are_derived():
    functions = Functions(WHEEL)
    assert len(list(functions.programs())) == functions.count


def test_a_derivation_is_shown_after_a_second_and_not_before(monkeypatch, capsys):
    seconds = (0.4 * i for i in count())
    monkeypatch.setattr(progress.time, "monotonic", lambda: next(seconds))
    with progress.show_deriving("mine") as show:
        for i in range(1, 11):
            show(i, 10, f"function_{i}")
    lines = capsys.readouterr().err.splitlines()
    assert lines[0] == "deriving mine: 3 of 10 functions, function_3 done, 1 s"
    assert lines[-1] == "deriving mine: 10 of 10 functions, writing the kernels, 4 s"
    assert len(lines) == 3
