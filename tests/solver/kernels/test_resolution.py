"""The number of Runge-Kutta steps follows the fastest mode: what a stiff spring needs, and what it gets."""

import numpy as np
import pytest

from stridemap.solver.kernels.catalogue import CYCLE_N_RK, SEARCH_N_RK
from stridemap.solver.kernels.resolution import Resolution
from stridemap.solver.kernels.step_map import StepMap
from stridemap.solver.model.loading import load

PERIOD = 1.9
Z = np.array([0.09, -0.15, -0.003, 0.002, 0.1])


def stiff(k, alpha):
    model = load("wobbling")
    return model, model.point({"k": k, "alpha": alpha})


@pytest.mark.quick
def test_the_fastest_mode_is_that_of_the_spring():
    """Upright and at rest the mass oscillates against the hip as if the legs had no part in it."""
    model, p = stiff(20.0, 0.25)
    mode = Resolution(model).fastest_mode(p[None])[0]
    assert mode == pytest.approx(np.sqrt(20.0 / (0.25 * 0.75)), rel=0.1)
    wheel = load("rimless_wheel")
    mode = Resolution(wheel).fastest_mode(wheel.point({"lambda2": 0.49, "slope": 0.2})[None])[0]
    assert mode == pytest.approx(
        0.7 * np.sqrt(np.cos(0.2)), rel=1e-12
    )  # ddtheta = lambda2 sin(theta + slope)


@pytest.mark.quick
def test_fastest_modes_are_kept_up_to_a_bound(monkeypatch):
    model = load("wobbling")
    points = np.array([model.point({"k": k}) for k in (1.0, 4.0, 9.0, 16.0, 25.0)])
    alone = np.array([Resolution(model).fastest_mode(point[None])[0] for point in points])
    monkeypatch.setattr("stridemap.solver.kernels.resolution.KEPT", 3)
    resolution = Resolution(model)
    computed = []
    compute = Resolution._fastest_mode
    monkeypatch.setattr(
        Resolution, "_fastest_mode", lambda one, params: computed.append(len(params)) or compute(one, params)
    )
    for some in ([], [0, 1, 0], [1, 2], [3, 2], [0, 1, 2, 3, 4]):
        np.testing.assert_array_equal(resolution.fastest_mode(points[some]), alone[some])
        assert len(resolution._known) <= max(3, len(some))
    assert computed == [2, 1, 1, 4]


@pytest.mark.parametrize(
    ("choose", "choices", "spring", "allowed"),
    [("search_n_rk", SEARCH_N_RK, (60.0, 0.1), 1e-4), ("cycle_n_rk", CYCLE_N_RK, (20.0, 0.25), 1e-9)],
)
def test_a_step_with_a_stiff_spring_is_resolved(choose, choices, spring, allowed):
    """By comparison with many more steps; the fewest would not do."""
    model, p = stiff(*spring)
    u = np.array([*Z, PERIOD])
    n = int(getattr(Resolution(model), choose)(np.array([PERIOD]), p[None])[0])
    step_map = StepMap(model)

    def closing(n_rk):
        return np.array(step_map.residual(n_rk)(u, p)).ravel()

    errors = [np.abs(closing(m) - closing(384)).max() for m in (n, choices[0])]
    assert errors[0] < allowed < errors[1]
