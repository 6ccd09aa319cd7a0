"""What is made once for all processes of a test run, or once for all runs."""

import contextlib
import pickle
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

try:
    import fcntl
except ImportError:  # not POSIX: the processes may make the same thing twice
    fcntl = None  # type: ignore[assignment]


@contextlib.contextmanager
def alone(path: Path) -> Iterator[None]:
    """Wait until no other process is in here with the same path."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with path.open("w") as file:
        if fcntl is not None:
            fcntl.flock(file, fcntl.LOCK_EX)  # closing the file releases it
        yield


def once(folder: Path, make: Callable[[Path], Any]) -> Any:
    """What ``make(folder)`` returned to the process that came first; the others wait for it."""
    made = folder / "made.pickle"
    with alone(folder.with_suffix(".lock")):
        if not made.exists():
            folder.mkdir(exist_ok=True)
            made.write_bytes(pickle.dumps(make(folder)))
    return pickle.loads(made.read_bytes())
