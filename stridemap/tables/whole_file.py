"""Files that are written whole or not at all."""

import contextlib
import os
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import IO


@contextlib.contextmanager
def whole_file(target: Path, *, replace: bool = True) -> Iterator[IO[bytes]]:
    """A file that takes its place when it is complete; one that was there before stays until then.

    Parameters
    ----------
    target : Path
        Folders on the way to it are made.
    replace : bool
        With False it is only tried whether it can be written.

    Raises
    ------
    OSError
        When it cannot.
    """
    target.parent.mkdir(parents=True, exist_ok=True)
    handle, temporary = tempfile.mkstemp(dir=target.parent, prefix=f".{target.name}.")
    try:
        with open(handle, "wb") as file:
            yield file
        if replace:
            mask = os.umask(0)
            os.umask(mask)
            os.chmod(temporary, 0o666 & ~mask)  # mkstemp makes files that only their owner reads
            os.replace(temporary, target)
    finally:
        with contextlib.suppress(OSError):
            os.unlink(temporary)
