"""Sampled motions against the event-driven simulator's path and against the orbit's own measures."""

import numpy as np
import pytest

import stridemap
from stridemap.errors import InputError
from stridemap.solver.cycles.orbits import Orbits
from stridemap.solver.observables.motion import motions

POINTS = {"wobbling": {"k": 6.0, "alpha": 0.25, "omega": 3.0}, "compass": {"omega": 3.0}}


@pytest.fixture(scope="module", params=sorted(POINTS))
def orbit(request):
    return stridemap.find_orbits(request.param, **POINTS[request.param])[0]


def test_states_are_those_of_another_integrator(orbit):
    from scipy.integrate import solve_ivp

    seen = stridemap.motion(orbit, 57)
    model = orbit.model
    n, p = len(model.coordinates), model.point(orbit.params)

    def rate(t, y):
        out = model.evaluate("state_derivative", t=t, q=y[:n], v=y[n:], p=p)
        return np.concatenate([out["dq"], out["dv"]])

    start = np.concatenate([seen.q[0], seen.v[0]])
    path = solve_ivp(rate, (0, orbit.period), start, "DOP853", t_eval=seen.t, rtol=1e-12, atol=1e-13)
    assert np.abs(path.y.T - np.concatenate([seen.q, seen.v], axis=1)).max() < 1e-10


@pytest.mark.quick
def test_it_begins_and_ends_with_a_touchdown(orbit):
    seen = stridemap.motion(orbit)
    assert seen.t[0] == 0.0
    assert seen.t[-1] == orbit.period
    assert seen.coordinate("theta1")[0] == orbit.state["theta1"]
    assert seen.coordinate("dtheta2")[0] == orbit.state["dtheta2"]
    foot = seen.lines["legs"][:, -1]
    assert np.abs(foot[[0, -1], 1]).max() < 1e-12
    assert foot[-1, 0] == pytest.approx(orbit.step_length, abs=1e-11)  # closed to that


@pytest.mark.quick
def test_what_is_seen_agrees_with_the_measures(orbit):
    seen = stridemap.motion(orbit, 20_001)
    assert np.abs(seen.d).max() == pytest.approx(orbit.d_max, abs=1e-7)
    assert seen.force[:, 1].min() == pytest.approx(orbit.min_vertical_force, abs=1e-6)
    assert np.abs(seen.force[:, 0] / seen.force[:, 1]).max() == pytest.approx(orbit.friction, abs=1e-6)
    assert seen.torque.shape == (20_001, 1)
    power = seen.torque[:, 0] * seen.coordinate("dtheta2")
    assert np.trapezoid(np.abs(power), seen.t) == pytest.approx(orbit.work, rel=1e-5)


def test_the_centre_of_mass_is_that_of_the_masses(orbit):
    seen = stridemap.motion(orbit, 33)
    mean = np.einsum("m,nmi->ni", seen.masses, seen.positions) / seen.masses.sum()
    assert np.abs(mean - seen.com).max() < 1e-14


def test_many_are_what_each_is_alone():
    model = stridemap.load("wobbling")
    some = [stridemap.find_orbits(model, k=k, alpha=0.25, omega=3) for k in (6, 45)]
    orbits = Orbits.concatenate(model, some)
    together = motions(model, orbits.u, orbits.params, 21)
    for i, orbit in enumerate(orbits):
        alone = stridemap.motion(orbit, 21)
        assert np.array_equal(together.q[i], alone.q)
        assert np.array_equal(together.lines["spring"][i], alone.lines["spring"])


def test_refusals(orbit):
    with pytest.raises(InputError, match="samples = 1 is not allowed"):
        stridemap.motion(orbit, 1)
    with pytest.raises(InputError, match="has no coordinate 'y'; its coordinates are theta1"):
        stridemap.motion(orbit, 2).coordinate("y")
    failure = stridemap.Orbit(orbit.model, orbit.params, stridemap.Status.NOT_CONVERGED)
    with pytest.raises(InputError, match="status not_converged"):
        stridemap.motion(failure)
