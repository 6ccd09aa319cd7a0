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
from stridemap.derive.mechanics import Mechanics
from stridemap.derive.models import WALKERS, compass, round_feet
from stridemap.derive.models.controller import CLOCK, GAINS, hip_torque
from tests.oracles.newton import by_hand
from tests.oracles.rewritten import light_model
from tests.oracles.states import MP, call, differences, exact, fifty_digits, on_section

STATES = 4


@pytest.fixture(autouse=True)
def _fifty_digits():
    """Decimal numbers have 50 digits in all of this."""
    with fifty_digits():
        yield


@cache
def fresh(name):
    """A built-in walker, derived now."""
    return light_model(WALKERS[name], forward=True)


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

ALONG = Coordinate("s", "1", "grows with the leg's angle, and not in proportion to it")
RADIUS = Parameter("r", 0.3, "L", "radius of the foot", 0.0)
s, r = ALONG.symbol, RADIUS.symbol
lean = s + s**3 / 3
tip = STANCE_FOOT + (1 - r) * sp.Matrix([-sp.sin(lean), sp.cos(lean)])
ROCKER = Walker(
    name="rocker",
    title="A leg with a mass at its tip, on a round foot",
    reference="none",
    coordinates=(ALONG,),
    parameters=(RADIUS,),
    bodies=(Body("tip", sp.Integer(2), tip, sp.Rational(1, 5), lean),),
    gravity=sp.Matrix([0, -1]),
    dissipation=sp.Rational(3, 20) * ALONG.rate**2,
    stance=rolling_arc(r, lean),
    swing_foot=tip - (1 - r) * sp.Matrix([-sp.sin(lean + 1), sp.cos(lean + 1)]),
    touchdown=Touchdown(sp.cos(sp.Rational(1, 2)) - sp.cos(lean), region=s),
    relabel={s: -s},
    search_box={"s": (0.5, 0.3), "ds": (-1.0, 0.5)},
)


def test_a_rolling_foot_has_an_acceleration_of_its_own():
    """The tip at ``(-r a - e sin a, r + e cos a)``, e = 1 - r, a = s + s^3 / 3, differentiated by hand."""
    model = light_model(ROCKER)
    rng = np.random.default_rng(6)
    q, v = rng.uniform(-0.7, 0.7, (50, 1)), rng.uniform(-2, 2, (50, 1))
    radius, mass, inertia, damping = 0.3, 2.0, 0.2, 0.3
    e, x, w = 1 - radius, q[:, 0], v[:, 0]
    sine, cosine, once, twice = np.sin(x + x**3 / 3), np.cos(x + x**3 / 3), 1 + x**2, 2 * x
    by_angle = np.stack([-radius - e * cosine, -e * sine], axis=1)
    first = by_angle * once[:, None]
    second = np.stack([e * sine, -e * cosine], axis=1) * once[:, None] ** 2 + by_angle * twice[:, None]
    matrix = mass * (first**2).sum(axis=1) + inertia * once**2
    turning = (mass * (first * second).sum(axis=1) + inertia * once * twice) * w**2
    weight = mass * first[:, 1]
    dv = -(turning + weight + damping * w) / matrix
    force = mass * (first * dv[:, None] + second * w[:, None] ** 2 + np.array([0.0, 1.0]))
    seen = {
        key: value
        for function in ("mass_matrix", "bias_forces", "state_derivative", "ground_force")
        for key, value in model.evaluate(function, q=q, v=v, p=np.full((50, 1), radius)).items()
    }
    np.testing.assert_allclose(seen["M"][:, 0, 0], matrix, rtol=1e-13)
    np.testing.assert_allclose(seen["h"][:, 0], turning, atol=1e-12)
    np.testing.assert_allclose(seen["v_gravity"][:, 0], weight, atol=1e-13)
    np.testing.assert_allclose(seen["damping"][:, 0], damping * w, atol=1e-13)
    np.testing.assert_allclose(seen["dv"][:, 0], dv, atol=1e-12)
    np.testing.assert_allclose(seen["force"], force, atol=1e-11)


@pytest.mark.quick
def test_the_step_of_a_round_foot_is_that_of_its_contact():
    """Legs at a after and -a before: the arcs' centres are 2 sin a apart, and the foot has rolled 2 r a."""
    walker = round_feet.WALKER
    a, radius = 0.19, 0.2
    at = {round_feet.q1: a, round_feet.q2: 2 * a, round_feet.RADIUS.symbol: radius}
    mechanics = Mechanics(walker)
    length, rise = (float(e.subs(at).evalf()) for e in (mechanics.step_length, mechanics.step_rise))
    assert length == pytest.approx(2 * np.sin(a) + 2 * radius * a, rel=1e-14)
    assert abs(rise) < 1e-15


def test_a_lock_stops_what_it_names_before_the_legs_swap_names():
    """The stance leg of the step that ends stands still after the impact; it is the swing leg then."""
    locked = light_model(compass.WALKER.with_(name="stiff", locks=(compass.theta1,)))
    at = some("compass")
    after = call(locked.equations.impact_map, MP, at)["v_plus"]
    assert largest(after[:, 0] - after[:, 1]) < 1e-14
    assert largest(after[:, 0]) > 1e-2
