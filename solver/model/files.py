"""The generated files of a walker: in a folder, or in memory where they came from another process."""

import errno
import os
import stat
import zlib
from abc import ABC, abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import stridemap.generated

MANIFEST = "manifest.json"

GENERATED = Path(stridemap.generated.__file__).parent
"""Folder of the built-in generated walkers."""


def kernels_file(model: str) -> str:
    """Name of the file that holds a model's kernels in C."""
    return f"{model}_kernels.c"


def equations_file(model: str) -> str:
    """Name of the file that holds a model's equations in Python."""
    return f"{model}.py"


LARGEST = 100_000_000
"""Bytes of a file that is read whole: the largest kernels known have 20 million."""


def contents(path: str | Path, largest: int = LARGEST) -> bytes:
    """What a file holds; a pipe that nobody writes into holds nothing, and a device is read to a bound.

    Parameters
    ----------
    path : path
    largest : int
        Bytes that it may have.

    Raises
    ------
    OSError
        When it cannot be read, or is larger.
    """
    descriptor = os.open(path, os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0))
    with open(descriptor, "rb", buffering=0) as file:
        if stat.S_ISDIR(os.fstat(descriptor).st_mode):
            raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR), str(path))
        parts, size = [], 0
        while (part := file.read(1 << 20)) != b"":
            if part is None:  # somebody has the other end of a pipe, and has not written yet
                os.set_blocking(descriptor, True)
                continue
            parts.append(part)
            size += len(part)
            if size > largest:
                raise OSError(errno.EFBIG, f"it has more than {largest / 1e6:g} MB", str(path))
    return b"".join(parts)


class Files(ABC):
    """Where generated files are read from."""

    @abstractmethod
    def read(self, name: str) -> bytes:
        """Contents of a file.

        Raises
        ------
        OSError
            When it cannot be read.
        """

    @property
    @abstractmethod
    def shown(self) -> str:
        """Where they are, for messages."""

    @property
    def builtin(self) -> bool:
        """Whether they come with stridemap."""
        return False

    def path(self, name: str) -> str:
        """Where one of them is, for messages."""
        return str(Path(self.shown) / name)


@dataclass(frozen=True)
class Folder(Files):
    """Generated files in a folder.

    Parameters
    ----------
    folder : pathlib.Path
    """

    folder: Path

    def read(self, name: str) -> bytes:
        """Contents of a file; raises OSError when it cannot be read."""
        return contents(self.folder / name)

    @property
    def shown(self) -> str:
        """The folder."""
        return str(self.folder)

    @property
    def builtin(self) -> bool:
        """Whether they come with stridemap."""
        return self.folder.parent == GENERATED


@dataclass(frozen=True)
class InMemory(Files):
    """Generated files that came along with a piece of work.

    Parameters
    ----------
    contents : mapping of str to bytes
        By name.
    source : str
        Name of the built-in model that they may be of: what was not sent is then read from its folder.
    """

    contents: Mapping[str, bytes]
    source: str

    def read(self, name: str) -> bytes:
        """Contents of a file; raises OSError where it was not sent and is not here either."""
        if name in self.contents:
            return self.contents[name]
        if self.builtin:
            return (GENERATED / self.source / name).read_bytes()
        raise FileNotFoundError(None, "the file was not sent with the model", name)

    @property
    def builtin(self) -> bool:
        """Whether they are those of a model that comes with stridemap here too."""
        try:
            return (GENERATED / self.source / MANIFEST).read_bytes() == self.contents[MANIFEST]
        except OSError:
            return False

    @property
    def shown(self) -> str:
        """They have no place of their own."""
        return "the model that was sent along"


def packed(contents: Mapping[str, bytes]) -> dict[str, bytes]:
    """Files by name, made small to be sent."""
    return {name: zlib.compress(content) for name, content in contents.items()}


def unpacked(pack: Mapping[str, bytes], source: str) -> InMemory:
    """Files that were sent."""
    return InMemory({name: zlib.decompress(content) for name, content in pack.items()}, source)
