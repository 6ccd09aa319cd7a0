"""Estimated errors of cycles and multipliers, held against what they estimate."""

import numpy as np
import pytest
from scipy.optimize import linear_sum_assignment

from stridemap.solver.backends.interpreter import Interpreter
from stridemap.solver.backends.lanes import Lanes
from stridemap.solver.cycles import floquet
from stridemap.solver.cycles.errors import Correction, differences, multiplier_error, size
from stridemap.solver.cycles.orbits import Orbits
from stridemap.solver.cycles.search import find_all
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.cycles.status import Status
from stridemap.solver.model.loading import load
from stridemap.solver.model.scales import Scales
from stridemap.solver.observables.measures import decided
from tests.oracles.kernels import needs_compiler
from tests.oracles.reference import GUESSES, NEXT_TO_A_FOLD, continue_one

EXACT_NEXT_TO_A_FOLD = (
    0.095765694950120647, -0.13635884229979062, -0.0024934759055502834, 0.0036866524364508979,
    0.20857107352601087, 1.171063693928899,
)  # fmt: skip
"""Section point and period of the cycle `NEXT_TO_A_FOLD`, from `benchmarks.references`."""

EXACT_MULTIPLIERS = (
    0.9999992212208824, 0.7454105871957067 + 0.45202319000162714j, 0.7454105871957067 - 0.45202319000162714j,
    -0.4926585711626694, 0.0,
)  # fmt: skip


@pytest.fixture(scope="module")
def some():
    """Cycles at 12 springs, with the same at a much higher resolution."""
    solver = Solver.for_model(load("wobbling"))
    points = np.array([solver.model.point({"k": k}) for k in (0.5, 2, 5.96, 6, 8, 12, 20, 22.5, 30, 45)])
    orbits = find_all(solver, points)[1]
    u = orbits.u.copy()
    for _ in range(4):
        jacobian, residual = solver.kernels.jacobian(384, u, orbits.params)
        u -= np.linalg.solve(jacobian, residual[:, :, None])[:, :, 0]
    exact = floquet.multipliers(solver.kernels.jacobian(384, u, orbits.params).jacobian)
    return orbits, u, exact


def test_errors_are_true_within_a_factor_of_three(some):
    orbits, u, multipliers = some
    assert len(orbits) > 12
    error = size(u - orbits.u, Scales.of(orbits.model).unknowns)
    for estimate, true in (
        (orbits.state_error, error),
        (orbits.multiplier_error, differences(orbits.multipliers, multipliers)),
    ):
        large = np.maximum(estimate, true) > 1e-13
        assert large.sum() > 8
        assert ((estimate / true)[large] < 3).all()
        assert ((estimate / true)[large] > 1 / 3).all()


def error_next_to_a_fold(orbit):
    """Of its state, in terms of the scales, and of its multipliers."""
    off = np.array([*orbit.state.values(), orbit.period]) - EXACT_NEXT_TO_A_FOLD
    multipliers = differences(np.array([orbit.multipliers]), np.array([EXACT_MULTIPLIERS]))
    return size(off[None], Scales.of(orbit.model).unknowns)[0], multipliers[0]


@needs_compiler
@pytest.mark.quick
def test_next_to_a_fold_the_errors_are_those_of_this_very_cycle():
    """The condition is 7e7: with residuals of twice the digits rounding neither hides nor makes an error."""
    _, _, orbit = continue_one(*NEXT_TO_A_FOLD, backend=Lanes())
    assert orbit.integration_error < 1e-11
    assert orbit.status is Status.CONVERGED
    state, multiplier = error_next_to_a_fold(orbit)
    assert 1e-13 < state < 1e-10
    assert orbit.state_error > 100 * orbit.integration_error
    assert orbit.state_error == pytest.approx(state, rel=0.5)
    assert orbit.multiplier_error == pytest.approx(multiplier, rel=0.5)
    assert orbit.stable is True


@pytest.mark.quick
def test_without_more_digits_the_errors_are_what_rounding_may_do():
    """The residual grows with the square of the distance: so near to the fold 1e-15 moves it by 1e-9."""
    _, _, orbit = continue_one(*NEXT_TO_A_FOLD, backend=Interpreter())
    assert orbit.integration_error < 1e-11
    assert orbit.status is Status.INACCURATE
    state, multiplier = error_next_to_a_fold(orbit)
    assert 1e-10 < state < 10 * orbit.state_error
    assert multiplier < 10 * orbit.multiplier_error


@pytest.mark.quick
def test_stability_is_not_known_where_1_lies_within_the_error():
    """Where the simplest walker's period doubles a multiplier is -1; to within what it is known to."""
    solver = Solver.for_model(load("simplest_walker"))
    guess = np.array([[0.2003, -0.1998, 3.8825]])

    def at(slope):
        nonlocal guess
        orbits = solver.converge(guess, solver.model.point({"slope": slope})[None], (1.0, 6.0))
        guess = orbits.u
        return orbits[0]

    for slope in np.linspace(0.009, 0.015, 13):
        at(slope)
    low, high = 0.015, 0.0152
    distance = [at(slope).spectral_radius - 1 for slope in (low, high)]
    assert distance[0] < 0 < distance[1]
    for _ in range(8):
        slope = high - distance[1] * (high - low) / (distance[1] - distance[0])
        low, high, distance = high, slope, [distance[1], at(slope).spectral_radius - 1]
        if abs(distance[1]) < 1e-13 or high == low:
            break
    orbit = at(high)
    assert orbit.status is Status.CONVERGED
    assert orbit.multipliers[0].real == pytest.approx(-1, abs=1e-11)
    assert abs(orbit.spectral_radius - 1) < orbit.multiplier_error
    assert orbit.stable is None
    assert "does not tell from 1" in orbit.undecided
    assert "not known" in orbit.summary
    assert orbit.to_dict()["stable"] is None
    near = continue_one(*GUESSES[Status.CONVERGED])[2]
    assert (near.stable, near.undecided, near.stability) == (True, "", "stable")


@pytest.mark.quick
def test_what_is_known_of_a_radius():
    radius, error = np.array([0.5, 1.05, 1 - 1e-9, 1 + 1e-9, 1 - 1e-9, 0.5]), np.full(6, 1e-8)
    error[4], error[5] = 1e-10, np.nan
    assert decided(radius, error).tolist() == [True, False, None, None, True, None]


def test_a_mask_selects_what_is_known_to_be_stable():
    _, _, orbit = continue_one(*GUESSES[Status.CONVERGED])
    orbits = Solver.for_model(orbit.model).converge(
        np.array([orbit.section_point]), orbit.model.point(orbit.params)[None], (0.3, 3.0)
    )
    columns = {**orbits.columns(), "stable": np.array([None], dtype=object)}
    unknown = Orbits.from_columns(orbits.model, columns)
    both = Orbits.concatenate(orbits.model, [orbits, unknown])
    assert both.stable.tolist() == [True, None]
    assert both.known_stable.tolist() == [True, False]
    assert len(both[both.stable]) == 1
    assert both[both.stable].stable.dtype == bool
    frame = both.to_frame()
    assert frame["stable"].isna().tolist() == [False, True]
    assert len(frame[frame.stable]) == 1
    with pytest.raises(TypeError):
        ~both.stable  # noqa: B018


# -- by hand -------------------------------------------------------------------------------------------------


@pytest.mark.quick
def test_a_correction_is_the_newton_step():
    jacobian = np.array([[[2.0, 1.0], [0.0, 1e-6]]])
    residual = np.array([[0.0, 1e-9]])
    correction = Correction.of(jacobian, residual, np.ones((1, 2)), np.ones(2))
    assert correction.change == pytest.approx(np.array([[0.5e-3, -1e-3]]))
    eps = np.finfo(float).eps
    assert 0.1 * eps < correction.rounding[0] < 10 * eps
    singular = Correction.of(np.zeros((1, 2, 2)), residual, np.ones((1, 2)), np.ones(2))
    assert np.isnan(singular.change).all()


@pytest.mark.quick
def test_eigenvalues_are_matched_whatever_their_order():
    one = np.array([[0.5 + 0.5j, 0.5 - 0.5j, 0.70710678]])
    other = np.array([[0.70710679, 0.5 - 0.5j, 0.5 + 0.5j]])
    assert differences(one, other)[0] == pytest.approx(1e-8)


@pytest.mark.quick
@pytest.mark.parametrize("size_of_change", [1e-9, 1e-3, 0.3])
def test_sets_of_eigenvalues_are_matched_at_the_least_cost(size_of_change):
    """Whether or not the order by modulus is found to be that match beforehand."""
    rng = np.random.default_rng(4)
    one = rng.choice([-0.5, 0.25, 0.5], (300, 4)) + 1j * rng.choice([0.0, 0.5, -0.5], (300, 4))
    other = one + size_of_change * (rng.normal(size=one.shape) + 1j * rng.normal(size=one.shape))
    for a, b, found in zip(one, other, differences(one, other), strict=True):
        distance = np.abs(a[:, None] - b)
        matched = distance[linear_sum_assignment(distance)].max()
        assert found == min(matched, np.abs(a - b).max())


@pytest.mark.quick
def test_a_defective_multiplier_is_off_by_the_root_of_the_rounding():
    """[[a, 1], [d, a]] has the eigenvalues a +- sqrt(d); rounding of the derivative is such a d."""

    def residual_jacobian(derivative):
        out = np.eye(3)[None].copy()
        out[0, :2, :2] = derivative - np.eye(2)
        return out

    exact = residual_jacobian(np.array([[0.5, 1.0], [0.0, 0.5]]))
    off = residual_jacobian(np.array([[0.5, 1.0], [1e-10, 0.5]]))
    assert multiplier_error(exact, off, np.ones(3))[0] == pytest.approx(1e-5, rel=0.02)
    rounding = multiplier_error(exact, exact, np.ones(3))[0]
    assert 1e-8 < rounding < 1e-6
    simple = residual_jacobian(np.diag([0.5, 0.25]))
    assert multiplier_error(simple, simple, np.ones(3))[0] < 1e-14


@pytest.mark.quick
def test_a_badly_conditioned_multiplier_is_off_by_its_condition():
    """[[a, c], [0, b]] turned by an angle: the condition of both eigenvalues is sqrt(1 + (c / (a - b))^2)."""
    derivative = np.array([[0.5, 1e6], [0.0, 0.25]])
    jacobian = np.eye(3)[None].copy()
    jacobian[0, :2, :2] = derivative - np.eye(2)
    estimate = multiplier_error(jacobian, jacobian, np.ones(3))[0]
    condition = np.hypot(1.0, 1e6 / 0.25)
    rounding = 0.5 * np.finfo(float).eps * np.linalg.norm(derivative)
    assert estimate == pytest.approx(rounding * condition, rel=1e-6)
