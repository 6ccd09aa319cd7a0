"""The simplest walker: a hip mass on two massless legs, with feet of no mass, going down a slope.

M. Garcia, A. Chatterjee, A. Ruina, M. Coleman, "The Simplest Walking Model: Stability, Complexity, and
Scaling", J. Biomech. Eng. 120 (1998) 281-288, doi:10.1115/1.2798313. It has two gaits on a gentle slope.
At slope 0.009 the section point (theta, dtheta), the period and the multipliers are

    stable:   0.20031090054424709, -0.19983247300495235; 3.88246375285137414;
              -0.19009984106588815 +- 0.55759877668206827i
    unstable: 0.19393736981018181, -0.20386692744200693; 3.09610586807816370;
              4.00386435892970718, 0.45958958979767159

(an independent computation with 45 digits; the figures printed by P. A. Bhounsule, Dyn. Cont. Disc. Impuls.
Syst. B 21 (2014) 137-148, agree to 4e-12).
"""

import sympy as sp

from stridemap.derive import STANCE_FOOT, Body, Coordinate, Line, Massless, Touchdown, Walker
from stridemap.derive.models.slope import SLOPE, downhill

THETA = Coordinate("theta", "rad", "angle of the stance leg from the ground's normal, positive leaning back")
PHI = Coordinate("phi", "rad", "angle from the stance leg to the swing leg")
theta, phi, foot = THETA.symbol, PHI.symbol, sp.Symbol("foot_mass", positive=True)

hip = STANCE_FOOT + sp.Matrix([-sp.sin(theta), sp.cos(theta)])
swing_foot = hip + sp.Matrix([sp.sin(theta - phi), -sp.cos(theta - phi)])

WALKER = Walker(
    name="simplest_walker",
    title="Simplest walker",
    reference="M. Garcia, A. Chatterjee, A. Ruina, M. Coleman, J. Biomech. Eng. 120 (1998) 281-288",
    coordinates=(THETA, PHI),
    parameters=(SLOPE,),
    bodies=(
        Body("hip", sp.Integer(1), hip),
        Body("stance foot", foot, STANCE_FOOT),
        Body("swing foot", foot, swing_foot),
    ),
    massless=Massless(foot, (PHI,)),
    gravity=downhill(SLOPE.symbol),
    swing_foot=swing_foot,
    touchdown=Touchdown(phi - 2 * theta, region=theta),
    relabel={theta: theta - phi, phi: -phi},
    section={phi: 2 * theta, PHI.rate: (1 - sp.cos(2 * theta)) * THETA.rate},
    stance_angle=THETA,
    drawing=(Line("legs", (STANCE_FOOT, hip, swing_foot), legs=True),),
    search_box={"theta": (0.2, 0.3), "dtheta": (-0.2, 0.3)},
    period_range=(1.0, 6.0),
)
