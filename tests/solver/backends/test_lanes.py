"""Kernels that work on several points per instruction: the same numbers, whatever is beside them."""

import ctypes
import itertools
import os
import re
import shutil
import subprocess
from pathlib import Path

import mpmath
import numpy as np
import pytest

from stridemap.errors import CompilerError
from stridemap.solver.api.points import find_orbits
from stridemap.solver.backends import lanes
from stridemap.solver.backends.compiler import compile_shared, find_compiler, processor_features
from stridemap.solver.backends.lanes import Lanes
from stridemap.solver.backends.scalar import ScalarC
from stridemap.solver.cycles.search import find_all
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.kernels import catalogue
from stridemap.solver.linear import solved
from stridemap.solver.model.loading import load
from stridemap.solver.model.scales import Scales
from stridemap.solver.options import SearchOptions
from tests.oracles.kernels import KERNELS, assert_same_bits, cases, needs_compiler
from tests.oracles.reference import REFERENCE, section_point

pytestmark = needs_compiler

INSTRUCTION_SETS = [
    (),
    *(flags for needed, flags in reversed(lanes.INSTRUCTIONS) if needed <= processor_features()),
]
"""What this processor can run: it knows two lanes in any case."""

each_instruction_set = pytest.mark.parametrize(
    ("name", "instructions"),
    [
        pytest.param(name, flags, id=f"{flags[0] if flags else 'baseline'}-{name}")
        for name, flags in zip(itertools.cycle(["compass", "wobbling"]), INSTRUCTION_SETS, strict=False)
    ],
)
"""With one of two models each: to compile one takes some seconds."""


# -- sine and cosine -------------------------------------------------------------------------------------

SINES = """
extern "C" void sines(long long n, const double* x, double* s, double* c)
{
    for (long long i = 0; i < n; i += LANES) {
        Lanes at;
        for (int l = 0; l < LANES; l++) at.v[l] = x[i + l];
        const Lanes sine = sin(at), cosine = cos(at);
        for (int l = 0; l < LANES; l++) { s[i + l] = sine.v[l]; c[i + l] = cosine.v[l]; }
    }
}
"""


def compiled_sines(instructions, before=""):
    """Sines and cosines of doubles by `lanes.h`, after some lines."""
    text = before + Path(lanes.__file__).with_name("lanes.h").read_text("utf-8") + SINES
    flags = (*lanes.FLAGS, *instructions)
    library = ctypes.CDLL(str(compile_shared("sines.cpp", text, find_compiler(), flags)))

    def call(x):
        padded = np.concatenate([x, np.zeros(-len(x) % 16)])
        s, c = np.empty(len(padded)), np.empty(len(padded))
        pointers = [ctypes.c_void_p(a.ctypes.data) for a in (padded, s, c)]
        library.sines(ctypes.c_longlong(len(padded)), *pointers)
        return s[: len(x)], c[: len(x)]

    return call


EACH_SET = {"params": INSTRUCTION_SETS, "ids": lambda flags: flags[0] if flags else "baseline"}


@pytest.fixture(scope="module", **EACH_SET)
def sines(request):
    return compiled_sines(request.param)


@pytest.fixture(scope="module", **EACH_SET)
def single_sines(request):
    return compiled_sines(request.param, "#define SINGLE_PRECISION\n")


def ulps(found, exact):
    """Error in units of the last place of the exact value."""
    size = mpmath.ldexp(1, int(mpmath.floor(mpmath.log(abs(exact), 2))) - 52)
    return float(abs(mpmath.mpf(float(found)) - exact) / size)


@pytest.mark.parametrize("largest", [0.8, 10.0, 1e3, 1e6])
def test_sines_are_off_by_less_than_two_units_in_the_last_place(sines, largest):
    x = np.random.default_rng(0).uniform(-largest, largest, 4000)
    # Where they nearly vanish: the doubles around multiples of pi/2.
    multiples = np.round(np.linspace(-largest, largest, 401) / (np.pi / 2)) * (np.pi / 2)
    x = np.concatenate([x, multiples, np.nextafter(multiples, 9e9), [1e-300, -1e-20, 5e-324]])
    x = x[np.abs(x) <= 1e6]
    s, c = sines(x)
    with mpmath.workdps(60):
        exact = [(mpmath.sin(mpmath.mpf(v)), mpmath.cos(mpmath.mpf(v))) for v in x.tolist()]
        assert max(ulps(f, e[0]) for f, e in zip(s, exact, strict=True) if e[0] and abs(e[0]) > 1e-290) < 2
        assert max(ulps(f, e[1]) for f, e in zip(c, exact, strict=True)) < 2
    assert np.array_equal(s[np.abs(x) < 1e-19], x[np.abs(x) < 1e-19])


@pytest.mark.parametrize("largest", [0.8, 10.0, 1e3, 1e4])
def test_sines_in_single_precision_are_off_by_its_rounding(single_sines, largest):
    """By less than a unit in the last place of 1. Near a zero that is many of theirs."""
    x = np.random.default_rng(0).uniform(-largest, largest, 20_000)
    multiples = np.round(np.linspace(-largest, largest, 401) / (np.pi / 2)) * (np.pi / 2)
    x = np.concatenate([x, multiples]).astype(np.float32).astype(np.float64)
    x = x[np.abs(x) <= largest]
    for found, exact in zip(single_sines(x), (np.sin(x), np.cos(x)), strict=True):
        assert np.abs(found - exact).max() < 2**-23


def test_in_single_precision_sines_of_no_number_and_from_afar_are_no_number(single_sines):
    x = np.array([np.nan, np.inf, -np.inf, 1.1e4, -1e300, 0.0, -0.0, 0.5])
    s, c = single_sines(x)
    assert np.isnan(s[:5]).all() and np.isnan(c[:5]).all()
    assert s[5:7].tolist() == [0.0, 0.0] and c[5:7].tolist() == [1.0, 1.0]
    assert abs(s[7] - np.sin(0.5)) < 2**-24 and abs(c[7] - np.cos(0.5)) < 2**-24


def test_sines_of_no_number_and_beyond_any_walker_are_no_number(sines):
    x = np.array([np.nan, np.inf, -np.inf, 1.1e6, -1e300, 0.0, -0.0, 0.5])
    s, c = sines(x)
    assert np.isnan(s[:5]).all() and np.isnan(c[:5]).all()
    assert s[5:].tolist() == [0.0, 0.0, np.sin(0.5)]
    assert c[5:].tolist() == [1.0, 1.0, np.cos(0.5)]


# -- the same numbers ------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["wobbling", pytest.param("compass", marks=pytest.mark.quick)])
def test_lanes_agree_with_one_point_at_a_time(name):
    model = load(name)
    u, params = cases(model, 120)
    one, many = ScalarC().kernels(model), Lanes().kernels(model)
    for kernel, *more in (
        (catalogue.residual(24),),
        (catalogue.jacobian(24),),
        (catalogue.jacobian_along(24), np.random.default_rng(2).normal(size=params.shape)),
        (catalogue.trace(48),),
    ):
        for a, b in zip(one.call(kernel, u, params, *more), many.call(kernel, u, params, *more), strict=True):
            scale = 1 + np.abs(np.nan_to_num(a)).max(axis=tuple(range(1, a.ndim)), keepdims=True)
            np.testing.assert_allclose((b / scale)[::2], (a / scale)[::2], rtol=0, atol=2e-14)
    near, rows = u[::2], params[::2]
    for kernel, tolerance in ((catalogue.search(12), 1e-7), (catalogue.limit_cycle(24), 1e-11)):
        a, b = one.call(kernel, near, rows), many.call(kernel, near, rows)
        closed = np.abs(a[-1]).max(axis=1) < 1e-8
        assert closed.sum() >= 8
        np.testing.assert_allclose(b[0][closed], a[0][closed], rtol=0, atol=tolerance)


@pytest.mark.parametrize("name", ["wobbling", pytest.param("compass", marks=pytest.mark.quick)])
def test_a_point_does_not_depend_on_those_beside_it(name):
    model = load(name)
    kernels = Lanes().kernels(model)
    u, params = cases(model, 64)
    rng = np.random.default_rng(5)
    for kernel in KERNELS:
        together = kernels.call(kernel, u, params)
        for size in range(1, 18):
            for chosen in (np.arange(size), rng.choice(64, size), rng.permutation(64)[:size]):
                alone = kernels.call(kernel, u[chosen], params[chosen])
                assert_same_bits(alone, [out[chosen] for out in together])
    directions = rng.normal(size=params.shape)
    together = kernels.jacobian_along(24, u, params, directions)
    for size in range(1, 18):
        chosen = rng.permutation(64)[:size]
        alone = kernels.jacobian_along(24, u[chosen], params[chosen], directions[chosen])
        assert_same_bits(alone, [out[chosen] for out in together])
    together = kernels.quick_search(12, u, params)
    for size in range(1, 34):
        chosen = rng.permutation(64)[:size]
        assert_same_bits(
            kernels.quick_search(12, u[chosen], params[chosen]), [out[chosen] for out in together]
        )


@pytest.mark.parametrize("name", ["wobbling", pytest.param("compass", marks=pytest.mark.quick)])
def test_a_search_in_single_precision_ends_where_one_in_double_precision_does(name):
    model = load(name)
    scale = Scales.of(model)
    u, params = cases(model, 300)
    exact = Lanes().kernels(model).search(24, u, params)
    found = Lanes().kernels(model).quick_search(24, u, params)
    closed = np.abs(exact.residual / scale.residual).max(axis=1) < 1e-9
    with np.errstate(invalid="ignore"):
        near = (np.abs((found.u - exact.u) / scale.unknowns).max(axis=1) < 1e-3) & closed
    assert closed.sum() >= 60
    # From far away, rounding may lead it elsewhere.
    assert near.sum() > 0.95 * closed.sum()
    size = np.abs(found.residual / scale.residual).max(axis=1)
    assert (size[near] < 1e-4).all()
    residual = Lanes().kernels(model).residual(24, found.u, params)
    np.testing.assert_array_equal(found.residual, residual)
    # It is of single precision: what it leaves open is more than double precision does.
    assert np.median(size[near]) > 1e-9


def test_what_is_prepared_is_compiled():
    kernels = Lanes().kernels(load("simplest_walker"))
    assert not {"_search", "_along"} & vars(kernels).keys()
    kernels.prepare_search_and_following()
    assert {"_search", "_along"} <= vars(kernels).keys()


def test_a_search_in_single_precision_is_finished_in_double_precision_where_it_came_near(monkeypatch):
    model = load("wobbling")
    u, params = cases(model, 300)
    size = {}
    for nearly, closed in ((0.0, 0.0), (1e-2, 1e-8)):
        monkeypatch.setattr(lanes, "NEARLY", nearly)
        monkeypatch.setattr(lanes, "SEARCH_RESIDUAL", closed)
        left = Lanes().kernels(model).quick_search(24, u, params).residual
        size[nearly] = np.nan_to_num(np.abs(left / Scales.of(model).residual).max(axis=1), nan=np.inf)
    rough, finished = size.values()
    near = (rough > 1e-8) & (rough < 1e-2)
    np.testing.assert_array_equal(rough[~near], finished[~near])
    assert near.sum() >= 60
    assert (finished[near & (rough < 1e-5)] < 1e-9).mean() > 0.95


@pytest.mark.quick
def test_a_search_takes_no_more_steps_than_it_may():
    model = load("compass")
    u, params = cases(model, 40)
    kernels = Lanes().kernels(model)
    one = kernels.quick_search(12, u, params, 1)
    matrix, residual = kernels.jacobian(12, u, params)
    newton = u - solved(matrix, residual)
    far = np.abs(one.residual / Scales.of(model).residual).max(axis=1) > 1e-2  # it is not finished
    assert far.sum() >= 10
    np.testing.assert_allclose(one.u[far], newton[far], rtol=1e-3, atol=1e-3)
    assert [len(part) for part in kernels.quick_search(12, u[:0], params[:0])] == [0, 0]


@pytest.mark.quick
@pytest.mark.parametrize("backend", [Lanes(), ScalarC()], ids=["lanes", "scalar"])
def test_points_at_resolutions_of_their_own_are_as_they_are_alone(backend):
    model = load("compass")
    kernels = backend.kernels(model)
    u, params = cases(model, 41)
    n_rk = np.random.default_rng(3).choice(np.array(catalogue.CYCLE_N_RK), 41)
    n_rk[0], n_rk[1:19] = 384, 24  # one of its own, and more than fit into two vectors
    matrices, closing = kernels.jacobian(n_rk, u, params)
    residual = kernels.residual(n_rk, u, params)
    for i, n in enumerate(n_rk.tolist()):
        at = slice(i, i + 1)
        alone = kernels.jacobian(n, u[at], params[at])
        assert_same_bits([matrices[at], closing[at]], list(alone))
        assert_same_bits([residual[at]], [kernels.residual(n, u[at], params[at])])
    none = np.empty(0, dtype=np.int64)
    assert kernels.jacobian(none, u[:0], params[:0]).jacobian.shape == (0, 4, 4)
    assert_same_bits(
        list(kernels.jacobian(np.full(41, 48), u, params)), list(kernels.jacobian(48, u, params))
    )


@each_instruction_set
def test_the_processor_does_not_change_a_bit(name, instructions):
    model = load(name)
    u, params = cases(model, 40)
    wide, other = Lanes().kernels(model), Lanes(instructions=instructions).kernels(model)
    for kernel in KERNELS:
        assert_same_bits(other.call(kernel, u, params), wide.call(kernel, u, params))
    assert_same_bits(other.quick_search(12, u, params), wide.quick_search(12, u, params))


@each_instruction_set
def test_reference_orbits_with_each_instruction_set(name, instructions):
    entries = [e for e in REFERENCE if e["model"] == name]
    model = load(name)
    u = np.array([[*section_point(e), e["period"]] for e in entries])
    params = np.array([model.point(e["params"]) for e in entries])
    solved = Lanes(instructions=instructions).kernels(model).limit_cycle(96, u * 1.001, params)
    np.testing.assert_allclose(solved.u, u, rtol=0, atol=1e-10)
    assert np.abs(solved.residual).max() < 1e-11


def test_part_of_a_step_and_no_points():
    model = load("wobbling")
    kernels = Lanes().kernels(model)
    rng = np.random.default_rng(8)
    n, params = 21, np.tile(model.point({}), (21, 1))
    inputs = (rng.uniform(0, 2, (n, 1)), rng.uniform(-0.3, 0.3, (n, 7)), rng.uniform(0, 0.1, (n, 1)), params)
    one = ScalarC().kernels(model).advance(*inputs)
    for a, b in zip(one, kernels.advance(*inputs), strict=True):
        np.testing.assert_allclose(b, a, rtol=1e-13, atol=1e-13)
    assert [len(out) for out in kernels.advance(*(x[:0] for x in inputs))] == [0, 0, 0]


# -- memory ----------------------------------------------------------------------------------------------

MAIN = """
int main()
{
    const casadi_int nu = 3, np = 3, in_size[] = {nu, np}, out_size[] = {nu * nu, nu};
    const double start[] = START, params[] = PARAMS, one[] = {1, 1, 1};
    for (casadi_int n = 1; n < 18; n++) {
        double* u = (double*) malloc((size_t) (n * nu) * sizeof(double));
        double* p = (double*) malloc((size_t) (n * np) * sizeof(double));
        double* j = (double*) malloc((size_t) (n * nu * nu) * sizeof(double));
        double* r = (double*) malloc((size_t) (n * nu) * sizeof(double));
        for (casadi_int i = 0; i < n; i++) {
            const double off = i % 5 == 3 ? NAN : 1 + 0.01 * (double) i;
            for (casadi_int k = 0; k < nu; k++) u[i * nu + k] = start[k] * off;
            for (casadi_int k = 0; k < np; k++) p[i * np + k] = params[k];
        }
        const double* in[] = {u, p};
        double* out[] = {j, r};
        const Kernel* derivative = &lockstep_rimless_wheel_jacobian_12;
        const Kernel* residual = &lockstep_rimless_wheel_residual_24;
        int status = lockstep_newton(derivative, residual, n, nu, np, u, p, one, one, 1e-14, 1e-9, 6);
        status |= lockstep_newton(derivative, NULL, n, nu, np, u, p, one, one, 1e-14, 1e-9, 6);
        status |= lockstep_map(1, &derivative, &n, NULL, 2, in, in_size, 2, out, out_size);
        if (status || !(fabs(r[0]) < 1e-9)) return 1;
        const Kernel* const both[] = {derivative, derivative};
        const casadi_int counts[] = {n / 3, n - n / 3};
        casadi_int points[17];
        for (casadi_int i = 0; i < n; i++) points[i] = n - 1 - i;
        r[0] = 1;
        status = lockstep_map(2, both, counts, points, 2, in, in_size, 2, out, out_size);
        if (status || !(fabs(r[0]) < 1e-9)) return 1;
        free(u); free(p); free(j); free(r);
    }
    return 0;
}
"""


def test_drivers_under_the_address_sanitizer(tmp_path):
    model, compiler = load("rimless_wheel"), shutil.which(find_compiler())
    orbit = find_orbits(model)[0]
    # The other kernels would take long to compile.
    shown = r"^KERNEL\((?!rimless_wheel_(jacobian_12|residual_24)\)).*$"
    text, main = re.sub(shown, "", lanes.source(model), flags=re.M), MAIN
    for word, values in (("START", orbit.section_point), ("PARAMS", orbit.params.values())):
        main = main.replace(word, "{" + ", ".join(map(repr, values)) + "}")
    (tmp_path / "main.cpp").write_text(text + main)
    flags = [flag for flag in lanes.FLAGS if flag != "-shared"]
    command = [
        compiler,
        *flags,
        "-Wall",
        "-Wextra",
        "-Werror",
        "-Wno-unused-parameter",
        "-Wno-unused-function",
    ]
    command += ["-fsanitize=address", tmp_path / "main.cpp", "-o", tmp_path / "main", "-lm"]
    built = subprocess.run(command, capture_output=True, text=True, check=False)
    if "cannot find" in built.stderr:
        pytest.skip("the compiler has no address sanitizer")
    assert built.returncode == 0, built.stderr[:2000]
    ran = subprocess.run([tmp_path / "main"], capture_output=True, text=True, check=False)
    assert ran.returncode == 0, ran.stderr[:2000]


# -- what depends on it ----------------------------------------------------------------------------------


def test_a_branch_on_lanes_is_not_compiled(tmp_path, monkeypatch):
    monkeypatch.setenv("STRIDEMAP_CACHE", str(tmp_path / "cache"))
    header = Path(lanes.__file__).with_name("lanes.h").read_text("utf-8")
    branch = 'extern "C" int less(const Lanes* x) { return x[0] < x[1] ? 1 : 0; }\n'
    with pytest.raises(CompilerError, match=r"failed on branch.cpp .*"):
        compile_shared("branch.cpp", header + branch, find_compiler(), lanes.FLAGS)


def test_orbits_are_those_of_one_point_at_a_time():
    model = load("wobbling")
    points = np.array([model.point({}), model.point({"k": 0.5})])
    options = SearchOptions(starts=48, seed=1)
    at, fast = find_all(Solver.for_model(model, Lanes()), points, options)
    at_slow, slow = find_all(Solver.for_model(model, ScalarC()), points, options)
    assert at.tolist() == at_slow.tolist()
    assert set(at.tolist()) == {0, 1}
    np.testing.assert_allclose(fast.u, slow.u, rtol=0, atol=1e-11)
    np.testing.assert_allclose(fast.d_max, slow.d_max, rtol=0, atol=1e-10)
    np.testing.assert_allclose(fast.work, slow.work, rtol=0, atol=1e-10)


def test_the_arithmetic_is_its_own():
    """The bytes of tables agree where the arithmetic does, whatever the compiler and the instructions."""
    assert Lanes().arithmetic == Lanes("gcc").arithmetic == Lanes(instructions=()).arithmetic
    assert Lanes().arithmetic != ScalarC().arithmetic
    assert "contract=off" in Lanes().kernels(load("compass")).compiler


@pytest.mark.parametrize("compiler", ["gcc", "clang"])
def test_the_compiler_does_not_change_a_bit(compiler):
    if not shutil.which(compiler):
        pytest.skip(f"there is no {compiler}")
    if os.path.realpath(shutil.which(compiler)) == os.path.realpath(shutil.which(find_compiler())):
        pytest.skip(f"{compiler} is the one that compiles in all other tests")
    model = load("compass")
    u, params = cases(model, 40)
    expected, found = Lanes().kernels(model), Lanes(compiler).kernels(model)
    for kernel in KERNELS:
        assert_same_bits(found.call(kernel, u, params), expected.call(kernel, u, params))
    assert_same_bits(found.quick_search(12, u, params), expected.quick_search(12, u, params))


def test_cache_of_several_machines_keeps_their_libraries_apart(tmp_path, monkeypatch):
    monkeypatch.setenv("STRIDEMAP_CACHE", str(tmp_path / "cache"))
    text = 'extern "C" int one() { return 1; }\n'
    built = {
        compile_shared("one.cpp", text, find_compiler(), (*lanes.FLAGS, *flags)) for flags in INSTRUCTION_SETS
    }
    assert len(built) == len(INSTRUCTION_SETS)
    native = compile_shared("one.cpp", text, f"{find_compiler()} -march=native", lanes.FLAGS)
    processor_features.cache_clear()
    monkeypatch.setattr(
        "stridemap.solver.backends.compiler.processor_features",
        lambda: frozenset({"of", "another", "machine"}),
    )
    assert compile_shared("one.cpp", text, f"{find_compiler()} -march=native", lanes.FLAGS) != native
