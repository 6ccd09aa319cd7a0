"""The software of a process, so that a worker which would compute something else refuses to.

Equal versions are not enough: a worker that was started before the source changed still runs the old one.
"""

import hashlib
import platform
import socket
from collections.abc import Mapping
from functools import cache
from importlib import import_module
from importlib.metadata import version
from pathlib import Path
from types import MappingProxyType

from stridemap.errors import WorkerError

PACKAGES = ("stridemap", "numpy", "scipy", "casadi", "pyarrow")
"""Packages whose versions are stored with a sweep."""

SOURCE = "source of stridemap"


def versions() -> dict[str, str]:
    """Versions of Python and of the packages that decide numbers."""
    return {"python": platform.python_version(), **{name: version(name) for name in PACKAGES}}


@cache
def software() -> Mapping[str, str]:
    """Versions, and a hash of the source that computes; as they were when this process first asked."""
    return MappingProxyType({**versions(), SOURCE: _source()})


def _source() -> str:
    """Hash of the rooms that compute the tiles of a sweep, and of the floor that they stand on."""
    digest = hashlib.sha256()
    for package, pattern in (("", "*.py"), (".solver", "**/*.[ph]*"), (".sweeps", "**/*.py")):
        folder = Path(next(iter(import_module(f"stridemap{package}").__path__)))
        for path in sorted(folder.glob(pattern)):
            if path.suffix in {".py", ".h"}:
                digest.update(f"{package}/{path.relative_to(folder).as_posix()}\n".encode())
                digest.update(path.read_bytes().replace(b"\r\n", b"\n"))
    return digest.hexdigest()[:12]


def refuse_other(theirs: Mapping[str, str]) -> None:
    """Refuse to work for a process that has other software.

    Parameters
    ----------
    theirs : mapping of str to str
        What `software` gives there.

    Raises
    ------
    WorkerError
    """
    here = software()
    if here != theirs:
        raise WorkerError(other_software(f"the worker on {socket.gethostname()}", here, theirs))


def other_software(who: str, there: Mapping[str, str], here: Mapping[str, str]) -> str:
    """One sentence on what `who` has that the process which began the sweep has not.

    Parameters
    ----------
    who : str
    there, here : mapping of str to str
        Versions by name, those of `who` and those of the process that began the sweep; what is missing there
        is not installed.
    """
    names = [name for name in here if there.get(name) != here[name]]
    differences = " and ".join(f"{name} {there.get(name) or 'missing'}, not {here[name]}" for name in names)
    return (
        f"{who} runs other software than this program ({differences}); start the workers again in the "
        "environment of this program, and continue with --resume"
    )
