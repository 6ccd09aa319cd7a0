"""Limit cycles to many more digits than the solver has, to hold its error bars against.

CasADi prints the pieces of a step as C with other numbers than doubles: the derivatives in 80 bits, the
residuals, which decide the cycle, in 113 bits. The coefficients of the integration have all the digits that
SciPy's source writes. Constants of the model stay the doubles that the solver has, so that both compute the
same walker. No code is shared with what the solver computes its error bars from.
"""

import ctypes
import inspect
import re
from collections.abc import Iterable
from typing import NamedTuple

import casadi as ca
import mpmath
import numpy as np
from numpy.typing import NDArray
from scipy.integrate._ivp import dop853_coefficients

from stridemap.solver.backends.compiler import Compiler
from stridemap.solver.kernels.step_map import BLOCK, StepMap
from stridemap.solver.model.model import Model

Long = np.longdouble
Numbers = NDArray[np.longdouble]

FLAGS = ("-O2", "-std=gnu99", "-ffp-contract=off", "-fPIC", "-shared", "-Wl,--no-as-needed,-lquadmath")

DIGITS = 25
"""Of the eigenvalues' arithmetic."""

CORRECTIONS = 12
"""Of a cycle at one resolution at most."""

SAME, FINEST = 3e-16, 6144
"""Change of a cycle that is none, and the last resolution."""


class Exact(NamedTuple):
    """Section points with periods, shape (n, nz + 1), and multipliers, shape (n, nz)."""

    u: Long
    multipliers: NDArray[np.complex128]


class Reference:
    """Limit cycles of one model to many digits.

    Parameters
    ----------
    model : Model
    n_rk : int
        RK steps per step of the walker to begin with.
    """

    def __init__(self, model: Model, n_rk: int = 384) -> None:
        if np.finfo(np.longdouble).eps > 2e-19:
            raise RuntimeError("long double has no more digits than double here")
        self.model, self.n_rk = model, n_rk
        steps = StepMap(model)
        pieces = {"begin": steps.begin, "swing": steps.swing, "end": steps.end}
        text = "#include <tgmath.h>\n#define casadi_real long double\n" + _printed(pieces.values(), "L")
        library = Compiler.named(None).library("long_steps.c", text, FLAGS)
        self._called = {key: _Called(library, function) for key, function in pieces.items()}
        text = QUADRUPLE + _printed(steps.plain_pieces(), "Q") + RESIDUAL.replace("MODEL", model.name)
        self._residual = Compiler.named(None).library("quadruple.c", text, FLAGS).residual

    def cycles(self, u: NDArray[np.float64], params: NDArray[np.float64]) -> Exact:
        """The cycles near some points, corrected until that changes nothing.

        Parameters
        ----------
        u : ndarray, shape (n, nz + 1)
        params : ndarray, shape (n, n_params)
        """
        rows = [self._cycle(*row) for row in zip(u.astype(Long), params.astype(Long), strict=True)]
        exact, jacobians = (np.array(one, dtype=Long) for one in zip(*rows, strict=True))
        return Exact(exact, _multipliers(jacobians))

    def _cycle(self, u: Numbers, p: Numbers) -> tuple[Numbers, Numbers]:
        """A cycle and the derivative of its residual, on so many RK steps that more change nothing."""
        n_rk = self.n_rk
        jacobian = self._jacobian(n_rk, u, p)
        while True:
            last = np.inf
            for _ in range(CORRECTIONS):
                step = np.linalg.solve(jacobian.astype(float), self._closing(n_rk, u, p).astype(float))
                if np.abs(step).max() >= 0.5 * last:
                    break
                u, last = u - step, np.abs(step).max()
                jacobian = self._jacobian(n_rk, u, p)
                if last < SAME:
                    break
            change = np.linalg.solve(jacobian.astype(float), self._closing(2 * n_rk, u, p).astype(float))
            if np.abs(change).max() < SAME or n_rk == FINEST:
                return u, jacobian
            n_rk *= 2

    def _closing(self, n_rk: int, u: Numbers, p: Numbers) -> Numbers:
        out, sizes = np.empty_like(u), (n_rk, BLOCK, len(u), len(p), 2 * len(self.model.coordinates))
        arrays = (np.ascontiguousarray(one) for one in (u, p, out))
        self._residual(*map(ctypes.c_longlong, sizes), *(ctypes.c_void_p(one.ctypes.data) for one in arrays))
        return out

    def _jacobian(self, n_rk: int, u: Numbers, p: Numbers) -> Numbers:
        (y,) = self._called["begin"](u, p)
        h, swing = u[-1:] / n_rk, self._called["swing"]
        for i in range(0, n_rk, BLOCK):
            (y,) = swing(i * h, h, y, p)
        derivative, _ = self._called["end"](y, u, p)
        return derivative.reshape(len(u), len(u)).T


QUADRUPLE = """
#include <math.h>
#include <quadmath.h>
#define casadi_real __float128
#define CASADI_SYMBOL_EXPORT static
#define sin sinq
#define cos cosq
#define tan tanq
#define sqrt sqrtq
#define exp expq
#define log logq
#define asin asinq
#define acos acosq
#define atan atanq
#define sinh sinhq
#define cosh coshq
#define tanh tanhq
"""

RESIDUAL = """
typedef int (*Sizes)(casadi_int*, casadi_int*, casadi_int*, casadi_int*);
typedef int (*Piece)(const __float128**, __float128**, casadi_int*, __float128*, int);

static void run(Piece piece, Sizes sizes, const __float128** in, int n_in, __float128* out)
{
    casadi_int n_arg, n_res, n_iw, n_w;
    sizes(&n_arg, &n_res, &n_iw, &n_w);
    const __float128* arg[n_arg + 1];
    __float128 *res[n_res + 1], w[n_w + 1];
    casadi_int iw[n_iw + 1];
    for (int i = 0; i < n_in; i++) arg[i] = in[i];
    res[0] = out;
    piece(arg, res, iw, w, 0);
}

void residual(long long n_rk, long long block, long long nu, long long np, long long ny, const long double* u,
    const long double* p, long double* out)
{
    __float128 point[nu], params[np + 1], y[ny], next[ny], closing[nu], t, h;
    for (int i = 0; i < nu; i++) point[i] = u[i];
    for (int i = 0; i < np; i++) params[i] = p[i];
    h = point[nu - 1] / n_rk;
    run(MODEL_plain_begin, MODEL_plain_begin_work, (const __float128*[]){point, params}, 2, y);
    for (long long i = 0; i < n_rk; i += block) {
        t = i * h;
        run(MODEL_plain_swing, MODEL_plain_swing_work, (const __float128*[]){&t, &h, y, params}, 4, next);
        for (int k = 0; k < ny; k++) y[k] = next[k];
    }
    run(MODEL_plain_end, MODEL_plain_end_work, (const __float128*[]){y, point, params}, 3, closing);
    for (int i = 0; i < nu; i++) out[i] = closing[i];
}
"""


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

    def __call__(self, *inputs: Numbers) -> list[Numbers]:
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


def _multipliers(jacobian: Numbers) -> NDArray[np.complex128]:
    """Floquet multipliers, shape (n, nz): rounded when they are known to `DIGITS`, in no order."""
    nz = jacobian.shape[1] - 1
    p_z = jacobian[:, :nz, :nz] + np.eye(nz, dtype=Long)
    derivative = p_z - jacobian[:, :nz, nz:] * jacobian[:, nz:, :nz] / jacobian[:, nz:, nz:]
    with mpmath.workdps(DIGITS):
        return np.array([_eigenvalues(one) for one in derivative]).reshape(len(jacobian), nz)


def _eigenvalues(matrix: Numbers) -> list[complex]:
    exact = mpmath.matrix([[_exactly(value) for value in row] for row in matrix])
    values = mpmath.eig(exact, left=False, right=False)
    return [complex(value) for value in values]


def _exactly(value: np.longdouble) -> mpmath.mpf:
    """A long double as a sum of two doubles."""
    high = float(value)
    return mpmath.mpf(high) + mpmath.mpf(float(value - np.longdouble(high)))


def _printed(functions: Iterable[ca.Function], suffix: str) -> str:
    """C of functions, in which the coefficients of the integration have all their digits."""
    generator = ca.CodeGenerator("pieces.c", {"with_header": False})
    for function in functions:
        generator.add(function)
    written = re.findall(r"-?\d+\.\d+(?:e[-+]?\d+)?", inspect.getsource(dop853_coefficients))
    exact = {f"{abs(float(one)):.16e}": f"{one.lstrip('-')}{suffix}" for one in written}
    return re.sub(r"\d\.\d{16}e[-+]\d\d", lambda found: exact.get(found[0], found[0]), generator.dump())
