"""The kernels' C with complex numbers: derivatives by an imaginary step, without any rule of differentiation.

A step of ``i h`` in a direction makes the imaginary part ``h`` times the derivative, and with h = 1e-30
nothing is lost (W. Squire and G. Trapp 1998, doi:10.1137/S003614459631241X).
"""

import ctypes

import numpy as np

from stridemap.solver.backends.compiler import compile_shared, find_compiler
from stridemap.solver.backends.lanes import FLAGS
from stridemap.solver.kernels.catalogue import c_name
from stridemap.solver.model.files import kernels_file

STEP = 1e-30

NUMBERS = """
#include <complex>
#include <math.h>
#include <stdlib.h>

struct Number {
    std::complex<double> z;
    Number() = default;
    Number(double x) : z(x) {}
    Number(std::complex<double> x) : z(x) {}
    Number& operator+=(Number x) { z += x.z; return *this; }
    Number& operator-=(Number x) { z -= x.z; return *this; }
    Number& operator*=(Number x) { z *= x.z; return *this; }
    Number& operator/=(Number x) { z /= x.z; return *this; }
    explicit operator bool() const { return z.real() != 0; }
};
static inline Number operator-(Number a) { return -a.z; }
static inline Number operator+(Number a, Number b) { return a.z + b.z; }
static inline Number operator-(Number a, Number b) { return a.z - b.z; }
static inline Number operator*(Number a, Number b) { return a.z * b.z; }
static inline Number operator/(Number a, Number b) { return a.z / b.z; }
#define COMPARED(op) \\
    static inline Number operator op(Number a, Number b) { return (double) (a.z.real() op b.z.real()); }
COMPARED(<) COMPARED(<=) COMPARED(>) COMPARED(>=) COMPARED(==) COMPARED(!=)
#define FUNCTION(name) static inline Number name(Number a) { return std::name(a.z); }
FUNCTION(sin) FUNCTION(cos) FUNCTION(tan) FUNCTION(sqrt) FUNCTION(exp) FUNCTION(log) FUNCTION(tanh)
FUNCTION(sinh) FUNCTION(cosh) FUNCTION(asin) FUNCTION(acos) FUNCTION(atan)
static inline Number fabs(Number a) { return a.z.real() < 0 ? -a : a; }
static inline Number fmax(Number a, Number b) { return a.z.real() >= b.z.real() ? a : b; }
#define casadi_real Number
#define CASADI_SYMBOL_EXPORT
namespace {
"""

CALL = """
extern "C" int call_KERNEL(long long n_in, const long long* in_size, const double* in, long long n_out,
    const long long* out_size, double* out)
{
    casadi_int n_arg, n_res, n_iw, n_w;
    KERNEL_work(&n_arg, &n_res, &n_iw, &n_w);
    const Number** arg = (const Number**) calloc(n_arg, sizeof(Number*));
    Number** res = (Number**) calloc(n_res, sizeof(Number*));
    casadi_int* iw = (casadi_int*) calloc(n_iw + 1, sizeof(casadi_int));
    Number* w = (Number*) calloc(n_w + 1, sizeof(Number));
    for (long long j = 0; j < n_in; in += 2 * in_size[j++]) arg[j] = (const Number*) in;
    for (long long j = 0; j < n_out; out += 2 * out_size[j++]) res[j] = (Number*) out;
    const int status = KERNEL(arg, res, iw, w, 0);
    free(arg); free(res); free(iw); free(w);
    return status;
}
"""


def imaginary(model, kernels, functions):
    """Kernels of a model with complex numbers, compiled together.

    Parameters
    ----------
    model : Model
    kernels : sequence of Kernel
    functions : mapping of Kernel to casadi.Function
        The kernels as CasADi has them, for the sizes of their inputs and outputs.

    Returns
    -------
    list of Imaginary
    """
    names = [c_name(model, kernel) for kernel in kernels]
    calls = "".join(CALL.replace("KERNEL", name) for name in names)
    text = f"{NUMBERS}{model.text(kernels_file(model.name))}}}\n{calls}"
    built = compile_shared(f"{model.name}_complex.cpp", text, find_compiler(), [*FLAGS, "-O0"])
    library = ctypes.CDLL(str(built))
    return [
        Imaginary(library[f"call_{name}"], functions[kernel])
        for name, kernel in zip(names, kernels, strict=True)
    ]


class Imaginary:
    """A kernel of a model, with complex numbers."""

    def __init__(self, call, function):
        self.call = call
        self.n_in = [function.nnz_in(i) for i in range(function.n_in())]
        self.shapes = [function.size_out(i) for i in range(function.n_out())]

    def derivative(self, x, direction):
        """Derivatives of all outputs at x, all inputs in one vector, in a direction."""
        values = np.ascontiguousarray(x + 1j * STEP * direction)
        n_out = [rows * columns for rows, columns in self.shapes]
        out = np.zeros(sum(n_out), dtype=np.complex128)
        sizes = [(ctypes.c_longlong * len(n))(*n) for n in (self.n_in, n_out)]
        status = self.call(
            ctypes.c_longlong(len(self.n_in)), sizes[0], ctypes.c_void_p(values.ctypes.data),
            ctypes.c_longlong(len(n_out)), sizes[1], ctypes.c_void_p(out.ctypes.data),
        )  # fmt: skip
        assert status == 0
        parts = np.split(out.imag / STEP, np.cumsum(n_out)[:-1])
        return [
            part.reshape(columns, rows).T for part, (rows, columns) in zip(parts, self.shapes, strict=True)
        ]
