"""Kernels as C for one point at a time: what any C compiler can do."""

import ctypes
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.backends.base import ONE_POINT, Backend, Kernels
from stridemap.solver.backends.compiler import FLAGS, Compiler
from stridemap.solver.backends.shared_library import check, pointers, sizes
from stridemap.solver.kernels.catalogue import KERNELS, Kernel, c_name
from stridemap.solver.model.files import kernels_file
from stridemap.solver.model.model import Model

Array = NDArray[np.float64]


@dataclass(frozen=True)
class ScalarC(Backend):
    """C for one point at a time.

    Parameters
    ----------
    compiler : str, optional
        Command line of the C compiler; by default the one that `Compiler.found` finds where it runs.
    """

    compiler: str | None = None

    @property
    def arithmetic(self) -> str:
        """One point at a time."""
        return ONE_POINT

    def kernels(self, model: Model) -> "ScalarKernels":
        """The kernels of a model."""
        return ScalarKernels(model, self)


class ScalarKernels(Kernels):
    """Kernels as machine code for one point at a time.

    Parameters
    ----------
    model : Model
    backend : ScalarC
    """

    def __init__(self, model: Model, backend: ScalarC) -> None:
        super().__init__(model, backend)
        self._compiler = Compiler.named(backend.compiler)
        name = kernels_file(model.name)
        self._library = self._compiler.library(name, model.text(name), FLAGS)
        self.library = Path(self._library._name)
        names = [c_name(model, kernel) for kernel in KERNELS]
        self._work = {one: (ctypes.c_longlong * 4)(*self._work_size(one)) for one in names}

    @property
    def compiler(self) -> str:
        """Compiler, its version and the flags."""
        return f"{self._compiler.version} {' '.join(FLAGS)}"

    def _work_size(self, name: str) -> list[int]:
        sizes = [ctypes.c_longlong() for _ in range(4)]
        getattr(self._library, f"{name}_work")(*[ctypes.byref(s) for s in sizes])
        return [s.value for s in sizes]

    def _map(self, kernel: Kernel, inputs: list[Array], outputs: list[Array]) -> None:
        n = len(inputs[0])
        failed = np.zeros(n, dtype=np.int32)
        name = c_name(self.model, kernel)
        status = getattr(self._library, f"{self.model.name}_map")(
            getattr(self._library, name), self._work[name], ctypes.c_longlong(n),
            ctypes.c_longlong(len(inputs)), pointers(inputs), sizes(inputs),
            ctypes.c_longlong(len(outputs)), pointers(outputs), sizes(outputs),
            failed.ctypes.data_as(ctypes.c_void_p),
        )  # fmt: skip
        check(status, kernel)
        for out in outputs:
            out[failed != 0] = np.nan
