"""Kernels in CasADi's virtual machine: no compiler is needed, and it is about twenty times slower."""

from dataclasses import dataclass

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from stridemap.solver.backends.base import ONE_POINT, Backend, Kernels
from stridemap.solver.kernels.catalogue import Kernel
from stridemap.solver.model.model import Model

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Interpreter(Backend):
    """CasADi's virtual machine."""

    @property
    def arithmetic(self) -> str:
        """That of C for one point at a time: the same operations in the same order."""
        return ONE_POINT

    def kernels(self, model: Model) -> "InterpretedKernels":
        """The kernels of a model."""
        return InterpretedKernels(model, self)


class InterpretedKernels(Kernels):
    """Kernels in CasADi's virtual machine."""

    @property
    def compiler(self) -> str:
        """Names the virtual machine."""
        return f"CasADi {ca.__version__} virtual machine"

    def _map(self, kernel: Kernel, inputs: list[Array], outputs: list[Array]) -> None:
        function = self.functions[kernel]
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
