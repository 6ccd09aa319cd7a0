"""Kernels that work on several points an instruction: the same numbers, whatever is beside them."""

import ctypes
import re
import shutil
import subprocess
from itertools import chain
from pathlib import Path

import mpmath
import numpy as np
import pytest

from stridemap.errors import InputError
from stridemap.solver.backends import lanes as lockstep
from stridemap.solver.backends.compiler import compile_shared, find_compiler, processor_features
from stridemap.solver.backends.library import CompiledKernels, LockstepKernels, load_kernels
from stridemap.solver.cycles.search import SearchOptions, find_orbits
from stridemap.solver.model.loading import load
from tests.oracles.reference import REFERENCE, section_point

pytestmark = pytest.mark.skipif(
    not any(map(shutil.which, ("cc", "gcc", "clang"))),
    reason="there is no C compiler to compile kernels with",
)
BARE = load_kernels.__wrapped__
KERNELS = ("search_12", "limit_cycle_24", "residual_24", "jacobian_24", "trace_48")

INSTRUCTION_SETS = [
    (),
    *(flags for needed, flags in lockstep.INSTRUCTIONS if needed <= processor_features()),
]
"""What this processor can run: it knows two lanes in any case."""


def lockstep_kernels(model, instructions=None):
    return LockstepKernels(model, find_compiler(), instructions)


def cases(model, n, seed=3):
    """Guesses near cycles, far from any, and impossible ones, with parameters."""
    rng = np.random.default_rng(seed)
    nz = len(model.section)
    params = np.tile(model.point({}), (n, 1)) * rng.uniform(0.8, 1.2, (n, len(model.parameters)))
    u = np.hstack([rng.uniform(-0.2, 0.2, (n, nz)), rng.uniform(0.3, 3.0, (n, 1))])
    cycle = np.array([*(0.094, -0.146, -0.0026, 0.0029, 0.152)[:nz], 1.18])
    u[::2] = cycle * rng.uniform(0.98, 1.02, (len(u[::2]), nz + 1))
    bad = [np.nan, np.inf, -np.inf, 0.0, 1e200, 1e7]
    u[3 : 3 + 4 * len(bad) : 4] = np.array(bad)[:, None]
    return u, params


def assert_same_bits(one, other):
    for a, b in zip(one, other, strict=True):
        assert a.shape == b.shape
        np.testing.assert_array_equal(np.isnan(a), np.isnan(b))
        numbers = ~np.isnan(a)
        np.testing.assert_array_equal(a[numbers].view(np.int64), b[numbers].view(np.int64))


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


@pytest.fixture(scope="module", params=INSTRUCTION_SETS, ids=lambda flags: flags[0] if flags else "baseline")
def sines(request):
    lanes = Path(lockstep.__file__).with_name("lanes.h").read_text("utf-8")
    flags = (*lockstep.FLAGS, *request.param)
    library = ctypes.CDLL(str(compile_shared("sines.cpp", lanes + SINES, find_compiler(), flags)))

    def call(x):
        padded = np.concatenate([x, np.zeros(-len(x) % 8)])
        s, c = np.empty(len(padded)), np.empty(len(padded))
        pointers = [ctypes.c_void_p(a.ctypes.data) for a in (padded, s, c)]
        library.sines(ctypes.c_longlong(len(padded)), *pointers)
        return s[: len(x)], c[: len(x)]

    return call


def ulps(found, exact):
    """Error in units of the last place of the exact value."""
    size = mpmath.ldexp(1, int(mpmath.floor(mpmath.log(abs(exact), 2))) - 52)
    return float(abs(mpmath.mpf(float(found)) - exact) / size)


@pytest.mark.parametrize("largest", [0.8, 10.0, 1e3, 1e6])
def test_sines_are_off_by_less_than_one_unit_in_the_last_place(sines, largest):
    x = np.random.default_rng(0).uniform(-largest, largest, 4000)
    # Where they nearly vanish: the doubles around multiples of pi/2.
    multiples = np.round(np.linspace(-largest, largest, 401) / (np.pi / 2)) * (np.pi / 2)
    x = np.concatenate([x, multiples, np.nextafter(multiples, 9e9), [1e-300, -1e-20, 5e-324]])
    x = x[np.abs(x) <= 1e6]
    s, c = sines(x)
    with mpmath.workdps(60):
        exact = [(mpmath.sin(mpmath.mpf(v)), mpmath.cos(mpmath.mpf(v))) for v in x.tolist()]
        assert max(ulps(f, e[0]) for f, e in zip(s, exact, strict=True) if e[0] and abs(e[0]) > 1e-290) < 0.8
        assert max(ulps(f, e[1]) for f, e in zip(c, exact, strict=True)) < 0.8
    assert np.array_equal(s[np.abs(x) < 1e-19], x[np.abs(x) < 1e-19])


def test_sines_of_no_number_and_beyond_any_walker_are_no_number(sines):
    x = np.array([np.nan, np.inf, -np.inf, 1.1e6, -1e300, 0.0, -0.0, 0.5])
    s, c = sines(x)
    assert np.isnan(s[:5]).all() and np.isnan(c[:5]).all()
    assert s[5:].tolist() == [0.0, 0.0, np.sin(0.5)]
    assert c[5:].tolist() == [1.0, 1.0, np.cos(0.5)]


# -- the same numbers ------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["wobbling", "compass"])
def test_lockstep_agrees_with_one_point_at_a_time(name):
    model = load(name)
    u, params = cases(model, 40)
    one, many = CompiledKernels(model, find_compiler()), lockstep_kernels(model)
    for kernel in ("residual_24", "jacobian_24", "trace_48"):
        for a, b in zip(one(kernel, u, params), many(kernel, u, params), strict=True):
            scale = 1 + np.abs(np.nan_to_num(a)).max(axis=tuple(range(1, a.ndim)), keepdims=True)
            np.testing.assert_allclose((b / scale)[::2], (a / scale)[::2], rtol=0, atol=2e-14)
    near, rows = u[::2], params[::2]
    for kernel, tolerance in (("search_12", 1e-7), ("limit_cycle_24", 1e-11)):
        a, b = one(kernel, near, rows), many(kernel, near, rows)
        closed = np.abs(a[-1]).max(axis=1) < 1e-8
        assert closed.sum() >= 8
        np.testing.assert_allclose(b[0][closed], a[0][closed], rtol=0, atol=tolerance)


@pytest.mark.parametrize("name", ["wobbling", "compass"])
def test_a_point_does_not_depend_on_those_beside_it(name):
    model = load(name)
    kernels = lockstep_kernels(model)
    u, params = cases(model, 64)
    rng = np.random.default_rng(5)
    for kernel in KERNELS:
        together = kernels(kernel, u, params)
        for size in range(1, 18):
            for chosen in (np.arange(size), rng.choice(64, size), rng.permutation(64)[:size]):
                alone = kernels(kernel, u[chosen], params[chosen])
                assert_same_bits(alone, [out[chosen] for out in together])


@pytest.mark.parametrize(
    "instructions", INSTRUCTION_SETS, ids=lambda flags: flags[0] if flags else "baseline"
)
def test_the_processor_does_not_change_a_bit(instructions):
    model = load("compass")
    u, params = cases(model, 40)
    for kernel in KERNELS:
        wide = lockstep_kernels(model)(kernel, u, params)
        assert_same_bits(lockstep_kernels(model, instructions)(kernel, u, params), wide)


@pytest.mark.parametrize(
    "instructions", INSTRUCTION_SETS, ids=lambda flags: flags[0] if flags else "baseline"
)
def test_reference_orbits_with_each_instruction_set(instructions):
    entries = [e for e in REFERENCE if e["model"] == "wobbling"]
    model = load("wobbling")
    u = np.array([[*section_point(e), e["period"]] for e in entries])
    params = np.array([model.point(e["params"]) for e in entries])
    found, _, residual = lockstep_kernels(model, instructions)("limit_cycle_96", u * 1.001, params)
    np.testing.assert_allclose(found, u, rtol=0, atol=1e-10)
    assert np.abs(residual).max() < 1e-11


def test_part_of_a_step_and_no_points():
    model = load("wobbling")
    kernels = lockstep_kernels(model)
    rng = np.random.default_rng(8)
    n, params = 21, np.tile(model.point({}), (21, 1))
    inputs = (rng.uniform(0, 2, (n, 1)), rng.uniform(-0.3, 0.3, (n, 7)), rng.uniform(0, 0.1, (n, 1)), params)
    one = CompiledKernels(model, find_compiler())("advance", *inputs)
    for a, b in zip(one, kernels("advance", *inputs), strict=True):
        np.testing.assert_allclose(b, a, rtol=1e-13, atol=1e-13)
    assert [len(out) for out in kernels("advance", *(x[:0] for x in inputs))] == [0, 0, 0]


# -- memory ----------------------------------------------------------------------------------------------

MAIN = """
int main()
{
    const casadi_int nu = 4, np = 6, in_size[] = {nu, np}, out_size[] = {nu * nu, nu};
    const double start[] = {0.09, -0.17, -0.003, 1.2}, params[] = PARAMS;
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
        int status = lockstep_newton(&lockstep_compass_jacobian_12, &lockstep_compass_residual_24,
            n, nu, np, u, p, 1e-14, 1e-9, 6);
        status |= lockstep_newton(&lockstep_compass_jacobian_12, NULL, n, nu, np, u, p, 1e-14, 1e-9, 6);
        status |= lockstep_map(&lockstep_compass_jacobian_12, n, 2, in, in_size, 2, out, out_size);
        if (status || !(fabs(r[0]) < 1e-9)) return 1;
        free(u); free(p); free(j); free(r);
    }
    return 0;
}
"""


def test_drivers_under_the_address_sanitizer(tmp_path):
    model, compiler = load("compass"), shutil.which(find_compiler())
    shown = r"^KERNEL\((?!compass_(jacobian_12|residual_24)\)).*$"  # the rest would take long to compile
    text = re.sub(shown, "", lockstep.source(model), flags=re.M)
    params = "{" + ", ".join(map(repr, model.point({}).tolist())) + "}"
    (tmp_path / "main.cpp").write_text(text + MAIN.replace("PARAMS", params))
    flags = [flag for flag in lockstep.FLAGS if flag != "-shared"]
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


# -- falling back ----------------------------------------------------------------------------------------


def script(path, text):
    path.write_text(f"#!/bin/sh\n{text}\n")
    path.chmod(0o755)
    return str(path)


def test_lockstep_is_what_runs_where_it_can():
    assert isinstance(load_kernels(load("wobbling")), LockstepKernels)
    assert "contract=off" in load_kernels(load("wobbling")).compiler


def test_compiler_without_cpp_gives_one_point_at_a_time(tmp_path, monkeypatch):
    compiler = shutil.which(find_compiler())
    only_c = script(
        tmp_path / "onlyc", f'case "$*" in *c++*) echo "no C++ here" >&2; exit 1;; esac\nexec {compiler} "$@"'
    )
    monkeypatch.setenv("STRIDEMAP_CACHE", str(tmp_path / "cache"))
    monkeypatch.setenv("CC", only_c)
    assert type(BARE(load("compass"))) is CompiledKernels


def test_a_branch_on_lanes_is_not_compiled(tmp_path, monkeypatch):
    monkeypatch.setenv("STRIDEMAP_CACHE", str(tmp_path / "cache"))
    lanes = Path(lockstep.__file__).with_name("lanes.h").read_text("utf-8")
    branch = 'extern "C" int less(const Lanes* x) { return x[0] < x[1] ? 1 : 0; }\n'
    with pytest.raises(InputError, match=r"failed on branch.cpp .*"):
        compile_shared("branch.cpp", lanes + branch, find_compiler(), lockstep.FLAGS)


def test_orbits_are_those_of_one_point_at_a_time(monkeypatch):
    model = load("wobbling")
    points = np.array([model.point({}), model.point({"k": 0.5})])
    options = SearchOptions(starts=48, seed=1)
    fast = find_orbits(model, points, options)
    monkeypatch.setattr(
        "stridemap.solver.cycles.solver.load_kernels", lambda m: CompiledKernels(m, find_compiler())
    )
    slow = find_orbits(model, points, options)
    assert [len(orbits) for orbits in fast] == [len(orbits) for orbits in slow]
    for a, b in zip(chain(*fast), chain(*slow), strict=True):
        np.testing.assert_allclose(section_point(a), section_point(b), rtol=0, atol=1e-11)
        assert a.period == pytest.approx(b.period, abs=1e-11)
        assert a.d_max == pytest.approx(b.d_max, abs=1e-10)
        assert a.work == pytest.approx(b.work, abs=1e-10)


@pytest.mark.parametrize("compiler", ["gcc", "clang"])
def test_the_compiler_does_not_change_a_bit(compiler):
    if not shutil.which(compiler):
        pytest.skip(f"there is no {compiler}")
    model = load("compass")
    u, params = cases(model, 40)
    for kernel in KERNELS:
        expected = lockstep_kernels(model)(kernel, u, params)
        assert_same_bits(LockstepKernels(model, compiler)(kernel, u, params), expected)


def test_cache_of_several_machines_keeps_their_libraries_apart(tmp_path, monkeypatch):
    monkeypatch.setenv("STRIDEMAP_CACHE", str(tmp_path / "cache"))
    text = 'extern "C" int one() { return 1; }\n'
    built = {
        compile_shared("one.cpp", text, find_compiler(), (*lockstep.FLAGS, *flags))
        for flags in INSTRUCTION_SETS
    }
    assert len(built) == len(INSTRUCTION_SETS)
    native = compile_shared("one.cpp", text, f"{find_compiler()} -march=native", lockstep.FLAGS)
    processor_features.cache_clear()
    monkeypatch.setattr(
        "stridemap.solver.backends.compiler.processor_features",
        lambda: frozenset({"of", "another", "machine"}),
    )
    assert compile_shared("one.cpp", text, f"{find_compiler()} -march=native", lockstep.FLAGS) != native
