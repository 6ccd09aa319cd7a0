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
    try:
        changed = path.stat().st_mtime_ns
    except OSError as error:
        raise InputError(f"cannot read the model file {path} ({error.strerror}); give its path") from None
    return _derived(path.resolve(), changed)


@cache
def _derived(path: Path, _changed: int) -> Path:
    command = [sys.executable, "-m", "stridemap", "derive", str(path)]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    if run.returncode:
        said = run.stderr.strip().splitlines() or ["the derivation said nothing"]
        raise InputError(said[-1].removeprefix("error: "))
    return Path(run.stdout.splitlines()[-1]).parent
