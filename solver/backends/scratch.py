"""A scratch folder that one process has at a time: what all of them need is made once."""

import contextlib
import os
import shutil
from collections.abc import Iterator
from pathlib import Path

try:
    import fcntl
except ImportError:  # Windows
    fcntl = None  # type: ignore[assignment]


@contextlib.contextmanager
def scratch(folder: Path) -> Iterator[Path]:
    """A folder for this process alone: others wait until it is gone. One that was killed holds up nobody.

    Where there are no locks nobody waits, and each process has a folder of its own.

    Parameters
    ----------
    folder : pathlib.Path
        In a folder that is there.

    Yields
    ------
    pathlib.Path
        The folder, which may hold what a process that was killed has left.
    """
    with contextlib.ExitStack() as stack:
        while (descriptor := _locked(folder)) is not None:
            if _is(folder, descriptor):
                stack.callback(os.close, descriptor)
                break
            os.close(descriptor)  # of a folder that is gone: the one before is done
        else:
            folder = folder.with_name(f"{folder.name}.{os.getpid()}")
            folder.mkdir(exist_ok=True)
        stack.callback(shutil.rmtree, folder, ignore_errors=True)
        yield folder


def _locked(folder: Path) -> int | None:
    """The folder, made and locked, as a descriptor; None where there are no locks."""
    while fcntl is not None:
        folder.mkdir(exist_ok=True)
        try:
            descriptor = os.open(folder, os.O_RDONLY)
        except FileNotFoundError:  # taken away meanwhile
            continue
        try:
            fcntl.flock(descriptor, fcntl.LOCK_EX)
        except OSError:
            os.close(descriptor)
            break
        return descriptor
    return None


def _is(folder: Path, descriptor: int) -> bool:
    """Whether what was opened is still the folder of that name."""
    try:
        return os.path.samestat(os.fstat(descriptor), os.stat(folder))
    except FileNotFoundError:
        return False
