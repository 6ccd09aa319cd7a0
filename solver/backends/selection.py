"""Which backend runs, by name or by what the machine has."""

import warnings
from functools import cache

from stridemap.errors import CompilerError, InputError
from stridemap.solver.backends.base import Backend, Kernels
from stridemap.solver.backends.compiler import Compiler
from stridemap.solver.backends.interpreter import Interpreter
from stridemap.solver.backends.lanes import Lanes
from stridemap.solver.backends.scalar import ScalarC
from stridemap.solver.backends.self_check import checked
from stridemap.solver.model.model import Model

BACKENDS: dict[str, Backend] = {"lanes": Lanes(), "scalar": ScalarC(), "interpreter": Interpreter()}
"""By name, the fastest first: several points per instruction, one point at a time, without a compiler."""


def named_backend(backend: str | Backend | None) -> Backend | None:
    """A backend from its name; a backend, or None for the fastest that works, is returned as it is.

    Raises
    ------
    InputError
        When there is no backend of that name.
    """
    if backend is None or isinstance(backend, Backend):
        return backend
    if not isinstance(backend, str) or backend not in BACKENDS:
        raise InputError(f"unknown backend {backend!r}; choose one of {', '.join(BACKENDS)}")
    return BACKENDS[backend]


@cache
def load_kernels(model: Model, backend: Backend | None) -> Kernels:
    """The kernels of a model, on a backend or on the fastest that the machine has.

    The environment variable CC names the compiler; without it, the first of cc, gcc and clang on the path.

    Parameters
    ----------
    model : Model
    backend : Backend or None

    Raises
    ------
    CompilerError
        When the compiler fails, or makes something that does not compute as it was written.
    InputError
        When the C is not the one that the manifest names.
    """
    if backend is not None:
        return checked(backend.kernels(model))
    if Compiler.found() is None:
        warnings.warn(
            "no C compiler found: the kernels run in CasADi's virtual machine, about 20 times slower; "
            "install gcc or clang, or name a compiler in the environment variable CC",
            RuntimeWarning,
            stacklevel=2,
        )
        return Interpreter().kernels(model)
    try:
        return checked(Lanes().kernels(model))
    except CompilerError:  # it knows no C++, or no vectors
        return checked(ScalarC().kernels(model))
