"""The compass walker: two straight massless legs, a mass at the hip and one at each foot.

The same walker as `wobbling` without the wobbling mass. It is a model of its own, because the mass
matrix of that one is singular at ``alpha = 0``.
"""

import sympy as sp

from stridemap.derive.models.controller import CLOCK, GAINS, OMEGA, hip_torque
from stridemap.derive.parts import STANCE_FOOT, Body, Coordinate, Line, Parameter, Touchdown
from stridemap.derive.walker import Walker

THETA1 = Coordinate("theta1", "rad", "angle of the stance leg from the vertical, positive leaning back")
THETA2 = Coordinate("theta2", "rad", "angle from the stance leg to the swing leg")
BETA = Parameter("beta", 0.15, "M", "point mass at each foot", 0.0, lower_open=True)

theta1, theta2 = THETA1.symbol, THETA2.symbol
hip = STANCE_FOOT + sp.Matrix([-sp.sin(theta1), sp.cos(theta1)])
swing_foot = hip + sp.Matrix([sp.sin(theta1 - theta2), -sp.cos(theta1 - theta2)])

LEGS = Line("legs", (STANCE_FOOT, hip, swing_foot), legs=True)
PAPER = "Kamimura & Sano 2023"

WALKER = Walker(
    name="compass",
    title="Compass walker",
    reference="T. Kamimura, A. Sano, ICRA 2023 (arXiv:2209.14515), without the wobbling mass",
    coordinates=(THETA1, THETA2),
    parameters=(OMEGA, BETA, *GAINS),
    bodies=(
        Body("hip", sp.Integer(1), hip),
        Body("stance foot", BETA.symbol, STANCE_FOOT),
        Body("swing foot", BETA.symbol, swing_foot),
    ),
    torques={THETA2: hip_torque(THETA2, CLOCK)},
    clock=CLOCK,
    swing_foot=swing_foot,
    touchdown=Touchdown(theta2 - 2 * theta1, region=theta1),
    relabel={theta1: theta1 - theta2, theta2: -theta2},
    section={theta2: 2 * theta1},
    stance_angle=THETA1,
    drawing=(LEGS,),
    search_box={"theta1": (0.08, 0.15), "dtheta1": (-0.15, 0.6), "dtheta2": (0.0, 0.2)},
    sources={
        "mass_matrix": f"{PAPER}, eq. (1)",
        "bias_forces": f"{PAPER}, eq. (1)",
        "controller_torque": f"{PAPER}, eqs. (3) and (4)",
        "state_derivative": f"{PAPER}, eq. (1)",
        "touchdown_condition": f"{PAPER}, below eq. (1)",
        "zmp": f"{PAPER}, eq. (6)",
    },
)
