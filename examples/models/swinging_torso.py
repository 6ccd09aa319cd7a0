"""The compass walker with a torso: a mass on a pendulum above the hip, held up by a rotational spring.

The spring (and a damper beside it) acts between the torso and the line that halves the angle between the legs,
so no couple comes from nowhere. Very stiff and well damped, it makes the torso one body with that line, as
the bisecting mechanism of M. Wisse, D. G. E. Hobbelen, A. L. Schwab, IEEE Trans. Robotics 23 (2007) 112-123,
does; without a torso's mass there remains the compass walker.
"""

import sympy as sp

from stridemap.derive import Body, Coordinate, Line, Parameter
from stridemap.derive.models.compass import LEGS, hip, theta1, theta2
from stridemap.derive.models.compass import WALKER as COMPASS

PSI = Coordinate("psi", "rad", "angle of the torso from the vertical, positive leaning ahead")
K = Parameter("k", 5.0, "M g L", "stiffness of the torso's spring", 0.0)
C = Parameter("c", 0.0, "M g L sqrt(L/g)", "coefficient of the torso's damper", 0.0)
ALPHA = Parameter(
    "alpha", 0.25, "1", "torso's mass as a share of the upper body's", 0.0, 1.0, True, True
)
R = Parameter("r", 0.5, "L", "height of the torso's mass above the hip", 0.0, lower_open=True)

psi, alpha, r = PSI.symbol, ALPHA.symbol, R.symbol
mass = hip + r * sp.Matrix([sp.sin(psi), sp.cos(psi)])
twist = psi + theta1 - theta2 / 2  # from the line that halves the angle between the legs
THETA1, THETA2 = COMPASS.coordinates
twist_rate = PSI.rate + THETA1.rate - THETA2.rate / 2
_, *feet = COMPASS.bodies

WALKER = COMPASS.with_(
    name="swinging_torso",
    title="Compass walker with a swinging torso",
    reference="outlook of T. Kamimura, A. Sano, ICRA 2023 (arXiv:2209.14515)",
    coordinates=(*COMPASS.coordinates, PSI),
    parameters=(K, C, ALPHA, R, *COMPASS.parameters),
    bodies=(Body("hip", 1 - alpha, hip), Body("torso", alpha, mass), *feet),
    potentials={"spring": K.symbol * twist**2 / 2},
    dissipation=C.symbol * twist_rate**2 / 2,
    relabel={**COMPASS.relabel, psi: psi},
    wobbling=PSI,
    drawing=(LEGS, Line("torso", (hip, mass))),
    search_box={**COMPASS.search_box, "psi": (0.0, 0.3), "dpsi": (0.0, 1.5)},
)
