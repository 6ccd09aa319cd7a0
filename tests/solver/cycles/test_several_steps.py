"""Cycles of several steps by a search of their own."""

import numpy as np
import pytest

from stridemap.solver.cycles.chain import Chain
from stridemap.solver.cycles.several_steps import find_chains
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.model.loading import load


@pytest.fixture(scope="module")
def solver():
    return Solver.for_model(load("simplest_walker"))


def test_a_stable_gait_of_three_steps_beside_the_stable_one_of_one_step(solver):
    """State and periods of a walk with an event-driven integrator."""
    point = solver.model.point({"slope": 0.0124})
    u, n_rk = find_chains(solver, point, 3)
    chain = Chain(solver.kernels, 3)
    multipliers = chain.multipliers(chain.jacobian(n_rk, u, np.repeat(point[None], len(u), axis=0)).jacobian)
    stable = u[np.abs(multipliers).max(axis=1) < 1]
    assert len(stable) == 1
    steps = stable[0].reshape(3, -1)
    np.testing.assert_allclose(steps[0, :2], [0.235649565947, -0.229751154266], rtol=0, atol=1e-10)
    np.testing.assert_allclose(steps[:, 2], [4.145346, 3.552517, 3.724043], rtol=0, atol=1e-6)


def test_a_cycle_of_one_step_is_not_one_of_two(solver):
    """Below the first doubling there is no cycle of two steps."""
    u, _ = find_chains(solver, solver.model.point({"slope": 0.0124}), 2)
    assert len(u) == 0
