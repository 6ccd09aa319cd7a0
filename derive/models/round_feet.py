"""A walker on round feet: a hip mass and two legs with inertia, whose feet are arcs, going down a slope.

P. A. Bhounsule, `passivewalker.m`, case 2 (https://pab47.github.io/passivewalker.m; first version of December
2009). The preset is his: hip 1, legs 0.5 with inertia 0.02 half-way from the hip, radius 0.2, slope 0.01, all
in terms of the length from the hip to the centre of the arc, and of g = 1.

The fixed point that the file prints, ``0.189472782205104, -0.239124222551699, ..., -0.053691703909393``, is
not one of the equations in the file. It belongs to the heel strike of the first versions; on 14 December 2019
the author corrected that ("heelstrike equations fixed") and left the numbers as they were. The old heel
strike gives the printed digits to 1e-13. With the corrected one, which is the plastic impact of every model
here, the section point (q1, dq1, dq2), the period and the multipliers of the two gaits are

    long:   0.189438283253, -0.239010987813, -0.051397006345; 2.427955842629;
            0.4334448697, 0.3704653850 +- 0.1837039158i
    short:  0.170377197548, -0.232652285601, -0.023678647519; 2.151258880007;
            2.0227272029 is the largest

(an independent program: floating-base Lagrangian, event-driven integration, Newton's method; it agrees to
1e-12). In case 1 of the same file (radius 0, hip mass 1000, leg mass 1 at the foot, slope 0.009) the heel
strike was right from the beginning, and so is its fixed point.
"""

import sympy as sp

from stridemap.derive import (
    STANCE_FOOT,
    Body,
    Coordinate,
    Line,
    Parameter,
    Touchdown,
    Walker,
    rolling_arc,
)
from stridemap.derive.models.slope import SLOPE, downhill

Q1 = Coordinate("q1", "rad", "angle of the stance leg from the ground's normal, positive leaning back")
Q2 = Coordinate("q2", "rad", "angle from the stance leg to the swing leg")
HIP_MASS = Parameter("hip_mass", 1.0, "M", "mass at the hip", 0.0)
LEG_MASS = Parameter("leg_mass", 0.5, "M", "mass of a leg", 0.0, lower_open=True)
INERTIA = Parameter("inertia", 0.02, "M L^2", "moment of inertia of a leg about its centre of mass", 0.0)
DISTANCE = Parameter("com_distance", 0.5, "L", "from the hip to a leg's centre of mass, along the leg", 0.0)
OFFSET = Parameter("com_offset", 0.0, "L", "of a leg's centre of mass from the leg, ahead of it")
RADIUS = Parameter("radius", 0.2, "L", "radius of the feet", 0.0)

q1, q2, distance, offset = Q1.symbol, Q2.symbol, DISTANCE.symbol, OFFSET.symbol


def along(angle: sp.Expr) -> sp.Matrix:
    """Up a leg, from the centre of its arc to the hip."""
    return sp.Matrix([-sp.sin(angle), sp.cos(angle)])


def ahead(angle: sp.Expr) -> sp.Matrix:
    """Across a leg, to the side where walking leads."""
    return sp.Matrix([sp.cos(angle), sp.sin(angle)])


def leg(name: str, angle: sp.Expr) -> Body:
    """A leg that hangs from the hip."""
    centre = hip - distance * along(angle) + offset * ahead(angle)
    return Body(name, LEG_MASS.symbol, centre, inertia=INERTIA.symbol, angle=angle)


hip = STANCE_FOOT + along(q1)
swing_foot = hip - along(q1 - q2)

WALKER = Walker(
    name="round_feet",
    title="Walker on round feet",
    reference="P. A. Bhounsule, passivewalker.m (2009, corrected 2019)",
    coordinates=(Q1, Q2),
    parameters=(
        HIP_MASS,
        LEG_MASS,
        INERTIA,
        DISTANCE,
        OFFSET,
        RADIUS,
        Parameter("slope", 0.01, SLOPE.unit, SLOPE.meaning, SLOPE.lower, SLOPE.upper),
    ),
    bodies=(
        Body("hip", HIP_MASS.symbol, hip),
        leg("stance leg", q1),
        leg("swing leg", q1 - q2),
    ),
    gravity=downhill(SLOPE.symbol),
    stance=rolling_arc(RADIUS.symbol, q1),
    swing_foot=swing_foot,
    touchdown=Touchdown(q2 - 2 * q1, region=q1),
    relabel={q1: q1 - q2, q2: -q2},
    section={q2: 2 * q1},
    stance_angle=Q1,
    drawing=(Line("legs", (STANCE_FOOT, hip, swing_foot), legs=True),),
    search_box={"q1": (0.2, 0.2), "dq1": (-0.3, 0.3), "dq2": (0.0, 0.4)},
    period_range=(0.5, 6.0),
)
