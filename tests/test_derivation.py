"""Physics of the generated equations, and their derivation by other methods.

Here the positions of the masses are written down once more, for SymPy's `LagrangesMethod` and
`KanesMethod`; nothing comes from `derive`. Each property holds at 1,000 random states and parameters.
"""

from functools import cache

import casadi as ca
import numpy as np
import pytest
import sympy as sp
from derive_support import FIFTY, MODELS, MP, Newton, call, exact, on_section, states
from sympy.physics import mechanics as me

from stridemap.solver.model import load

both_models = pytest.mark.parametrize("name", MODELS)


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


@cache
def bodies(name):
    """Coordinates, particles, forces and the frame, for SymPy's methods."""
    theta1, theta2, x = me.dynamicsymbols("theta1 theta2 x")
    k, alpha, beta, u = sp.symbols("k alpha beta u")
    world, ground = me.ReferenceFrame("N"), me.Point("stance foot")
    ground.set_vel(world, 0)
    stance = world.orientnew("stance leg", "Axis", (theta1, world.z))
    swing = world.orientnew("swing leg", "Axis", (theta1 - theta2, world.z))
    hip = ground.locatenew("hip", stance.y)
    foot = hip.locatenew("swing foot", -swing.y)
    points = [(hip, sp.Integer(1)), (foot, beta), (ground, beta)]
    coordinates = [theta1, theta2]
    # The hip's motor turns the swing leg one way and the stance leg the other.
    forces = [(swing, -u * world.z), (stance, u * world.z)]
    if name == "wobbling":
        wobbler = hip.locatenew("wobbler", x * world.x)
        points = [(hip, 1 - alpha), (wobbler, alpha), *points[1:]]
        coordinates.append(x)
        forces += [(wobbler, -k * x * world.x), (hip, k * x * world.x)]
    for point, _ in points[:-1]:
        point.set_vel(world, point.pos_from(ground).dt(world))
    particles = [me.Particle(point.name, point, mass) for point, mass in points]
    forces += [(point, -mass * world.y) for point, mass in points]
    return coordinates, particles, forces, world


def lagrange(name):
    """Mass matrix and forces of ``M a = f`` by Lagrange's equations; gravity and spring are forces."""
    coordinates, particles, forces, world = bodies(name)
    method = me.LagrangesMethod(me.Lagrangian(world, *particles), coordinates, forcelist=forces, frame=world)
    method.form_lagranges_equations()
    return method.mass_matrix, method.forcing, {}


def kane(name):
    """The same by Kane's equations: no energy is written down."""
    coordinates, particles, forces, world = bodies(name)
    rates = me.dynamicsymbols(" ".join(f"w{i}" for i in range(len(coordinates))))
    method = me.KanesMethod(
        world, coordinates, rates, [w - q.diff() for w, q in zip(rates, coordinates, strict=True)]
    )
    method.kanes_equations(particles, forces)
    return method.mass_matrix, method.forcing, dict(zip(rates, [q.diff() for q in coordinates], strict=True))


@both_models
@pytest.mark.parametrize("method", [lagrange, kane])
def test_another_method_gives_the_same_equations(name, method):
    matrix, forcing, rates = method(name)
    coordinates = bodies(name)[0]
    dofs = [sp.Symbol(c) for c in load(name).coordinates]
    speeds = [sp.Symbol("d" + c) for c in load(name).coordinates]
    plain = dict(zip([c.diff() for c in coordinates], speeds, strict=True))
    plain |= dict(zip(coordinates, dofs, strict=True))
    parameters = [sp.Symbol(a.name) for a in load(name).parameters]
    expressions = [e.xreplace(rates).xreplace(plain) for e in (matrix, forcing)]
    evaluate = sp.lambdify([*dofs, *speeds, *parameters, sp.Symbol("u")], expressions, cse=True)

    at, generated = states(name), quantities(name, "mass_matrix", "bias_forces", "controller_torque")
    columns = [*at["q"].T, *at["v"].T, *at["p"].T, generated["u"]]
    results = [evaluate(*row) for row in zip(*columns, strict=True)]
    mass_matrix = np.array([r[0] for r in results])
    force = np.array([r[1].ravel() for r in results])
    applied = np.zeros_like(force)
    applied[:, 1] = generated["u"]
    bias = generated["h"] + generated["v_gravity"] + generated.get("v_spring", 0)
    assert_close(generated["M"], mass_matrix)
    assert_close(applied - bias, force)
    accelerations = np.linalg.solve(mass_matrix, force[..., None])[..., 0]
    condition = np.linalg.cond(mass_matrix)
    dv = quantities(name, "state_derivative")["dv"]
    assert_close(dv, accelerations, 1e-14, condition * (1 + np.abs(force).max(axis=1)))


@both_models
def test_impact_solves_the_full_system_of_the_floating_base(name):
    """``Me (v+ - v-) = J^T Lambda, J v+ = 0`` with Me and J from positions, solved with pivoting."""
    stance_x, stance_y, theta1, theta2, x = floating = sp.symbols("X Y theta1 theta2 x")
    alpha, beta = sp.symbols("alpha beta")
    hip = sp.Matrix([stance_x - sp.sin(theta1), stance_y + sp.cos(theta1)])
    foot = hip + sp.Matrix([sp.sin(theta1 - theta2), -sp.cos(theta1 - theta2)])
    masses = [(beta, sp.Matrix([stance_x, stance_y])), (beta, foot)]
    if name == "wobbling":
        masses += [(1 - alpha, hip), (alpha, hip + sp.Matrix([x, 0]))]
    else:
        masses += [(1, hip)]
        floating = floating[:4]
    inertia = sp.zeros(len(floating))
    for mass, position in masses:
        inertia += mass * position.jacobian(floating).T * position.jacobian(floating)
    evaluate = sp.lambdify([theta1, theta2, alpha, beta], [inertia, foot.jacobian(floating)], cse=True)

    at = states(name)
    parameters = dict(zip([a.name for a in load(name).parameters], at["p"].T, strict=True))
    generated = quantities(name, "impact_map", "impact_impulse")
    n, alphas = len(floating), parameters.get("alpha", 0 * at["t"])
    for i, (q, v) in enumerate(zip(at["q"], at["v"], strict=True)):
        big, jacobian = evaluate(q[0], q[1], alphas[i], parameters["beta"][i])
        system = np.block([[big, -jacobian.T], [jacobian, np.zeros((2, 2))]])
        before = np.concatenate([[0, 0], v])
        solution = np.linalg.solve(system, np.concatenate([big @ before, [0, 0]]))
        after = solution[2:n]
        swapped = np.concatenate([[after[0] - after[1], -after[1]], after[2:]])
        assert np.abs(generated["v_plus"][i] - swapped).max() < 1e-12 * np.linalg.cond(system)
        assert np.abs(generated["Lambda"][i] - solution[n:]).max() < 1e-12 * np.linalg.cond(system)


# -- swing phase ---------------------------------------------------------------------------------------------


@both_models
def test_mass_matrix_is_symmetric_and_positive_definite(name):
    matrix = quantities(name, "mass_matrix")["M"]
    np.testing.assert_array_equal(matrix, matrix.transpose(0, 2, 1))
    assert np.linalg.eigvalsh(matrix).min() > 0


@both_models
def test_the_hip_supplies_all_the_power(name):
    """d(kinetic + potential)/dt = u dtheta2 along the flow, with exact derivatives."""
    model, at = load(name), states(name)
    sizes = {"t": 1, "q": at["q"].shape[1], "v": at["v"].shape[1], "p": at["p"].shape[1]}
    symbols = {key: ca.SX.sym(key, size) for key, size in sizes.items()}

    def generated(function):
        compiled = getattr(model, function)
        return compiled(**{key: symbols[key] for key in compiled.name_in()})

    energy = generated("kinetic_energy")["kinetic"] + generated("potential_energy")["potential"]
    flow = generated("state_derivative")
    moving, along = ca.vertcat(symbols["q"], symbols["v"]), ca.vertcat(flow["dq"], flow["dv"])
    power = generated("controller_torque")["u"] * symbols["v"][1]
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
        time = FIFTY.mpf(time)
        q = at["q"] + time * flow["dq"] + time**2 / 2 * flow["dv"]
        place = {**at, "q": q, "v": at["v"] + time * flow["dv"]}
        return call(getattr(load(name).equations, function), MP, place)

    return moved


@both_models
def test_ground_force_and_zmp_follow_from_the_motion_of_the_centre_of_mass(name):
    """By differences at 50 digits: steps of 1e-15 leave errors of about 1e-20."""
    moved, step = fifty_digit_flow(name), FIFTY.mpf("1e-15")
    behind, here, ahead = (moved("centre_of_mass", s * step) for s in (-1, 0, 1))
    velocity = (ahead["com"] - behind["com"]) / (2 * step)
    acceleration = (ahead["com"] - 2 * here["com"] + behind["com"]) / step**2
    assert np.abs(velocity - here["dcom"]).max() < 1e-24
    assert np.abs(acceleration - (ahead["dcom"] - behind["dcom"]) / (2 * step)).max() < 1e-14

    acceleration = acceleration.astype(float)
    generated = quantities(name, "ground_force", "total_mass", "zmp", "centre_of_mass")
    weight = np.array([0, 1])
    assert_close(generated["force"], generated["mass"][:, None] * (acceleration + weight), 1e-9)

    (x_g, y_g), (ddx_g, ddy_g) = generated["com"].T, acceleration.T
    expected = x_g - ddx_g / (1 + ddy_g) * y_g  # the paper's (6)
    # Where the ground hardly bears, the point is far away and ill-conditioned.
    scale = np.abs(expected) + np.abs(acceleration).max(axis=1) * (1 + np.abs(expected)) / np.abs(1 + ddy_g)
    assert_close(generated["zmp"], expected, 1e-9, scale)
    np.testing.assert_array_equal(generated["d"], -generated["zmp"])


@both_models
def test_swing_foot_moves_at_its_velocity(name):
    moved, step = fifty_digit_flow(name), FIFTY.mpf("1e-15")
    behind, here, ahead = (moved("swing_foot", s * step) for s in (-1, 0, 1))
    assert np.abs((ahead["foot"] - behind["foot"]) / (2 * step) - here["dfoot"]).max() < 1e-24


# -- impact --------------------------------------------------------------------------------------------------


def after_impact(name):
    """The state before an impact on the section and the one after it."""
    before = on_section(name)
    result = quantities(name, "impact_map", at=before)
    return before, {**before, "q": result["q_plus"], "v": result["v_plus"]}


@both_models
def test_impact_keeps_the_momentum_about_the_new_foot(name):
    """The generalised momentum after it is that of the velocities before it, in the new coordinates."""
    before, after = after_impact(name)
    momentum = np.einsum("nij,nj->ni", quantities(name, "mass_matrix", at=after)["M"], after["v"])
    # Newton's masses before and after, in the same order: the feet change places.
    old, new = Newton(name, before).masses, Newton(name, after).masses
    new[0], new[1] = new[1], new[0]
    kept = sum(
        m[:, None] * np.einsum("nci,nc->ni", point[1], np.einsum("nci,ni->nc", moving[1], before["v"]))
        for (m, moving), (_, point) in zip(old, new, strict=True)
    )
    assert_close(momentum, kept)


@both_models
def test_impact_loses_the_energy_that_the_impulse_takes(name):
    before, after = after_impact(name)
    lost = quantities(name, "kinetic_energy", at=before)["kinetic"]
    scale = 1 + lost
    lost = lost - quantities(name, "kinetic_energy", at=after)["kinetic"]
    assert (lost >= -1e-13 * scale).all()
    # Half the impulse times the velocity that it brings to rest; the other foot is free.
    at_impact = quantities(name, "impact_impulse", "swing_foot", at=before)
    assert_close(lost, -(at_impact["Lambda"] * at_impact["dfoot"]).sum(axis=1) / 2, 1e-11, scale)


@both_models
def test_swapping_the_legs_twice_changes_nothing(name):
    before, after = after_impact(name)
    twice = quantities(name, "impact_map", at=after)["q_plus"]
    np.testing.assert_allclose(twice, before["q"], rtol=0, atol=1e-15)


@both_models
def test_both_feet_are_on_the_ground_on_the_section_and_after_an_impact_there(name):
    model, at = load(name), states(name)
    on_ground = {**at, **quantities(name, "section_state")}
    for place in (on_ground, after_impact(name)[1]):
        assert np.abs(quantities(name, "swing_foot", at=place)["foot"][:, 1]).max() < 1e-15
        assert np.abs(quantities(name, "touchdown_condition", at=place)["h"]).max() < 1e-15
    # The free coordinates of the section stand where they belong.
    names = [*model.coordinates, *("d" + c for c in model.coordinates)]
    columns = dict(zip(names, [*on_ground["q"].T, *on_ground["v"].T], strict=True))
    np.testing.assert_array_equal(np.stack([columns[n] for n in model.section], axis=-1), at["z"])


@both_models
def test_impact_forgets_the_swing_foot(name):
    """Its own speed is lost, so that one multiplier of the step map is exactly zero."""
    assert not quantities(name, "impact_map_dv")["v_plus_dv"][:, :, 1].any()


# -- the two models ------------------------------------------------------------------------------------------


def held_wobbler(alpha):
    """Random states of the compass, and the same ones with a wobbling mass at rest above the hip."""
    compass = states("compass")
    rest = np.zeros((len(compass["t"]), 1))
    shared = dict(zip([a.name for a in load("compass").parameters], compass["p"].T, strict=True))
    shared |= {"k": 0 * compass["t"], "alpha": alpha + 0 * compass["t"]}
    parameters = np.stack([shared[a.name] for a in load("wobbling").parameters], axis=-1)
    at = {key: np.concatenate([compass[key], rest], axis=-1) for key in ("q", "v")}
    return {**compass, **at, "p": parameters}


def test_a_wobbling_mass_held_at_the_hip_makes_a_compass():
    wobbling = held_wobbler(0.4)
    functions = ["mass_matrix", "bias_forces", "controller_torque", "kinetic_energy", "potential_energy"]
    functions += ["total_mass", "centre_of_mass", "swing_foot", "touchdown_condition"]
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
