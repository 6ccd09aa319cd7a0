"""Physics of the generated equations, and their derivation by other methods.

Each property holds at 1,000 random states and parameters.
"""

from decimal import Decimal

import casadi as ca
import numpy as np
import pytest

from stridemap.solver.model.loading import load
from tests.oracles.newton import Newton, by_hand
from tests.oracles.second_derivation import equations, kane, lagrange
from tests.oracles.states import MODELS, MP, call, exact, fifty_digits, on_section, states

WITH_MASSES = [name for name in MODELS if name != "simplest_walker"]
all_models = pytest.mark.parametrize("name", MODELS)


@pytest.fixture(autouse=True)
def _fifty_digits():
    """Decimal numbers have 50 digits in all of this."""
    with fifty_digits():
        yield


def quantities(name, *functions, at=None):
    """Outputs of generated functions at all random states, in one dict."""
    values = states(name) if at is None else at
    return {k: v for f in functions for k, v in load(name).evaluate(f, **values).items()}


def assert_close(result, expected, tolerance=1e-11, scale=None):
    """Equal relative to the largest entry at each state, or to `scale`."""
    if scale is None:
        scale = np.abs(expected).reshape(len(expected), -1).max(axis=1)
    error = np.abs(result - expected).reshape(len(expected), -1).max(axis=1)
    assert (error <= tolerance * (1 + scale)).all(), f"off by {(error / (1 + scale)).max():.1e}"


# -- other methods -------------------------------------------------------------------------------------------


def second_equations(method, name, at, *more):
    """Mass matrix and force at all states by another method; `more` are further parameters (name, value)."""
    parameters = [a.name for a in load(name).parameters] + [key for key, _ in more]
    evaluate = equations(method, name, load(name).coordinates, parameters)
    torque = np.zeros(len(at["t"]))
    if load(name).actuated:
        torque = quantities(name, "controller_torque", at=at)["u"][:, 0]
    values = [value + 0 * at["t"] for _, value in more]
    columns = [*at["q"].T, *at["v"].T, *at["p"].T, *values, torque]
    results = [evaluate(*row) for row in zip(*columns, strict=True)]
    return np.array([r[0] for r in results]), np.array([np.ravel(r[1]) for r in results])


@pytest.mark.parametrize("name", WITH_MASSES)
@pytest.mark.parametrize("method", [lagrange, kane])
def test_another_method_gives_the_same_equations(name, method):
    at = states(name)
    mass_matrix, force = second_equations(method, name, at)
    generated = quantities(name, "mass_matrix", "bias_forces", "state_derivative")
    applied = np.zeros_like(force)
    if load(name).actuated:
        applied[:, 1] = quantities(name, "controller_torque")["u"][:, 0]
    bias = sum(generated.get(part, 0) for part in ("h", "v_gravity", "v_spring", "damping"))
    assert_close(generated["M"], mass_matrix)
    assert_close(applied - bias, force)
    accelerations = np.linalg.solve(mass_matrix, force[..., None])[..., 0]
    condition = np.linalg.cond(mass_matrix)
    assert_close(generated["dv"], accelerations, 1e-14, condition * (1 + np.abs(force).max(axis=1)))


@pytest.mark.parametrize("name", WITH_MASSES)
def test_impact_solves_the_full_system_of_the_floating_base(name):
    """``Me (v+ - v-) = J^T Lambda, J v+ = 0`` with Me and J from positions, solved with pivoting."""
    at, generated = states(name), quantities(name, "impact_map", "impact_impulse")
    walker = by_hand(name, at)
    after, impulse, condition = full_impact(walker)
    tolerance = 1e-12 * condition
    assert (np.abs(generated["v_plus"] - walker.swapped(after)).max(axis=1) < tolerance).all()
    assert (np.abs(generated["Lambda"] - impulse).max(axis=1) < tolerance).all()


def full_impact(walker):
    """Rates after the impact, impulse on the swing foot, and the condition of the system they solve."""
    inertia, jacobian = walker.floating()
    none = np.zeros((walker.count, 2, 2))
    system = np.block([[inertia, -jacobian.transpose(0, 2, 1)], [jacobian, none]])
    before = np.concatenate([np.zeros((walker.count, 2)), walker.v], axis=1)
    right = np.concatenate([np.einsum("nij,nj->ni", inertia, before), np.zeros((walker.count, 2))], axis=1)
    solution = np.linalg.solve(system, right[..., None])[..., 0]
    after, impulse = solution[:, : walker.n + 2], solution[:, walker.n + 2 :]
    assert np.abs(np.einsum("nij,nj->ni", jacobian, after)).max() < 1e-11
    return after[:, 2:], impulse, np.linalg.cond(system)


# -- the limit of feet without mass --------------------------------------------------------------------------


class Heavy(Newton):
    """The simplest walker with masses at its feet, by the laws of any walker with masses."""

    def __init__(self, foot, values):
        self.foot_mass = foot
        super().__init__("simplest_walker", values, MP)

    def build(self):
        self.par["beta"] = self.foot_mass + 0 * self.t
        super().build()


LIMITS = {  # what follows from the equations, and what is summed over the bodies
    "state_derivative": "dv", "impact_map": "v_plus", "impact_impulse": "Lambda", "ground_force": "force",
    "kinetic_energy": "kinetic", "potential_energy": "potential", "centre_of_mass": "com",
    "total_mass": "mass",
}  # fmt: skip


def test_feet_without_mass_are_the_limit_of_light_ones():
    """A hundredth of the mass leaves a hundredth of the deviation, by Newton's laws at 50 digits."""
    at = {key: value[:200] for key, value in states("simplest_walker").items()}
    seen = quantities("simplest_walker", *LIMITS, at=at)
    at = {key: exact(value) for key, value in at.items()}
    light = [Heavy(Decimal(10) ** -n, at) for n in (4, 6, 8)]
    for function, key in LIMITS.items():
        off = [np.abs(getattr(walker, function)()[key] - exact(seen[key])).astype(float) for walker in light]
        coarse, fine, finest = (x.max() for x in off)
        assert finest < 1e-5, key
        assert [coarse / fine, fine / finest] == pytest.approx([100, 100], rel=0.05), key


@pytest.mark.parametrize("method", [lagrange, kane])
def test_other_methods_tend_to_the_simplest_walker_as_its_feet_lose_their_mass(method):
    at, dv = states("simplest_walker"), quantities("simplest_walker", "state_derivative")["dv"]
    off = []
    for foot in (1e-4, 1e-6, 1e-8):
        mass_matrix, force = second_equations(method, "simplest_walker", at, ("foot_mass", foot))
        off.append(np.abs(np.linalg.solve(mass_matrix, force[..., None])[..., 0] - dv).max())
    assert off[-1] < 1e-5
    assert [off[0] / off[1], off[1] / off[2]] == pytest.approx([100, 100], rel=0.05)


def test_the_published_equations_of_the_simplest_walker():
    """Garcia, Chatterjee, Ruina, Coleman 1998, eqs. (1) to (3), word by word."""
    at = on_section("simplest_walker")
    (theta, phi), (dtheta, _), gamma = at["q"].T, at["v"].T, at["p"][:, 0]
    ddtheta, ddphi = quantities("simplest_walker", "state_derivative", at=at)["dv"].T
    first = ddtheta - np.sin(theta - gamma)
    second = ddtheta - ddphi + dtheta**2 * np.sin(phi) - np.cos(theta - gamma) * np.sin(phi)
    assert max(np.abs(first).max(), np.abs(second).max()) < 1e-14
    after = quantities("simplest_walker", "impact_map", at=at)
    shrink = np.cos(2 * theta)
    published = [-theta, shrink * dtheta, -2 * theta, shrink * (1 - shrink) * dtheta]
    mine = [after["q_plus"][:, 0], after["v_plus"][:, 0], after["q_plus"][:, 1], after["v_plus"][:, 1]]
    assert np.abs(np.array(mine) - published).max() < 1e-14
    # What the section takes the rate of the swing leg for is what the impact gives.
    section = {**at, "z": np.stack([after["q_plus"][:, 0], after["v_plus"][:, 0]], axis=-1)}
    section = quantities("simplest_walker", "section_state", at=section)
    assert np.abs(section["q"] - after["q_plus"]).max() < 1e-15
    assert np.abs(section["v"] - after["v_plus"]).max() < 1e-14


def test_the_impact_of_the_rimless_wheel_is_the_one_in_closed_form():
    slope, spokes, lambda2 = states("rimless_wheel")["p"].T
    before, after = after_impact("rimless_wheel")
    mu = 1 + lambda2 * (np.cos(2 * np.pi / spokes) - 1)
    assert np.abs(after["v"][:, 0] - mu * before["v"][:, 0]).max() < 1e-14
    assert np.abs(after["q"][:, 0] + np.pi / spokes).max() < 1e-15
    acceleration = quantities("rimless_wheel", "state_derivative", at=before)["dv"][:, 0]
    assert np.abs(acceleration - lambda2 * np.sin(before["q"][:, 0] + slope)).max() < 1e-15


# -- swing phase ---------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", WITH_MASSES)
def test_mass_matrix_is_symmetric_and_positive_definite(name):
    matrix = quantities(name, "mass_matrix")["M"]
    np.testing.assert_array_equal(matrix, matrix.transpose(0, 2, 1))
    assert np.linalg.eigvalsh(matrix).min() > 0


@all_models
def test_the_motors_supply_all_the_power_that_dampers_leave(name):
    """d(kinetic + potential)/dt = sum of torque times rate along the flow, with exact derivatives."""
    model, at = load(name), states(name)
    sizes = {"t": 1, "q": at["q"].shape[1], "v": at["v"].shape[1], "p": at["p"].shape[1]}
    symbols = {key: ca.SX.sym(key, size) for key, size in sizes.items()}

    def generated(function):
        compiled = getattr(model, function)
        return compiled(**{key: symbols[key] for key in compiled.reads})

    energy = generated("kinetic_energy")["kinetic"] + generated("potential_energy")["potential"]
    flow = generated("state_derivative")
    moving, along = ca.vertcat(symbols["q"], symbols["v"]), ca.vertcat(flow["dq"], flow["dv"])
    rates = [symbols["v"][model.coordinates.index(c)] for c in model.actuated]
    power = ca.dot(generated("controller_torque")["u"], ca.vertcat(*rates)) if rates else ca.SX(0)
    bias = generated("bias_forces")
    if "damping" in bias:
        power -= ca.dot(bias["damping"], symbols["v"])
    # The powers of the single coordinates are large and cancel: they set the scale.
    parts = ca.jacobian(energy, moving).T * along
    check = ca.Function("check", list(symbols.values()), [ca.sum1(parts), power, ca.norm_1(parts)])
    columns = [at[key].T.reshape(size, -1) for key, size in sizes.items()]
    change, supplied, scale = (np.array(out).ravel() for out in check.map(len(at["t"]))(*columns))
    assert_close(change, supplied, 1e-12, scale)


def fifty_digit_flow(name):
    """States, rates and accelerations at 50 digits, and generated functions along the parabola there."""
    at = {key: exact(value) for key, value in states(name).items()}
    flow = call(load(name).equations.state_derivative, MP, at)

    def moved(function, time):
        time = exact(time)
        q = at["q"] + time * flow["dq"] + time**2 / 2 * flow["dv"]
        place = {**at, "q": q, "v": at["v"] + time * flow["dv"]}
        return call(getattr(load(name).equations, function), MP, place)

    return moved


@all_models
def test_ground_force_and_zmp_follow_from_the_motion_of_the_centre_of_mass(name):
    """By differences at 50 digits: steps of 1e-15 leave errors of about 1e-20."""
    moved, step = fifty_digit_flow(name), Decimal("1e-15")
    behind, here, ahead = (moved("centre_of_mass", s * step) for s in (-1, 0, 1))
    velocity = (ahead["com"] - behind["com"]) / (2 * step)
    acceleration = (ahead["com"] - 2 * here["com"] + behind["com"]) / step**2
    assert np.abs(velocity - here["dcom"]).max() < 1e-24
    assert np.abs(acceleration - (ahead["dcom"] - behind["dcom"]) / (2 * step)).max() < 1e-14

    acceleration = acceleration.astype(float)
    generated = quantities(name, "ground_force", "total_mass", "zmp", "centre_of_mass")
    gravity = by_hand(name, states(name)).gravity
    assert_close(generated["force"], generated["mass"][:, None] * (acceleration - gravity), 1e-9)
    assert_close(generated["weight"], generated["mass"] * np.linalg.norm(gravity, axis=1))
    assert_close(generated["pull"], generated["mass"] * gravity[:, 0])

    x_g, y_g = generated["com"].T
    along, up = (acceleration - gravity).T
    expected = x_g - along / up * y_g  # the paper's (6), where up is 1 + ddy_g
    # Where the ground hardly bears, the point is far away and ill-conditioned.
    scale = np.abs(expected) + np.abs(acceleration).max(axis=1) * (1 + np.abs(expected)) / np.abs(up)
    assert_close(generated["zmp"], expected, 1e-9, scale)
    np.testing.assert_array_equal(generated["d"], -generated["zmp"])


@all_models
def test_swing_foot_moves_at_its_velocity(name):
    moved, step = fifty_digit_flow(name), Decimal("1e-15")
    behind, here, ahead = (moved("swing_foot", s * step) for s in (-1, 0, 1))
    assert np.abs((ahead["foot"] - behind["foot"]) / (2 * step) - here["dfoot"]).max() < 1e-24


# -- impact --------------------------------------------------------------------------------------------------


def after_impact(name):
    """The state before an impact on the section and the one after it."""
    before = on_section(name)
    result = quantities(name, "impact_map", at=before)
    return before, {**before, "q": result["q_plus"], "v": result["v_plus"]}


@pytest.mark.parametrize("name", WITH_MASSES)
def test_impact_keeps_the_momentum_about_the_new_foot(name):
    """The generalised momentum after it is that of the velocities before it, in the new coordinates."""
    before, after = after_impact(name)
    momentum = np.einsum("nij,nj->ni", quantities(name, "mass_matrix", at=after)["M"], after["v"])
    # The bodies before and after, in the same order: those of the legs change places.
    old, new = (by_hand(name, at).bodies for at in (before, after))
    if len(new) > 1:
        new[-2:] = new[:-3:-1]
    kept = 0
    for one, other in zip(old, new, strict=True):
        velocity = np.einsum("nci,ni->nc", one.point.jacobian, before["v"])
        kept = kept + one.mass[:, None] * np.einsum("nci,nc->ni", other.point.jacobian, velocity)
        if one.inertia is not None:
            spin = (one.turn * before["v"]).sum(axis=1)
            kept = kept + (one.inertia * spin)[:, None] * other.turn
    assert_close(momentum, kept)


@all_models
def test_impact_loses_the_energy_that_the_impulse_takes(name):
    before, after = after_impact(name)
    lost = quantities(name, "kinetic_energy", at=before)["kinetic"]
    scale = 1 + lost
    lost = lost - quantities(name, "kinetic_energy", at=after)["kinetic"]
    assert (lost >= -1e-13 * scale).all()
    # Half the impulse times the velocity that it brings to rest; the other foot is free.
    at_impact = quantities(name, "impact_impulse", "swing_foot", at=before)
    assert_close(lost, -(at_impact["Lambda"] * at_impact["dfoot"]).sum(axis=1) / 2, 1e-11, scale)


@all_models
def test_swapping_the_legs_twice_changes_nothing(name):
    before, after = after_impact(name)
    back = quantities(name, "before_touchdown", at=after)["q_minus"]
    np.testing.assert_allclose(back, before["q"], rtol=0, atol=1e-15)
    if name != "rimless_wheel":  # its next spoke is another one
        twice = quantities(name, "impact_map", at=after)["q_plus"]
        np.testing.assert_allclose(twice, before["q"], rtol=0, atol=1e-15)


@all_models
def test_a_step_is_as_long_as_the_swing_foot_was_ahead(name):
    before, after = after_impact(name)
    landed = quantities(name, "swing_foot", at=before)["foot"][:, 0]
    length = quantities(name, "step_length", at=after)["length"]
    np.testing.assert_allclose(length, landed, atol=1e-15)
    # Seen from the new foot the walker is where it was.
    before, after = (quantities(name, "centre_of_mass", at=at)["com"] for at in (before, after))
    np.testing.assert_allclose(before - after, np.stack([length, 0 * length], axis=1), atol=1e-15)


@all_models
def test_both_feet_are_on_the_ground_on_the_section_and_after_an_impact_there(name):
    model, at = load(name), states(name)
    on_ground = {**at, **quantities(name, "section_state")}
    if name == "rimless_wheel":  # its angle on the section is free, and the foot on the ground is behind
        on_ground = after_impact(name)[1]
    for place in (on_ground, after_impact(name)[1]):
        foot = quantities(name, "swing_foot", at=place)["foot"]
        if name == "rimless_wheel":
            foot = quantities(name, "drawing", at=place)["spoke_behind"][:, -1]
        assert np.abs(foot[:, 1]).max() < 1e-15
        assert np.abs(quantities(name, "touchdown_condition", at=place)["h"]).max() < 1e-15
    on_ground = {**at, **quantities(name, "section_state")}
    # The free coordinates of the section stand where they belong.
    names = [*model.coordinates, *("d" + c for c in model.coordinates)]
    columns = dict(zip(names, [*on_ground["q"].T, *on_ground["v"].T], strict=True))
    np.testing.assert_array_equal(np.stack([columns[n] for n in model.section], axis=-1), at["z"])


@pytest.mark.parametrize("name", ["wobbling", "compass", "simplest_walker"])
def test_impact_forgets_the_swing_foot(name):
    """Where a leg's mass is at its foot, its own speed is lost: one multiplier is exactly zero."""
    assert not quantities(name, "impact_map_dv")["v_plus_dv"][:, :, 1].any()


# -- the two models ------------------------------------------------------------------------------------------


def held_wobbler(alpha):
    """Random states of the compass, and the same ones with a wobbling mass at rest above the hip."""
    compass = states("compass")
    rest = np.zeros((len(compass["t"]), 1))
    shared = dict(zip([a.name for a in load("compass").parameters], compass["p"].T, strict=True))
    shared |= {"k": 0 * compass["t"], "alpha": alpha + 0 * compass["t"], "c": 0 * compass["t"]}
    parameters = np.stack([shared[a.name] for a in load("wobbling").parameters], axis=-1)
    at = {key: np.concatenate([compass[key], rest], axis=-1) for key in ("q", "v")}
    return {**compass, **at, "p": parameters}


def test_a_wobbling_mass_held_at_the_hip_makes_a_compass():
    wobbling = held_wobbler(0.4)
    functions = ["mass_matrix", "bias_forces", "controller_torque", "kinetic_energy", "potential_energy"]
    functions += [
        "total_mass",
        "before_touchdown",
        "step_length",
        "centre_of_mass",
        "swing_foot",
        "touchdown_condition",
    ]
    result = quantities("wobbling", *functions, at=wobbling)
    for key, value in quantities("compass", *functions).items():
        angles = tuple(slice(size) for size in value.shape)  # without the wobbling mass's own entries
        assert_close(result[key][angles], value, 1e-14)


def test_a_vanishing_wobbling_mass_leaves_a_compass():
    wobbling = held_wobbler(1e-9)
    functions = ["state_derivative", "impact_map", "impact_impulse", "ground_force"]
    result = quantities("wobbling", *functions, at=wobbling)
    for key, value in quantities("compass", *functions).items():
        assert_close(result[key][:, :2], value, 1e-6)
