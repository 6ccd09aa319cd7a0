"""The centre of pressure is where the whole walker's angular momentum says that the ground pushes.

Positions and angles are taken from the declaration, and the rest from Newton and Euler: accelerations are
second differences along the motion at 50 digits. The moment about the contact is what the bodies'
accelerations need beyond gravity's; of its own the test only knows in which sense each body counts its angle.
"""

import inspect
from dataclasses import dataclass

import mpmath
import numpy as np
import pytest
import sympy as sp

from stridemap.derive import (
    STANCE_FOOT,
    TIME,
    Body,
    Coordinate,
    Motor,
    Parameter,
    rolling_arc,
)
from stridemap.derive.functions import Functions
from stridemap.derive.models import WALKERS, compass, goswami_compass, rimless_wheel, round_feet, wobbling
from stridemap.derive.printers.printer import Equations
from stridemap.derive.printers.python import Python
from stridemap.derive.turn import turn
from tests.oracles import walkers
from tests.oracles.rewritten import Change, rewritten, unsimplified

MP = mpmath.mp
STEP = MP.mpf("1e-15")
STATES = 6


@pytest.fixture(autouse=True)
def fifty_digits():
    with MP.workdps(50):
        yield


class Newton:
    """Force and moment that the bodies' accelerations need, by differences along the motion.

    Parameters
    ----------
    walker : Walker
    senses : dict of str to int
        For each body with inertia: 1 if its angle grows from x to y, -1 if the other way.
    """

    def __init__(self, walker, senses):
        massless = {} if walker.massless is None else {walker.massless.mass: 0}
        self.values = {a.symbol: sp.Rational(str(a.default)) for a in walker.parameters} | massless
        self.walker, q = walker, list(walker.q)
        on_stance = dict(zip(STANCE_FOOT, walker.stance, strict=True))
        self.places = [self.function(q, b.position.subs(on_stance)) for b in walker.bodies]
        self.angles = [self.function(q, sp.Matrix([senses.get(b.name, 0) * b.angle])) for b in walker.bodies]
        self.masses, self.inertias = (
            [MP.mpf(sp.sympify(x).subs(self.values).evalf(50)) for x in of]
            for of in ([b.mass for b in walker.bodies], [b.inertia for b in walker.bodies])
        )
        self.stance = self.function(q, sp.Matrix(walker.stance))
        self.gravity = MP.matrix([MP.mpf(g) for g in walker.gravity.subs(self.values).evalf(50)])

    def function(self, arguments, matrix):
        return sp.lambdify(arguments, sp.Matrix(matrix).subs(self.values), "mpmath")

    def at(self, q, v, a):
        """Force, moment about the contact, contact, shape of floats."""

        def second(f):
            def place(t):
                return f(*[x + t * y + t * t * z / 2 for x, y, z in zip(q, v, a, strict=True)])

            return (place(STEP) - 2 * place(0) + place(-STEP)) / STEP**2

        contact = self.stance(*q)[0]
        force, moment = MP.matrix([0, 0]), MP.mpf(0)
        parts = zip(self.places, self.angles, self.masses, self.inertias, strict=True)
        for place, angle, mass, inertia in parts:
            push = mass * (second(place) - self.gravity)
            x, y = place(*q)
            force += push
            moment += (x - contact) * push[1] - y * push[0] + inertia * second(angle)[0]
        return force, float(moment), float(contact)


class Generated:
    """The two functions that are compared, derived afresh and without simplifying."""

    def __init__(self, walker):
        with unsimplified():
            made = Functions(walker)
            programs = (made.state_derivative(), made.centre_of_pressure())
            text = Python().text(Equations(walker, programs, "tests", "-"))
        self.functions = {}
        exec(text, self.functions)

    def __call__(self, name, at):
        function = self.functions[name]
        names = list(inspect.signature(function).parameters)[1:]
        found = function(np, *(at[key] for key in names))
        return {key: np.array(value, dtype=float) for key, value in found.items()}


@dataclass(frozen=True)
class Case:
    """A walker; the senses of its angles; and the part of the moment that is not the foot's, by hand."""

    walker: object
    senses: dict
    elsewhere: object = None


def states(count, seed=5):
    rng = np.random.default_rng(seed)
    return (
        rng.uniform(-0.4, 0.4, (STATES, count)),
        rng.uniform(-1, 1, (STATES, count)),
        rng.uniform(0, 2, STATES),
    )


def along(case):
    """Generated and own results at random states: (outputs, state, own force, own moment, own contact)."""
    walker, generated = case.walker, Generated(case.walker)
    own, p = Newton(walker, case.senses), np.array([a.default for a in walker.parameters])
    for q, v, t in zip(*states(len(walker.q)), strict=True):
        if walker.phase is not None:
            v[list(walker.coordinates).index(walker.phase)] = 0.0
        at = {"t": t, "q": q, "v": v, "p": p}
        a = generated("state_derivative", at)["dv"]
        at["a"] = a
        exact = ([MP.mpf(float(x)) for x in values] for values in (q, v, a))
        force, moment, contact = own.at(*exact)
        if case.elsewhere is not None:
            f, m = case.elsewhere(*q)
            force, moment = force - MP.matrix(f), moment - m
        yield generated("centre_of_pressure", at), at, [float(x) for x in force], moment, contact


def agree(case, moment=None, tolerance=1e-11):
    """Compare everything, and the moment with one that is known beforehand as well."""
    seen = []
    for out, at, force, own, contact in along(case):
        scale = 1 + max(map(abs, force)) + abs(own)
        assert abs(out["moment"] - own) < tolerance * scale
        assert abs(out["offset"] - own / force[1]) < tolerance * (1 + scale / abs(force[1])) ** 2
        assert out["cop"] == pytest.approx(contact + out["offset"], abs=1e-13)
        if moment is not None:
            known = moment(at["t"], at["q"], at["v"])
            assert abs(out["moment"] - known) < tolerance * scale
        seen.append(float(out["moment"]))
    return seen


# -- nothing but the foot holds the walker ---------------------------------------------------------------

PASSIVE = {
    "compass": {},
    "goswami_compass": {},
    "simplest_walker": {},
    "rimless_wheel": {"hub": -1},
    "round_feet": {"stance leg": 1, "swing leg": 1},
}


@pytest.mark.parametrize("name", PASSIVE)
def test_the_contact_of_a_built_in_walker_bears_no_moment(name):
    """Point feet, and feet that roll: the ground force acts at the contact."""
    seen = agree(Case(WALKERS[name], PASSIVE[name]), moment=lambda t, q, v: 0.0)
    assert not np.any(seen)  # nothing that rounds


def test_what_holds_a_rail_horizontal_does_not_push_on_the_foot():
    """The guide's torque is the load of the mass times its arm, and comes from outside the walker."""
    walker, own = wobbling.WALKER, Newton(wobbling.WALKER, {})
    assert turn(walker).guided == ("wobbling mass",)
    i = [b.name for b in walker.bodies].index("wobbling mass")
    alone = Newton(walker, {})
    alone.masses = [m if j == i else MP.mpf(0) for j, m in enumerate(own.masses)]
    for out, at, _, moment, _ in along(Case(walker, {})):
        exact = ([MP.mpf(float(x)) for x in at[key]] for key in "qva")
        load = float(alone.at(*exact)[0][1])
        assert moment == pytest.approx(at["q"][2] * load, abs=1e-12)
        assert abs(moment) > 1e-4
        assert out["moment"] == out["offset"] == 0


# -- motors, springs and dampers at the ankle ------------------------------------------------------------

GAIN = Parameter("gain", 0.05, "M g L", "gain of the ankle")
th1, th2 = compass.THETA1, compass.THETA2
TORQUE = GAIN.symbol * (sp.cos(TIME) - 3 * th1.symbol + th2.rate)


def torque(t, q, v):
    return 0.05 * (np.cos(t) - 3 * q[0] + v[1])


def with_ankle(base, **changes):
    return base.with_(name="with_ankle", parameters=(*base.parameters, GAIN), **changes)


def test_a_motor_at_the_ankle_shifts_it_by_torque_over_force():
    """Pushing the leg back presses the toes: the centre of pressure moves ahead."""
    base = goswami_compass.WALKER
    case = Case(with_ankle(base, motors=(Motor("ankle", TORQUE, drives=th1.symbol),)), {})
    seen = agree(case, moment=torque)
    assert min(map(abs, seen)) > 1e-3
    ahead = [out["offset"] * force[1] for out, _, force, *_ in along(case)]
    np.testing.assert_allclose(ahead, seen, rtol=1e-9)


def test_a_torque_on_an_absolute_angle_is_a_motor_at_the_ankle():
    """In the coordinates theta1, theta1 - theta2 each torque is one against the ground."""
    change = Change(("stance", "swing"), ((1, 0), (1, -1)), (0.0, 0.0))
    absolute = rewritten(goswami_compass.WALKER, change, "absolute")
    stance, swing = absolute.coordinates
    driven = with_ankle(
        absolute, torques={stance: GAIN.symbol * sp.sin(TIME), swing: GAIN.symbol * swing.rate}
    )
    agree(Case(driven, {}), moment=lambda t, q, v: 0.05 * (np.sin(t) + v[1]))
    # On the angle between the legs it is not.
    inner = with_ankle(absolute, motors=(Motor("hip", GAIN.symbol, drives=stance.symbol - swing.symbol),))
    assert not np.any(agree(Case(inner, {}), moment=lambda t, q, v: 0.0))


@pytest.mark.parametrize("matrix", [((-1, 0), (0, 1)), ((0, -1), (1, -1)), ((1, 0), (1, 1))])
def test_it_does_not_depend_on_the_coordinates(matrix):
    change = Change(("one", "other"), matrix, (0.0, 0.25))
    driven = with_ankle(goswami_compass.WALKER, motors=(Motor("ankle", TORQUE, drives=th1.symbol),))
    agree(Case(rewritten(driven, change, "elsewise"), {}))


def test_springs_and_dampers_at_the_ankle_count():
    walker = with_ankle(
        compass.WALKER,
        potentials={"ankle": GAIN.symbol * th1.symbol**2 / 2, "hip": th2.symbol**2},
        dissipation=GAIN.symbol * th1.rate**2 + th2.rate**2,
    )
    agree(Case(walker, {}), moment=lambda t, q, v: -0.05 * (q[0] + 2 * v[0]))


def test_a_rolling_foot_with_a_motor_at_the_ankle():
    """The contact is below the arc's centre, and the centre of pressure is ahead of that."""
    base = round_feet.WALKER
    walker = with_ankle(base, motors=(Motor("ankle", GAIN.symbol * sp.cos(TIME), drives=round_feet.q1),))
    case = Case(walker, PASSIVE["round_feet"])
    agree(case, moment=lambda t, q, v: 0.05 * np.cos(t))
    for out, at, *_ in along(case):
        assert out["cop"] - out["offset"] == pytest.approx(-0.2 * at["q"][0], abs=1e-15)


def test_arcs_that_turn_against_the_leg_need_a_moment():
    """A foot that rolls the wrong way is not a rigid part of its leg: the ground would have to turn it."""
    walker = round_feet.WALKER.with_(
        name="gears", stance=rolling_arc(round_feet.RADIUS.symbol, -round_feet.q1)
    )
    assert np.abs(agree(Case(walker, PASSIVE["round_feet"]))).min() > 1e-3


# -- bodies whose coordinates turn in other ways ---------------------------------------------------------


def with_body(position, angle, inertia=sp.S.Zero, **changes):
    base = goswami_compass.WALKER
    coordinates = changes.pop("coordinates")
    return base.with_(
        name="with_body",
        coordinates=(*base.coordinates, *coordinates),
        bodies=(*base.bodies, Body("load", sp.Rational(1, 2), position, inertia, angle)),
        relabel={**base.relabel, **{c.symbol: c.symbol for c in coordinates}},
        search_box={
            **base.search_box,
            **{n: (0.1, 0.3) for c in coordinates for n in (c.name, f"d{c.name}")},
        },
        **changes,
    )


def test_a_wheel_about_the_hip():
    """Nothing but the motor shows in which sense its angle is counted: in that of the other bodies."""
    psi = Coordinate("psi", "rad", "angle of a wheel about the hip")
    motors = (Motor("wheel", sp.sin(TIME), drives=psi.symbol - th1.symbol),)
    absolute = with_body(
        goswami_compass.hip, psi.symbol, sp.Rational(1, 5), coordinates=(psi,), motors=motors
    )
    assert not np.any(agree(Case(absolute, {"load": 1}), moment=lambda t, q, v: 0.0))
    motors = (Motor("wheel", sp.sin(TIME), drives=psi.symbol),)
    relative = with_body(
        goswami_compass.hip, th1.symbol + psi.symbol, sp.Rational(1, 5), coordinates=(psi,), motors=motors
    )
    assert not np.any(agree(Case(relative, {"load": 1}), moment=lambda t, q, v: 0.0))
    braked = absolute.with_(motors=(Motor("wheel", sp.sin(TIME), drives=psi.symbol),))
    agree(Case(braked, {"load": 1}), moment=lambda t, q, v: np.sin(t))


def test_a_wheel_about_a_hip_whose_bodies_count_backwards():
    """The leg's angle grows from y to x, and so does the wheel's: a motor between them stays inside."""
    psi = Coordinate("psi", "rad", "angle of a wheel about the hip, positive ahead")
    motors = (Motor("wheel", sp.sin(TIME), drives=psi.symbol + th1.symbol),)
    walker = with_body(goswami_compass.hip, psi.symbol, sp.Rational(1, 5), coordinates=(psi,), motors=motors)
    hip, stance, *rest = walker.bodies
    stance = Body(stance.name, stance.mass, stance.position, sp.Rational(1, 10), -th1.symbol)
    walker = walker.with_(bodies=(hip, stance, *rest))
    assert not np.any(agree(Case(walker, {stance.name: -1, "load": -1}), moment=lambda t, q, v: 0.0))


def test_a_load_in_cartesian_coordinates():
    """A turn changes them by amounts that depend on where the load is."""
    x, y = Coordinate("lx", "L", "load ahead of the hip"), Coordinate("ly", "L", "load above the hip")
    place = goswami_compass.hip + sp.Matrix([x.symbol, y.symbol])
    round_spring = {"spring": 3 * (x.symbol**2 + y.symbol**2) / 2}
    free = with_body(place, sp.S.Zero, coordinates=(x, y), potentials=round_spring)
    assert turn(free).guided == ()
    assert np.abs(agree(Case(free, {}), moment=lambda t, q, v: 0.0)).max() < 1e-14
    # Springs that know where up is hold on to the ground.
    stiff = with_body(
        place, sp.S.Zero, coordinates=(x, y), potentials={"spring": (3 * x.symbol**2 + y.symbol**2) / 2}
    )
    agree(Case(stiff, {}), moment=lambda t, q, v: 2 * q[2] * q[3])


def test_a_leg_that_telescopes_and_an_angle_scaled_by_a_parameter():
    scale = Parameter("scale", 0.7, "1", "angle per unit of the coordinate", 0.1)
    a, b = Coordinate("a", "1", "stance leg"), Coordinate("b", "1", "swing leg")
    put = {goswami_compass.theta1: scale.symbol * a.symbol, goswami_compass.theta2: b.symbol}
    base = goswami_compass.WALKER
    walker = base.with_(
        name="scaled",
        coordinates=(a, b),
        parameters=(*base.parameters, scale, GAIN),
        bodies=tuple(Body(o.name, o.mass, o.position.subs(put)) for o in base.bodies),
        swing_foot=base.swing_foot.subs(put),
        touchdown=type(base.touchdown)(b.symbol - 2 * scale.symbol * a.symbol, region=a.symbol),
        relabel={a.symbol: a.symbol - b.symbol / scale.symbol, b.symbol: -b.symbol},
        section={b.symbol: 2 * scale.symbol * a.symbol},
        stance_angle=None,
        drawing=(),
        search_box={"a": (0.25, 0.3), "da": (-0.3, 0.5), "db": (0.0, 0.5)},
        torques={a: GAIN.symbol * sp.cos(TIME)},
    )
    # The coordinate does the torque's work with 0.7 times the angle.
    agree(Case(walker, {}), moment=lambda t, q, v: 0.05 * np.cos(t) / 0.7)


# -- what holds on to the ground elsewhere ---------------------------------------------------------------


def test_a_spring_to_a_wall_does_not_push_on_the_foot():
    base, k = goswami_compass.WALKER, sp.Rational(2, 5)
    wall = sp.Matrix([3, 1])
    stretched = goswami_compass.hip - wall
    walker = base.with_(name="leashed", potentials={"leash": k * stretched.dot(stretched) / 2})

    def leash(th1, th2):
        hip = np.array([-np.sin(th1), np.cos(th1)])
        force = -0.4 * (hip - [3, 1])
        return force.tolist(), hip[0] * force[1] - hip[1] * force[0]

    agree(Case(walker, {}, leash), moment=lambda t, q, v: 0.0)


def test_walkers_of_the_other_tests():
    for name in ("rolling", "locked", "finite_feet"):
        agree(Case(walkers.walker(name), {}), moment=lambda t, q, v: 0.0)


def test_a_wheel_that_is_braked_against_the_ground():
    """The wheel's angle is counted leaning ahead: a torque along it pushes the ground back under the heel."""
    wheel = rimless_wheel.WALKER.with_(name="braked", torques={rimless_wheel.THETA: sp.Rational(1, 10)})
    agree(Case(wheel, {"hub": -1}), moment=lambda t, q, v: -0.1)
