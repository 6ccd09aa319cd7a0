"""A walker that declares all that a declaration can hold, in no way a sensible one, and the same by hand.

Legs with mass and inertia end in arcs, about whose centres the mass lies, and roll down a slope; a torso is
driven, damped, held by a spring and locked by the impact; the clock is not reset at touchdown.
"""

import numpy as np
import sympy as sp

from stridemap.derive import (
    SI,
    STANCE_FOOT,
    Body,
    Clock,
    Coordinate,
    Parameter,
    Touchdown,
    Walker,
    rolling_arc,
)
from stridemap.derive.models.compass import THETA1, THETA2
from tests.oracles.newton import Body as Mass
from tests.oracles.newton import Newton, times, transposed

PSI = Coordinate("psi", "rad", "angle of the torso from the vertical, positive leaning ahead")
NAMES = {"g": 9.81, "slope": 0.05, "radius": 0.2, "c": 0.3, "omega": 3.0}
PARAMETERS = tuple(Parameter(name, value, "1", "a parameter", 0.0) for name, value in NAMES.items())
g, slope, radius, c, omega = (a.symbol for a in PARAMETERS)
m, J = sp.Rational(5, 8), sp.Rational(1, 4)  # fractions that are floats too
theta1, theta2, psi = THETA1.symbol, THETA2.symbol, PSI.symbol
CLOCK = Clock(omega, resets=False)

up = sp.Matrix([-sp.sin(theta1), sp.cos(theta1)])
down = sp.Matrix([sp.sin(theta1 - theta2), -sp.cos(theta1 - theta2)])
hip = STANCE_FOOT + (1 - radius) * up
swing_foot = hip + (1 - radius) * down
torso = hip + m * sp.Matrix([sp.sin(psi), sp.cos(psi)])

WALKER = Walker(
    name="everything",
    title="A walker with everything",
    reference="none",
    coordinates=(THETA1, THETA2, PSI),
    parameters=PARAMETERS,
    bodies=(
        Body("stance leg", m, STANCE_FOOT, J, theta1),
        Body("swing leg", m, swing_foot, J, theta1 - theta2),
        Body("torso", sp.Integer(1), torso, J / 2, -psi),
    ),
    gravity=g * sp.Matrix([sp.sin(slope), -sp.cos(slope)]),
    potentials={"spring": 2 * psi**2},
    dissipation=c * (PSI.rate + THETA1.rate) ** 2 / 2,
    torques={PSI: -2 * psi - PSI.rate, THETA2: 3 * sp.sin(CLOCK.phase) - theta2},
    clock=CLOCK,
    stance=rolling_arc(radius, theta1),
    swing_foot=swing_foot,
    touchdown=Touchdown(2 * theta1 - theta2, theta1, rising=False),
    relabel={theta1: theta1 - theta2, theta2: -theta2, psi: psi},
    locks=(psi + theta1 - theta2,),  # the torso to the leg that stands next
    section={theta2: 2 * theta1, PSI.rate: -THETA1.rate},
    search_box={"theta1": (0.2, 0.1), "dtheta1": (-0.5, 0.5), "dtheta2": (0.0, 0.5), "psi": (0.0, 0.1)},
    units=SI,
)


class ByHand(Newton):
    """The same without the clock, on the floating base: the arc's centre has coordinates of its own."""

    def build(self):
        self.phase = self.q[:, 3]
        self.q, self.v, self.n = self.q[:, :3], self.v[:, :3], 3
        (theta1, theta2, psi), (w1, w2, w3) = self.q.T, self.v.T
        leg = 1 - self.par["radius"]
        self.hip = self.leg(theta1, w1, -1, {0: 1}) * leg
        self.foot = self.hip + self.leg(theta1 - theta2, w1 - w2, 1, {0: 1, 1: -1}) * leg
        torso = self.hip + self.leg(-psi, -w3, -1, {2: -1}) * (0.625 + 0 * psi)
        one = 1 + 0 * psi
        mass, inertia, turns = 0.625 * one, 0.25 * one, np.eye(3)
        self.bodies = [
            Mass(mass, self.rest, inertia, turns[0] + 0 * self.q),
            Mass(mass, self.foot, inertia, turns[0] - turns[1] + 0 * self.q),
            Mass(one, torso, inertia / 2, -turns[2] + 0 * self.q),
        ]

    @property
    def gravity(self):
        return self.par["g"][:, None] * super().gravity

    @property
    def applied(self):
        """Torques, spring and damper, on the three coordinates."""
        a, (_, theta2, psi), (w1, _, w3) = self.par, self.q.T, self.v.T
        damper = a["c"] * (w3 + w1)
        hip, torso = 3 * np.sin(self.phase) - theta2, -2 * psi - w3
        return np.stack([-damper, hip, torso - 4 * psi - damper], axis=-1)

    def rolling(self, leg):
        """Constraint that a foot's centre moves by minus the radius times the leg's turn, shape (2, 5)."""
        rows = np.zeros((self.count, 2, 5))
        rows[:, 0, 2:] = self.par["radius"][:, None] * leg
        return rows

    def motion(self):
        """Accelerations of base and coordinates, and the ground's force where the foot touches."""
        inertia, _ = self.floating()
        held = self.rolling(np.array([1, 0, 0]))
        held[:, :2, :2] = np.eye(2)

        def wide(point):
            return np.concatenate([np.broadcast_to(np.eye(2), (self.count, 2, 2)), point.jacobian], axis=-1)

        force = self.sum(lambda p: times(transposed(wide(p)), self.gravity - p.acceleration))
        force[:, 2:] += self.applied
        system = np.block([[inertia, -transposed(held)], [held, np.zeros((self.count, 2, 2))]])
        right = np.concatenate([force, np.zeros((self.count, 2))], axis=1)
        solution = np.linalg.solve(system, right[..., None])[..., 0]
        return solution[:, :5], solution[:, 5:]

    def impact(self):
        """Rates after the impact, legs swapped, and the impulses of the ground and of the lock."""
        inertia, swing = self.floating()
        free = np.zeros((self.count, 3, 5))
        free[:, :2] = swing + self.rolling(np.array([1, -1, 0]))
        free[:, 2, 2:] = [1, -1, 1]  # the torso's rate from the leg that stands next
        before = np.concatenate([0 * self.v[:, :2], self.v], axis=1)
        before[:, 0] = -self.par["radius"] * self.v[:, 0]
        system = np.block([[inertia, -transposed(free)], [free, np.zeros((self.count, 3, 3))]])
        right = np.concatenate([times(inertia, before), np.zeros((self.count, 3))], axis=1)
        solution = np.linalg.solve(system, right[..., None])[..., 0]
        return self.swapped(solution[:, 2:5]), solution[:, 5:7]

    def on_stance(self, point):
        """Position of a point that is given from the arc's centre, from where the foot's lowest point was."""
        radius, theta1 = self.par["radius"], self.q[:, 0]
        return point.position + np.stack([-radius * theta1, radius], axis=-1)
