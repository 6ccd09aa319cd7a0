"""Residuals in numbers of twice the digits, against the same operations in 40 digits."""

import ctypes
import inspect
import re
from fractions import Fraction
from pathlib import Path

import casadi as ca
import mpmath
import numpy as np
import pytest
from scipy.integrate import DOP853
from scipy.integrate._ivp import dop853_coefficients

from stridemap.solver.backends import lanes
from stridemap.solver.backends.compiler import Compiler
from stridemap.solver.backends.interpreter import Interpreter
from stridemap.solver.backends.lanes import Lanes
from stridemap.solver.kernels.dormand_prince import STAGES
from stridemap.solver.kernels.step_map import StepMap
from stridemap.solver.kernels.tableau import rests
from stridemap.solver.model.loading import available, load
from tests.oracles.kernels import needs_compiler

DIGITS = 40

OPERATIONS = {
    ca.OP_ASSIGN: lambda a: a,
    ca.OP_ADD: lambda a, b: a + b,
    ca.OP_SUB: lambda a, b: a - b,
    ca.OP_MUL: lambda a, b: a * b,
    ca.OP_DIV: lambda a, b: a / b,
    ca.OP_INV: lambda a: 1 / a,
    ca.OP_NEG: lambda a: -a,
    ca.OP_SQ: lambda a: a * a,
    ca.OP_TWICE: lambda a: 2 * a,
    ca.OP_SQRT: mpmath.sqrt,
    ca.OP_SIN: mpmath.sin,
    ca.OP_COS: mpmath.cos,
}


def written_coefficients():
    """The digits of the method's coefficients in SciPy's source, by the doubles that they become."""
    digits = re.findall(r"\d+\.\d+(?:e[-+]?\d+)?", inspect.getsource(dop853_coefficients))
    return {float(one): Fraction(one) for one in digits}


def in_many_digits(function, u, p, n_rk):
    """A function of (u, p), operation by operation."""
    times = {i / n_rk: Fraction(i, n_rk) for i in range(n_rk)}
    exact, work, out = times | written_coefficients(), {}, {}
    for i in range(function.n_instructions()):
        op, arguments = function.instruction_id(i), function.instruction_input(i)
        *_, result = function.instruction_output(i)
        if op == ca.OP_CONST:
            value = function.instruction_constant(i)
            fraction = exact.get(abs(value), Fraction(abs(value)))
            work[result] = mpmath.sign(value) * mpmath.mpf(fraction.numerator) / fraction.denominator
        elif op == ca.OP_INPUT:
            work[result] = mpmath.mpf(float((u, p)[arguments[0]][arguments[1]]))
        elif op == ca.OP_OUTPUT:
            out[result] = work[arguments[0]]
        else:
            work[result] = OPERATIONS[op](*(work[a] for a in arguments))
    return out


def guess(model):
    """A point in the search box with a period."""
    middle, half = np.array([model.spec.search_box[name] for name in model.section]).T
    low, high = model.period_range
    return np.array([[*(middle + 0.11 * half), low + 0.4 * (high - low)]]), model.point({})[None]


@needs_compiler
@pytest.mark.parametrize(
    ("name", "n_rk"),
    [
        pytest.param("simplest_walker", 24, marks=pytest.mark.quick),
        pytest.param("simplest_walker", 60, id="simplest_walker, chained"),
        ("wobbling", 36),
    ],
)
def test_against_forty_digits(name, n_rk):
    model = load(name)
    u, p = guess(model)
    found = Lanes().kernels(model).precise_residual(n_rk, u, p)[0]
    with mpmath.workdps(DIGITS):
        exact = in_many_digits(StepMap(model).residual(n_rk).expand(), u[0], p[0], n_rk)
        off = [float(mpmath.mpf(value) - exact.get(k, 0)) for k, value in enumerate(found.tolist())]
    # Rounded to doubles at the end.
    assert np.abs(found).max() > 1e-3
    assert (np.abs(off) <= 0.51 * np.finfo(float).eps * np.abs(found) + 1e-19).all()


IN_PIECES = ("compass", "simplest_walker", "wobbling")
"""Models for which the pieces of which a long residual is chained are compiled as well."""


@needs_compiler
@pytest.mark.parametrize("name", sorted(available()))
def test_it_is_the_residual(name):
    model = load(name)
    kernels, (u, p) = Lanes().kernels(model), guess(model)
    many = np.repeat(u, 11, axis=0) * np.linspace(0.99, 1.01, 11)[:, None]
    params = np.repeat(p, 11, axis=0)
    for n_rk in (48, 768) if name in IN_PIECES else (48,):
        found = kernels.precise_residual(n_rk, many, params)
        np.testing.assert_allclose(found, kernels.residual(n_rk, many, params), rtol=0, atol=1e-11)
        # No lane looks at another.
        np.testing.assert_array_equal(kernels.precise_residual(n_rk, many[3:4], params[:1])[0], found[3])


@needs_compiler
@pytest.mark.quick
def test_the_same_bits_with_any_instructions(few_kernels):
    model = load("simplest_walker")
    u, p = guess(model)
    found = [Lanes(instructions=one).kernels(model).precise_residual(24, u, p) for one in (None, ())]
    np.testing.assert_array_equal(*found)


def test_not_every_backend_has_them():
    model = load("simplest_walker")
    u, p = guess(model)
    assert np.isnan(Interpreter().kernels(model).precise_residual(24, u, p)).all()


@pytest.mark.quick
def test_coefficients_are_the_published_ones():
    exact, rest = written_coefficients(), rests((24, 36))
    used = {abs(one) for table in (DOP853.A, DOP853.B, DOP853.C) for one in np.ravel(table[:STAGES]).tolist()}
    used = {one for one in used if one in exact and Fraction(one) != exact[one]}
    assert len(used) > 50
    for one in used:
        assert rest[one] == pytest.approx(float(exact[one] - Fraction(one)), rel=1e-12)
    assert rest[1 / 3] == float(Fraction(1, 3) - Fraction(1 / 3))


FUNCTIONS = {
    "sin": (-20.0, 20.0), "cos": (-20.0, 20.0), "tan": (-1.5, 1.5), "exp": (-30.0, 3.0), "log": (0.01, 20.0),
    "sqrt": (0.0, 20.0), "asin": (-0.99, 0.99), "acos": (-0.99, 0.99), "atan": (-5.0, 5.0),
    "sinh": (-3.0, 3.0), "cosh": (-3.0, 3.0), "tanh": (-20.0, 20.0), "fabs": (-1.0, 1.0),
}  # fmt: skip
"""Where each is tried."""


@needs_compiler
def test_functions():
    """Each on a number with a second part, so that it is seen to be used."""
    here = Path(lanes.__file__).parent
    text = "".join((here / name).read_text(encoding="utf-8") for name in ("lanes.h", "pairs.h"))
    for name in FUNCTIONS:
        text += (
            f'\nextern "C" void try_{name}(double x, double rest, double* out)\n'
            f"{{ const Pair y = {name}(Pair(x, rest)); out[0] = y.hi[0]; out[1] = y.lo[0]; }}\n"
        )
    library = Compiler.named(None).library("pairs.cpp", text, lanes.FLAGS)
    rng = np.random.default_rng(3)
    for name, (low, high) in FUNCTIONS.items():
        for x in [*rng.uniform(low, high, 40).tolist(), low, high]:
            rest, out = 0.3 * np.spacing(x), np.zeros(2)
            run = getattr(library, f"try_{name}")
            run(ctypes.c_double(x), ctypes.c_double(rest), ctypes.c_void_p(out.ctypes.data))
            with mpmath.workdps(DIGITS):
                argument = mpmath.mpf(x) + mpmath.mpf(float(rest))
                exact = abs(argument) if name == "fabs" else getattr(mpmath, name)(argument)
                off = float(abs(mpmath.mpf(out[0]) + mpmath.mpf(out[1]) - exact) / (1 + abs(exact)))
            assert off < 2e-19, (name, x, off)


@needs_compiler
def test_the_greater_of_two_and_comparisons():
    here = Path(lanes.__file__).parent
    text = "".join((here / name).read_text(encoding="utf-8") for name in ("lanes.h", "pairs.h"))
    text += """
extern "C" void compare(double a, double more, double* out)
{
    const Pair x(a), y(a, more);
    const Pair all[] = {fmax(x, y), x < y, x <= y, x > y, x >= y, x == y, x != y};
    for (int i = 0; i < 7; i++) { out[2 * i] = all[i].hi[0]; out[2 * i + 1] = all[i].lo[0]; }
}
"""
    library = Compiler.named(None).library("pairs.cpp", text, lanes.FLAGS)
    for more, truths in (
        (1e-20, [1, 1, 0, 0, 0, 1]),
        (-1e-20, [0, 0, 1, 1, 0, 1]),
        (0.0, [0, 1, 0, 1, 1, 0]),
    ):
        out = np.zeros((7, 2))
        library.compare(ctypes.c_double(0.7), ctypes.c_double(more), ctypes.c_void_p(out.ctypes.data))
        assert out[0].tolist() == [0.7, max(more, 0.0)]
        assert out[1:, 0].tolist() == truths
