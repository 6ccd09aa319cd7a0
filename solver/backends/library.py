"""The kernels of a model, loaded in the fastest way that the machine has, and called on arrays of points.

Compiled for several points an instruction (`lockstep`); where the compiler cannot, for one point at a time;
and where there is no C compiler, in CasADi's virtual machine: slower, with one warning.
"""

import ctypes
import shlex
import warnings
from abc import ABC, abstractmethod
from collections.abc import Sequence
from functools import cache

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from stridemap.solver.backends import lanes as lockstep
from stridemap.solver.backends.compiler import FLAGS, CompileError, compile_shared, find_compiler, version
from stridemap.solver.kernels import catalogue as kernels
from stridemap.solver.model.model import Model

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
        outputs = [np.empty((n, function.nnz_out(i))) for i in range(function.n_out())]
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
        self._command = shlex.split(compiler)
        self._library = self._load(compiler)
        self._work = {f.name(): (ctypes.c_longlong * 4)(*self._work_size(f)) for f in self.functions.values()}

    @property
    def compiler(self) -> str:
        """Compiler, its version and the flags."""
        return f"{version(self._command[0])} {' '.join(FLAGS)}"

    def _load(self, compiler: str) -> ctypes.CDLL:
        name = f"{self.model.name}_kernels.c"
        return _loaded(name, self.model.text(name), compiler, FLAGS)

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
        _check(status, name)
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
            except RuntimeError:  # CasADi's word for a breakdown inside a kernel
                for out in outputs:
                    out[i] = np.nan
                continue
            parts = result if isinstance(result, tuple) else (result,)
            for out, part in zip(outputs, parts, strict=True):
                out[i] = part.full().ravel(order="F")


class LockstepKernels(Kernels):
    """Kernels as machine code for several points an instruction; the others differ in the last digits.

    Parameters
    ----------
    model : Model
    compiler : str
        Command line of the C compiler.
    instructions : sequence of str, optional
        Flags for the processor's instructions; by default the widest that it has. The results are the same.
    """

    def __init__(self, model: Model, compiler: str, instructions: Sequence[str] | None = None) -> None:
        super().__init__(model)
        self._command = shlex.split(compiler)
        flags = [*lockstep.FLAGS, *(lockstep.instruction_flags() if instructions is None else instructions)]
        self._library = _loaded(f"{model.name}_lockstep.cpp", lockstep.source(model), compiler, flags)

    @property
    def compiler(self) -> str:
        """Compiler, its version and those flags on which results may depend."""
        return f"{version(self._command[0])} {' '.join(lockstep.FLAGS)}"

    def _map(self, function: ca.Function, inputs: list[Array], outputs: list[Array]) -> None:
        name = function.name().removeprefix(f"{self.model.name}_")
        method = kernels.NEWTON.get(name)
        if method is None:
            self._apply(name, inputs, outputs)
            return
        outputs[0][:] = inputs[0]
        self._newton(method, outputs[0], inputs[1])
        self._apply(method.closing, [outputs[0], inputs[1]], outputs[1:])

    def _newton(self, method: kernels.Newton, u: Array, params: Array) -> None:
        """Newton's method from the guesses in `u`, which the solutions replace."""
        alike = method.steps == method.jacobian_steps
        status = self._library.lockstep_newton(
            self._kernel(f"jacobian_{method.jacobian_steps}"),
            None if alike else self._kernel(f"residual_{method.steps}"),
            ctypes.c_longlong(len(u)), ctypes.c_longlong(u.shape[1]), ctypes.c_longlong(params.shape[1]),
            ctypes.c_void_p(u.ctypes.data), ctypes.c_void_p(params.ctypes.data),
            ctypes.c_double(method.abstol), ctypes.c_double(method.abstol_step), method.iterations,
        )  # fmt: skip
        _check(status, f"jacobian_{method.jacobian_steps}")

    def _apply(self, name: str, inputs: list[Array], outputs: list[Array]) -> None:
        """A kernel without branches, point by point."""
        status = self._library.lockstep_map(
            self._kernel(name), ctypes.c_longlong(len(inputs[0])),
            ctypes.c_longlong(len(inputs)), _pointers(inputs), _sizes(inputs),
            ctypes.c_longlong(len(outputs)), _pointers(outputs), _sizes(outputs),
        )  # fmt: skip
        _check(status, name)

    def _kernel(self, name: str) -> ctypes.c_void_p:
        shown = ctypes.c_char.in_dll(self._library, f"lockstep_{self.model.name}_{name}")
        return ctypes.c_void_p(ctypes.addressof(shown))


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
    try:
        return LockstepKernels(model, compiler)
    except CompileError:  # it knows no C++, or no vectors
        return CompiledKernels(model, compiler)


def _loaded(name: str, text: str, compiler: str, flags: Sequence[str]) -> ctypes.CDLL:
    """A source, compiled or from the cache, as a library of this process."""
    built = compile_shared(name, text, compiler, flags)
    try:
        return ctypes.CDLL(str(built))
    except OSError as error:
        built.unlink(missing_ok=True)
        raise CompileError(
            f"the C compiler {compiler!r} wrote no library that can be loaded ({error}); "
            "set CC to one that works"
        ) from None


def _check(status: int, name: str) -> None:
    if status == 1:
        raise MemoryError(f"no memory for the work space of kernel {name}")
    if status:
        raise RuntimeError(f"kernel {name} broke down")


def _pointers(arrays: list[Array]) -> ctypes.Array:
    return (ctypes.c_void_p * len(arrays))(*[a.ctypes.data for a in arrays])


def _sizes(arrays: list[Array]) -> ctypes.Array:
    return (ctypes.c_longlong * len(arrays))(*[a.shape[1] for a in arrays])
