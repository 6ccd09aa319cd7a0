"""Compiled kernels: built once into a cache, called on arrays of points.

The cache key is the hash of source, flags and compiler, so nothing stale is ever loaded. Where there is
no C compiler, the same kernels run in CasADi's virtual machine: slower, with one warning.
"""

import ctypes
import hashlib
import os
import shlex
import shutil
import subprocess
import tempfile
import warnings
from abc import ABC, abstractmethod
from functools import cache
from pathlib import Path

import casadi as ca
import numpy as np
from numpy.typing import NDArray
from platformdirs import user_cache_path

from stridemap.errors import InputError
from stridemap.solver import kernels
from stridemap.solver.model import Model

FLAGS = ("-O1", "-std=c99", "-ffp-contract=off", "-fPIC", "-shared")
"""Contraction is off, so that compiled code and virtual machine agree to the last bit; higher levels of
optimisation were measured and are not faster on straight-line code."""

Array = NDArray[np.float64]


class Kernels(ABC):
    """The kernels of one model, mapped over arrays of points.

    Parameters
    ----------
    model : Model
    """

    def __init__(self, model: Model) -> None:
        self.model = model
        self.functions = _functions(model)

    @property
    @abstractmethod
    def compiler(self) -> str:
        """Compiler and flags, or what runs in their place."""

    @abstractmethod
    def _map(self, function: ca.Function, inputs: list[Array], outputs: list[Array]) -> None:
        """Call `function` for every point; fills `outputs`."""

    def __call__(self, name: str, *inputs: Array) -> list[Array]:
        """Call kernel `name` at n points.

        Parameters
        ----------
        name : str
        *inputs : ndarray, shape (n, size of the input)
            One array an input, in the kernel's order; a row a point.

        Returns
        -------
        list of ndarray
            One array an output: shape (n, rows), or (n, columns, rows) for a matrix: node by node for
            traces, and transposed for Jacobians. NaN where a point's computation broke down.
        """
        function = self.functions[name]
        n = len(inputs[0])
        arrays = [np.ascontiguousarray(x, dtype=np.float64) for x in inputs]
        for i, array in enumerate(arrays):
            if array.size != n * function.nnz_in(i):
                wanted = function.nnz_in(i)
                raise ValueError(
                    f"{name}: input {function.name_in(i)} has shape {array.shape}, not ({n}, {wanted})"
                )
        outputs = [np.full((n, function.nnz_out(i)), np.nan) for i in range(function.n_out())]
        if n:
            self._map(function, [a.reshape(n, -1) for a in arrays], outputs)
        shapes = [function.size_out(i) for i in range(function.n_out())]
        return [
            out if columns == 1 else out.reshape(n, columns, rows)
            for out, (rows, columns) in zip(outputs, shapes, strict=True)
        ]


class CompiledKernels(Kernels):
    """Kernels as machine code.

    Parameters
    ----------
    model : Model
    compiler : str
        Command line of the C compiler.
    """

    def __init__(self, model: Model, compiler: str) -> None:
        super().__init__(model)
        self._command = [*shlex.split(compiler), *FLAGS]
        built = compile_shared(model.path(f"{model.name}_kernels.c"), compiler)
        try:
            self._library = ctypes.CDLL(str(built))
        except OSError as error:
            built.unlink(missing_ok=True)
            raise InputError(
                f"the C compiler {compiler!r} wrote no library that can be loaded ({error}); "
                "set CC to one that works"
            ) from None
        self._work = {f.name(): (ctypes.c_longlong * 4)(*self._work_size(f)) for f in self.functions.values()}

    @property
    def compiler(self) -> str:
        """Compiler, its version and the flags."""
        return f"{_version(self._command[0])} {' '.join(FLAGS)}"

    def _work_size(self, function: ca.Function) -> list[int]:
        sizes = [ctypes.c_longlong() for _ in range(4)]
        getattr(self._library, f"{function.name()}_work")(*[ctypes.byref(s) for s in sizes])
        return [s.value for s in sizes]

    def _map(self, function: ca.Function, inputs: list[Array], outputs: list[Array]) -> None:
        n = len(inputs[0])
        failed = np.zeros(n, dtype=np.int32)
        name = function.name()
        status = getattr(self._library, f"{self.model.name}_map")(
            getattr(self._library, name), self._work[name], ctypes.c_longlong(n),
            ctypes.c_longlong(len(inputs)), _pointers(inputs), _sizes(inputs),
            ctypes.c_longlong(len(outputs)), _pointers(outputs), _sizes(outputs),
            failed.ctypes.data_as(ctypes.c_void_p),
        )  # fmt: skip
        if status:
            raise MemoryError(f"no memory for the work space of kernel {name}")
        for out in outputs:
            out[failed != 0] = np.nan


class InterpretedKernels(Kernels):
    """Kernels in CasADi's virtual machine."""

    @property
    def compiler(self) -> str:
        """Names the virtual machine."""
        return f"CasADi {ca.__version__} virtual machine"

    def _map(self, function: ca.Function, inputs: list[Array], outputs: list[Array]) -> None:
        for i, row in enumerate(zip(*inputs, strict=True)):
            try:
                result = function(*row)
            except RuntimeError:
                # CasADi's word for a breakdown inside a kernel; the point stays NaN, which means just that.
                continue
            parts = result if isinstance(result, tuple) else (result,)
            for out, part in zip(outputs, parts, strict=True):
                out[i] = part.full().ravel(order="F")


@cache
def _functions(model: Model) -> dict[str, ca.Function]:
    return kernels.build(model)


@cache
def load_kernels(model: Model) -> Kernels:
    """The kernels of a model, compiled if there is a C compiler.

    The environment variable CC names the compiler; without it, the first of cc, gcc and clang on the path.

    Parameters
    ----------
    model : Model

    Raises
    ------
    InputError
        When the compiler fails, or the C is not the one that the manifest names.
    """
    compiler = find_compiler()
    if compiler is None:
        warnings.warn(
            "no C compiler found: the kernels run in CasADi's virtual machine, about 20 times slower; "
            "install gcc or clang, or name a compiler in the environment variable CC",
            RuntimeWarning,
            stacklevel=2,
        )
        return InterpretedKernels(model)
    return CompiledKernels(model, compiler)


def find_compiler() -> str | None:
    """The C compiler's command, or None where there is none.

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
def _version(command: str) -> str:
    try:
        run = subprocess.run([command, "--version"], capture_output=True, text=True, check=False)
    except OSError as error:
        raise InputError(
            f"the C compiler {command!r} cannot be run ({error.strerror}); set CC to one that works"
        ) from None
    return (run.stdout or run.stderr or command).splitlines()[0].strip()


def compile_shared(source: Path, compiler: str) -> Path:
    """Compile a C file into the cache, unless it is there.

    Parameters
    ----------
    source : pathlib.Path
    compiler : str

    Returns
    -------
    pathlib.Path
        The shared library.

    Raises
    ------
    InputError
        When the compiler fails or the cache cannot be written.
    """
    words = shlex.split(compiler)
    key = hashlib.sha256()
    for part in (source.read_bytes(), " ".join([*words, *FLAGS]).encode(), _version(words[0]).encode()):
        key.update(hashlib.sha256(part).digest())
    folder = cache_folder()
    name = f"{source.stem}-{key.hexdigest()[:32]}"
    for library in sorted(folder.glob(f"{name}-*.so")):
        if library.stem == f"{name}-{_digest(library)}":  # to load half a library would end the process
            return library
    try:
        folder.mkdir(parents=True, exist_ok=True)
        # Beside and renamed: another process never sees half a library.
        with tempfile.TemporaryDirectory(dir=folder) as scratch:
            built = Path(scratch) / f"{name}.so"
            run = subprocess.run(
                [*words, *FLAGS, str(source), "-o", str(built), "-lm"],
                capture_output=True,
                text=True,
                check=False,
            )
            if run.returncode or not built.exists():
                said = (run.stderr.strip() or run.stdout.strip() or "it said nothing").splitlines()[0]
                raise InputError(
                    f"the C compiler {compiler!r} failed on {source.name} ({said}); set CC to one that works"
                )
            library = folder / f"{name}-{_digest(built)}.so"
            built.replace(library)
    except OSError as error:
        raise InputError(
            f"cannot write compiled kernels to {folder}: {error.strerror}; "
            "set STRIDEMAP_CACHE to a folder that can be written"
        ) from None
    return library


def _digest(library: Path) -> str:
    return hashlib.sha256(library.read_bytes()).hexdigest()[:16]


def _pointers(arrays: list[Array]) -> ctypes.Array:
    return (ctypes.c_void_p * len(arrays))(*[a.ctypes.data for a in arrays])


def _sizes(arrays: list[Array]) -> ctypes.Array:
    return (ctypes.c_longlong * len(arrays))(*[a.shape[1] for a in arrays])
