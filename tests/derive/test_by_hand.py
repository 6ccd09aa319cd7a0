"""The derivation, run afresh, against mechanics that is written by hand.

The committed files are compared with hand-written mechanics in `test_mechanics`. Here nothing is committed:
what `derive` makes of a declaration now is compared, at 50 digits, so that an error in it shows before any
file is written.
"""

from functools import cache

import numpy as np
import pytest
import sympy as sp

from stridemap.derive import STANCE_FOOT, TIME, Body, Coordinate, Parameter, Touchdown, Walker, rolling_arc
from stridemap.derive.models import WALKERS, compass
from stridemap.derive.models.controller import CLOCK, GAINS, hip_torque
from tests.oracles.newton import by_hand
from tests.oracles.rewritten import light_model
from tests.oracles.states import MP, call, differences, exact, on_section

STATES = 4


@cache
def fresh(name):
    """A built-in walker, derived now."""
    return light_model(WALKERS[name])


def some(name):
    """A few random states on the section, at 50 digits."""
    return {key: exact(value[:STATES]) for key, value in on_section(name).items()}


def largest(found):
    return float(np.abs(found).max(initial=0.0))


@pytest.mark.parametrize(
    "name", [pytest.param("rimless_wheel", marks=pytest.mark.quick), "simplest_walker", "compass", "wobbling"]
)
def test_every_function_is_as_by_hand(name):
    model, at = fresh(name), some(name)
    hand = by_hand(name, at, MP)
    compared = []
    for function in model.spec.functions:
        if not hasattr(hand, function) or (name, function) == ("simplest_walker", "mass_matrix"):
            continue  # which row of it is divided by the mass, and how, is free
        if (name, function) == ("simplest_walker", "bias_forces"):
            continue
        found = call(getattr(model.equations, function), MP, at)
        for key, value in getattr(hand, function)().items():
            scale = 1 + largest(value)
            assert largest(found[key] - value) < 1e-13 * scale, (function, key)
            compared.append(key)
    assert {"dv", "v_plus", "Lambda", "force", "zmp", "cop", "kinetic", "length", "press"} <= set(compared)


@pytest.mark.parametrize(
    ("function", "output"), [("state_derivative", "dv"), ("impact_map", "v_plus"), ("forward_dynamics", "dv")]
)
@pytest.mark.parametrize("which", ["q", "v"])
def test_derivatives_are_differences(function, output, which):
    """Central differences with steps of 1e-16 at 50 digits: their error is about 1e-32."""
    equations, at = fresh("compass").equations, some("compass")
    found = call(getattr(equations, f"{function}_d{which}"), MP, at)[f"{output}_d{which}"]
    expected = differences(getattr(equations, function), at, output, which)
    assert largest(expected) > 1e-3
    assert largest(found - expected) < 1e-13 * (1 + largest(expected))


def test_a_hip_that_moves_as_desired_feels_no_torque():
    """The desired rate is the derivative of the desired angle ``gamma (1 + cos phi) - S``."""
    _, _, stride, gamma = (gain.symbol for gain in GAINS)
    hip = compass.THETA2
    desired = gamma * (1 + sp.cos(CLOCK.phase)) - stride
    torque = hip_torque(hip, CLOCK)
    assert sp.simplify(torque.subs({hip.symbol: desired, hip.rate: desired.diff(TIME)})) == 0
    kp, kd = (gain.symbol for gain in GAINS[:2])
    assert (torque.diff(hip.symbol), torque.diff(hip.rate)) == (-kp, -kd)


# -- a foot that rolls -------------------------------------------------------------------------------------

ANGLE = Coordinate("theta", "rad", "angle of the leg, positive leaning back")
RADIUS = Parameter("r", 0.3, "L", "radius of the foot", 0.0)
theta, r = ANGLE.symbol, RADIUS.symbol
tip = STANCE_FOOT + (1 - r) * sp.Matrix([-sp.sin(theta), sp.cos(theta)])
ROCKER = Walker(
    name="rocker",
    title="A leg with a mass at its tip, on a round foot",
    reference="none",
    coordinates=(ANGLE,),
    parameters=(RADIUS,),
    bodies=(Body("tip", sp.Integer(2), tip, sp.Rational(1, 5), theta),),
    gravity=sp.Matrix([0, -1]),
    dissipation=sp.Rational(3, 20) * ANGLE.rate**2,
    stance=rolling_arc(r, theta),
    swing_foot=tip - (1 - r) * sp.Matrix([-sp.sin(theta + 1), sp.cos(theta + 1)]),
    touchdown=Touchdown(sp.cos(sp.Rational(1, 2)) - sp.cos(theta), region=theta),
    relabel={theta: theta + 1},
    search_box={"theta": (0.5, 0.3), "dtheta": (-1.0, 0.5)},
)


@pytest.mark.quick
def test_a_rolling_foot_has_an_acceleration_of_its_own():
    """With the tip at ``(-r theta - e sin theta, r + e cos theta)``, e = 1 - r, differentiated by hand."""
    model = light_model(ROCKER)
    rng = np.random.default_rng(6)
    q, v = rng.uniform(-0.7, 0.7, (50, 1)), rng.uniform(-2, 2, (50, 1))
    radius, mass, inertia, damping = 0.3, 2.0, 0.2, 0.3
    e, s, c, w = 1 - radius, np.sin(q[:, 0]), np.cos(q[:, 0]), v[:, 0]
    along, bend = np.stack([-radius - e * c, -e * s], axis=1), np.stack([e * s, -e * c], axis=1)
    matrix = mass * (along**2).sum(axis=1) + inertia
    turning, weight = -mass * radius * e * s * w**2, -mass * e * s
    seen = {
        key: value
        for function in ("mass_matrix", "bias_forces", "state_derivative", "ground_force")
        for key, value in model.evaluate(function, q=q, v=v, p=np.full((50, 1), radius)).items()
    }
    dv = -(turning + weight + damping * w) / matrix
    force = mass * (along * dv[:, None] + bend * w[:, None] ** 2 + np.array([0.0, 1.0]))
    np.testing.assert_allclose(seen["M"][:, 0, 0], matrix, rtol=1e-13)
    np.testing.assert_allclose(seen["h"][:, 0], turning, atol=1e-13)
    np.testing.assert_allclose(seen["v_gravity"][:, 0], weight, atol=1e-13)
    np.testing.assert_allclose(seen["damping"][:, 0], damping * w, atol=1e-13)
    np.testing.assert_allclose(seen["dv"][:, 0], dv, atol=1e-13)
    np.testing.assert_allclose(seen["force"], force, atol=1e-12)
