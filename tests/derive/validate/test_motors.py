"""Motors that contradict themselves, and torques that are one motor's, are refused with the way out."""

import pytest
import sympy as sp

from stridemap.derive import STANCE_FOOT, TIME, Body, Clock, Coordinate, Motor, Parameter, Touchdown, Walker
from stridemap.errors import InputError
from tests.oracles.motors import ABSOLUTE, FEEDBACK, GAIN, TORSO_WHEEL, A, B, a, b, k, oscillation

pytestmark = pytest.mark.quick

SECOND = Parameter("k2", 0.5, "1", "another gain", 0.0)
k2 = SECOND.symbol
ankle = -k2 * a - A.rate


def with_torques(u, w):
    return ABSOLUTE.with_(motors=(), torques={A: u, B: w}, parameters=(*ABSOLUTE.parameters, SECOND))


@pytest.mark.parametrize(
    ("u", "w", "drives"),
    [
        (FEEDBACK, -FEEDBACK, "stance - swing"),
        (FEEDBACK, FEEDBACK, "stance + swing"),
        (FEEDBACK, 3 * FEEDBACK / 2, "stance + 3*swing/2"),
        (k * (a - b), k * b - k * a, "stance - swing"),  # not the same as it is written
        (k * (a - b), k2 * k * (b - a), "-k2*swing + stance"),
        (k * sp.cos(TIME), -k * sp.cos(TIME), "stance - swing"),
        (k, -k, "stance - swing"),
        (ankle + FEEDBACK, -FEEDBACK, "stance - swing"),  # a part of one
        ((k2 + k) * a - k * b, k * (b - a), "stance - swing"),  # not even a term
        (sp.sin(a - b) / (2 + sp.cos(b)), sp.sin(b - a) / (2 + sp.cos(b)), "stance - swing"),
    ],
)
def test_one_torque_on_two_coordinates_is_a_motor_between_them(u, w, drives):
    with pytest.raises(InputError) as refused:
        with_torques(u, w)
    assert f'motors=(Motor("stance_motor", torque, drives={drives}),)' in str(refused.value)
    assert "the same torque acts on stance and" in str(refused.value)


@pytest.mark.parametrize(
    ("u", "w"),
    [
        (-k * a, -k * b),  # two motors of equal gains
        (-k * a - A.rate, -k2 * b - B.rate),
        (-k * (a - sp.cos(TIME)), -k * (b - sp.cos(TIME))),  # that follow one rhythm
        (k * sp.cos(TIME), k2 * sp.cos(TIME)),  # of two amplitudes
        (k, k2),
        (ankle, sp.S.Zero),
    ],
)
def test_two_motors_are_two(u, w):
    walker = with_torques(u, w)
    assert [m.name for m in walker.actuators] == ["stance", "swing"]
    assert [m.drives for m in walker.actuators] == [a, b]


def test_more_torques_than_motors():
    c = Coordinate("torso", "rad", "torso from the vertical")
    left, right = -k * sp.sin(a - c.symbol), -k2 * sp.tanh(b - c.symbol)
    torso = Body(
        "torso",
        sp.Integer(1),
        STANCE_FOOT + sp.Matrix([-sp.sin(a), sp.cos(a)]) + sp.Matrix([-sp.sin(c.symbol), sp.cos(c.symbol)]),
    )
    with pytest.raises(InputError, match=r"(the same torque acts on|depend on each other)"):
        ABSOLUTE.with_(
            motors=(),
            torques={A: left, B: right, c: -left - right},
            coordinates=(*ABSOLUTE.coordinates, c),
            parameters=(*ABSOLUTE.parameters, SECOND),
            bodies=(*ABSOLUTE.bodies, torso),
            relabel={**ABSOLUTE.relabel, c.symbol: c.symbol},
            search_box={**ABSOLUTE.search_box, "torso": (0.0, 0.1), "dtorso": (0.0, 0.1)},
        )


MOTOR = Motor("hip", FEEDBACK, a - b)


@pytest.mark.parametrize(
    ("motors", "said"),
    [
        (
            (Motor("hip", FEEDBACK, a - b, limit=0),),
            "the limit of the motor hip is 0; it must be a number above 0",
        ),
        ((Motor("hip", FEEDBACK, a - b, limit=k),), "the limit of the motor hip is k; it must be a number"),
        (
            (Motor("hip", FEEDBACK, a - b, efficiency=1.5),),
            "the efficiency of the motor hip is 1.5; it must be",
        ),
        ((Motor("hip", FEEDBACK, a - b, efficiency=0),), "the efficiency of the motor hip is 0; it must be"),
        ((Motor("hip", FEEDBACK, a - b, kind="work"),), "the kind of the motor hip is 'work'; it must be"),
        (
            (Motor("hip", FEEDBACK, k),),
            "the motor hip drives k, which does not move; give an angle or a length",
        ),
        ((Motor("hip", FEEDBACK, A.rate),), "the drive of the motor hip has the symbol dstance"),
        ((Motor("hip", FEEDBACK, a * TIME),), "the drive of the motor hip has the symbol t"),
        (
            (Motor("hip", sp.Symbol("x"), a),),
            "the torque of the motor hip has the symbol x, which is not a parameter",
        ),
        ((Motor("a hip", FEEDBACK, a),), "the motor 'a hip' cannot be a part of a column's name"),
        ((MOTOR, MOTOR), "there are two motors called hip; rename one of them"),
        (
            (MOTOR, Motor("net", FEEDBACK, a)),
            "the motor net has a column work_net, which is the name of a column",
        ),
        (
            (Motor("positive", FEEDBACK, a), MOTOR),
            "the motor positive has a column work_positive, which is the name",
        ),
        (
            (MOTOR, Motor("net_hip", FEEDBACK, a)),
            "the motor net_hip has a column work_net_hip, which is the name of a column of the motor hip",
        ),
        ((FEEDBACK,), "which is not a Motor"),
        (MOTOR, "motors is not a tuple; write (Motor(...),)"),
        ((Motor("hip", FEEDBACK, A),), "the drives of the motor hip is the Coordinate stance itself"),
    ],
)
def test_refused(motors, said):
    with pytest.raises(InputError) as refused:
        ABSOLUTE.with_(motors=motors)
    assert said in str(refused.value)


def test_a_parameter_cannot_bear_the_name_of_a_motors_column():
    motors = (MOTOR, Motor("ankle", FEEDBACK, a))
    mine = Parameter("peak_torque_hip", 1.0, "1", "a parameter")
    with pytest.raises(InputError, match="has a column peak_torque_hip, which is the name of a parameter"):
        ABSOLUTE.with_(motors=motors, parameters=(*ABSOLUTE.parameters, mine))


def test_torques_and_motors_stand_side_by_side_under_different_names():
    walker = ABSOLUTE.with_(torques={A: ankle.subs(k2, 1)})
    assert [m.name for m in walker.actuators] == ["stance", "hip"]
    with pytest.raises(
        InputError, match="there are a torque on stance and a motor stance; rename one of them"
    ):
        ABSOLUTE.with_(torques={A: ankle.subs(k2, 1)}, motors=(Motor("stance", FEEDBACK, a - b),))


def test_the_clocks_phase_is_not_driven():
    clock = Clock(oscillation, resets=False)
    with pytest.raises(
        InputError, match="the motor hip drives phase, the clock's phase, which is not a motion"
    ):
        ABSOLUTE.with_(clock=clock, motors=(Motor("hip", FEEDBACK, clock.phase),))
    with pytest.raises(InputError, match="the motor phase drives phase, the clock's phase"):
        ABSOLUTE.with_(clock=clock, motors=(), torques={clock.coordinate: FEEDBACK})


# -- between bodies ----------------------------------------------------------------------------------------

WHEEL, TORSO = TORSO_WHEEL.bodies


def between(body, other, bodies=(WHEEL, TORSO), **options):
    motor = Motor.between("hub", GAIN.symbol, body, other, **options)
    return TORSO_WHEEL.with_(bodies=bodies, motors=(motor,), parameters=(*TORSO_WHEEL.parameters, GAIN))


def test_angles_of_opposite_senses_are_noticed():
    with pytest.raises(InputError, match="count their angles in opposite senses") as refused:
        between(TORSO, WHEEL)
    assert "write drives=phi + theta" in str(refused.value)
    turned = Body("wheel", WHEEL.mass, WHEEL.position, WHEEL.inertia, -WHEEL.angle)
    (motor,) = between(TORSO, turned, (turned, TORSO), meaning="in the hub", limit=2.0).actuators
    assert motor.drives == TORSO.angle + WHEEL.angle
    assert (motor.meaning, motor.limit, motor.kind) == ("in the hub", 2.0, "torque")


def test_a_body_and_the_ground():
    (motor,) = between(TORSO, None).actuators
    assert motor.drives == TORSO.angle


def test_what_is_no_body_of_the_walker_is_refused():
    with pytest.raises(InputError, match=r"motor hub: phi is not a Body; give the bodies themselves"):
        between(TORSO.angle, WHEEL)
    with pytest.raises(InputError, match="acts on a body torso with the angle 2\\*phi, which is not one of"):
        between(Body("torso", sp.S.One, TORSO.position, angle=2 * TORSO.angle), None)
    relative = Body("torso", TORSO.mass, TORSO.position, TORSO.inertia, TORSO.angle + WHEEL.angle)
    with pytest.raises(
        InputError, match="changes by 0 when the walker is turned by 1 rad, so it is not the body's"
    ):
        between(relative, None, (WHEEL, relative))
    point = Body("torso", TORSO.mass, TORSO.position)
    with pytest.raises(
        InputError, match=r"does not move; give angle= to the bodies it acts between \(torso has none\)"
    ):
        between(point, None, (WHEEL, point))


def test_a_walker_is_needed():
    assert isinstance(ABSOLUTE, Walker)
    assert isinstance(ABSOLUTE.touchdown, Touchdown)
