"""Fixtures: the command line in this process, and a finished sweep."""

import shutil
import sys
import warnings

import pytest

from stridemap.cli.app import main
from stridemap.sweeps.run import sweep
from tests.oracles.sweeping import SMALL, Inline


@pytest.fixture
def run(monkeypatch, capsys):
    """The command line in this process: exit status, standard output, standard error."""

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


@pytest.fixture(scope="session")
def finished(tmp_path_factory):
    """A configuration and a finished sweep of it, to be copied."""
    folder = tmp_path_factory.mktemp("finished")
    (folder / "small.toml").write_text(SMALL)
    sweep(folder / "small.toml", folder / "out", executor=Inline())
    return folder


@pytest.fixture
def done(finished, tmp_path):
    """A folder of our own with `small.toml` and its sweep in `out`."""
    shutil.copytree(finished, tmp_path, dirs_exist_ok=True)
    return tmp_path
