"""Walkers whose motors act between bodies, and what independent programs found for them.

The compass walker with both legs from the vertical is the built-in one. The torso-driven rimless wheel has
the masses of a published robot's model; its gait comes from a floating-base Lagrangian, DOP853 at 1e-12 with
events, and Newton's method on the step map.
"""

import sympy as sp

from stridemap.derive import SI, STANCE_FOOT, Body, Coordinate, Motor, Parameter, Touchdown, Walker
from stridemap.derive.models import compass
from stridemap.derive.models.controller import CLOCK, GAINS, OMEGA

GAIN = Parameter("k", 1.0, "1", "gain", 0.0)
k = GAIN.symbol
oscillation = OMEGA.symbol


def along(angle):
    return sp.Matrix([-sp.sin(angle), sp.cos(angle)])


# -- the compass walker in absolute angles ---------------------------------------------------------------

A = Coordinate("stance", "rad", "stance leg from the vertical, positive leaning back")
B = Coordinate("swing", "rad", "swing leg from the vertical, positive leaning back")
a, b = A.symbol, B.symbol
FEEDBACK = -k * (a - b) - (A.rate - B.rate)
hip = STANCE_FOOT + along(a)

_kp, _kd, _stride, _gamma = (gain.symbol for gain in GAINS)
HIP_TORQUE = -_kp * (a - b - _gamma * (1 + sp.cos(CLOCK.phase)) + _stride) - _kd * (
    A.rate - B.rate + _gamma * CLOCK.rate * sp.sin(CLOCK.phase)
)

ABSOLUTE = Walker(
    name="absolute",
    title="Compass walker in absolute angles",
    reference="the built-in one",
    coordinates=(A, B),
    parameters=(OMEGA, compass.BETA, *GAINS, GAIN),
    bodies=(
        Body("hip", sp.Integer(1), hip),
        Body("stance foot", compass.BETA.symbol, STANCE_FOOT),
        Body("swing foot", compass.BETA.symbol, hip - along(b)),
    ),
    motors=(Motor("hip", HIP_TORQUE, a - b),),
    clock=CLOCK,
    swing_foot=hip - along(b),
    touchdown=Touchdown(a + b, region=a, rising=False),
    relabel={a: b, b: a},
    section={b: -a},
    stance_angle=A,
    search_box={"stance": (0.08, 0.15), "dstance": (-0.15, 0.6), "dswing": (0.0, 0.6)},
)
ABSOLUTE_GAIT = ([0.0892433641167, -0.168972662551, -0.166288276081, 1.21843703885], {"omega": 3.0})
ABSOLUTE_MEASURES = {"work": 0.0713800965, "cot": 0.3080381338}

# -- a torso-driven rimless wheel ------------------------------------------------------------------------

THETA = Coordinate("theta", "rad", "angle of the stance spoke, positive leaning ahead")
PHI = Coordinate("phi", "rad", "angle of the torso below the hub, positive swung ahead")
theta, phi = THETA.symbol, PHI.symbol
_between, _l1, _l2 = sp.pi / 5, sp.Rational("0.26"), sp.Rational("0.05")
hub = STANCE_FOOT + _l1 * sp.Matrix([sp.sin(theta), sp.cos(theta)])
TORSO_TORQUE = 20 * (sp.Rational(1, 2) - phi) - 2 * PHI.rate
"""Lifts the torso ahead and turns the wheel ahead: phi grows anticlockwise, theta clockwise."""

TORSO_WHEEL = Walker(
    name="torso_wheel",
    title="Rimless wheel with a torso",
    reference="torso-driven rimless wheels",
    units=SI,
    coordinates=(THETA, PHI),
    parameters=(Parameter("g", 9.81, "m/s^2", "gravity", 0.0, lower_open=True),),
    bodies=(
        Body("wheel", sp.Rational("2.32"), hub, sp.Rational("0.0784160"), theta),
        Body(
            "torso",
            sp.Rational("4.194"),
            hub + _l2 * sp.Matrix([sp.sin(phi), -sp.cos(phi)]),
            sp.Rational("0.0380256"),
            phi,
        ),
    ),
    gravity=sp.Matrix([0, -sp.Symbol("g", real=True)]),
    motors=(Motor("hub", TORSO_TORQUE, phi + theta),),
    swing_foot=hub - _l1 * sp.Matrix([sp.sin(theta - _between), sp.cos(theta - _between)]),
    touchdown=Touchdown(sp.cos(_between / 2) - sp.cos(theta), region=-theta),
    relabel={theta: theta - _between, phi: phi},
    stance_angle=THETA,
    search_box={"theta": (-0.3, 0.3), "dtheta": (1.5, 2.0), "phi": (0.5, 0.6), "dphi": (0.0, 3.0)},
    period_range=(0.05, 1.5),
)
TORSO_GAIT = ([-0.314159265359, 2.326385284, 0.449520155, -0.434009510, 0.316002609812], {})
TORSO_MEASURES = {"work": 0.5729395648, "cot": 0.0557964213}
