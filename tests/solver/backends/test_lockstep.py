"""Newton's method in lockstep on a made-up kernel that counts how often it is called."""

import ctypes
from pathlib import Path

import numpy as np
import pytest

from stridemap.solver.backends import lanes
from stridemap.solver.backends.compiler import compile_shared, find_compiler
from tests.oracles.kernels import needs_compiler

pytestmark = [needs_compiler, pytest.mark.quick]

# Two unknowns x, y and a parameter p: R = (x^2 - p, (y - 3) y') with y' = 1, or no number where p is not one.
KERNELS = """
static casadi_int calls = 0;

static int sizes(casadi_int* arg, casadi_int* res, casadi_int* iw, casadi_int* w)
{
    *arg = 2; *res = 2; *iw = 0; *w = 0;
    return 0;
}

static int root(const Lanes** arg, Lanes** res, casadi_int*, Lanes*, int)
{
    calls++;
    const Lanes x = arg[0][0], y = arg[0][1], p = arg[1][0];
    if (res[0]) {
        res[0][0] = 2.0 * x; res[0][1] = 0.0; res[0][2] = 0.0; res[0][3] = 1.0;
    }
    res[1][0] = x * x - p;
    res[1][1] = y - 3.0;
    return 0;
}

static const Kernel kernel = {root, sizes};

extern "C" long long newton(long long n, double* u, const double* p, const double* scale, int iterations)
{
    calls = 0;
    const int status = lockstep_newton(&kernel, NULL, n, 2, 1, u, p, scale, scale, 1e-13, 1e-9, iterations);
    return status ? -1 : calls;
}

extern "C" int lanes() { return LANES; }

extern "C" void solved(double* a, double* b, long long* pivot, long long n)
{
    factorise(a, pivot, n);
    solve_factorised(a, pivot, b, n);
}
"""


@pytest.fixture(scope="module")
def library():
    here = Path(lanes.__file__)
    header, driver = (here.with_name(name).read_text("utf-8") for name in ("lanes.h", "lockstep.h"))
    text = f"{header}\ntypedef long long casadi_int;\n{driver}\n{KERNELS}"
    flags = (*lanes.FLAGS, *lanes.instruction_flags())
    return ctypes.CDLL(str(compile_shared("counted.cpp", text, find_compiler(), flags)))


def newton(library, u, p, iterations=20, scale=(1.0, 1.0)):
    """Solutions from guesses, and how often the kernel was called."""
    u, p, scale = (np.array(x, dtype=np.float64) for x in (u, p, scale))
    library.newton.restype = ctypes.c_longlong
    pointers = [ctypes.c_void_p(x.ctypes.data) for x in (u, p, scale)]
    calls = library.newton(ctypes.c_longlong(len(u)), *pointers, iterations)
    assert calls >= 0
    return u, calls


def test_a_lane_takes_the_next_point_when_it_is_done(library):
    p = np.arange(1.0, 40.0)
    u, calls = newton(library, [[1.0 + x / 2, 0.0] for x in p], p[:, None])
    np.testing.assert_allclose(u, np.stack([np.sqrt(p), np.full(39, 3.0)], axis=1), rtol=1e-14)
    alone = [newton(library, [[1.0 + x / 2, 0.0]], [[x]])[1] for x in p]
    # No more calls than the lanes' shares of the work, but for those that wait for the last point.
    assert calls <= sum(alone) / library.lanes() + max(alone)


def test_what_is_no_number_stops_at_once_and_keeps_its_guess(library):
    guess = [[1.5, np.nan], [np.nan, 1.0], [1.5, 1.0]]
    for p, start in zip([2.0, 2.0, np.nan], guess, strict=True):
        u, calls = newton(library, [start], [[p]])
        np.testing.assert_array_equal(u[0], start)
        assert calls == 1
    # Beside others it changes nothing, and its lane serves the next point.
    many = np.full((40, 2), np.nan)
    many[::5] = [1.5, 1.0]
    u, calls = newton(library, many, np.full((40, 1), 2.0))
    np.testing.assert_allclose(u[::5, 0], np.sqrt(2), rtol=1e-15)
    assert np.isnan(np.delete(u, np.s_[::5], axis=0)).all()
    _, alone = newton(library, [[1.5, 1.0]], [[2.0]])
    assert calls <= (8 * alone + 32) / library.lanes() + alone + 1


def test_a_step_that_is_no_number_is_the_last(library):
    """The derivative is singular at x = 0, so that elimination divides zero by zero."""
    u, calls = newton(library, [[0.0, 1.0]], [[2.0]])
    assert np.isnan(u).any()
    assert calls == 1


def test_it_ends_after_so_many_iterations(library):
    _, calls = newton(library, [[1e6, 1.0]], [[2.0]], iterations=4)
    assert calls == 4


def test_what_is_small_is_small_in_terms_of_the_scales(library):
    """With a scale of 1e6 a residual of 1e-8 is closed: the guess is the solution."""
    near = np.sqrt(2) + 3e-9
    u, calls = newton(library, [[near, 3.0]], [[2.0]], scale=(1e6, 1.0))
    assert (u[0, 0], calls) == (near, 1)
    u, calls = newton(library, [[near, 3.0]], [[2.0]])
    assert u[0, 0] == pytest.approx(np.sqrt(2), abs=3e-16)


@pytest.mark.parametrize("first", [0.0, 1e-17, 1.0])
def test_systems_are_solved_with_interchanged_rows(library, first):
    """Without that a zero in the first place would make everything infinite, and a small number inexact."""
    rng = np.random.default_rng(0)
    for n in (2, 3, 7):
        a, x, pivot = rng.normal(size=(n, n)), rng.normal(size=n), np.zeros(n, dtype=np.int64)
        a[0, 0] = first
        exact, columns = np.linalg.solve(a, x), a.T.copy()
        places = (ctypes.c_void_p(one.ctypes.data) for one in (columns, x, pivot))
        library.solved(*places, ctypes.c_longlong(n))
        np.testing.assert_allclose(x, exact, rtol=1e-10)
