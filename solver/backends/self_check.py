"""The arithmetic of compiled kernels, looked at once when they are loaded.

A compiler that regards sums as associative, or that assumes that nothing is ever infinite, makes kernels
that are fast and wrong. So one residual is computed operation by operation, in CasADi's virtual machine or in
Python, which round as IEEE 754 says, and what the kernels give there must be the same to the last bit.
"""

import contextlib
import math
import os
import struct
from collections.abc import Callable, Mapping

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from stridemap.errors import CompilerError
from stridemap.services import shown
from stridemap.solver.backends.base import ONE_POINT, Kernels
from stridemap.solver.kernels.catalogue import residual
from stridemap.solver.model.model import Model

Array = NDArray[np.float64]

KERNEL = residual(12)
"""The smallest kernel that has every part of the step map in it."""

PERIODS = (0.37, 0.61, 0.83)
"""Where in the range of periods a residual is looked for that is finite."""

_REMEDY = (
    "set CC to a compiler, or to options, that keep to IEEE 754 (not -ffast-math), or choose the backend "
    "interpreter"
)

CLOSE = 1e-9
"""Relative difference where a kernel has a function that is not known here: it tells wrong from rounded."""


def checked(kernels: Kernels) -> Kernels:
    """`kernels`, if they compute as they were written; found out once for each compiled file.

    Raises
    ------
    CompilerError
        When they do not.
    """
    if kernels.library is None:
        return kernels
    seen = kernels.library.with_suffix(".checked")
    if not os.path.isfile(seen):
        with shown(f"checking the compiled kernels of {kernels.model.name}"):
            check_arithmetic(kernels)
        with contextlib.suppress(OSError):  # where it cannot be noted, it is found out again
            seen.touch()
    check_tiny(kernels)
    return kernels


def check_tiny(kernels: Kernels) -> None:
    """Look whether the smallest numbers are still there: a library may switch them off for the whole process.

    Raises
    ------
    CompilerError
        When they are not.
    """
    if not (np.full(1, np.finfo(np.float64).tiny) / 2 > 0).all():
        raise CompilerError(
            f"the kernels that {kernels.compiler} made switch off the smallest numbers of the whole process; "
            f"{_REMEDY}"
        )


def check_arithmetic(kernels: Kernels) -> None:
    """Compare one residual of compiled kernels with the same operations in Python.

    Parameters
    ----------
    kernels : Kernels

    Raises
    ------
    CompilerError
        When they differ.
    """
    u, p = _points(kernels.model)
    found = kernels.residual(KERNEL.n_rk, u, p)
    function = kernels.functions[KERNEL]
    virtual = np.array([np.ravel(function(a, b).full(), "F") for a, b in zip(u, p, strict=True)])
    if kernels.backend.arithmetic == ONE_POINT:
        same = _same_bits(found, virtual)
    else:
        # One program of all operations may have them in another order than the kernel: with the usual sines
        # it must give what CasADi's virtual machine gives, or it says nothing about the bits.
        program = function.expand()
        plain, exact = (_exact(program, u, p, lanes) for lanes in (False, True))
        known = plain is not None and _same_bits(plain, virtual)
        same = not known or exact is None or _same_bits(found, exact)
    if not (same and _close(found, virtual)):
        raise CompilerError(
            f"the kernels that {kernels.compiler} made do not compute as they were written: a residual of "
            f"the model {kernels.model.name} differs from the same operations in Python; {_REMEDY}"
        )


def _points(model: Model) -> tuple[Array, Array]:
    """Guesses in the search box with periods in their range, and the preset."""
    low, high = model.period_range
    middle, half = np.array([model.spec.search_box[name] for name in model.section]).T
    u = [[*(middle + half * (0.31 - 0.2 * i)), low + share * (high - low)] for i, share in enumerate(PERIODS)]
    return np.array(u), np.tile(model.point({}), (len(u), 1))


def _same_bits(one: Array, other: Array) -> bool:
    missing = np.isnan(one)
    alike = np.array_equal(missing, np.isnan(other))
    return alike and bool(((one == other) | missing).all())


def _close(one: Array, other: Array) -> bool:
    """Whether results agree but for rounding, which a path that diverges makes larger."""
    usual = np.isfinite(other) & (np.abs(other) < 1e3)
    return bool((np.abs(one - other)[usual] <= CLOSE * (1 + np.abs(other[usual]))).all())


# -- the operations, one by one --------------------------------------------------------------------------


def _exact(function: ca.Function, u: Array, p: Array, lanes: bool) -> Array | None:
    """Results at some points, or None where the function has an operation that is not known here."""
    table = _operations(lanes)
    program = [
        (function.instruction_id(i), function.instruction_input(i), function.instruction_output(i))
        for i in range(function.n_instructions())
    ]
    if {op for op, _, _ in program} - {ca.OP_CONST, ca.OP_INPUT, ca.OP_OUTPUT, *table}:
        return None
    constants = {
        i: function.instruction_constant(i) for i, (op, _, _) in enumerate(program) if op == ca.OP_CONST
    }
    rows = [
        _run(program, constants, table, [a.tolist(), b.tolist()], function) for a, b in zip(u, p, strict=True)
    ]
    return np.array(rows)


def _run(
    program: list[tuple[int, list[int], list[int]]],
    constants: Mapping[int, float],
    table: Mapping[int, Callable[..., float]],
    inputs: list[list[float]],
    function: ca.Function,
) -> list[float]:
    work = [0.0] * function.sz_w()
    out = [[0.0] * function.nnz_out(i) for i in range(function.n_out())]
    for i, (op, arguments, results) in enumerate(program):
        if op == ca.OP_CONST:
            work[results[0]] = constants[i]
        elif op == ca.OP_INPUT:
            work[results[0]] = inputs[arguments[0]][arguments[1]]
        elif op == ca.OP_OUTPUT:
            out[results[0]][results[1]] = work[arguments[0]]
        else:
            work[results[0]] = table[op](*[work[a] for a in arguments])
    return [value for one in out for value in one]


def _operations(lanes: bool) -> dict[int, Callable[..., float]]:
    """What CasADi's operations are in C, by their codes."""
    return {
        ca.OP_ASSIGN: lambda a: a,
        ca.OP_ADD: lambda a, b: a + b,
        ca.OP_SUB: lambda a, b: a - b,
        ca.OP_MUL: lambda a, b: a * b,
        ca.OP_DIV: _quotient,
        ca.OP_INV: lambda a: _quotient(1.0, a),
        ca.OP_NEG: lambda a: -a,
        ca.OP_SQ: lambda a: a * a,
        ca.OP_TWICE: lambda a: 2.0 * a,
        ca.OP_FABS: abs,
        ca.OP_SQRT: _or_nan(math.sqrt),
        ca.OP_SIN: (lambda a: _turned(a, 0)) if lanes else _or_nan(math.sin),
        ca.OP_COS: (lambda a: _turned(a, 1)) if lanes else _or_nan(math.cos),
        ca.OP_EXP: _or_nan(math.exp),
        ca.OP_TANH: math.tanh,
        ca.OP_LT: lambda a, b: float(a < b),
        ca.OP_LE: lambda a, b: float(a <= b),
    }


def _quotient(a: float, b: float) -> float:
    if b == 0:
        return math.nan if a == 0 or math.isnan(a) else math.copysign(math.inf, a) * math.copysign(1.0, b)
    return a / b


def _or_nan(function: Callable[[float], float]) -> Callable[[float], float]:
    def value(a: float) -> float:
        try:
            return function(a)
        except ValueError:
            return math.nan
        except OverflowError:
            return math.inf

    return value


def _turned(x: float, quarters: int) -> float:
    """The sine of lanes.h, `quarters` quarter turns further on; operation for operation."""
    if not abs(x) <= 1e6:
        return math.nan
    round_off = float.fromhex("0x1.8p52")
    shifted = x * 0.6366197723675814 + round_off
    n = shifted - round_off
    r = ((x - n * 1.5707963267341256) - n * 6.077100506303966e-11) - n * 2.0222662487959506e-21
    quadrant = struct.unpack("<q", struct.pack("<d", shifted))[0] + quarters
    value = _cosine(r) if quadrant & 1 else _sine(r)
    return -value if quadrant & 2 else value


def _sine(r: float) -> float:
    z = r * r
    rest = -0.16666666666666666 + z * (
        0.008333333333330946
        + z
        * (
            -0.0001984126983675497
            + z * (2.755731610068303e-06 + z * (-2.5051131455427946e-08 + z * 1.591810123027412e-10))
        )
    )
    return r + z * r * rest


def _cosine(r: float) -> float:
    z = r * r
    rest = 0.041666666666666664 + z * (
        -0.0013888888888887395
        + z
        * (
            2.4801587298763433e-05
            + z * (-2.7557317270560326e-07 + z * (2.0876146024689747e-09 + z * -1.1382614868556325e-11))
        )
    )
    return (1.0 - z * 0.5) + z * z * rest
