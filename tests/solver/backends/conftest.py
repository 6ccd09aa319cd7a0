"""Fixtures of the tests of the backends."""

import shutil

import pytest

from stridemap.solver.backends import lanes
from stridemap.solver.backends.selection import load_kernels
from tests.oracles.kernels import few


@pytest.fixture
def fresh_kernels():
    """Forget which kernels are loaded, before and after."""
    load_kernels.cache_clear()
    yield
    load_kernels.cache_clear()


@pytest.fixture
def own_cache(tmp_path, monkeypatch, fresh_kernels):
    """An empty cache of compiled kernels, on disk and in memory."""
    folder = tmp_path / "cache"
    monkeypatch.setenv("STRIDEMAP_CACHE", str(folder))
    return folder


@pytest.fixture
def few_kernels(monkeypatch):
    """Of the kernels in lanes a residual and a trace: the others take most of the time of a compilation."""
    monkeypatch.setattr(lanes, "source", lambda model, whole=lanes.source: few(whole(model)))


@pytest.fixture
def no_compiler(monkeypatch, fresh_kernels):
    """A machine without a C compiler."""
    monkeypatch.delenv("CC", raising=False)
    monkeypatch.setattr(shutil, "which", lambda *_args, **_kwargs: None)
