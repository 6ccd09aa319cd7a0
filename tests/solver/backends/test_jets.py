"""Numbers that carry derivatives, function by function, against derivatives at 50 digits."""

import ctypes
from pathlib import Path

import mpmath
import numpy as np
import pytest

from stridemap.solver.backends import lanes
from stridemap.solver.backends.compiler import compile_shared, find_compiler
from tests.oracles.kernels import needs_compiler

pytestmark = [needs_compiler, pytest.mark.quick]

RANGES = {
    "sin": (-3, 3), "cos": (-3, 3), "tan": (-1.2, 1.2), "sqrt": (0.2, 4), "exp": (-2, 2), "log": (0.2, 4),
    "asin": (-0.8, 0.8), "acos": (-0.8, 0.8), "atan": (-3, 3), "sinh": (-2, 2), "cosh": (-2, 2),
    "tanh": (-2, 2), "fabs": (-2, -0.1),
}  # fmt: skip
OPERATIONS = {
    "+": lambda x, y: x + y,
    "-": lambda x, y: x - y,
    "*": lambda x, y: x * y,
    "/": lambda x, y: x / y,
}

CALLS = "".join(f"case {i}: return {name}(x);\n" for i, name in enumerate(RANGES))
BINARY = "".join(f"case {i}: return x {sign} y;\n" for i, sign in enumerate(OPERATIONS))
CODE = f"""
static Jet one(int which, Jet x) {{ switch (which) {{ {CALLS} }} return Jet(0.0); }}
static Jet two(int which, Jet x, Jet y) {{ switch (which) {{ {BINARY} }} return fmax(x, y); }}
static Jet read(const double* x) {{ return Jet(Lanes(x[0]), Lanes(x[1]), Lanes(x[2]), Lanes(x[3])); }}
static void write(Jet from, double* to)
{{
    to[0] = from.x.v[0]; to[1] = from.a.v[0]; to[2] = from.b.v[0]; to[3] = from.ab.v[0];
}}
extern "C" void unary(int which, const double* x, double* out) {{ write(one(which, read(x)), out); }}
extern "C" void binary(int which, const double* x, const double* y, double* out)
{{
    write(two(which, read(x), read(y)), out);
}}
"""


@pytest.fixture(scope="module")
def library():
    here = Path(lanes.__file__)
    text = "".join(here.with_name(name).read_text("utf-8") for name in ("lanes.h", "jets.h")) + CODE
    return ctypes.CDLL(str(compile_shared("jets.cpp", text, find_compiler(), lanes.FLAGS)))


def called(function, which, *jets):
    out = np.empty(4)
    pointers = [ctypes.c_void_p(x.ctypes.data) for x in (*jets, out)]
    function(which, *pointers)
    return out


def expected(function, *jets):
    """Value, both first derivatives and the mixed one along ``x + a s + b t + ab s t``, at 50 digits."""
    with mpmath.workdps(50):
        numbers = [[mpmath.mpf(float(v)) for v in jet] for jet in jets]

        def along(s, t):
            return function(*(x + a * s + b * t + ab * s * t for x, a, b, ab in numbers))

        orders = [(0, 0), (1, 0), (0, 1), (1, 1)]
        return np.array([float(mpmath.diff(along, (0, 0), order)) for order in orders])


@pytest.mark.parametrize("name", RANGES)
def test_functions(library, name):
    rng = np.random.default_rng(11)
    for x in rng.uniform(*RANGES[name], 5):
        jet = np.array([x, *rng.normal(size=3)])
        exact = expected(getattr(mpmath, name), jet)
        seen = called(library.unary, list(RANGES).index(name), jet)
        np.testing.assert_allclose(seen, exact, rtol=1e-13, atol=1e-13 * np.abs(exact).max())


@pytest.mark.parametrize("sign", OPERATIONS)
def test_operations(library, sign):
    rng = np.random.default_rng(12)
    for _ in range(5):
        one, other = rng.normal(size=(2, 4))
        seen = called(library.binary, list(OPERATIONS).index(sign), one, other)
        exact = expected(OPERATIONS[sign], one, other)
        np.testing.assert_allclose(seen, exact, rtol=1e-13, atol=1e-13 * np.abs(exact).max())


def test_the_larger_of_two_is_one_of_them(library):
    one, other = np.random.default_rng(13).normal(size=(2, 4))
    larger = one if one[0] > other[0] else other
    for pair in ((one, other), (other, one)):
        np.testing.assert_array_equal(called(library.binary, len(OPERATIONS), *pair), larger)
    np.testing.assert_array_equal(
        called(library.unary, list(RANGES).index("fabs"), one * 0 + 2)[1:], [2, 2, 2]
    )
