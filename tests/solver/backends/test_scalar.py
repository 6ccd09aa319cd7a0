"""C for one point at a time and CasADi's virtual machine: the same operations, so the same bits."""

import numpy as np
import pytest

from stridemap.errors import CompilerError
from stridemap.solver.backends.interpreter import Interpreter
from stridemap.solver.backends.scalar import ScalarC
from stridemap.solver.kernels import catalogue
from stridemap.solver.kernels.catalogue import CYCLE_N_RK, SEARCH_N_RK
from stridemap.solver.model.loading import load
from tests.oracles.kernels import assert_same_bits, needs_compiler


@needs_compiler
@pytest.mark.parametrize("name", ["wobbling", pytest.param("compass", marks=pytest.mark.quick)])
@pytest.mark.parametrize(
    "kernel",
    [catalogue.search(SEARCH_N_RK[0]), catalogue.limit_cycle(CYCLE_N_RK[0]), catalogue.trace(48)],
    ids=lambda kernel: kernel.name,
)
def test_virtual_machine_and_machine_code_agree_bit_for_bit(name, kernel):
    model = load(name)
    rng = np.random.default_rng(7)
    n, nz = 24, len(model.section)
    params = np.tile(model.point({}), (n, 1)) * rng.uniform(0.7, 1.3, (n, len(model.parameters)))
    u = np.hstack([rng.uniform(-0.2, 0.2, (n, nz)), rng.uniform(0.3, 3.0, (n, 1))])
    cycle = np.array([*(0.094, -0.146, -0.0026, 0.0029, 0.152)[:nz], 1.18])
    u[:8] = cycle * rng.uniform(0.98, 1.02, (8, nz + 1))
    u[20:] = [[np.nan] * (nz + 1), [np.inf] * (nz + 1), [0.0] * (nz + 1), [1e200] * (nz + 1)]
    compiled = ScalarC().kernels(model).call(kernel, u, params)
    assert_same_bits(compiled, Interpreter().kernels(model).call(kernel, u, params))
    assert np.isfinite(compiled[0][:8]).all()
    assert np.isnan(compiled[-1][20]).all()


@needs_compiler
@pytest.mark.parametrize("name", ["wobbling", "compass"])
def test_part_of_a_step_agrees_bit_for_bit(name):
    model = load(name)
    rng = np.random.default_rng(8)
    n, size = 200, 2 * len(model.coordinates) + 1
    params = np.tile(model.point({}), (n, 1)) * rng.uniform(0.7, 1.3, (n, len(model.parameters)))
    w = rng.uniform(-0.3, 0.3, (n, size))
    w[0], w[1], w[2] = np.nan, np.inf, 1e160
    inputs = (rng.uniform(0, 2, (n, 1)), w, rng.uniform(0, 0.1, (n, 1)), params)
    compiled = ScalarC().kernels(model).advance(*inputs)
    assert_same_bits(compiled, Interpreter().kernels(model).advance(*inputs))


def test_both_have_one_arithmetic():
    assert ScalarC().arithmetic == ScalarC("clang").arithmetic == Interpreter().arithmetic


def test_without_a_compiler_it_cannot_be_had(no_compiler):
    with pytest.raises(CompilerError, match="no C compiler was found here; install gcc or clang, or set CC"):
        ScalarC().kernels(load("compass"))
