"""Motors: forces by virtual work, against Newton's law written by hand; work, power, limits, cost."""

import json
from functools import cache

import numpy as np
import pytest
import sympy as sp

from stridemap import find_orbits
from stridemap.derive import SI, STANCE_FOOT, Body, Coordinate, Massless, Motor, Parameter, Touchdown, Walker
from stridemap.derive.models import rimless_wheel, simplest_walker
from stridemap.derive.motors import kind_of
from stridemap.solver.backends.interpreter import Interpreter
from stridemap.solver.cycles.search import continued
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.observables.motion import motions
from stridemap.spec import ModelSpec
from tests.oracles import motors
from tests.oracles.rewritten import light_model
from tests.oracles.walkers import walker


def cycle(model, gait):
    """The limit cycle near a section point with its period."""
    guess, params = gait
    solver = Solver.for_model(model, Interpreter())
    (orbit,) = continued(solver, model.point(params)[None, :], np.array([guess]))
    assert orbit.status == "converged"
    return orbit


# -- what independent programs found -----------------------------------------------------------------------


@pytest.mark.parametrize(
    ("declared", "gait", "measures"),
    [
        (motors.ABSOLUTE, motors.ABSOLUTE_GAIT, motors.ABSOLUTE_MEASURES),
        (motors.TORSO_WHEEL, motors.TORSO_GAIT, motors.TORSO_MEASURES),
    ],
    ids=["absolute", "torso_wheel"],
)
def test_work_and_cost_are_those_of_the_motor(declared, gait, measures):
    orbit = cycle(light_model(declared), gait)
    for name, value in measures.items():
        assert getattr(orbit, name) == pytest.approx(value, abs=1e-10), name
    assert not [
        name for name in orbit.measures if name.endswith(("_hip", "_hub"))
    ]  # of one motor the sums say it


# -- virtual work ------------------------------------------------------------------------------------------

THETA = Coordinate("theta", "rad", "angle of the leg, positive leaning back")
theta, rate = THETA.symbol, THETA.rate
PULL = Parameter("cable", 0.7, "N", "force of a cable")
SPRING = Parameter("kappa", 2.0, "N/m", "spring to a wall", 0.0)
tip = STANCE_FOOT + sp.Matrix([-sp.sin(theta), sp.cos(theta)])

TETHERED = Walker(
    name="tethered",
    title="A leg that a cable pulls at, from a wall",
    reference="none",
    units=SI,
    coordinates=(THETA,),
    parameters=(PULL, SPRING),
    bodies=(Body("tip", sp.Integer(2), tip),),
    gravity=sp.Matrix([0, -10]),
    potentials={"wall": SPRING.symbol * (tip[0] - 1) ** 2 / 2},
    motors=(Motor("winch", PULL.symbol, tip[0], "pulls the tip ahead", limit=3.5, efficiency=0.5),),
    swing_foot=tip - sp.Matrix([-sp.sin(theta + 1), sp.cos(theta + 1)]),
    touchdown=Touchdown(sp.cos(sp.Rational(1, 2)) - sp.cos(theta), region=theta),
    relabel={theta: theta + 1},
    search_box={"theta": (0.5, 0.3), "dtheta": (-1.0, 0.5)},
)


@pytest.mark.quick
def test_a_force_from_outside_reaches_coordinates_and_ground():
    model = light_model(TETHERED)
    rng = np.random.default_rng(2)
    q, v = rng.uniform(-0.6, 0.6, (2, 50, 1))
    p = np.tile([0.7, 2.0], (50, 1))
    dv = model.evaluate("state_derivative", q=q, v=v, p=p)["dv"]
    ground = model.evaluate("ground_force", q=q, v=v, p=p)["force"]
    # By hand: a mass of 2 on a leg of 1; cable and spring pull at it along x.
    s, c, w = np.sin(q[:, 0]), np.cos(q[:, 0]), v[:, 0]
    outside = np.stack([0.7 - 2.0 * (-s - 1), np.full(50, -20.0)], axis=1)
    along = np.stack([-c, -s], axis=1)  # derivative of the tip's position
    a = (along * outside).sum(axis=1) / 2
    np.testing.assert_allclose(dv[:, 0], a, rtol=1e-13, atol=1e-13)
    acceleration = along * a[:, None] + np.stack([s, -c], axis=1) * w[:, None] ** 2
    np.testing.assert_allclose(ground, 2 * acceleration - outside, rtol=1e-12, atol=1e-12)
    seen = model.evaluate("motor_rates", q=q, v=v, p=p)
    np.testing.assert_allclose(seen["driven"][:, 0], -s, atol=1e-15)
    np.testing.assert_allclose(seen["rate"][:, 0], -c * w, atol=1e-15)
    np.testing.assert_allclose(model.evaluate("controller_torque", p=p)["u"][:, 0], 0.7)


def test_a_torque_on_a_massless_leg_is_divided_by_its_mass():
    # phi'' gains what the torque m k phi gives on the inertia m of the foot: k phi.
    gain = Parameter("k", 0.3, "1", "gain", 0.0)
    base = simplest_walker.WALKER
    torque = -simplest_walker.foot * gain.symbol * simplest_walker.phi
    changes = {"parameters": (*base.parameters, gain)}
    passive = light_model(base.with_(name="without", **changes))
    hip = Motor("hip", torque, simplest_walker.phi)
    driven = light_model(base.with_(name="driven", motors=(hip,), **changes))
    plain = light_model(base.with_(name="plain", torques={simplest_walker.PHI: torque}, **changes))
    q, v = np.random.default_rng(4).uniform(-0.5, 0.5, (2, 20, 2))
    p = driven.point({})
    gained = [m.evaluate("state_derivative", q=q, v=v, p=p)["dv"] for m in (driven, plain)]
    without = passive.evaluate("state_derivative", q=q, v=v, p=p)["dv"]
    np.testing.assert_allclose(gained[0], gained[1], atol=1e-14)
    np.testing.assert_allclose(gained[0][:, 0], without[:, 0], atol=1e-14)
    # The inertia of a foot of mass m about the hip is m: with the stance leg held, phi turns it as a whole.
    np.testing.assert_allclose(gained[0][:, 1] - without[:, 1], -0.3 * q[:, 1], atol=1e-13)
    assert (driven.evaluate("controller_torque", q=q, v=v, p=p)["u"] == 0).all()
    assert isinstance(base.massless, Massless)


# -- several motors ----------------------------------------------------------------------------------------


@cache
def two_motors():
    """The gait of the wobbling walker with a motor at the hip and a push on its mass, limits and losses."""
    declared = walker("two_motors")
    hip, push = declared.actuators
    changed = declared.with_(
        name="two_losses",
        torques={},
        motors=(
            Motor("hip", hip.torque, hip.drives, limit=0.25, efficiency=0.8),
            Motor("push", push.torque, push.drives, limit=0.2),
        ),
    )
    model = light_model(changed)
    (known,) = [o for o in find_orbits("wobbling", k=7.0) if o.stable]
    return cycle(model, (known.section_point, {"k": 7.0, "push": 0.01}))


def test_each_motor_and_all_of_them():
    orbit = two_motors()
    p = orbit.model.point(orbit.params)[None, :]
    seen = motions(orbit.model, [orbit.section_point], p, 20001, squeeze=True, backend=Interpreter())
    u = seen.torque
    rates = np.stack([seen.coordinate("dtheta2"), seen.coordinate("dx")], axis=1)
    power, t = u * rates, seen.t
    for i, name in enumerate(("hip", "push")):
        sums = [np.trapezoid(f(power[:, i]), t) for f in (np.abs, lambda x: np.maximum(x, 0), np.positive)]
        measured = [getattr(orbit, f"{what}_{name}") for what in ("work", "work_positive", "work_net")]
        assert measured == pytest.approx(sums, abs=1e-7)
        assert getattr(orbit, f"peak_power_{name}") == pytest.approx(np.abs(power[:, i]).max(), rel=1e-6)
    assert orbit.peak_torque_hip == pytest.approx(np.abs(u[:, 0]).max(), rel=1e-7)
    assert orbit.peak_force_push == pytest.approx(np.abs(u[:, 1]).max(), rel=1e-7)
    assert orbit.peak_torque == orbit.peak_torque_hip  # a force is not a torque
    assert orbit.work == orbit.work_hip + orbit.work_push
    assert orbit.work_positive == orbit.work_positive_hip + orbit.work_positive_push
    assert orbit.work_net == orbit.work_net_hip + orbit.work_net_push
    both = np.abs(power).sum(axis=1).max()
    assert orbit.peak_power == pytest.approx(both, rel=1e-6)
    assert orbit.peak_power >= both - 1e-12
    assert orbit.peak_power < orbit.peak_power_hip + orbit.peak_power_push
    names = list(orbit.measures)
    assert names[-11:] == [
        "limit_use",
        "work_hip", "work_positive_hip", "work_net_hip", "peak_torque_hip", "peak_power_hip",
        "work_push", "work_positive_push", "work_net_push", "peak_force_push", "peak_power_push",
    ]  # fmt: skip


def test_losses_limits_and_cost():
    orbit = two_motors()
    drawn = orbit.work_positive_hip / 0.8 + (orbit.work_hip - orbit.work_positive_hip) + orbit.work_push
    weight = 1 + 2 * orbit.params["beta"]
    assert orbit.cot == pytest.approx(drawn / (weight * orbit.step_length), rel=1e-13)
    assert orbit.cot_per_speed == pytest.approx(drawn / (weight * orbit.speed), rel=1e-13)
    assert orbit.limit_use == max(orbit.peak_torque_hip / 0.25, orbit.peak_force_push / 0.2)
    assert orbit.limit_use > 1 > orbit.peak_force_push / 0.2


# -- the record --------------------------------------------------------------------------------------------


@pytest.mark.quick
def test_the_manifest_lists_motors():
    model = light_model(TETHERED)
    (winch,) = model.spec.motors
    assert winch.name == "winch"
    assert (winch.kind, winch.unit, winch.meaning) == ("force", "N", "pulls the tip ahead")
    assert (winch.drives, winch.limit, winch.efficiency) == ("stance_x - sin(theta)", 3.5, 0.5)
    assert model.actuated == ("winch",)
    read = ModelSpec.from_manifest(json.loads(json.dumps(model.spec.to_manifest())))
    assert read.motors == model.spec.motors
    assert list(model.measured)[-2:] == ["limit_use", "peak_force_winch"]
    assert model.measured["peak_force_winch"].kind == "force"


X, Y = Coordinate("x", "m", "a length"), Coordinate("y", "m", "another")
RADIUS = Parameter("r", 0.1, "m", "radius of a pulley", 0.0)


@pytest.mark.quick
@pytest.mark.parametrize(
    ("drives", "kind"),
    [
        (theta, "torque"),
        (2 * theta, "torque"),
        (X.symbol - Y.symbol, "force"),
        (RADIUS.symbol * sp.sin(theta), "force"),
        (sp.sqrt((X.symbol - RADIUS.symbol) ** 2 + Y.symbol**2), "force"),
        (sp.atan(Y.symbol / (X.symbol + RADIUS.symbol)), "torque"),
        (tip[0], "force"),
    ],
)
def test_units_and_form_tell_torques_from_forces(drives, kind):
    class Declared:
        coordinates, parameters, units = (THETA, X, Y), (RADIUS,), SI
        q = [c.symbol for c in coordinates]  # noqa: RUF012

    assert kind_of(Declared, Motor("m", sp.S.One, drives)) == kind
    assert kind_of(Declared, Motor("m", sp.S.One, drives, kind="torque")) == "torque"


# -- what gravity supplies ---------------------------------------------------------------------------------


ROLLING = [-np.pi / 6, 0.460341126609458, 2.31]
"""Just after impact with six spokes, lambda2 2/3 and slope 0.2, in closed form, and about the period."""


def wheel(name, **changes):
    fixed = {rimless_wheel.SPOKES.symbol: 6, rimless_wheel.LAMBDA2.symbol: sp.Rational(2, 3)}
    base = rimless_wheel.WALKER
    put = {
        "parameters": (base.parameters[0],),
        "bodies": tuple(
            Body(b.name, b.mass, b.position, b.inertia.subs(fixed), b.angle) for b in base.bodies
        ),
        "swing_foot": base.swing_foot.subs(fixed),
        "touchdown": Touchdown(base.touchdown.condition.subs(fixed), base.touchdown.region),
        "relabel": {s: e.subs(fixed) for s, e in base.relabel.items()},
        "drawing": (),
    }
    return base.with_(name=name, **{**put, **changes})


@pytest.mark.quick
def test_a_wheel_costs_the_sine_of_the_slope_whichever_way_it_goes():
    slope = 0.2
    gait = (ROLLING, {"slope": slope})
    ahead = cycle(light_model(wheel("ahead")), gait)
    mirror = sp.diag(-1, 1)
    base = wheel("ahead")
    back = wheel(
        "back",
        bodies=tuple(
            Body(b.name, b.mass, mirror * (b.position - STANCE_FOOT) + STANCE_FOOT, b.inertia, b.angle)
            for b in base.bodies
        ),
        swing_foot=mirror * (base.swing_foot - STANCE_FOOT) + STANCE_FOOT,
        gravity=mirror * base.gravity,
    )
    orbit = cycle(light_model(back), gait)
    for one in (ahead, orbit):
        assert one.cot == pytest.approx(np.sin(slope), abs=1e-14)
        assert one.state["dtheta"] == pytest.approx(0.460341126609458, abs=1e-12)
        assert one.cot_per_speed > 0
    assert orbit.step_length == pytest.approx(-ahead.step_length, abs=1e-14)
    # A walker that nothing is spent on costs zero, which has no sign.
    assert not np.signbit(ahead.work)


@pytest.mark.quick
def test_stairs_cost_the_rise():
    # A wheel on stairs is the one on the slope through their edges, seen from the upright.
    slope = 0.2
    theta, lean = rimless_wheel.theta, rimless_wheel.SLOPE.symbol
    stairs = wheel(
        "stairs",
        gravity=sp.Matrix([0, -1]),
        touchdown=Touchdown(sp.cos(sp.pi / 6) - sp.cos(theta - lean), region=lean - theta),
        rise=-sp.sin(lean),
    )
    orbit = cycle(light_model(stairs), ([ROLLING[0] + slope, *ROLLING[1:]], {"slope": slope}))
    assert orbit.state["dtheta"] == pytest.approx(0.460341126609458, abs=1e-12)
    chord = 2 * np.sin(np.pi / 6)
    assert orbit.step_length == pytest.approx(chord * np.cos(slope), abs=1e-13)
    assert orbit.cot == pytest.approx(chord * np.sin(slope) / orbit.step_length, abs=1e-13)
