"""One sweep at a time in a folder: who writes into it says so, until it ends or is killed."""

import contextlib
import json
import os
import socket
from collections.abc import Iterator
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from stridemap.errors import InputError, StorageError, short
from stridemap.sweeps.store import PARTS

try:
    import fcntl
except ImportError:  # Windows
    fcntl = None  # type: ignore[assignment]

LOCK = "lock"
"""Name of the file, beside the finished pieces of a sweep; it is gone when no sweep runs."""


def refuse_if_held(folder: str | Path) -> None:
    """Refuse a folder that another sweep is writing into; nothing is touched.

    Raises
    ------
    InputError
        With who it is, where and since when.
    """
    path = Path(folder) / PARTS / LOCK
    if os.path.isfile(path):
        with _open(path, os.O_RDONLY) as descriptor:
            _take(descriptor, path)


@contextlib.contextmanager
def held(folder: str | Path) -> Iterator[None]:
    """Hold the folder of a sweep, which must be there, for as long as the context lasts.

    Raises
    ------
    InputError
        When another sweep holds it.
    StorageError
        When the lock cannot be written.
    """
    path = Path(folder) / PARTS / LOCK
    with contextlib.ExitStack() as stack:
        for _ in range(10):  # the one before may just be taking its file away
            descriptor = stack.enter_context(_open(path, os.O_RDWR | os.O_CREAT))
            _take(descriptor, path)
            with contextlib.suppress(FileNotFoundError):
                if os.path.samestat(os.fstat(descriptor), os.stat(path)):
                    break
        own = {
            "pid": os.getpid(),
            "host": socket.gethostname(),
            "since": f"{datetime.now(UTC):%Y-%m-%d %H:%M UTC}",
            "begun": _begun(os.getpid()),
        }
        try:
            os.ftruncate(descriptor, 0)
            os.pwrite(descriptor, json.dumps(own).encode(), 0)
        except OSError as error:
            raise _cannot(path, error) from None
        try:
            yield
        finally:
            with contextlib.suppress(OSError):
                path.unlink()
            with contextlib.suppress(OSError):  # the last to leave; other files in there keep it
                if (Path(folder) / "orbits.parquet").exists():
                    path.parent.rmdir()


@contextlib.contextmanager
def _open(path: Path, flags: int) -> Iterator[int]:
    try:
        descriptor = os.open(path, flags | getattr(os, "O_NONBLOCK", 0), 0o666)
    except OSError as error:
        raise _cannot(path, error) from None
    try:
        yield descriptor
    finally:
        os.close(descriptor)


def _take(descriptor: int, path: Path) -> None:
    """Take the lock, unless somebody has it: the system knows that of this machine, the file of others."""
    if fcntl is not None:
        try:
            fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise _refusal(path, _holder(descriptor)) from None
        except OSError:  # a file system without locks
            pass
    holder = _holder(descriptor)
    if holder and not _gone(holder, locked=fcntl is not None):
        raise _refusal(path, holder)


def _holder(descriptor: int) -> dict[str, Any]:
    """What the one who holds a lock wrote into it; empty where that cannot be read."""
    try:
        found = json.loads(os.pread(descriptor, 4096, 0))
    except (OSError, ValueError, RecursionError):
        return {}
    return found if isinstance(found, dict) else {}


def _gone(holder: dict[str, Any], locked: bool) -> bool:
    """Whether the process that held a lock is known to have ended."""
    if holder.get("host") != socket.gethostname():
        return False
    if locked:  # the system gave us the lock, so that nobody on this machine has it
        return True
    pid = holder.get("pid")
    if not isinstance(pid, int) or pid <= 0:
        return True
    try:
        os.kill(pid, 0)
    except (ProcessLookupError, OverflowError):
        return True
    except OSError:
        return False
    return bool(holder.get("begun")) and holder["begun"] != _begun(pid)


def _begun(pid: int) -> str:
    """When a process began, as the system counts it, so that one of the same number is not taken for it."""
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[19]
    except (OSError, IndexError):
        return ""


def _refusal(path: Path, holder: dict[str, Any]) -> InputError:
    pid, host, since = (short(holder.get(key, "unknown"), 60).strip("'") for key in ("pid", "host", "since"))
    return InputError(
        f"another sweep is writing into {path.parent.parent} (process {pid} on {host}, since {since}); wait "
        f"for it, or give another folder; if that machine is lost, delete {path}"
    )


def _cannot(path: Path, error: OSError) -> StorageError:
    return StorageError(f"cannot write {path} ({error.strerror or error}); give a folder that can be written")
