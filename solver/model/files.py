"""The generated files of a walker: in a folder, or in memory where they came from another process."""

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
        return (self.folder / name).read_bytes()

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
