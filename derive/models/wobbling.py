"""The paper's walker: a compass walker whose hip carries a mass on a horizontal spring.

The rail of the wobbling mass stays horizontal at the height of the hip.
"""

import sympy as sp

from stridemap.derive.controller import GAINS, OSCILLATOR, hip_torque
from stridemap.derive.declaration import Coordinate, Line, Parameter, PointMass, Walker
from stridemap.derive.models.compass import (
    BETA,
    FEET,
    LEGS,
    SWAP,
    THETA1,
    THETA2,
    hip,
    swing_foot,
    theta1,
    theta2,
)
from stridemap.derive.models.compass import WALKER as COMPASS

X = Coordinate("x", "L", "distance of the wobbling mass ahead of the hip")
K = Parameter("k", 6.0, "M g / L", "stiffness of the wobbling mass's spring", 0.0)
ALPHA = Parameter(
    "alpha", 0.25, "1", "wobbling mass as a share of the upper body's mass", 0.0, 1.0, True, True
)

k, alpha, x = K.symbol, ALPHA.symbol, X.symbol
wobbling_mass = hip + sp.Matrix([x, 0])

WALKER = Walker(
    name="wobbling",
    title="Compass walker with a horizontally wobbling mass",
    reference="T. Kamimura, A. Sano, ICRA 2023 (arXiv:2209.14515)",
    coordinates=(THETA1, THETA2, X),
    parameters=(K, ALPHA, *OSCILLATOR, BETA, *GAINS),
    masses=(
        PointMass("hip", 1 - alpha, hip),
        PointMass("wobbling mass", alpha, wobbling_mass),
        *FEET,
    ),
    springs={"spring": k * x**2 / 2},
    actuated=THETA2,
    torque=hip_torque(THETA2),
    swing_foot=swing_foot,
    touchdown=theta2 - 2 * theta1,
    touchdown_side=theta1,
    relabel={**SWAP, x: x},
    section_solves=(theta2, 2 * theta1),
    stance_angle=THETA1,
    spring_mode=sp.sqrt(k / (alpha * (1 - alpha))),
    wobbling=X,
    drawing=(LEGS, Line("spring", (hip, wobbling_mass), spring=True)),
    search_box={**COMPASS.search_box, "x": (0.0, 0.15), "dx": (0.0, 1.5)},
)
