"""The compass walker with a mass on a vertical spring at its hip: the other half of the paper's outlook.

The guide of the wobbling mass stays vertical. The spring is preloaded so that it carries the resting mass at
the height of the hip.
"""

import sympy as sp

from stridemap.derive import Body, Coordinate, Line, Parameter
from stridemap.derive.models.compass import LEGS, hip
from stridemap.derive.models.compass import WALKER as COMPASS

Y = Coordinate("y", "L", "height of the wobbling mass above the hip")
K = Parameter("k", 6.0, "M g / L", "stiffness of the wobbling mass's spring", 0.0)
C = Parameter("c", 0.1, "M sqrt(g/L)", "coefficient of the damper beside it", 0.0)
ALPHA = Parameter(
    "alpha",
    0.25,
    "1",
    "wobbling mass as a share of the upper body's mass",
    0.0,
    1.0,
    True,
    True,
)

y, k, alpha = Y.symbol, K.symbol, ALPHA.symbol
mass = hip + sp.Matrix([0, y])
_, *feet = COMPASS.bodies

WALKER = COMPASS.with_(
    name="vertical_wobbling",
    title="Compass walker with a vertically wobbling mass",
    reference="outlook of T. Kamimura, A. Sano, ICRA 2023 (arXiv:2209.14515)",
    coordinates=(*COMPASS.coordinates, Y),
    parameters=(K, C, ALPHA, *COMPASS.parameters),
    bodies=(Body("hip", 1 - alpha, hip), Body("wobbling mass", alpha, mass), *feet),
    potentials={"spring": k * y**2 / 2 - alpha * y},
    dissipation=C.symbol * Y.rate**2 / 2,
    relabel={**COMPASS.relabel, y: y},
    spring_mode=sp.sqrt(k / (alpha * (1 - alpha))),
    wobbling=Y,
    drawing=(LEGS, Line("spring", (hip, mass), spring=True)),
    search_box={**COMPASS.search_box, "y": (0.0, 0.15), "dy": (0.0, 1.0)},
)
