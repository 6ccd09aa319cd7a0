"""The compass gait: a hip mass and a mass part-way along each leg, going down a slope without any motor.

A. Goswami, B. Espiau, A. Keramane, "Limit cycles in a passive compass gait biped and passivity-mimicking
control laws", Autonomous Robots 4 (1997) 273-286, doi:10.1023/A:1008844026298; A. Goswami, B. Thuilot,
B. Espiau, "A study of the passive gait of a compass-like biped robot", Int. J. Robotics Research 17 (1998)
1282-1301, doi:10.1177/027836499801701202. With ``mu = 2`` and ``beta = 1`` the period of the gait doubles
first near a slope of 4.4 degrees.
"""

import sympy as sp

from stridemap.derive import STANCE_FOOT, Body, Line, Parameter, Touchdown, UnitNames, Walker
from stridemap.derive.models.compass import THETA1, THETA2
from stridemap.derive.models.slope import SLOPE, downhill

MU = Parameter("mu", 2.0, "1", "mass at the hip, in terms of the mass of a leg", 0.0)
BETA = Parameter("beta", 1.0, "1", "distance from hip to a leg's mass, over that from there to the foot", 0.0)
theta1, theta2, beta = THETA1.symbol, THETA2.symbol, BETA.symbol

from_hip = beta / (1 + beta)
up = sp.Matrix([-sp.sin(theta1), sp.cos(theta1)])
down = sp.Matrix([sp.sin(theta1 - theta2), -sp.cos(theta1 - theta2)])
hip, swing_foot = STANCE_FOOT + up, STANCE_FOOT + up + down

WALKER = Walker(
    name="goswami_compass",
    title="Compass gait on a slope",
    reference="A. Goswami, B. Thuilot, B. Espiau, Int. J. Robotics Research 17 (1998) 1282-1301",
    coordinates=(THETA1, THETA2),
    parameters=(MU, BETA, Parameter("slope", 0.05, SLOPE.unit, SLOPE.meaning, SLOPE.lower, SLOPE.upper)),
    bodies=(
        Body("hip", MU.symbol, hip),
        Body("stance leg", sp.Integer(1), STANCE_FOOT + (1 - from_hip) * up),
        Body("swing leg", sp.Integer(1), hip + from_hip * down),
    ),
    gravity=downhill(SLOPE.symbol),
    swing_foot=swing_foot,
    touchdown=Touchdown(theta2 - 2 * theta1, region=theta1),
    relabel={theta1: theta1 - theta2, theta2: -theta2},
    section={theta2: 2 * theta1},
    stance_angle=THETA1,
    drawing=(Line("legs", (STANCE_FOOT, hip, swing_foot), legs=True),),
    search_box={"theta1": (0.25, 0.3), "dtheta1": (-0.3, 0.5), "dtheta2": (0.0, 0.5)},
    period_range=(0.8, 5.0),
    units=UnitNames(mass="m", energy="m g L"),
)
