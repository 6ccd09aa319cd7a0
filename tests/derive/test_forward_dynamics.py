"""Forward dynamics with the torques as an input: against what the controller makes, and other code.

Values at 50 digits and derivatives by differences at 50 digits, for all built-in models, are on the ladder of
`printers/test_equivalence.py`.
"""

import numpy as np
import pytest
import sympy as sp

from stridemap.derive.emit import emit
from stridemap.derive.functions import Functions
from stridemap.derive.models import WALKERS
from stridemap.derive.models.simplest_walker import WALKER as SIMPLEST
from stridemap.derive.parts import Motor
from stridemap.solver.model.loading import available, load
from tests.oracles.states import RANGES

COUNT = 200
ANGLES = (-0.8, 0.8)
"""Of coordinates that have no range of their own."""


def at(name, seed=3):
    """Random states, torques and parameters, the latter within a quarter of the preset."""
    rng, model = np.random.default_rng(seed), load(name)
    n = len(model.coordinates)
    p = model.point({}) * rng.uniform(0.75, 1.25, (COUNT, len(model.parameters)))
    p = np.where(model.point({}) == 0, rng.uniform(0, 0.3, p.shape), p)
    return {
        "t": rng.uniform(0, 3, COUNT),
        "q": np.stack([rng.uniform(*RANGES.get(c, ANGLES), COUNT) for c in model.coordinates], axis=-1),
        "v": rng.uniform(-2, 2, (COUNT, n)),
        "u": rng.uniform(-2, 2, (COUNT, len(model.actuated))),
        "p": p,
    }


def close(one, other, tolerance=1e-11):
    """Equal, relative to the largest entry of each state."""
    size = 1 + np.abs(other).reshape(len(other), -1).max(axis=1)
    off = np.abs(one - other).reshape(len(other), -1).max(axis=1, initial=0)
    assert (off <= tolerance * size).all(), (off / size).max()


@pytest.mark.parametrize("name", available())
def test_the_controllers_torques_give_the_controllers_motion(name):
    model, state = load(name), at(name)
    if model.actuated:
        state["u"] = model.evaluate("controller_torque", **state)["u"]
    moved = model.evaluate("forward_dynamics", **state)["dv"]
    close(moved, model.evaluate("state_derivative", **state)["dv"])


@pytest.mark.parametrize("name", available())
def test_the_torques_enter_by_virtual_work(name):
    """M (dv(u) - dv(0)) is the transpose of the rates of what the motors drive, times u."""
    model, state = load(name), at(name)
    still = {**state, "u": 0 * state["u"]}
    gain = np.subtract(*(model.evaluate("forward_dynamics", **s)["dv"] for s in (state, still)))
    force = np.einsum("nij,nj->ni", model.evaluate("mass_matrix", **state)["M"], gain)
    expected = np.zeros_like(force)
    if model.actuated:
        n = len(model.coordinates)
        unit = [model.evaluate("motor_rates", **{**state, "v": np.eye(n)[[i] * COUNT]}) for i in range(n)]
        jacobian = np.stack([one["rate"] for one in unit], axis=-1)
        expected = np.einsum("nji,nj->ni", jacobian, state["u"])
    close(force, expected)


@pytest.mark.parametrize("name", available())
@pytest.mark.parametrize("by", ["q", "v", "u", "p"])
def test_derivatives_by_an_imaginary_step(name, by):
    """Derivatives of the accelerations without any rule of differentiation, exact to rounding."""
    model, state = load(name), at(name)
    if by == "u" and not model.actuated:
        assert "forward_dynamics_du" not in model.spec.functions
        return
    function = model.spec.functions["forward_dynamics"]
    columns = []
    for j in range(state[by].shape[1]):
        moved = {**state, by: state[by] + 1e-30j * np.eye(state[by].shape[1])[j]}
        values = [moved[a] if a == "t" else list(moved[a].T) for a in function.arguments]
        dv = model.equations.forward_dynamics(np, *values)["dv"]
        columns.append(np.stack([np.broadcast_to(x, (COUNT,)) for x in dv], axis=-1).imag / 1e-30)
    found = model.evaluate(f"forward_dynamics_d{by}", **state)[f"dv_d{by}"]
    close(found, np.stack(columns, axis=-1), 1e-10)


@pytest.mark.parametrize("name", available())
def test_time_is_read_where_forces_depend_on_it_only(name):
    """The clock of a controller is no part of what torques from outside do."""
    reads = load(name).spec.functions["forward_dynamics"].arguments
    assert "t" not in reads
    assert ("u" in reads) == bool(load(name).actuated)


def test_the_number_of_functions_is_known_before_any_is_derived():
    for name in ("rimless_wheel", "simplest_walker"):
        functions = Functions(WALKERS[name])
        assert functions.count == len(list(functions.programs()))


def test_a_motor_on_what_has_no_mass_takes_no_torque_as_an_input():
    """Any torque of its own would accelerate it infinitely; on what has mass it is one like any other."""
    mass = SIMPLEST.massless.mass
    theta, phi = (c.symbol for c in SIMPLEST.coordinates)
    light = SIMPLEST.with_(name="light", motors=(Motor("hip", mass * sp.Rational(1, 10), phi),))
    assert not [f for f in emit(light, "test")[1].functions if f.startswith("forward")]
    heavy = SIMPLEST.with_(name="heavy", motors=(Motor("ankle", sp.Rational(1, 10), theta),))
    files, spec = emit(heavy, "test")
    scope = {}
    exec(files["heavy.py"], scope)
    given = {"t": 0.3, "q": [0.2, 0.4], "v": [-0.3, 0.1], "u": [0.1], "p": [0.009]}

    def call(name):
        return scope[name](np, *(given[a] for a in spec.functions[name].arguments))

    np.testing.assert_allclose(call("forward_dynamics")["dv"], call("state_derivative")["dv"], rtol=1e-13)
    # The hip has the mass 1 and the leg the length 1: a unit of torque gives a unit of acceleration.
    np.testing.assert_allclose(call("forward_dynamics_du")["dv_du"][0], [1], rtol=1e-13)
