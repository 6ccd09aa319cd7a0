"""Floquet multipliers against differences of the event-driven simulator's step map."""

import warnings

import numpy as np
import pytest

from stridemap.solver.cycles import floquet
from stridemap.solver.kernels.step_map import StepMap
from stridemap.solver.walks.simulator import walk
from tests.oracles.reference import POINTS, orbits_at, parameters, point_name, section_point

CYCLES_AT = (0, 1, 8, 9, 22)
"""Points with stable and unstable cycles of both models."""


def differences_of_the_step_map(model, p, z, size=3e-5):
    """Derivative of the simulator's step map by central differences of fourth order."""

    def image(column, factor):
        start = z.copy()
        start[column] += factor * size
        (step,) = walk(model, p, start, 1).steps
        return section_point(step)

    columns = [
        (8 * (image(j, 1) - image(j, -1)) - (image(j, 2) - image(j, -2))) / (12 * size) for j in range(len(z))
    ]
    return np.array(columns).T


@pytest.mark.parametrize("index", CYCLES_AT, ids=[point_name(POINTS[i]) for i in CYCLES_AT])
def test_multipliers_agree_with_differences_of_the_simulator(index):
    for orbit in orbits_at(index):
        model, p, z = orbit.model, parameters(orbit), section_point(orbit)
        derivative = differences_of_the_step_map(model, p, z)
        distance = np.abs(np.linalg.eigvals(derivative)[:, None] - np.array(orbit.multipliers))
        limit = 1e-6 * max(1.0, orbit.spectral_radius)
        assert distance.min(axis=0).max() < limit
        assert distance.min(axis=1).max() < limit
        jacobian = StepMap(model).jacobian(48)(np.append(z, orbit.period), p)[0].full()
        exact = floquet.step_map_derivative(jacobian[None])[0]
        np.testing.assert_allclose(exact, derivative, rtol=0, atol=1e-6 * np.abs(derivative).max())


def test_cycles_compared_are_stable_and_unstable():
    stable = [orbit.stable for index in CYCLES_AT for orbit in orbits_at(index)]
    assert stable.count(True) >= 4
    assert stable.count(False) >= 4


@pytest.mark.quick
def test_multipliers_are_ordered_and_survive_points_without_any():
    jacobian = np.full((2, 4, 4), np.nan)
    jacobian[0] = np.diag([-0.5 - 1, 0.0 - 1, 0.9 - 1, 2.0])
    values = floquet.multipliers(jacobian)
    np.testing.assert_allclose(values[0], [0.9, -0.5, 0.0], atol=1e-15)
    assert np.isnan(values[1]).all()


@pytest.mark.quick
def test_period_follows_the_section_point():
    """Where h depends on z and P on T, the period that follows z enters the derivative."""
    jacobian = np.array([[[1.0, 0.0, 3.0], [0.0, 1.0, 0.0], [2.0, 0.0, 4.0]]])
    np.testing.assert_allclose(floquet.step_map_derivative(jacobian)[0], [[2 - 3 * 2 / 4, 0], [0, 2]])


def test_a_foot_that_only_touches_has_no_multipliers_and_warns_of_nothing():
    grazing = np.eye(3)[None].repeat(2, axis=0)
    grazing[0, -1] = 1.0, 0.0, 0.0  # of the touchdown condition: its rate is zero
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        values = floquet.multipliers(grazing)
    assert np.isnan(values[0]).all()
    assert np.isfinite(values[1]).all()
