"""Gives made-up input to the program, in this process, and says what became of it.

What an input asks for is checked in full and then done in small: a search makes few starts, a walk few steps,
a sweep none.
"""

import contextlib
import io
import os
import sys
import warnings
from pathlib import Path

import stridemap.solver.api.points as points
import stridemap.solver.walks.simulator as simulator
from stridemap.cli.app import main
from stridemap.errors import StridemapError
from stridemap.solver.options import SearchOptions
from stridemap.sweeps.config import load_config
from tests.fuzz import inputs

LONGEST = 1_000
"""Characters of a sentence."""


class Fault(AssertionError):
    """An outcome that is neither success nor a sentence."""


def cut(monkeypatch):
    """Do in small what takes long, after all checks."""
    find, walk = points.find_all, simulator.walk

    def few(solver, points, search=None):
        return find(solver, points, SearchOptions(starts=2, seed=0 if search is None else search.seed))

    def one_step(model, point, state, steps, **options):
        return walk(model, point, state, min(steps, 1), **options)

    def refuse(*_args, **_keywords):
        raise StridemapError("it would be done now")

    monkeypatch.setattr(points, "find_all", few)
    monkeypatch.setattr(simulator, "walk", one_step)
    monkeypatch.setattr("stridemap.solver.walks.swing.MAX_STEPS", 60)
    monkeypatch.setattr("stridemap.views.film.film", lambda *_: b"")
    for name in (
        "stridemap.solver.branches.survey.Survey.branches", "stridemap.solver.api.targets.hits",
        "stridemap.solver.model.loading.derive_file", "stridemap.solver.model.derivation.derive_file",
        "stridemap.codegen.derive", "stridemap.codegen.drift", "stridemap.sweeps.run._Run.all_rounds",
    ):  # fmt: skip
        monkeypatch.setattr(name, refuse)


def check_sentence(text):
    """Fail unless `text` is one sentence of bounded length."""
    if not text or "\n" in text or len(text) > LONGEST or "Traceback" in text:
        raise Fault(f"this is not a sentence: {text[:300]!r} ({len(text)} characters)")


def try_command_line(number, folder):
    """Run a command line; returns its exit status."""
    words = inputs.command_line(number)
    out, err = io.StringIO(), io.StringIO()
    before = os.environ.copy()
    shown, where = warnings.showwarning, os.getcwd()
    sys.argv = ["stridemap", *words]
    os.chdir(folder)
    try:
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            main()
    except SystemExit as ended:
        status = ended.code
    except BaseException as error:
        raise Fault(f"{words!r:.400} ends in {type(error).__name__}: {error!s:.300}") from error
    finally:
        warnings.showwarning = shown
        os.environ.clear()
        os.environ.update(before)
        os.chdir(where)
    if status not in (0, 1, 2):
        raise Fault(f"{words!r:.400} ends with status {status}")
    if status == 2:
        said = [line for line in err.getvalue().splitlines() if not line.startswith("sweep ")]
        if len(said) != 1 or not said[0].startswith("error: "):
            raise Fault(f"{words!r:.400} says {said!r:.400}")
        check_sentence(said[0])
    return status


def try_configuration(number, folder):
    """Read a configuration; returns whether it is one."""
    path = Path(folder) / "fuzz.toml"
    data = inputs.configuration(number)
    path.write_bytes(data)
    try:
        load_config(path)
    except StridemapError as error:
        check_sentence(str(error))
        return 2
    except BaseException as error:
        raise Fault(f"{data!r:.600} ends in {type(error).__name__}: {error!s:.300}") from error
    return 0


def try_declaration(number, _folder):
    """Declare a walker; returns whether it can be."""
    what = f"declaration {number}"
    try:
        walker, field, thing = inputs.declaration(number)
        with contextlib.suppress(Exception):
            what = f"{walker.name} with {field} = {thing!r}"
        walker.with_(**{field: thing})
    except StridemapError as error:
        check_sentence(str(error))
        return 2
    except BaseException as error:
        raise Fault(f"{what:.600} ends in {type(error).__name__}: {error!s:.300}") from error
    return 0


KINDS = {
    "command lines": try_command_line,
    "configurations": try_configuration,
    "declarations": try_declaration,
}
