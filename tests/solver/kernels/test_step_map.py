"""The step map and its derivative against integrators that it shares nothing with."""

import cmath

import casadi as ca
import numpy as np
import pytest
from scipy.integrate import solve_ivp

from stridemap.solver.kernels.dormand_prince import ORDER
from stridemap.solver.kernels.step_map import StepMap
from stridemap.solver.model.loading import available, load
from stridemap.solver.walks.simulator import swing, walk
from tests.oracles import walkers
from tests.oracles.reference import (
    REFERENCE,
    reference_name,
    section_point,
)


def near_cycle(entry, scale):
    """Model, parameters and (z, T) on or near a reference orbit."""
    model = load(entry["model"])
    u = scale * np.append(section_point(entry), entry["period"])
    return model, model.point(entry["params"]), u


def call(function, *arguments):
    out = function(*arguments)
    return [np.array(m) for m in out] if isinstance(out, tuple) else np.array(out).ravel()


# -- order of convergence --------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "params", "period"),
    [
        ("wobbling", {"k": 60.0, "alpha": 0.2, "omega": 3.0}, 2.2),
        ("wobbling", {"k": 90.0, "alpha": 0.2, "omega": 3.0}, 2.2),
        ("compass", {"beta": 0.05, "Kp": 16.0, "Kd": 0.1, "omega": 2.0}, 2.2),
    ],
)
def test_integrator_converges_with_order_eight(name, params, period):
    model = load(name)
    step_map, p = StepMap(model), model.point(params)
    u = np.array([*(0.09, -0.15, -0.003, 0.002, 0.1)[: len(model.section)], period])
    exact = call(step_map.residual(768), u, p)
    errors = np.array([np.abs(call(step_map.residual(n), u, p) - exact).max() for n in (12, 24, 48, 96)])
    slopes = np.log2(errors[:-1] / errors[1:])
    assert errors[-1] > 1e-13  # far above rounding, or it would not tell
    assert slopes[1:] == pytest.approx([ORDER, ORDER], abs=0.3)
    assert ORDER == 8


# -- the flow and the impact -----------------------------------------------------------------------------


@pytest.mark.quick
@pytest.mark.parametrize("entry", REFERENCE, ids=reference_name)
def test_residual_agrees_with_the_event_driven_simulator(entry):
    """At the simulator's own touchdown time the residual is its closing error."""
    model, p, u = near_cycle(entry, 1.02)
    (step,) = walk(model, p, u[:-1], 1).steps
    residual = call(StepMap(model).residual(96), np.append(u[:-1], step.period), p)
    np.testing.assert_allclose(residual[:-1], section_point(step) - u[:-1], rtol=0, atol=2e-12)
    assert residual[-1] == pytest.approx(0, abs=2e-12)


@pytest.mark.parametrize("name", ["wobbling", "compass"])
def test_step_agrees_with_a_taylor_integrator(heyoka, name):
    """The same equations, symbolically in heyoka, integrated by Taylor series to 1e-15."""
    model = load(name)
    n = len(model.coordinates)
    state = list(heyoka.make_vars(*model.coordinates, *[f"d{c}" for c in model.coordinates]))
    pars = [heyoka.par[i] for i in range(len(model.parameters))]
    rate = model.equations.state_derivative(heyoka, heyoka.time, state[:n], state[n:], pars)
    system = list(zip(state, rate["dq"] + rate["dv"], strict=True))
    taylor = heyoka.taylor_adaptive(system, [0.0] * (2 * n), tol=1e-15)
    residual = StepMap(model).residual(96)

    def flow(z, p, time):
        start = model.evaluate("section_state", z=z)
        taylor.time = 0.0
        taylor.pars[:], taylor.state[:] = p, np.concatenate([start["q"], start["v"]])
        taylor.propagate_until(time)
        return taylor.state.copy()

    for entry in REFERENCE:
        if entry["model"] != name:
            continue
        for scale in (1.0, 1.02):
            _, p, u = near_cycle(entry, scale)
            y = flow(u[:-1], p, u[-1])
            closing = land(model, p, y[:n], y[n:]) - np.append(u[:-1], 0)
            assert np.abs(closing - call(residual, u, p)).max() < 1e-13
        # The simulator arrives where the Taylor series does, though it looks for the touchdown itself.
        phase = swing(model, p, u[:-1])
        np.testing.assert_allclose(phase.end, flow(u[:-1], p, phase.duration), rtol=0, atol=2e-12)


def land(model, p, q, v):
    """Section point after the impact, and the touchdown condition before it; also for complex numbers."""
    after = model.equations.impact_map(cmath if np.iscomplexobj(q) else np, q, v, p)
    values = dict(zip(model.coordinates, after["q_plus"], strict=True))
    values |= {f"d{c}": rate for c, rate in zip(model.coordinates, after["v_plus"], strict=True)}
    return np.array([*(values[name] for name in model.section), q[1] - 2 * q[0]])


# -- the derivative --------------------------------------------------------------------------------------


def complex_step_jacobian(model, p, u):
    """Derivative of the residual by complex steps through SciPy's integrator: exact but for its tolerance."""
    n, tiny = len(model.coordinates), 1e-30
    jacobian = np.empty((len(u), len(u)))
    for column in range(len(u)):
        w = u.astype(complex)
        w[column] += 1j * tiny
        z, period = w[:-1], w[-1]
        start = model.equations.section_state(cmath, z)

        def rate(s, y, period=period):
            out = model.equations.state_derivative(cmath, s * period, y[:n], y[n:], p)
            return period * np.array(out["dq"] + out["dv"])

        y0 = np.array([*start["q"], *start["v"]], dtype=complex)
        y = solve_ivp(rate, (0, 1), y0, "DOP853", rtol=1e-12, atol=1e-14).y[:, -1]
        jacobian[:, column] = (land(model, p, y[:n], y[n:]) - np.append(z, 0)).imag / tiny
    return jacobian


@pytest.mark.parametrize("scale", [1.0, 1.02])
@pytest.mark.parametrize("entry", REFERENCE, ids=reference_name)
def test_jacobian_agrees_with_complex_steps(entry, scale):
    model, p, u = near_cycle(entry, scale)
    jacobian, residual = call(StepMap(model).jacobian(48), u, p)
    expected = complex_step_jacobian(model, p, u)
    np.testing.assert_allclose(jacobian, expected, rtol=1e-9, atol=1e-10 * np.abs(expected).max())
    # Not bit for bit: with the tangents in the same graph, common subexpressions are others.
    np.testing.assert_allclose(residual.ravel(), call(StepMap(model).residual(48), u, p), rtol=0, atol=1e-14)


@pytest.mark.parametrize("name", [*sorted(available()), "locked", "two_motors"])
def test_derivative_in_the_parameters_is_that_of_the_residual(name):
    """CasADi differentiates the whole residual, in all parameters at once.

    With walkers whose state just after touchdown depends on parameters, and whose time is more than a phase.
    """
    model = load(name) if name in available() else walkers.derived(name)
    rng = np.random.default_rng(3)
    p = model.point({})
    u = np.append(0.1 * rng.normal(size=len(model.section)) * model.spec.scales, 1.3)
    d = rng.normal(size=len(p))
    step_map = StepMap(model)
    residual = step_map.residual(24)
    at, params = ca.MX.sym("u", len(u)), ca.MX.sym("p", len(p))
    exact = ca.Function("dR_dp", [at, params], [ca.jacobian(residual(at, params), params)])
    expected = np.array(exact(u, p)) @ d
    jacobian, along, closing = call(step_map.jacobian_along(24), u, p, d)
    assert np.abs(expected).max() > 1e-3
    np.testing.assert_allclose(along.ravel(), expected, rtol=0, atol=1e-12 * np.abs(expected).max())
    for own, other in zip((jacobian, closing), call(step_map.jacobian(24), u, p), strict=True):
        np.testing.assert_allclose(own, other, rtol=0, atol=1e-13 * np.abs(other).max())


# -- as C -----------------------------------------------------------------------------------------------


def test_rootfinder_prints_as_one_c_function():
    rootfinder = StepMap(load("wobbling")).rootfinder(12, 10, abstol=1e-12, abstol_step=1e-4)
    generator = ca.CodeGenerator("rootfinder.c")
    generator.add(rootfinder)
    text = generator.dump()
    assert "#error" not in text
    assert "casadi_newton(" in text
    kernels = load("wobbling").text("wobbling_kernels.c")
    assert "#error" not in kernels
