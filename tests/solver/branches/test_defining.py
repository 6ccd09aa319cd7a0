"""Newton's method on the defining systems of bifurcations, on maps whose bifurcations are known."""

from dataclasses import replace

import numpy as np
import pytest

from stridemap.solver.branches.arclength import CurvePoint
from stridemap.solver.branches.bifurcation import SpecialType
from stridemap.solver.branches.defining import Attempt
from tests.oracles.maps import MapKernels, curve, p, x

pytestmark = pytest.mark.quick


def beside(on, z, value):
    """A guess beside a branch."""
    at = np.array([z, 1.0, value])
    matrix, _ = on.linearised(at, 24)
    return CurvePoint(at, on.tangent(matrix, np.array([1.0, 0.0, 0.0])), matrix, on.multipliers(matrix), 24)


@pytest.fixture
def counted(monkeypatch):
    """How often second derivatives were asked for."""
    count, directional = [0], MapKernels.directional

    def one_more(self, *arguments):
        count[0] += 1
        return directional(self, *arguments)

    monkeypatch.setattr(MapKernels, "directional", one_more)
    return count


def test_one_gradient_serves_for_several_newton_steps(counted):
    """Of seven, which become shorter slowly at first: three gradients, and another one for the slope."""
    on = curve(x + p - x**2 + x**3)
    (fold,) = Attempt.answers([Attempt(SpecialType.FOLD, on, beside(on, 0.1, 0.02))])
    np.testing.assert_allclose(fold.x, [0.0, 1.0, 0.0], rtol=0, atol=1e-13)
    assert fold.slope == pytest.approx(2.0, rel=1e-9)
    assert counted[0] == 4


def test_what_was_found_at_a_coarser_resolution_takes_no_second_derivatives(counted):
    """It moves by the error of the coarse one, and keeps its slope."""
    on = curve(x + p - x**2, error=1e-6)
    (fold,) = Attempt.answers([Attempt(SpecialType.FOLD, on, beside(on, 0.1, 0.02))])
    error = 1e-6 * (24 / 48) ** 8
    assert fold.x[-1] == pytest.approx(-error, rel=1e-3)
    counted[0] = 0
    guess = replace(beside(on, *fold.x[[0, -1]]), n_rk=192)
    (finer,) = Attempt.answers([Attempt(SpecialType.FOLD, on, guess, before=fold)])
    assert abs(finer.x[-1]) < 1e-13
    assert finer.slope == fold.slope
    assert counted[0] == 0


def test_a_special_point_is_not_looked_for_beyond_reach():
    """Two guesses of which only one is near enough, answered together."""
    on = curve(x + p - x**2)
    guesses = [beside(on, z, z**2) for z in (0.3, 0.05)]
    near, far = (
        Attempt.answers([Attempt(SpecialType.FOLD, on, one, r) for one in guesses]) for r in (0.2, 2)
    )
    assert [one is None for one in near] == [True, False]
    assert [one is None for one in far] == [False, False]
    for one in (near[1], *far):
        np.testing.assert_allclose(one.x, [0.0, 1.0, 0.0], rtol=0, atol=1e-12)
