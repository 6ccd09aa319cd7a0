"""Model files of the user's own, derived when they are first used.

The derivation runs as a program of its own: what runs here needs neither SymPy nor the user's code, only
the files that were generated.
"""

import subprocess
import sys
from functools import cache
from pathlib import Path

from stridemap.errors import InputError


def derived_folder(path: Path) -> Path:
    """Folder of the generated files of a model file.

    Parameters
    ----------
    path : pathlib.Path
        A Python file that declares a walker.

    Raises
    ------
    InputError
        When there is no such file, or it declares no walker that can be derived.
    """
    if not path.is_file():
        raise InputError(f"cannot read the model file {path}; give the path of a Python file (.py)")
    beside = sorted(path.resolve().parent.glob("*.py"))  # it may import them
    return _derived(path.resolve(), tuple((p.name, _changed(p)) for p in beside), str(path))


def _changed(path: Path) -> int:
    try:
        return path.stat().st_mtime_ns
    except OSError:  # a dangling link, say
        return 0


@cache
def _derived(path: Path, _beside: tuple[tuple[str, int], ...], shown: str) -> Path:
    if sys.stderr.isatty():
        print(f"reading {shown}; a walker that is new is derived first, about half a minute", file=sys.stderr)
    command = [sys.executable, "-m", "stridemap", "derive", shown, "--keep"]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    if run.returncode:
        said = run.stderr.strip().splitlines() or ["the derivation ended without a word"]
        raise InputError(said[-1].removeprefix("error: "))
    return Path(run.stdout.splitlines()[-1]).parent
