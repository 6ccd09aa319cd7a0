"""What no built-in walker has (rolling feet, dampers, locks, a clock that goes on) against laws by hand."""

import numpy as np
import pytest

from stridemap.codegen import derive_model
from tests.oracles.everything import NAMES, WALKER, ByHand
from tests.oracles.remembered import remembered
from tests.oracles.states import MP, call, differences, exact, fifty_digits

COUNT = 300


@pytest.fixture(autouse=True)
def _digits():
    with fifty_digits():
        yield


@pytest.fixture(scope="module")
def model():
    """Derived with all its files, where it is not in the cache: the kernels are built too."""
    with remembered():
        return derive_model(WALKER)


@pytest.fixture(scope="module")
def at():
    """Random states and parameters, within a factor of two of the defaults."""
    rng = np.random.default_rng(11)
    angles, rates = rng.uniform(-1, 1, (COUNT, 4)), rng.uniform(-2, 2, (COUNT, 4))
    p = np.array(list(NAMES.values())) * rng.uniform(0.5, 2, (COUNT, len(NAMES)))
    rates[:, 3] = p[:, list(NAMES).index("omega")]
    torques = rng.uniform(-2, 2, (COUNT, 2))
    return {"t": rng.uniform(0, 1, COUNT), "q": angles, "v": rates, "p": p, "u": torques}


def assert_close(result, expected, tolerance=1e-11):
    assert result.shape == expected.shape
    assert np.abs(result - expected).max() < tolerance * (1 + np.abs(expected).max())


def test_swing_phase(model, at):
    hand = ByHand(model.source, at)
    acceleration, force = hand.motion()
    flow = model.evaluate("state_derivative", **at)
    assert_close(flow["dv"][:, :3], acceleration[:, 2:])
    assert not flow["dv"][:, 3].any()  # the clock keeps its rate
    assert_close(model.evaluate("ground_force", **at)["force"], force)
    assert_close(flow["dq"], at["v"])
    torques = model.evaluate("controller_torque", **at)["u"]
    assert model.actuated == ("psi", "theta2")  # as declared
    psi, dpsi, theta2, phase = at["q"][:, 2], at["v"][:, 2], at["q"][:, 1], at["q"][:, 3]
    assert_close(torques, np.stack([-2 * psi - dpsi, 3 * np.sin(phase) - theta2], axis=1))


def test_impact(model, at):
    after, impulse = ByHand(model.source, at).impact()
    result = model.evaluate("impact_map", **at)
    assert_close(result["v_plus"][:, :3], after)
    assert np.abs(result["v_plus"][:, 2] + result["v_plus"][:, 0]).max() < 1e-13  # locked
    np.testing.assert_allclose(result["v_plus"][:, 3], at["v"][:, 3], rtol=1e-14)
    theta1, theta2, psi, phase = at["q"].T
    assert_close(result["q_plus"], np.stack([theta1 - theta2, -theta2, psi, phase - 2 * np.pi], axis=1))
    assert_close(model.evaluate("impact_impulse", **at)["Lambda"], impulse)
    back = model.evaluate("before_touchdown", **{**at, "q": result["q_plus"]})["q_minus"]
    assert_close(back, at["q"])


def test_the_impact_takes_energy_and_the_walker_stays_where_it_is(model, at):
    ground = {**at, "q": at["q"].copy()}
    ground["q"][:, 1] = 2 * ground["q"][:, 0]
    result = model.evaluate("impact_map", **ground)
    after = {**ground, "q": result["q_plus"], "v": result["v_plus"]}
    energy = [model.evaluate("kinetic_energy", **place)["kinetic"] for place in (ground, after)]
    assert (energy[1] <= energy[0] * (1 + 1e-13)).all()
    length = model.evaluate("step_length", **after)["length"]
    moved = [model.evaluate("centre_of_mass", **place)["com"] for place in (ground, after)]
    assert_close(moved[0], moved[1] + np.stack([length, 0 * length], axis=1), 1e-14)


def test_what_is_measured(model, at):
    hand = ByHand(model.source, at)
    mass = sum(body.mass for body in hand.bodies)
    com = sum(body.mass[:, None] * hand.on_stance(body.point) for body in hand.bodies) / mass[:, None]
    assert_close(model.evaluate("centre_of_mass", **at)["com"], com, 1e-14)
    assert_close(model.evaluate("swing_foot", **at)["foot"], hand.on_stance(hand.foot), 1e-14)
    _, force = hand.motion()
    contact = -hand.par["radius"] * at["q"][:, 0]
    expected = com[:, 0] - force[:, 0] / force[:, 1] * com[:, 1] - contact
    zmp = model.evaluate("zmp", **at)["zmp"]
    assert np.abs((zmp - expected) / (1 + np.abs(expected))).max() < 1e-9
    totals = model.evaluate("total_mass", **at)
    g, slope = hand.par["g"], hand.par["slope"]
    assert_close(totals["mass"], mass)
    assert_close(totals["weight"], mass * g)
    assert_close(totals["pull"], mass * g * np.sin(slope))
    spring = 4 * at["q"][:, 2] ** 2 / 2
    height = -(hand.gravity * com).sum(axis=1) * mass
    assert_close(model.evaluate("potential_energy", **at)["potential"], height + spring)
    inertia, _ = hand.floating()
    rates = np.concatenate([0 * hand.v[:, :2], hand.v], axis=1)
    rates[:, 0] = -hand.par["radius"] * hand.v[:, 0]
    kinetic = np.einsum("ni,nij,nj->n", rates, inertia, rates) / 2
    assert_close(model.evaluate("kinetic_energy", **at)["kinetic"], kinetic)
    seen = model.evaluate("touchdown_condition", **at)
    assert_close(seen["h"], at["q"][:, 1] - 2 * at["q"][:, 0])  # turned so that it rises


def test_motors_give_and_dampers_take_all_the_power(model, at):
    """d(kinetic + potential)/dt along the flow, by differences at 50 digits."""
    few = {key: exact(value[:50]) for key, value in at.items()}
    flow = call(model.equations.state_derivative, MP, few)

    def energy(step):
        place = {**few, "q": few["q"] + step * flow["dq"], "v": few["v"] + step * flow["dv"]}
        parts = (
            call(model.equations.kinetic_energy, MP, place),
            call(model.equations.potential_energy, MP, place),
        )
        return parts[0]["kinetic"] + parts[1]["potential"]

    step = exact(1e-16)
    change = (energy(step) - energy(-step)) / (2 * step)
    torque = call(model.equations.controller_torque, MP, few)["u"]
    w1, w2, w3, _ = few["v"].T
    damped = few["p"][:, list(NAMES).index("c")] * (w3 + w1) ** 2
    supplied = torque[:, 0] * w3 + torque[:, 1] * w2
    assert np.abs(change - supplied + damped).max() < 1e-24


@pytest.mark.parametrize(
    ("function", "output", "parent", "of", "which"),
    [
        ("state_derivative_dq", "dv_dq", "state_derivative", "dv", "q"),
        ("state_derivative_dv", "dv_dv", "state_derivative", "dv", "v"),
        ("impact_map_dq", "v_plus_dq", "impact_map", "v_plus", "q"),
        ("impact_map_dv", "v_plus_dv", "impact_map", "v_plus", "v"),
        ("touchdown_condition_dq", "h_dq", "touchdown_condition", "h", "q"),
        *((f"forward_dynamics_d{x}", f"dv_d{x}", "forward_dynamics", "dv", x) for x in "qvup"),
    ],
)
def test_derivatives(model, at, function, output, parent, of, which):
    few = {key: exact(value[:50]) for key, value in at.items()}
    expected = differences(getattr(model.equations, parent), few, of, which)
    result = call(getattr(model.equations, function), MP, few)[output]
    assert np.abs(result - expected).max() < 1e-26


def test_the_motion_is_that_of_the_controllers_torques(model, at):
    torques = model.evaluate("controller_torque", **at)["u"]
    moved = model.evaluate("forward_dynamics", **{**at, "u": torques})["dv"]
    assert_close(moved, model.evaluate("state_derivative", **at)["dv"])


def test_the_section(model):
    assert model.section == ("theta1", "dtheta1", "dtheta2", "psi", "phase")
    z = np.array([0.2, -0.5, 0.3, 0.1, 1.7])
    state = model.evaluate("section_state", z=z, p=model.point({}))
    np.testing.assert_array_equal(state["q"], [0.2, 0.4, 0.1, 1.7])
    np.testing.assert_array_equal(state["v"], [-0.5, 0.3, 0.5, 3.0])
