"""The rimless wheel: spokes without a rim, rolling down a slope.

T. McGeer, "Passive dynamic walking", Int. J. Robotics Research 9 (1990) 62-82,
doi:10.1177/027836499000900206;
M. J. Coleman, "Dynamics and stability of a rimless spoked wheel", Dynamical Systems 25 (2010) 215-238,
doi:10.1080/14689360903429188. All is known in closed form: with n spokes and
``mu = 1 + lambda2 (cos(2 pi/n) - 1)``, just after impact

    dtheta = mu sqrt(4 lambda2 sin(pi/n) sin(slope) / (1 - mu^2)),

and the multiplier is ``mu^2``. With n = 6, lambda2 = 2/3 and slope 0.2 they are 0.460341126609458 and 4/9.
"""

import sympy as sp

from stridemap.derive import STANCE_FOOT, Body, Coordinate, Line, Parameter, Touchdown, UnitNames, Walker
from stridemap.derive.models.slope import SLOPE, downhill

THETA = Coordinate(
    "theta", "rad", "angle of the stance spoke from the ground's normal, positive leaning ahead"
)
SPOKES = Parameter("spokes", 6.0, "1", "number of spokes", 3.0, counts=True)
LAMBDA2 = Parameter(
    "lambda2", 2 / 3, "1", "m l^2 / (I + m l^2) with the moment of inertia I about the hub", 0.0, 1.0, True
)
theta, between = THETA.symbol, 2 * sp.pi / SPOKES.symbol


def spoke(angle: sp.Expr) -> sp.Matrix:
    """From the tip of a spoke to the hub."""
    return sp.Matrix([sp.sin(angle), sp.cos(angle)])


hub = STANCE_FOOT + spoke(theta)
swing_foot = hub - spoke(theta - between)

WALKER = Walker(
    name="rimless_wheel",
    title="Rimless wheel",
    reference="T. McGeer, Int. J. Robotics Research 9 (1990) 62-82",
    coordinates=(THETA,),
    parameters=(
        Parameter("slope", 0.2, SLOPE.unit, SLOPE.meaning, SLOPE.lower, SLOPE.upper),
        SPOKES,
        LAMBDA2,
    ),
    bodies=(Body("hub", sp.Integer(1), hub, inertia=1 / LAMBDA2.symbol - 1, angle=theta),),
    gravity=downhill(SLOPE.symbol),
    swing_foot=swing_foot,
    touchdown=Touchdown(sp.cos(between / 2) - sp.cos(theta), region=-theta),
    relabel={theta: theta - between},
    stance_angle=THETA,
    drawing=(
        Line("stance_spokes", (STANCE_FOOT, hub, swing_foot)),
        Line("spoke_behind", (hub, hub - spoke(theta + between))),
    ),
    search_box={"theta": (-0.5, 0.5), "dtheta": (0.5, 1.0)},
    period_range=(0.1, 8.0),
    units=UnitNames(mass="m", energy="m g L"),
)
