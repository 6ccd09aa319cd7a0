"""The C compiler, and the cache of what it compiled.

The cache key is the hash of source, flags and compiler, so nothing stale is ever loaded; flags name the
instructions that a processor must have, so a cache that several machines share serves each what it can run.
"""

import ctypes
import hashlib
import os
import re
import shlex
import shutil
import subprocess
import threading
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from platformdirs import user_cache_path

from stridemap.errors import CompilerError, InputError, StorageError
from stridemap.services import shown
from stridemap.solver.backends.scratch import scratch

FLAGS = ("-O1", "-std=c99", "-ffp-contract=off", "-fPIC", "-shared")
"""Contraction is off, so that compiled code and virtual machine agree to the last bit; higher levels of
optimisation were measured and are not faster on straight-line code."""


CHANGES_ARITHMETIC = re.compile(
    r"-Ofast|-ffast-math|-funsafe-math-optimizations|-ffinite-math-only|-fassociative-math|-freciprocal-math"
    r"|-fno-signed-zeros|-fapprox-func|-fno-honor-(nans|infinities)|-fcx-(limited-range|fortran-rules)"
    r"|-fsingle-precision-constant|-ffp-contract=(?!off).*|-fexcess-precision=(?!standard).*"
    r"|-ffp-model[= ]?(?!strict).*|-fp-model[= ]?.*|-fdenormal-fp-math=(?!ieee).*|-m?fpmath=(?!sse$).*"
    r"|-mfpmath=(?!sse$).*|-mdaz-ftz|-m(no-)?80387|-mno-sse2?|-mrecip.*"
    r"|-mpc(32|64|80)|-menable-unsafe-fp-math|/fp:fast"
)
"""Options under which a compiler does not keep to the arithmetic that was written down."""


COMPILE_SECONDS, VERSION_SECONDS = 1800.0, 60.0
"""After so long a compiler is ended: the largest model known takes two minutes on a slow machine."""

SAID_MAX = 1_000_000
"""Bytes of output after which it is ended: a compiler that says so much does something else."""


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
        return version(_words(self.command)[0])

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
                f"the C compiler {_short(self.command)} did not write a library that can be loaded "
                f"({_first_line(str(error))}); "
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
        if shutil.which(_words(named, "the environment variable CC")[0]) is None:
            raise InputError(
                f"the environment variable CC names {_short(named)}, which is not on the path; unset or "
                "correct it"
            )
        return named
    return next((name for name in ("cc", "gcc", "clang") if shutil.which(name)), None)


def _words(command: str, what: str = "the C compiler") -> list[str]:
    """The words of a compiler's command line, none of which changes arithmetic."""
    try:
        words = shlex.split(command)
    except ValueError as error:
        raise InputError(
            f"{what} = {_short(command)} is not understood ({error}); unset or correct it"
        ) from None
    if not words or "\0" in command:
        raise InputError(f"{what} = {_short(command)} does not name a command; unset or correct it")
    for word in words[1:]:
        if CHANGES_ARITHMETIC.fullmatch(word):
            raise InputError(
                f"{what} = {_short(command)} has the option {_short(word)}, which changes the arithmetic of "
                "the kernels, so that limit cycles are wrong or not found; leave it out"
            )
    return words


def _short(text: str) -> str:
    shown = repr(text)
    return shown if len(shown) <= 100 else f"{shown[:97]}..."


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
        _, said = _run([command, "--version"], VERSION_SECONDS)
    except OSError as error:
        raise InputError(
            f"the C compiler {_short(command)} cannot be run ({error.strerror}); set CC to one that works"
        ) from None
    return _first_line(said) or command


def _run(command: list[str], seconds: float) -> tuple[int, str]:
    """Status and first output of a command, which is ended when it takes too long or says too much."""
    with subprocess.Popen(
        command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT
    ) as process:
        limit = threading.Timer(seconds, process.kill)
        limit.start()
        try:
            said = process.stdout.read(SAID_MAX) if process.stdout else b""
            if len(said) == SAID_MAX:
                process.kill()
            status = process.wait()
        finally:
            limit.cancel()
            process.kill()
    return status, said.decode("utf-8", "replace")


def _first_line(text: str) -> str:
    """The first line with something in it, of bounded length."""
    line = next((line.strip() for line in text.splitlines() if line.strip()), "")
    return line if len(line) <= 200 else f"{line[:197]}..."


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
    command = [*_words(compiler), *flags]
    stem = f"{Path(name).stem}-{_key(text, command)}"
    folder = cache_folder()
    try:
        if (library := _made(folder, stem)) is not None:
            return library
        folder.mkdir(parents=True, exist_ok=True)
        # Beside and renamed: another process never sees half a library. One compiles, and the others wait.
        with scratch(folder / stem) as own:
            if (library := _made(folder, stem)) is not None:
                return library
            source, built = own / name, own / f"{stem}.so"
            source.write_text(text, encoding="utf-8")
            with shown(f"compiling the kernels ({name})", announced=True):
                status, said = _run([*command, str(source), "-o", str(built), "-lm"], COMPILE_SECONDS)
            if status or not built.is_file():
                raise CompilerError(
                    f"the C compiler {_short(compiler)} failed on {name} "
                    f"({_first_line(said) or 'without a message'}); set CC to one that works"
                )
            library = folder / f"{stem}-{_digest(built)}.so"
            built.replace(library)
    except OSError as error:
        raise StorageError(
            f"cannot write compiled kernels to {folder}: {error.strerror or error}; "
            "set STRIDEMAP_CACHE to a folder that can be written"
        ) from None
    return library


def _made(folder: Path, stem: str) -> Path | None:
    """A library in the cache that is whole: to load half of one would end the process."""
    for library in sorted(folder.glob(f"{stem}-*.so")):
        # To read a pipe or a device would never end.
        if os.path.isfile(library) and library.stem == f"{stem}-{_digest(library)}":
            return library
    return None


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
