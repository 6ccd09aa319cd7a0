"""How arrays of points are handed to a shared library, and what its return values mean."""

import ctypes

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.kernels.catalogue import Kernel

Array = NDArray[np.float64]


def pointers(arrays: list[Array]) -> ctypes.Array:
    """Addresses of arrays."""
    return (ctypes.c_void_p * len(arrays))(*[a.ctypes.data for a in arrays])


def sizes(arrays: list[Array]) -> ctypes.Array:
    """Numbers per point of each array."""
    return (ctypes.c_longlong * len(arrays))(*[a.shape[1] for a in arrays])


def check(status: int, what: Kernel | str) -> None:
    """Raise what a return value stands for.

    Parameters
    ----------
    status : int
    what : Kernel or str
        What was called.

    Raises
    ------
    MemoryError
        When there was no memory for the work space.
    RuntimeError
        When a kernel broke down.
    """
    name = what if isinstance(what, str) else f"kernel {what.name}"
    if status == 1:
        raise MemoryError(f"not enough memory for {name}")
    if status:
        raise RuntimeError(f"{name} broke down")
