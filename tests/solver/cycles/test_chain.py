"""Cycles of several walking steps: a two-step gait, and one step as the shortest chain."""

import numpy as np
import pytest

from stridemap.solver.backends.selection import load_kernels
from stridemap.solver.cycles.chain import Chain
from stridemap.solver.cycles.floquet import multipliers
from stridemap.solver.cycles.search import find_all
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.model.loading import load
from tests.oracles.maps import MapKernels, T, p, x

N_RK = 48


@pytest.fixture(scope="module")
def simplest():
    """The kernels of the simplest walker."""
    return load_kernels(load("simplest_walker"), None)


@pytest.fixture(scope="module")
def two_steps(simplest):
    """Its two-step gait at a slope of 0.0165: parameters, chain, unknowns."""
    model = simplest.model
    point = model.point({"slope": 0.0165})[None, :]
    _, orbits = find_all(Solver.for_model(model), point)
    single = orbits.u[orbits.multipliers.real.argmin(axis=0)[0]]  # the gait that has doubled
    chain = Chain(simplest, 2)
    guess = np.concatenate([single * 1.03, single * 0.97])[None, :]
    return point, chain, chain.newton(N_RK, guess, point)


def test_the_two_step_gait_of_the_simplest_walker(two_steps):
    """Values from an independent program (event-driven DOP853, central differences)."""
    point, chain, u = two_steps
    steps = u.reshape(2, -1)
    order = np.argsort(steps[:, -1])
    theta, period = steps[order, 0], steps[order, -1]
    np.testing.assert_allclose(theta, [0.23665687719, 0.25054944845], rtol=0, atol=1e-11)
    np.testing.assert_allclose(period, [3.76779272, 4.02590285], rtol=0, atol=5e-9)
    found = chain.multipliers(chain.jacobian(N_RK, u, point).jacobian)[0]
    np.testing.assert_allclose(found[:2], [-0.03632505 + 0.28829155j, -0.03632505 - 0.28829155j], atol=1e-8)


def test_the_derivative_is_that_of_the_residual(two_steps):
    point, chain, u = two_steps
    u = u * 1.001
    exact = chain.jacobian(N_RK, u, point)
    np.testing.assert_array_equal(exact.residual, chain.residual(N_RK, u, point))
    shift = 1e-6 * np.eye(u.shape[1])
    many = np.repeat(point, u.shape[1], axis=0)
    ahead, behind = (chain.residual(N_RK, u + sign * shift, many) for sign in (1, -1))
    np.testing.assert_allclose(exact.jacobian[0], ((ahead - behind) / 2e-6).T, atol=1e-8)


def test_the_derivative_in_parameters_is_that_of_the_residual():
    """Of two steps, in two directions at once."""
    chain = Chain(load_kernels(load("goswami_compass"), None), 2)
    point = chain.kernels.model.point({})
    rng = np.random.default_rng(4)
    u = np.tile([*0.1 * rng.normal(size=chain.width - 1), 0.7], 2) + 0.01 * rng.normal(size=2 * chain.width)
    d = rng.normal(size=(2, len(point)))
    many, points = np.repeat(u[None], 2, axis=0), np.repeat(point[None], 2, axis=0)
    exact = chain.jacobian_along(N_RK, many, points, d)
    ahead, behind = (chain.residual(N_RK, many, points + sign * 1e-6 * d) for sign in (1, -1))
    assert np.abs(exact.along).max() > 1e-2
    np.testing.assert_allclose(exact.along, (ahead - behind) / 2e-6, atol=1e-7 * np.abs(exact.along).max())
    whole = chain.jacobian(N_RK, many, points)
    np.testing.assert_allclose(
        exact.jacobian, whole.jacobian, rtol=0, atol=1e-12 * np.abs(whole.jacobian).max()
    )


def test_one_step_is_the_shortest_chain(simplest):
    point = simplest.model.point({})[None, :]
    _, orbits = find_all(Solver.for_model(simplest.model), point)
    params = np.repeat(point, len(orbits), axis=0)
    chain = Chain(simplest)
    found, residual = chain.jacobian(N_RK, orbits.u, params)
    one = simplest.jacobian(N_RK, orbits.u, params)
    np.testing.assert_array_equal(found, one.jacobian)
    np.testing.assert_array_equal(residual, one.residual)
    np.testing.assert_array_equal(chain.multipliers(found), multipliers(one.jacobian))
    np.testing.assert_allclose(chain.newton(N_RK, orbits.u * 1.001, params), orbits.u, atol=1e-10)


def test_a_guess_that_leads_nowhere_is_reported_as_nan(simplest):
    point = simplest.model.point({})[None, :]
    chain = Chain(simplest, 2)
    guess = np.full((1, 2 * chain.width), np.nan)
    assert np.isnan(chain.newton(N_RK, guess, point)).all()


@pytest.mark.quick
def test_each_step_leads_to_the_next_and_the_last_to_the_first():
    """Three steps of a map that is known: the residual by hand, and its derivative by differences."""
    chain, value = Chain(MapKernels((p * x * (1 - x),), T - 1 - p * x), 3), 3.7
    z, periods = np.array([0.2, 0.5, 0.9]), np.array([1.0, 2.0, 3.0])
    u, params = np.stack([z, periods], axis=1).reshape(1, -1), np.array([[value]])
    images = value * z * (1 - z)
    expected = np.stack([images - z[[1, 2, 0]], periods - 1 - value * z], axis=1).reshape(1, -1)
    np.testing.assert_allclose(chain.residual(0, u, params), expected, rtol=0, atol=1e-14)
    exact = chain.jacobian(0, u, params)
    np.testing.assert_allclose(exact.residual, expected, rtol=0, atol=1e-14)
    shifts = 1e-6 * np.eye(6)
    columns = [
        (chain.residual(0, u + e, params) - chain.residual(0, u - e, params))[0] / 2e-6 for e in shifts
    ]
    np.testing.assert_allclose(exact.jacobian[0], np.array(columns).T, rtol=0, atol=1e-9)
    slopes = value * (1 - 2 * z)
    np.testing.assert_allclose(chain.multipliers(exact.jacobian)[0, 0], slopes.prod(), rtol=1e-12)
