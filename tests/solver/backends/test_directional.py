"""Exact derivatives of the residual in two directions, against complex numbers, Taylor series and CasADi."""

import numpy as np
import pytest

from stridemap.solver.backends.interpreter import Interpreter
from stridemap.solver.backends.lanes import Lanes
from stridemap.solver.cycles.search import find_all
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.kernels import catalogue
from stridemap.solver.model.loading import available, load
from stridemap.solver.options import SearchOptions
from tests.oracles import taylor
from tests.oracles.imaginary import imaginary
from tests.oracles.kernels import needs_compiler

pytestmark = needs_compiler

N_RK, FINE_N_RK = 24, 192


def points(name):
    """Kernels of a model, its cycles at the preset and a little off them, and two directions at each."""
    model = load(name)
    solver = Solver.for_model(model, Lanes())
    point = model.point({})[None, :]
    _, orbits = find_all(solver, point, SearchOptions(starts=64))
    u = np.concatenate([orbits.u, 1.01 * orbits.u])
    p = np.repeat(point, len(u), axis=0)
    rng = np.random.default_rng(7)
    a, b = rng.normal(size=(2, len(u), u.shape[1] + p.shape[1]))
    return model, solver.kernels, u, p, a, b


def assert_close(found, expected):
    """Equal to rounding, in terms of the largest entry."""
    assert np.abs(expected).max() > 1e-3
    np.testing.assert_allclose(found, expected, rtol=0, atol=2e-13 * np.abs(expected).max())


@pytest.mark.parametrize(
    "name",
    [
        pytest.param("simplest_walker", marks=pytest.mark.quick),
        *sorted(set(available()) - {"simplest_walker"}),
    ],
)
def test_against_an_imaginary_step(name):
    model, kernels, u, p, a, b = points(name)
    found = kernels.directional(N_RK, u, p, a, b)
    np.testing.assert_array_equal(found.residual, kernels.residual(N_RK, u, p))
    shown = (catalogue.residual(N_RK), catalogue.jacobian(N_RK))
    first, second = imaginary(model, shown, kernels.functions)
    nu = u.shape[1]
    for i in range(len(u)):
        x = np.concatenate([u[i], p[i]])
        assert_close(found.along_a[i], first.derivative(x, a[i])[0].ravel())
        assert_close(found.along_b[i], first.derivative(x, b[i])[0].ravel())
        # The Jacobian's columns of the section point, differentiated in both u and the parameters. That of
        # the period is the rate of the flow and not of the integrator; second derivatives are symmetric.
        in_u = a[i] * (np.arange(len(x)) < nu - 1)
        mixed = kernels.directional(N_RK, u[i : i + 1], p[i : i + 1], in_u[None], b[i : i + 1]).mixed[0]
        assert_close(mixed, second.derivative(x, b[i])[0] @ in_u[:nu])
    in_p = np.where(np.arange(a.shape[1]) < nu, 0.0, a)
    along = kernels.jacobian_along(N_RK, u, p, a[:, nu:]).along
    for i in range(len(u)):
        assert_close(along[i], first.derivative(np.concatenate([u[i], p[i]]), in_p[i])[0].ravel())


@pytest.mark.parametrize("name", sorted(available()))
def test_against_taylor_series_of_second_order(heyoka, name):
    """Another integrator, which differentiates the differential equations and not their discretisation."""
    model, kernels, u, p, a, b = points(name)
    found = kernels.directional(FINE_N_RK, u[-1:], p[-1:], a[-1:], b[-1:])
    expected = taylor.directional(heyoka, model, u[-1], p[-1], a[-1], b[-1])
    for own, other in zip(found[1:], expected[1:], strict=True):
        np.testing.assert_allclose(own[0], other, rtol=0, atol=1e-13 * np.abs(other).max())


@pytest.mark.parametrize("name", ["simplest_walker", "wobbling"])
def test_against_casadis_own_differentiation(name):
    model, kernels, u, p, a, b = points(name)
    found = kernels.directional(N_RK, u, p, a, b)
    for one, other in zip(
        found[1:], Interpreter().kernels(model).directional(N_RK, u, p, a, b)[1:], strict=True
    ):
        assert_close(one, other)


def test_second_derivatives_are_symmetric():
    _, kernels, u, p, a, b = points("simplest_walker")
    one = kernels.directional(N_RK, u, p, a, b)
    other = kernels.directional(N_RK, u, p, b, a)
    assert_close(one.mixed, other.mixed)
    np.testing.assert_array_equal(one.along_a, other.along_b)


@pytest.mark.quick
def test_no_points_have_no_derivatives():
    model = load("simplest_walker")
    kernels = Solver.for_model(model, Lanes()).kernels
    nu, n_params = len(model.section) + 1, len(model.parameters)
    empty = np.empty((0, nu + n_params))
    found = kernels.directional(N_RK, np.empty((0, nu)), np.empty((0, n_params)), empty, empty)
    assert [one.shape for one in found] == [(0, nu)] * 4
