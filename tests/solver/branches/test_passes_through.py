"""Whether a curve that was followed passes through a point, where another curve runs beside it."""

from dataclasses import dataclass

import numpy as np
import pytest

from stridemap.solver.branches import arclength
from stridemap.solver.branches.arclength import CurvePoint, passes_through
from stridemap.solver.branches.curve import ZeroCurve


@dataclass(frozen=True)
class TwoSines(ZeroCurve):
    """``(u - sin p) (u - sin p - apart) = 0``."""

    apart: float
    scale = np.ones(2)

    def linearised(self, x, n_rk):
        u, p = x
        first = u - np.sin(p)
        slope = (2 * first - self.apart) / abs(self.apart)
        value = first * (first - self.apart) / abs(self.apart)
        return np.array([[slope, -slope * np.cos(p)]]), np.array([value])

    def n_rk(self, x):
        return 24

    def multipliers(self, matrix):
        return np.empty(0, dtype=complex)


def on_the_first(p):
    tangent = np.array([np.cos(p), 1.0])
    return CurvePoint(
        np.array([np.sin(p), p]), tangent / np.linalg.norm(tangent), np.empty((1, 2)), np.empty(0), 24
    )


POINTS = [on_the_first(p) for p in np.linspace(0.0, 3.0, 13)]


@pytest.mark.quick
@pytest.mark.parametrize("apart", [1e-3, 1e-4, -1e-4, 5e-5, -5e-5])
def test_a_point_of_the_curve_beside_it_is_not_one_of_the_curve(apart):
    """The doublings at k = 43, alpha = 0.0875 of the wobbling walker are 6e-5 apart."""
    curve = TwoSines(apart)
    for p in np.linspace(0.003, 2.997, 14).tolist():
        assert passes_through(curve, POINTS, np.array([np.sin(p), p])), p
        assert not passes_through(curve, POINTS, np.array([np.sin(p) + apart, p])), p


@pytest.mark.quick
@pytest.mark.parametrize("apart", [1e-3, -1e-3])
def test_a_step_aside_is_noticed_where_steps_are_too_long(apart, monkeypatch):
    monkeypatch.setattr(arclength, "SHORT", 0.1)
    test_a_point_of_the_curve_beside_it_is_not_one_of_the_curve(apart)


@pytest.mark.quick
def test_from_the_nearest_point_newtons_method_would_find_the_other_curve():
    """So that the test above asks for something."""
    curve, lost = TwoSines(1e-4), 0
    for p in np.linspace(0.0, 3.0, 61):
        x = np.array([np.sin(p) + curve.apart, p])
        nearest = min(POINTS, key=lambda one: np.linalg.norm(one.x - x))
        guess = nearest.x + curve.dot(x - nearest.x, nearest.tangent) * nearest.tangent
        found = curve.corrected(guess, nearest.tangent, 24, 10)
        lost += found.converged and np.linalg.norm(found.x - x) < 1e-5
    assert lost > 10


@pytest.mark.quick
def test_a_little_beyond_its_last_point_it_goes_on_and_far_away_it_passes_nothing():
    curve = TwoSines(1e-4)
    for p in (3.2, -0.2):
        assert passes_through(curve, POINTS, np.array([np.sin(p), p]))
        assert not passes_through(curve, POINTS, np.array([np.sin(p) + curve.apart, p]))
    for x in ([np.sin(4.0), 4.0], [0.5, 2.9], [5.0, 1.0]):
        assert not passes_through(curve, POINTS, np.array(x))
