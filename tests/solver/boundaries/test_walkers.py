"""Boundaries of walkers: where two curves must meet, and counts of gaits on either side."""

import numpy as np
import pytest

import stridemap


@pytest.fixture(scope="module")
def resonance():
    """About a resonance 1:2 of the wobbling mass, at which a torus ends on a doubling."""
    ranges = ((0.95, 1.25), (0.47, 0.55))
    return stridemap.boundaries("wobbling", ("k", "alpha"), ranges, omega=3.0, lines=1, seeds=2)


def test_a_torus_ends_on_a_doubling(resonance):
    """The same point is found from both curves, each by its own way."""
    assert sorted(one.type for one in resonance) == ["ns", "pd"]
    double = [point for point in resonance.points if point.type == "r2"]
    kinds = {resonance[point.boundary].type for point in double}
    assert kinds == {"ns", "pd"}
    first, second = double
    for name in ("k", "alpha"):
        assert first.params[name] == pytest.approx(second.params[name], abs=1e-9)
    for name, value in first.state.items():
        assert second.state[name] == pytest.approx(value, abs=1e-8)
    np.testing.assert_allclose(np.sort_complex(first.multipliers)[:2], -1.0, atol=1e-4)  # a double root
    assert all(point.gait and point.residual < 1e-11 for point in double)
    (torus,) = (one for one in resonance if one.type == "ns")
    assert "double_multiplier" in torus.reasons


def test_every_point_solves_its_equations(resonance):
    for one in resonance:
        for point in one.points[1:-1]:
            _, values = one.curve.linearised(point.x, point.n_rk)
            assert np.abs(values).max() < 1e-11


def test_what_a_boundary_says_is_what_the_search_finds(resonance):
    """Beside the doubling, the multiplier at -1 lies on either side of the unit circle."""
    pd = max((one for one in resonance if one.type == "pd"), key=lambda one: one.borders_stable.sum())
    place = int(np.abs(pd.cycles[:, -1] - 0.535).argmin())
    k, alpha = pd.cycles[place, -2:]
    period = pd.curve.equations.steps(pd.cycles[place])[0, -1]
    beside = []
    for offset in (-0.003, 0.003):
        orbits = stridemap.find_orbits("wobbling", k=k + offset, alpha=alpha, omega=3.0)
        near = min(orbits, key=lambda orbit: abs(orbit.period - period))
        beside.append(min(near.multipliers, key=lambda one: abs(one + 1.0)).real + 1.0)
    assert beside[0] * beside[1] < 0
    assert max(map(abs, beside)) < 0.1


def test_multipliers_that_are_infinite_are_left_alone():
    """At a grazing touchdown the time of the touchdown has no derivative."""
    from stridemap.solver.branches.tables import by_continuity, pair

    curves = np.array([[0.5, -0.5], [-0.4, 0.6], [np.inf, np.nan], [0.7, -0.3]], dtype=complex)
    followed = by_continuity(curves)
    np.testing.assert_array_equal(followed[[0, 1, 3], 0], [0.5, 0.6, 0.7])
    np.testing.assert_array_equal(followed[2], curves[2])
    assert pair(complex(np.inf, 0.0)) == [None, 0.0]
