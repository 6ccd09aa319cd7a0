"""Kernels as C++ that works on several points per instruction, one per lane of the processor's vectors.

CasADi's C has no branches and names its type of number once. As C++, with `Lanes` (lanes.h) for that type,
the same text works on 8 points at a time with AVX-512, on 4 with AVX2, on 2 elsewhere. Newton's method,
which stops when it has converged, is written by hand around it (lockstep.h).

The results do not depend on the processor, nor on which points are in a batch.
"""

import ctypes
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.backends.base import Backend, Kernels
from stridemap.solver.backends.compiler import Compiler, processor_features
from stridemap.solver.backends.shared_library import check, pointers, sizes
from stridemap.solver.kernels.catalogue import BRANCH_FREE, NEWTON, Kernel, Newton, c_name, jacobian, residual
from stridemap.solver.model.files import kernels_file
from stridemap.solver.model.model import Model

Array = NDArray[np.float64]

FLAGS = (
    *(
        "-x",
        "c++",
        "-O1",
        "-std=c++17",
        "-ffp-contract=off",
        "-fno-math-errno",
        "-fno-exceptions",
        "-fno-rtti",
    ),
    *("-Wno-psabi", "-Wno-ignored-attributes", "-fPIC", "-shared"),
)
"""No contraction here either: processors that can and that cannot would differ in the last digits."""

INSTRUCTIONS = (
    (frozenset({"avx512f", "avx512dq", "avx512vl"}), ("-mavx512f", "-mavx512dq", "-mavx512vl")),
    (frozenset({"avx2"}), ("-mavx2",)),
)
"""What a processor must offer for which flags, best first."""


def instruction_flags() -> tuple[str, ...]:
    """Flags for the widest instructions of this processor; none where it does not say what it has."""
    return next((flags for needed, flags in INSTRUCTIONS if needed <= processor_features()), ())


def source(model: Model) -> str:
    """The kernels, and what calls them in lockstep, as one C++ file.

    Parameters
    ----------
    model : Model

    Raises
    ------
    InputError
        When the C is not the one that the manifest names.
    """
    here = Path(__file__).parent
    lanes, driver = ((here / name).read_text(encoding="utf-8") for name in ("lanes.h", "lockstep.h"))
    kernels = model.text(kernels_file(model.name))
    shown = "".join(f"KERNEL({c_name(model, kernel)})\n" for kernel in BRANCH_FREE)
    # What is not shown is not compiled.
    return (
        f"{lanes}\n#define casadi_real Lanes\n#define CASADI_SYMBOL_EXPORT\n"
        f"namespace {{\n{kernels}\n}}\n{driver}\n{shown}"
    )


@dataclass(frozen=True)
class Lanes(Backend):
    """C++ for several points per instruction.

    Parameters
    ----------
    compiler : str, optional
        Command line of the C compiler; by default the one that `Compiler.found` finds where it runs.
    instructions : tuple of str, optional
        Flags for the processor's instructions; by default the widest that it has. The results are the same.
    """

    compiler: str | None = None
    instructions: tuple[str, ...] | None = None

    def __post_init__(self) -> None:
        if self.instructions is not None:
            object.__setattr__(self, "instructions", tuple(self.instructions))

    @property
    def arithmetic(self) -> str:
        """The same on every processor and with every compiler: its sines are its own."""
        return "several points per instruction, without contraction, sines of its own"

    def kernels(self, model: Model) -> "LaneKernels":
        """The kernels of a model."""
        return LaneKernels(model, self)


class LaneKernels(Kernels):
    """Kernels as machine code for several points per instruction.

    Parameters
    ----------
    model : Model
    backend : Lanes
    """

    def __init__(self, model: Model, backend: Lanes) -> None:
        super().__init__(model, backend)
        self._compiler = Compiler.named(backend.compiler)
        wide = instruction_flags() if backend.instructions is None else backend.instructions
        self._library = self._compiler.library(f"{model.name}_lockstep.cpp", source(model), [*FLAGS, *wide])
        self.library = Path(self._library._name)

    @property
    def compiler(self) -> str:
        """Compiler, its version and those flags on which results may depend."""
        return f"{self._compiler.version} {' '.join(FLAGS)}"

    def _map(self, kernel: Kernel, inputs: list[Array], outputs: list[Array]) -> None:
        method = NEWTON.get(kernel)
        if method is None:
            self._apply(kernel, inputs, outputs)
            return
        outputs[0][:] = inputs[0]
        self._newton(method, outputs[0], inputs[1])
        self._apply(method.closing, [outputs[0], inputs[1]], outputs[1:])

    def _newton(self, method: Newton, u: Array, params: Array) -> None:
        """Newton's method from the guesses in `u`, which the solutions replace."""
        derivative = jacobian(method.jacobian_n_rk)
        alike = method.n_rk == method.jacobian_n_rk
        status = self._library.lockstep_newton(
            self._shown(derivative), None if alike else self._shown(residual(method.n_rk)),
            ctypes.c_longlong(len(u)), ctypes.c_longlong(u.shape[1]), ctypes.c_longlong(params.shape[1]),
            ctypes.c_void_p(u.ctypes.data), ctypes.c_void_p(params.ctypes.data),
            ctypes.c_double(method.abstol), ctypes.c_double(method.abstol_step), method.iterations,
        )  # fmt: skip
        check(status, derivative)

    def _apply(self, kernel: Kernel, inputs: list[Array], outputs: list[Array]) -> None:
        """A kernel without branches, point by point."""
        status = self._library.lockstep_map(
            self._shown(kernel), ctypes.c_longlong(len(inputs[0])),
            ctypes.c_longlong(len(inputs)), pointers(inputs), sizes(inputs),
            ctypes.c_longlong(len(outputs)), pointers(outputs), sizes(outputs),
        )  # fmt: skip
        check(status, kernel)

    def _shown(self, kernel: Kernel) -> ctypes.c_void_p:
        """Address of a kernel in the library."""
        shown = ctypes.c_char.in_dll(self._library, f"lockstep_{c_name(self.model, kernel)}")
        return ctypes.c_void_p(ctypes.addressof(shown))
