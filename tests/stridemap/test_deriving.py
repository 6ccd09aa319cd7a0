"""A derivation says how far it is, and what the cache has is not derived again."""

from contextlib import contextmanager
from pathlib import Path

import pytest

import stridemap
from stridemap import codegen, services
from stridemap.derive.functions import Functions
from stridemap.derive.models import WALKERS
from stridemap.solver.model import derivation

WHEEL = WALKERS["rimless_wheel"].with_(name="own_wheel")


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


@pytest.mark.quick
def test_functions_are_counted_before_they_are_derived():
    functions = Functions(WHEEL)
    assert len(list(functions.programs())) == functions.count


def test_a_derivation_in_a_process_of_its_own_is_shown_where_it_is_waited_for(tmp_path, monkeypatch):
    """And what is known is copied: the second time nothing is derived."""
    seen = []

    @contextmanager
    def show_work(title, unit=""):
        yield lambda done=None, total=None, detail="", title=title: seen.append((title, done, total, detail))

    monkeypatch.setattr(services, "offered", lambda name: name == "show_work")
    monkeypatch.setattr(services, "service", lambda name: show_work)
    monkeypatch.setenv("STRIDEMAP_CACHE", str(tmp_path / "cache"))
    source = Path(__file__).parents[2] / "derive" / "models" / "rimless_wheel.py"
    text = source.read_text("utf-8").replace('name="rimless_wheel"', 'name="own_wheel"')
    (tmp_path / "mine.py").write_text(text)
    folder = derivation.derive_file(tmp_path / "mine.py")
    titles = {title for title, *_ in seen}
    assert "deriving own_wheel" in titles
    counts = [(done, total) for title, done, total, _ in seen if title == "deriving own_wheel" and done]
    assert counts == sorted(counts) and counts[-1][0] == counts[-1][1]
    seen.clear()
    derivation.derive_file(tmp_path / "mine.py", tmp_path / "out", keep=False)
    assert "deriving own_wheel" not in {title for title, *_ in seen}
    assert (tmp_path / "out" / "manifest.json").read_bytes() == (folder / "manifest.json").read_bytes()
