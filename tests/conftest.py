"""Fixtures: the command line in this process, and what is computed once for a whole run.

Compiled kernels and derived models are kept in ``.pytest_cache/stridemap`` from run to run, and all worker
processes share them; their names are hashes of all that they depend on. The environment variable
STRIDEMAP_CACHE names another folder.
"""

import contextlib
import gc
import os
import shutil
import sys
import warnings

import pytest

from stridemap.cli import progress
from stridemap.cli.app import main
from stridemap.solver.backends.interpreter import Interpreter
from stridemap.solver.backends.selection import load_kernels
from stridemap.solver.model import derivation, loading
from stridemap.solver.observables import motion
from stridemap.sweeps import run as running
from stridemap.sweeps.run import sweep
from tests.oracles.shared import once
from tests.oracles.sweeping import LARGER, SMALL, Inline, Remembering, tables, uninterrupted


def pytest_configure(config):
    os.environ.setdefault("STRIDEMAP_CACHE", str(config.rootpath / ".pytest_cache" / "stridemap"))


def pytest_collection_finish():
    gc.collect()
    gc.freeze()  # what was imported stays: it need not be looked through again and again


@pytest.fixture
def run(monkeypatch, capsys):
    """The command line in this process: exit status, standard output, standard error.

    However slow the machine is, what it writes does not depend on it: nothing says how far it is.
    """
    monkeypatch.setattr(progress, "QUIET", 3600.0)

    def command(*words):
        monkeypatch.setattr(sys, "argv", ["stridemap", *map(str, words)])
        monkeypatch.setattr(warnings, "showwarning", warnings.showwarning)  # main() sets its own
        with pytest.raises(SystemExit) as exit_:
            main()
        out, err = capsys.readouterr()
        return exit_.value.code, out, err

    return command


@pytest.fixture
def refused(run):
    """The command line in this process, which must refuse in one sentence that contains `words`."""

    def command(line, *words):
        status, out, err = run(*(line.split() if isinstance(line, str) else line))
        assert (status, out) == (2, "")
        assert err.startswith("error: ")
        assert err.count("\n") == 1
        assert err.endswith("\n")
        assert "Traceback" not in err
        assert [word for word in map(str, words) if word not in err] == []

    return command


@pytest.fixture
def in_this_process(monkeypatch):
    """Model files are run in this process and not in one of their own, which takes a second to start.

    What the process is for is tested in `tests/solver/model/test_derivation.py`.
    """
    from stridemap.codegen import derive_file  # SymPy takes a second, too

    for module in (derivation, loading):
        monkeypatch.setattr(module, "derive_file", derive_file)


@pytest.fixture
def no_workers(monkeypatch):
    """Sweeps are computed in this process: each worker that is started takes a second for its imports."""
    monkeypatch.setattr(running, "processes", lambda _: contextlib.nullcontext(Inline()))


@pytest.fixture
def uncompiled(monkeypatch):
    """Motions of walkers that are not built in are sampled in CasADi's virtual machine.

    To compile the kernels of a walker takes longer than all that a test does with them.
    """

    def kernels(model, backend):
        built_in = model.name in loading.available()
        return load_kernels(model, backend if backend or built_in else Interpreter())

    monkeypatch.setattr(motion, "load_kernels", kernels)


@pytest.fixture(scope="session")
def common(tmp_path_factory):
    """A temporary folder that all processes of this run have in common."""
    base = tmp_path_factory.getbasetemp()
    return base.parent if "PYTEST_XDIST_WORKER" in os.environ else base


@pytest.fixture(scope="session")
def finished(common):
    """A configuration and a finished sweep of it, to be copied."""

    def make(folder):
        (folder / "small.toml").write_text(SMALL)
        sweep(folder / "small.toml", folder / "out", executor=Inline())

    once(common / "finished", make)
    return common / "finished"


@pytest.fixture
def done(finished, tmp_path):
    """A folder of our own with `small.toml` and its sweep in `out`."""
    shutil.copy(finished / "small.toml", tmp_path)
    shutil.copytree(finished / "out", tmp_path / "out")
    return tmp_path


@pytest.fixture(scope="session")
def reference(common):
    """The sweep of CONFIG in tiles of 2: its folder, summary, progress, and the pieces that were computed."""
    return once(common / "reference", lambda folder: uninterrupted(folder / "out"))


@pytest.fixture(scope="session")
def larger(common):
    """A configuration file and the tables of its sweep in tiles of 2 without interruption."""

    def make(folder):
        config = folder / "larger.toml"
        config.write_text(LARGER)
        sweep(config, folder / "out", executor=Remembering(), tile_cells=2)
        return config, tables(folder / "out")

    return once(common / "larger", make)
