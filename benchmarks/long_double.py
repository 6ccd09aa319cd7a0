"""The step map in 80-bit numbers, which round 2,000 times finer than those of the solver.

The pieces of a step that the solver chains are printed by CasADi as C with ``long double`` for its numbers; the
coefficients of the integration have all the digits that SciPy's source writes. Constants of the model stay
the doubles that the solver has, so that both compute the same walker.
"""

import ctypes
import inspect
import re
from typing import NamedTuple

import casadi as ca
import mpmath
import numpy as np
from numpy.typing import NDArray
from scipy.integrate._ivp import dop853_coefficients

from stridemap.solver.backends.compiler import Compiler
from stridemap.solver.kernels.step_map import BLOCK, StepMap
from stridemap.solver.model.model import Model

Long = NDArray[np.longdouble]

FLAGS = ("-O2", "-std=c99", "-ffp-contract=off", "-fPIC", "-shared")

DIGITS = 25
"""Of the eigenvalues' arithmetic."""


class Linearised(NamedTuple):
    """Derivatives of the residuals, shape (n, nz + 1, nz + 1), and residuals, shape (n, nz + 1)."""

    jacobian: Long
    residual: Long


class LongSteps:
    """Residuals of one model with their derivatives.

    Parameters
    ----------
    model : Model
    """

    def __init__(self, model: Model) -> None:
        if np.finfo(np.longdouble).eps > 2e-19:
            raise RuntimeError("long double has no more digits than double here")
        steps = StepMap(model)
        self.functions = {"begin": steps.begin, "swing": steps.swing, "end": steps.end}
        generator = ca.CodeGenerator("long_steps.c", {"with_header": False})
        for function in self.functions.values():
            generator.add(function)
        library = Compiler.named(None).library("long_steps.c", _in_long_double(generator.dump()), FLAGS)
        self._called = {key: _Called(library, function) for key, function in self.functions.items()}

    def jacobian(self, n_rk: int, u: Long, p: Long) -> Linearised:
        """Residuals at section points with periods, shape (n, nz + 1), on `n_rk` RK steps, and derivatives."""
        u, p = (np.ascontiguousarray(one, dtype=np.longdouble) for one in (u, p))
        rows = [self._one(n_rk, *row) for row in zip(u, p, strict=True)]
        return Linearised(*(np.array(one, dtype=np.longdouble) for one in zip(*rows, strict=True)))

    def _one(self, n_rk: int, u: Long, p: Long) -> tuple[Long, Long]:
        (y,) = self._called["begin"](u, p)
        h, swing = u[-1:] / n_rk, self._called["swing"]
        for i in range(0, n_rk, BLOCK):
            (y,) = swing(i * h, h, y, p)
        derivative, residual = self._called["end"](y, u, p)
        return derivative.reshape(len(u), len(u)).T, residual


class _Called:
    """A function of the library, called with arrays of long double."""

    def __init__(self, library: ctypes.CDLL, function: ca.Function) -> None:
        name = function.name()
        sizes = [ctypes.c_longlong() for _ in range(4)]
        getattr(library, f"{name}_work")(*map(ctypes.byref, sizes))
        n_arg, n_res, n_iw, n_w = (size.value for size in sizes)
        self._function = getattr(library, name)
        self._arg, self._res = (ctypes.c_void_p * n_arg)(), (ctypes.c_void_p * n_res)()
        self._iw, self._w = np.empty(n_iw + 1, dtype=np.int64), np.empty(n_w + 1, dtype=np.longdouble)
        self._sizes = [function.nnz_out(i) for i in range(function.n_out())]

    def __call__(self, *inputs: Long) -> list[Long]:
        inputs = tuple(np.ascontiguousarray(one, dtype=np.longdouble) for one in inputs)
        outputs = [np.empty(size, dtype=np.longdouble) for size in self._sizes]
        for i, one in enumerate(inputs):
            self._arg[i] = one.ctypes.data
        for i, one in enumerate(outputs):
            self._res[i] = one.ctypes.data
        work = (ctypes.c_void_p(one.ctypes.data) for one in (self._iw, self._w))
        if self._function(self._arg, self._res, *work, 0):
            raise RuntimeError("a kernel broke down")
        return outputs


def multipliers(jacobian: Long) -> NDArray[np.complex128]:
    """Floquet multipliers, shape (n, nz): rounded when they are known to `DIGITS`, in no order."""
    nz = jacobian.shape[1] - 1
    p_z = jacobian[:, :nz, :nz] + np.eye(nz, dtype=np.longdouble)
    derivative = p_z - jacobian[:, :nz, nz:] * jacobian[:, nz:, :nz] / jacobian[:, nz:, nz:]
    with mpmath.workdps(DIGITS):
        return np.array([_eigenvalues(one) for one in derivative]).reshape(len(jacobian), nz)


def _eigenvalues(matrix: Long) -> list[complex]:
    exact = mpmath.matrix([[_exactly(value) for value in row] for row in matrix])
    values = mpmath.eig(exact, left=False, right=False)
    return [complex(value) for value in values]


def _exactly(value: np.longdouble) -> mpmath.mpf:
    """A long double as a sum of two doubles."""
    high = float(value)
    return mpmath.mpf(high) + mpmath.mpf(float(value - np.longdouble(high)))


def _in_long_double(text: str) -> str:
    """C for doubles as C for long doubles; the coefficients of the integration with all their digits."""
    written = re.findall(r"-?\d+\.\d+(?:e[-+]?\d+)?", inspect.getsource(dop853_coefficients))
    exact = {f"{abs(float(one)):.16e}": f"{one.lstrip('-')}L" for one in written}
    text = re.sub(r"\d\.\d{16}e[-+]\d\d", lambda found: exact.get(found[0], found[0]), text)
    return "#include <tgmath.h>\n#define casadi_real long double\n" + text
