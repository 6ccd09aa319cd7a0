"""The C compiler, and the cache of what it compiled.

The cache key is the hash of source, flags and compiler, so nothing stale is ever loaded; flags name the
instructions that a processor must have, so a cache that several machines share serves each what it can run.
"""

import ctypes
import hashlib
import os
import shlex
import shutil
import subprocess
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from platformdirs import user_cache_path

from stridemap.errors import CompilerError, InputError, StorageError

FLAGS = ("-O1", "-std=c99", "-ffp-contract=off", "-fPIC", "-shared")
"""Contraction is off, so that compiled code and virtual machine agree to the last bit; higher levels of
optimisation were measured and are not faster on straight-line code."""


@dataclass(frozen=True)
class Compiler:
    """A C compiler.

    Parameters
    ----------
    command : str
        Its command line.
    """

    command: str

    @classmethod
    def found(cls) -> "Compiler | None":
        """The one that the environment variable CC names, or else the first of cc, gcc and clang on the path.

        Raises
        ------
        InputError
            When CC names a command that does not exist.
        """
        command = find_compiler()
        return None if command is None else cls(command)

    @classmethod
    def named(cls, command: str | None) -> "Compiler":
        """The one with this command line; without it, the one that is found.

        Raises
        ------
        CompilerError
            When no compiler is found.
        """
        compiler = cls.found() if command is None else cls(command)
        if compiler is None:
            raise CompilerError("no C compiler was found here; install gcc or clang, or set CC to one")
        return compiler

    @property
    def version(self) -> str:
        """First line of its ``--version`` output."""
        return version(shlex.split(self.command)[0])

    def library(self, name: str, text: str, flags: Sequence[str]) -> ctypes.CDLL:
        """A source, compiled or from the cache, as a library of this process.

        Parameters
        ----------
        name : str
            File name of the source.
        text : str
            The source.
        flags : sequence of str

        Raises
        ------
        CompilerError
            When the compiler fails, or what it wrote cannot be loaded.
        """
        built = compile_shared(name, text, self.command, flags)
        try:
            return ctypes.CDLL(str(built))
        except OSError as error:
            built.unlink(missing_ok=True)
            raise CompilerError(
                f"the C compiler {self.command!r} did not write a library that can be loaded ({error}); "
                "set CC to one that works"
            ) from None


def find_compiler() -> str | None:
    """The C compiler's command, or None where none is found.

    Raises
    ------
    InputError
        When CC names a command that does not exist.
    """
    named = os.environ.get("CC", "").strip()
    if named:
        try:
            words = shlex.split(named)
        except ValueError as error:
            raise InputError(
                f"the environment variable CC = {named} is not understood ({error}); unset or correct it"
            ) from None
        if shutil.which(words[0]) is None:
            raise InputError(
                f"the environment variable CC names {named!r}, which is not on the path; unset or correct it"
            )
        return named
    return next((name for name in ("cc", "gcc", "clang") if shutil.which(name)), None)


def cache_folder() -> Path:
    """Where compiled kernels are kept; the environment variable STRIDEMAP_CACHE overrides it."""
    return Path(os.environ.get("STRIDEMAP_CACHE") or user_cache_path("stridemap"))


@cache
def version(command: str) -> str:
    """First line of what a compiler says of itself.

    Raises
    ------
    InputError
        When it cannot be run.
    """
    try:
        run = subprocess.run([command, "--version"], capture_output=True, text=True, check=False)
    except OSError as error:
        raise InputError(
            f"the C compiler {command!r} cannot be run ({error.strerror}); set CC to one that works"
        ) from None
    return (run.stdout or run.stderr or command).splitlines()[0].strip()


@cache
def processor_features() -> frozenset[str]:
    """Instruction sets that the processor and the system offer, where Linux names them; empty elsewhere."""
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
    except OSError:
        return frozenset()
    named = (line.split(":", 1)[1].split() for line in lines if line.startswith(("flags", "Features")))
    return frozenset(next(named, []))


def compile_shared(name: str, text: str, compiler: str, flags: Sequence[str] = FLAGS) -> Path:
    """Compile a source into the cache, unless it is there.

    Parameters
    ----------
    name : str
        File name of the source.
    text : str
        The source.
    compiler : str
        Command line of the compiler.
    flags : sequence of str

    Returns
    -------
    pathlib.Path
        The shared library.

    Raises
    ------
    CompilerError
        When the compiler fails.
    InputError
        When it cannot be run.
    StorageError
        When the cache cannot be written.
    """
    command = [*shlex.split(compiler), *flags]
    stem = f"{Path(name).stem}-{_key(text, command)}"
    folder = cache_folder()
    for library in sorted(folder.glob(f"{stem}-*.so")):
        if library.stem == f"{stem}-{_digest(library)}":  # to load half a library would end the process
            return library
    try:
        folder.mkdir(parents=True, exist_ok=True)
        # Beside and renamed: another process never sees half a library.
        with tempfile.TemporaryDirectory(dir=folder) as scratch:
            source, built = Path(scratch) / name, Path(scratch) / f"{stem}.so"
            source.write_text(text, encoding="utf-8")
            run = subprocess.run(
                [*command, str(source), "-o", str(built), "-lm"], capture_output=True, text=True, check=False
            )
            if run.returncode or not built.exists():
                said = (run.stderr.strip() or run.stdout.strip() or "without a message").splitlines()[0]
                raise CompilerError(
                    f"the C compiler {compiler!r} failed on {name} ({said}); set CC to one that works"
                )
            library = folder / f"{stem}-{_digest(built)}.so"
            built.replace(library)
    except OSError as error:
        raise StorageError(
            f"cannot write compiled kernels to {folder}: {error.strerror}; "
            "set STRIDEMAP_CACHE to a folder that can be written"
        ) from None
    return library


def _key(text: str, command: list[str]) -> str:
    parts = [text, " ".join(command), version(command[0])]
    if any("native" in word for word in command):
        parts.append(" ".join(sorted(processor_features())))
    key = hashlib.sha256()
    for part in parts:
        key.update(hashlib.sha256(part.encode()).digest())
    return key.hexdigest()[:32]


def _digest(library: Path) -> str:
    return hashlib.sha256(library.read_bytes()).hexdigest()[:16]
