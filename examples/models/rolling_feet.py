"""The compass walker on round feet: each leg ends in an arc whose centre lies on the leg.

``STANCE_FOOT`` is the centre of the stance foot's arc. With ``radius = 0`` it is the compass
walker.
"""

import sympy as sp

from stridemap.derive import STANCE_FOOT, Body, Line, Parameter, rolling_arc
from stridemap.derive.models.compass import BETA, theta1, theta2
from stridemap.derive.models.compass import WALKER as COMPASS

RADIUS = Parameter("radius", 0.2, "L", "radius of the feet", 0.0, 1.0, upper_open=True)

radius, beta = RADIUS.symbol, BETA.symbol
up = sp.Matrix([-sp.sin(theta1), sp.cos(theta1)])
down = sp.Matrix([sp.sin(theta1 - theta2), -sp.cos(theta1 - theta2)])
hip = STANCE_FOOT + (1 - radius) * up

WALKER = COMPASS.with_(
    name="rolling_feet",
    title="Compass walker on round feet",
    reference="T. McGeer, Int. J. Robotics Research 9 (1990) 62-82, for the feet",
    parameters=(RADIUS, *COMPASS.parameters),
    bodies=(
        Body("hip", sp.Integer(1), hip),
        Body("stance foot", beta, hip - up),
        Body("swing foot", beta, hip + down),
    ),
    stance=rolling_arc(radius, theta1),
    swing_foot=hip + (1 - radius) * down,
    drawing=(Line("legs", (hip - up, hip, hip + down), legs=True),),
)
