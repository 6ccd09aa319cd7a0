"""Whether a curve that was followed passes through a point, where another curve runs beside it."""

import numpy as np
import pytest

from stridemap.solver.branches.arclength import CurvePoint, passes_through
from stridemap.solver.branches.curve import ZeroCurve

APART = 1e-4
"""Distance of the two curves; half the distance of the doublings at k = 43, alpha = 0.0875 of the wobbling
walker."""


class TwoSines(ZeroCurve):
    """``(u - sin p) (u - sin p - APART) = 0``."""

    scale = np.ones(2)

    def linearised(self, x, n_rk):
        u, p = x
        first = u - np.sin(p)
        slope = 2 * first - APART
        return np.array([[slope, -slope * np.cos(p)]]) / APART, np.array([first * (first - APART)]) / APART

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
@pytest.mark.parametrize("p", [0.003, 0.1, 0.25, 0.374, 1.61, 2.9])
def test_a_point_of_the_curve_beside_it_is_not_one_of_the_curve(p):
    assert passes_through(TwoSines(), POINTS, np.array([np.sin(p), p]))
    assert not passes_through(TwoSines(), POINTS, np.array([np.sin(p) + APART, p]))


@pytest.mark.quick
def test_from_the_nearest_point_newtons_method_would_find_the_other_curve():
    """So that the test above asks for something."""
    curve, lost = TwoSines(), 0
    for p in np.linspace(0.0, 3.0, 61):
        x = np.array([np.sin(p) + APART, p])
        nearest = min(POINTS, key=lambda one: np.linalg.norm(one.x - x))
        guess = nearest.x + curve.dot(x - nearest.x, nearest.tangent) * nearest.tangent
        found = curve.corrected(guess, nearest.tangent, 24, 10)
        lost += found.converged and np.linalg.norm(found.x - x) < 1e-5
    assert lost > 10


@pytest.mark.quick
def test_beyond_its_last_point_and_far_away_it_passes_nothing():
    for x in ([np.sin(3.2), 3.2], [np.sin(-0.2), -0.2], [0.5, 2.9], [5.0, 1.0]):
        assert not passes_through(TwoSines(), POINTS, np.array(x))
