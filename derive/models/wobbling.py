"""The paper's walker: a compass walker whose hip carries a mass on a horizontal spring.

The rail of the wobbling mass stays horizontal at the height of the hip. The paper's spring has no friction;
a real one has, so the walker has a damper beside it, and with ``c = 0`` it is the paper's.
"""

import sympy as sp

from stridemap.derive.models.compass import LEGS, hip
from stridemap.derive.models.compass import WALKER as COMPASS
from stridemap.derive.parts import Body, Coordinate, Line, Parameter

X = Coordinate("x", "L", "distance of the wobbling mass ahead of the hip")
K = Parameter("k", 6.0, "M g / L", "stiffness of the wobbling mass's spring", 0.0)
ALPHA = Parameter(
    "alpha", 0.25, "1", "wobbling mass as a share of the upper body's mass", 0.0, 1.0, True, True
)
C = Parameter("c", 0.0, "M sqrt(g/L)", "damping of the wobbling mass; the paper has none", 0.0)

k, alpha, c, x = K.symbol, ALPHA.symbol, C.symbol, X.symbol
mass = hip + sp.Matrix([x, 0])
_, *feet = COMPASS.bodies

WALKER = COMPASS.with_(
    name="wobbling",
    title="Compass walker with a horizontally wobbling mass",
    reference="T. Kamimura, A. Sano, ICRA 2023 (arXiv:2209.14515)",
    coordinates=(*COMPASS.coordinates, X),
    parameters=(K, ALPHA, *COMPASS.parameters, C),
    bodies=(Body("hip", 1 - alpha, hip), Body("wobbling mass", alpha, mass), *feet),
    potentials={"spring": k * x**2 / 2},
    dissipation=c * X.rate**2 / 2,
    relabel={**COMPASS.relabel, x: x},
    spring_mode=sp.sqrt(k / (alpha * (1 - alpha))),
    wobbling=X,
    drawing=(LEGS, Line("spring", (hip, mass), spring=True)),
    search_box={**COMPASS.search_box, "x": (0.0, 0.15), "dx": (0.0, 1.5)},
)
