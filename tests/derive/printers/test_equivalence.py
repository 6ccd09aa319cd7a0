"""The ladder: hand-written mechanics at 50 digits = Python module = NumPy = CasADi = compiled C.

All rungs, the 50-digit ones too, stand on the same 1,000 random states and random parameters of each
function; those of derivatives, whose differences at 50 digits take most of the time, on the first 200. The
tolerance of the floats is not chosen: it is the bound of each result's rounding error, carried along by the
program itself.
"""

import re
import subprocess
from decimal import Decimal
from functools import cache

import mpmath
import numpy as np
import pytest
from cffi import FFI

from stridemap import codegen
from stridemap.solver.model.loading import load
from tests.oracles.newton import by_hand
from tests.oracles.states import (
    MODELS,
    MP,
    call,
    differences,
    error_bounds,
    exact,
    fifty_digits,
    need,
    states,
)

FUNCTIONS = (
    "mass_matrix", "bias_forces", "controller_torque", "motor_rates", "state_derivative",
    "touchdown_condition",
    "impact_map", "impact_impulse", "kinetic_energy", "potential_energy", "total_mass", "centre_of_mass",
    "ground_force", "zmp", "centre_of_pressure", "swing_foot", "stance_foot", "drawing", "spring_mode",
    "section_state", "before_touchdown", "step_length", "forward_dynamics",
)  # fmt: skip
JACOBIANS = {
    "state_derivative_dq": ("dv_dq", "state_derivative", "dv", "q"),
    "state_derivative_dv": ("dv_dv", "state_derivative", "dv", "v"),
    "touchdown_condition_dq": ("h_dq", "touchdown_condition", "h", "q"),
    "impact_map_dq": ("v_plus_dq", "impact_map", "v_plus", "q"),
    "impact_map_dv": ("v_plus_dv", "impact_map", "v_plus", "v"),
    **{f"forward_dynamics_d{x}": (f"dv_d{x}", "forward_dynamics", "dv", x) for x in "qvup"},
}
PASSIVE = {"spring_mode", "controller_torque", "motor_rates", "forward_dynamics_du"}
LACKING = {"wobbling": set(), "compass": {"spring_mode"}}
PAIRS = [(m, f) for m in MODELS for f in (*FUNCTIONS, *JACOBIANS) if f not in LACKING.get(m, PASSIVE)]


@pytest.fixture(autouse=True)
def _digits():
    with fifty_digits():
        yield


def test_sines_of_decimal_numbers():
    """Decimal numbers are ten times as fast as mpmath's and have no sines; these are as good as its own."""
    own = mpmath.mp.clone()
    own.dps = 60
    values = exact(np.concatenate([np.random.default_rng(3).uniform(-25, 25, 500), [0, 1e-9, np.pi]]))
    for of, right in ((MP.sin, own.sin), (MP.cos, own.cos)):
        for x in values:
            assert abs(own.mpf(str(of(x))) - right(own.mpf(str(x)))) < own.mpf("1e-50")
    assert abs(own.mpf(str(MP.pi)) - own.pi) < own.mpf("1e-59")


@pytest.mark.parametrize("name", MODELS)
def test_every_generated_function_is_on_the_ladder(name):
    assert set(load(name).spec.functions) == {f for m, f in PAIRS if m == name}


@pytest.mark.parametrize(("name", "function"), PAIRS, ids=[f"{m}-{f}" for m, f in PAIRS])
def test_all_rungs_agree(name, function, libraries):
    # One test a function, because the truth and the bounds cost more than all the comparing.
    value = truth(name, function)
    assert_exact(by_module(name, function), value, "1e-28" if function in JACOBIANS else "1e-44")
    bounds = error_bounds(getattr(load(name).equations, function), at(name, function))
    assert_sharp(bounds, value)
    assert_within(bounds, by_numpy(name, function), value, "NumPy")
    assert_within(bounds, by_casadi(name, function), value, "CasADi")
    assert_within(bounds, by_c(libraries(name), name, function), value, "compiled C")


# -- what is compared ----------------------------------------------------------------------------------------


DERIVATIVES = 200
"""States at which derivatives are compared."""


def at(name, function):
    """The states at which a function is compared."""
    return first(name) if function in JACOBIANS else states(name)


@cache
def first(name):
    return {key: value[:DERIVATIVES] for key, value in states(name).items()}


@cache
def all_exact(name):
    return {key: exact(value) for key, value in states(name).items()}


@cache
def first_exact(name):
    return {key: exact(value) for key, value in first(name).items()}


def exact_at(name, function):
    """The same as decimal numbers."""
    return first_exact(name) if function in JACOBIANS else all_exact(name)


def truth(name, function):
    """The 50-digit values at all states."""
    if function not in JACOBIANS:
        return getattr(by_hand(name, exact_at(name, function), MP), function)()
    # The function that is differentiated here was itself compared with the hand-written one.
    result, parent, output, which = JACOBIANS[function]
    parent = getattr(load(name).equations, parent)
    return {result: differences(parent, exact_at(name, function), output, which)}


def by_module(name, function):
    return call(getattr(load(name).equations, function), MP, exact_at(name, function))


def by_numpy(name, function):
    return load(name).evaluate(function, **at(name, function))


def by_casadi(name, function):
    compiled = getattr(load(name), function)
    given = at(name, function)
    count = len(given["t"])
    inputs = {key: given[key].T.reshape(-1, count) for key in compiled.name_in()}
    result = compiled.map(count)(**inputs) if inputs else compiled()
    outputs = load(name).spec.functions[function].outputs
    return {o.name: from_casadi(result[o.name], o.shape) for o in outputs}


def from_casadi(value, shape):
    """CasADi's columns, one block a state, with the states on the first axis."""
    rows, columns = [*shape, 1, 1][:2]
    return value.full().reshape(rows, -1, columns).transpose(1, 0, 2).reshape(-1, *shape)


def by_c(library, name, function):
    """The C function at all states; everything goes through pointers into the arrays."""
    ffi, compiled = library
    spec = load(name).spec.functions[function]
    given = at(name, function)
    count = len(given["t"])
    inputs = [np.ascontiguousarray(given[a]) for a in spec.signature]
    outputs = [np.full((count, *o.shape), np.nan) for o in spec.outputs]
    in_c = getattr(compiled, f"{name}_{function}")
    for i in range(count):
        read = [float(x[i]) if x.ndim == 1 else pointer(ffi, x, i) for x in inputs]
        in_c(*read, *[pointer(ffi, x, i) for x in outputs])
    return dict(zip([o.name for o in spec.outputs], outputs, strict=True))


def pointer(ffi, array, row):
    return ffi.cast("double *", array.ctypes.data + row * array.strides[0])


@pytest.fixture(scope="module")
def libraries(tmp_path_factory):
    """Readable C by model: compiled, and called through what its header declares."""

    @cache
    def library(name):
        compiler = need("cc", "gcc", "clang")
        target = tmp_path_factory.mktemp("readable") / f"{name}.so"
        flags = ["-O2", "-std=c99", "-ffp-contract=off", "-shared", "-fPIC"]
        subprocess.run(
            [compiler, *flags, codegen.generated_folder() / name / f"{name}.c", "-o", target, "-lm"],
            check=True,
        )
        ffi = FFI()
        ffi.cdef(prototypes(name))
        return ffi, ffi.dlopen(str(target))

    return library


def prototypes(name):
    """The header's declarations, without comments and preprocessor."""
    text = re.sub(r"/\*.*?\*/", "", load(name).text(f"{name}.h"), flags=re.DOTALL)
    text = re.sub(
        r"#ifdef STRIDEMAP_(FLOAT|OLD_SIGNATURES)$.*?^#(else|endif) *$", "", text, flags=re.M | re.S
    )
    return re.sub(r'^#.*$|extern "C" \{|^\}$', "", text, flags=re.MULTILINE)


# -- how it is compared --------------------------------------------------------------------------------------


def assert_exact(result, value, tolerance):
    """Equal at 50 digits, relative to the largest entry."""
    assert result.keys() == value.keys()
    for key in value:
        assert result[key].shape == value[key].shape, key
        error = np.abs(result[key] - value[key]).max()
        assert error <= Decimal(tolerance) * (1 + np.abs(value[key]).max()), f"the module's {key}"


def assert_within(bounds, result, value, rung):
    """Every entry is as near to the truth as rounding allows."""
    assert result.keys() == value.keys()
    for key in value:
        shape = value[key].shape
        assert result[key].shape in (shape, (1, *shape[1:]), shape[1:]), key  # constants may come once
        error = np.abs(exact(result[key]) - value[key]).astype(float)
        # The bound itself is rounded, and differences are not quite exact.
        allowed = 1.001 * bounds[key] + 1e-28 * (1 + np.abs(value[key]).astype(float).max())
        assert (error <= allowed).all(), f"{rung}: {key} is off by {(error - allowed).max():.1e}"


def assert_sharp(bounds, value):
    """The bounds mean something: most are within some hundred units in the last place."""
    for key in value:
        count = len(value[key])
        size = np.abs(value[key]).astype(float).reshape(count, -1).max(axis=1)
        if size.max() < 1e-40:
            size = 1.0  # the zero moment point of a single mass on a leg without any is the foot
        bound = bounds[key].reshape(count, -1).max(axis=1)
        assert np.median(bound / np.maximum(size, 1e-3)) < 1e-12, key


@pytest.mark.parametrize("name", MODELS)
def test_the_header_declares_what_the_manifest_says(name):
    expected, spec = [], load(name).spec
    for function, entry in spec.functions.items():
        sizes = {a: f"[{size}]" if (size := spec.size(a)) else "" for a in entry.signature}
        arguments = ["double t" if a == "t" else f"const double {a}{size}" for a, size in sizes.items()]
        named = {o: f"{o.name}_" if o.name in entry.signature else o.name for o in entry.outputs}
        arguments += [f"double {n}[{np.prod(o.shape, dtype=int)}]" for o, n in named.items()]
        expected.append((f"{name}_{function}", ", ".join(arguments).replace("double u,", "double *u,")))
    text = prototypes(name).replace("stridemap_real", "double")
    declared = re.findall(r"^void (\w+)\(([^)]*)\);", text, flags=re.M)
    assert [(f, re.sub(r"\s+", " ", a)) for f, a in declared] == expected
