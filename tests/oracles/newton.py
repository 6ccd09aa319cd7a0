"""The built-in walkers stated a second time, by hand.

Nothing here comes from `derive`: `Newton` holds positions, Jacobians and centripetal accelerations of the
bodies as one writes them down on paper, and adds up Newton's and Euler's laws over them. There is no
Lagrangian and no SymPy. It runs on arrays of floats and, for the truth, on arrays of 50-digit numbers.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np

from stridemap.solver.model.loading import load


def solve(matrix, right):
    """Gauss's elimination for a stack of equations, without pivoting: floats or 50-digit numbers."""
    rows = np.concatenate([matrix, right[..., None]], axis=-1)
    n = rows.shape[1]
    for i in range(n):
        rows[:, i, i:] = rows[:, i, i:] / rows[:, i, i, None]
        rows[:, i + 1 :, i:] = rows[:, i + 1 :, i:] - rows[:, i + 1 :, i, None] * rows[:, None, i, i:]
    for i in reversed(range(n)):
        rows[:, :i, -1] = rows[:, :i, -1] - rows[:, :i, i] * rows[:, i, None, -1]
    return rows[..., -1]


def times(matrix, vector):
    """Matrix times vector for stacks of both."""
    return (matrix * vector[:, None, :]).sum(axis=-1)


def transposed(matrix):
    return matrix.transpose(0, 2, 1)


@dataclass
class Point:
    """A point of the walker: position, Jacobian and acceleration at constant rates, from the stance foot."""

    position: Any
    jacobian: Any
    acceleration: Any

    def __add__(self, other):
        return Point(*(getattr(self, key) + getattr(other, key) for key in vars(self)))

    def __mul__(self, factor):
        factor = np.asarray(factor)
        parts = vars(self).values()
        return Point(*(factor.reshape(-1, *[1] * (x.ndim - 1)) * x for x in parts))


@dataclass
class Body:
    """Mass, centre of mass, moment of inertia and what the rates turn the body by, each for all states."""

    mass: Any
    point: Point
    inertia: Any = None
    turn: Any = None


class Newton:
    """Every generated quantity of a walker on legs, from Newton's law for its bodies.

    Methods are named as the generated functions and return a dict of outputs, as those do. Jacobians are
    missing: their truth are differences at 50 digits.
    """

    def __init__(self, name, values, xp=np):
        self.name, self.values, self.xp = name, values, xp
        self.t, self.q, self.v = values["t"], values["q"], values["v"]
        self.count, self.n = self.q.shape
        self.par = dict(zip([a.name for a in load(name).parameters], values["p"].T, strict=True))
        self.build()

    def build(self):
        """State hip, swing foot and bodies, in the order in which they are drawn."""
        theta1, theta2 = self.q.T[:2]
        w1, w2 = self.v.T[:2]
        self.hip = self.leg(theta1, w1, -1, {0: 1})
        self.down = self.leg(theta1 - theta2, w1 - w2, 1, {0: 1, 1: -1})
        self.foot = self.hip + self.down
        beta = self.par["beta"]
        feet = [Body(beta, self.rest), Body(beta, self.foot)]
        self.bodies = [*self.upper_body(), *feet]

    def upper_body(self):
        return [Body(1 + 0 * self.par["beta"], self.hip)]

    def leg(self, angle, rate, sign, jacobian):
        """The vector ``sign (sin angle, -cos angle)`` of an angle with that Jacobian."""
        s, c = self.xp.sin(angle), self.xp.cos(angle)
        along = np.stack([s, -c], axis=-1)
        across = np.stack([c, s], axis=-1)
        columns = [sign * jacobian.get(j, 0) * across for j in range(self.n)]
        return Point(sign * along, np.stack(columns, axis=-1), -sign * along * (rate * rate)[:, None])

    @property
    def rest(self):
        """The stance foot."""
        return self.hip * (0 * self.t)

    @property
    def gravity(self):
        """Acceleration of gravity along and across the ground, shape (count, 2)."""
        slope = self.par.get("slope", 0 * self.t)
        return np.stack([self.xp.sin(slope), -self.xp.cos(slope)], axis=-1)

    def sum(self, term):
        """Sum of ``mass * term(point)`` over the bodies."""
        parts = [(body.mass, term(body.point)) for body in self.bodies]
        return sum(m.reshape(-1, *[1] * (x.ndim - 1)) * x for m, x in parts)

    def rotation(self, size):
        """What the moments of inertia add to a mass matrix, `size` coordinates before those of q."""
        total = 0
        for body in self.bodies:
            if body.inertia is not None:
                turn = np.concatenate([np.zeros((self.count, size), dtype=int), body.turn], axis=-1)
                total = total + body.inertia[:, None, None] * turn[:, :, None] * turn[:, None, :]
        return total

    # -- swing phase -----------------------------------------------------------------------------------------

    def mass_matrix(self):
        return {"M": self.sum(lambda p: np.matmul(transposed(p.jacobian), p.jacobian)) + self.rotation(0)}

    def bias_forces(self):
        return {
            "h": self.sum(lambda p: times(transposed(p.jacobian), p.acceleration)),
            "v_gravity": -self.sum(lambda p: times(transposed(p.jacobian), self.gravity)),
        }

    def controller_torque(self):
        a = self.par
        phase = a["omega"] * self.t
        target = a["gamma"] * (1 + self.xp.cos(phase)) - a["S"]
        target_rate = -a["gamma"] * a["omega"] * self.xp.sin(phase)
        torque = -a["Kp"] * (self.q[:, 1] - target) - a["Kd"] * (self.v[:, 1] - target_rate)
        return {"u": torque[:, None]}

    def motor_rates(self):
        """The motor at the hip drives the angle between the legs."""
        return {"driven": self.q[:, 1:2], "rate": self.v[:, 1:2]}

    def state_derivative(self):
        force = -sum(self.bias_forces().values())
        if "Kp" in self.par:
            force[:, 1] = force[:, 1] + self.controller_torque()["u"][:, 0]
        return {"dq": self.v, "dv": solve(self.mass_matrix()["M"], force)}

    def forward_dynamics(self):
        """As the motion, with given torques of the motor between the legs in place of the controller's."""
        if not self.values["u"].size:
            return {"dv": self.state_derivative()["dv"]}
        force = -sum(self.bias_forces().values())
        force[:, 1] = force[:, 1] + self.values["u"][:, 0]
        return {"dv": solve(self.mass_matrix()["M"], force)}

    # -- touchdown and impact --------------------------------------------------------------------------------

    def touchdown_condition(self):
        (theta1, theta2), (w1, w2) = self.q.T[:2], self.v.T[:2]
        return {"h": theta2 - 2 * theta1, "dh": w2 - 2 * w1, "side": theta1}

    def floating(self):
        """Mass matrix with the stance foot free, and Jacobian of the swing foot."""
        stance = np.broadcast_to(np.eye(2, dtype=int), (self.count, 2, 2))

        def wide(point):
            return np.concatenate([stance, point.jacobian], axis=-1)

        inertia = self.sum(lambda p: np.matmul(transposed(wide(p)), wide(p))) + self.rotation(2)
        return inertia, wide(self.foot)

    def after_release(self):
        """The impact as it is stated: ``Me (v+ - v-) = J^T Lambda, J v+ = 0`` for all n + 4 unknowns."""
        inertia, jacobian = self.floating()
        size = self.n + 2
        matrix = np.zeros((self.count, size + 2, size + 2), dtype=inertia.dtype)
        matrix[:, :size, :size] = inertia
        matrix[:, :size, size:] = -transposed(jacobian)
        matrix[:, size:, :size] = jacobian
        before = np.concatenate([0 * self.velocity(self.foot), self.v], axis=-1)
        right = np.concatenate([times(inertia, before), 0 * before[:, :2]], axis=-1)
        solution = solve(matrix, right)
        return solution[:, 2:size], solution[:, size:]

    def swapped(self, vector):
        """theta1 - theta2, -theta2 and the rest: the legs swap names."""
        return np.concatenate([vector[:, :1] - vector[:, 1:2], -vector[:, 1:2], vector[:, 2:]], axis=-1)

    def impact_map(self):
        return {"q_plus": self.swapped(self.q), "v_plus": self.swapped(self.after_release()[0])}

    def impact_impulse(self):
        return {"Lambda": self.after_release()[1]}

    def before_touchdown(self):
        return {"q_minus": self.swapped(self.q)}

    def step_length(self):
        """The old stance foot is now the swing foot, that far behind the new one."""
        return {"length": -self.foot.position[:, 0], "rise": -self.foot.position[:, 1]}

    # -- what is measured ------------------------------------------------------------------------------------

    def velocity(self, point):
        return times(point.jacobian, self.v)

    def kinetic_energy(self):
        turning = sum(
            b.inertia * (b.turn * self.v).sum(axis=-1) ** 2 for b in self.bodies if b.turn is not None
        )
        return {"kinetic": (self.sum(lambda p: (self.velocity(p) ** 2).sum(axis=-1)) + turning) / 2}

    def potential_energy(self):
        return {"potential": -self.sum(lambda p: (self.gravity * p.position).sum(axis=-1))}

    def total_mass(self):
        """The acceleration of gravity is 1 in all these walkers."""
        mass = sum(body.mass for body in self.bodies)
        pull, press = mass * self.gravity[:, 0], -mass * self.gravity[:, 1]
        return {"mass": mass, "weight": mass, "pull": pull, "press": press}

    def centre_of_mass(self):
        mass = self.total_mass()["mass"][:, None]
        return {"com": self.sum(lambda p: p.position) / mass, "dcom": self.sum(self.velocity) / mass}

    def ground_force(self):
        acceleration = self.state_derivative()["dv"]
        return {"force": self.sum(lambda p: times(p.jacobian, acceleration) + p.acceleration - self.gravity)}

    def zmp(self):
        x_g, y_g = self.centre_of_mass()["com"].T
        along, up = (self.ground_force()["force"] / self.total_mass()["mass"][:, None]).T
        point = x_g - along / up * y_g  # on level ground up is 1 + ddy_g
        return {"zmp": point, "d": -point}

    def moment(self, bodies):
        """What the accelerations of bodies need beyond gravity's, about the stance foot, from x to y."""
        acceleration = self.state_derivative()["dv"]
        total = 0 * self.t
        for body in bodies:
            point = body.point
            push = times(point.jacobian, acceleration) + point.acceleration - self.gravity
            x, y = point.position.T
            total = total + body.mass * (x * push[:, 1] - y * push[:, 0])
            if body.inertia is not None:
                total = total + self.sense * body.inertia * (body.turn * acceleration).sum(axis=-1)
        return total

    sense = 1
    """Of the bodies' angles, from x to y."""

    def guide(self):
        """Moment of what keeps a body from turning along with the walker."""
        return 0 * self.t

    def centre_of_pressure(self):
        moment = self.moment(self.bodies) - self.guide()
        offset = moment / self.ground_force()["force"][:, 1]
        return {"cop": offset, "offset": offset, "moment": moment}

    def stance_foot(self):
        return {"stance": 0 * self.hip.position}

    def swing_foot(self):
        return {"foot": self.foot.position, "dfoot": self.velocity(self.foot)}

    def lines(self):
        """Points of the lines by which the walker is drawn."""
        return {"legs": [self.rest, self.hip, self.foot]}

    def drawing(self):
        return {
            "positions": np.stack([b.point.position for b in self.bodies], axis=1),
            "masses": np.stack([b.mass for b in self.bodies], axis=-1),
            **{key: np.stack([p.position for p in line], axis=1) for key, line in self.lines().items()},
        }

    def section_state(self):
        theta1, *rates = self.values["z"].T
        return {"q": np.stack([theta1, 2 * theta1], axis=-1), "v": np.stack(rates, axis=-1)}


class Wobbling(Newton):
    """Beside the hip, a mass on a rail that stays horizontal."""

    def upper_body(self):
        rail = self.rest
        rail.position[:, 0] = self.q[:, 2]
        rail.jacobian[:, 0, 2] = 1
        alpha = self.par["alpha"]
        return [Body(1 - alpha, self.hip), Body(alpha, self.hip + rail)]

    def bias_forces(self):
        forces = super().bias_forces()
        spring = 0 * forces["h"]
        spring[:, 2] = self.par["k"] * self.q[:, 2]
        damping = 0 * forces["h"]
        damping[:, 2] = self.par["c"] * self.v[:, 2]
        return {**forces, "v_spring": spring, "damping": damping}

    def potential_energy(self):
        spring = self.par["k"] * self.q[:, 2] ** 2 / 2
        return {"potential": super().potential_energy()["potential"] + spring}

    def guide(self):
        """What keeps the rail horizontal carries the load of the mass on it."""
        load, acceleration = self.bodies[1], self.state_derivative()["dv"]
        push = times(load.point.jacobian, acceleration) + load.point.acceleration - self.gravity
        return load.mass * self.q[:, 2] * push[:, 1]

    def lines(self):
        return {**super().lines(), "spring": [body.point for body in self.bodies[:2]]}

    def spring_mode(self):
        k, alpha = self.par["k"], self.par["alpha"]
        return {"frequency": self.xp.sqrt(k / (alpha * (1 - alpha)))}

    def section_state(self):
        theta1, dtheta1, dtheta2, x, dx = self.values["z"].T
        q, v = [theta1, 2 * theta1, x], [dtheta1, dtheta2, dx]
        return {"q": np.stack(q, axis=-1), "v": np.stack(v, axis=-1)}


class Goswami(Newton):
    """Leg masses ``a = 1/(1 + beta)`` above the feet, ``b = beta/(1 + beta)`` below the hip."""

    def build(self):
        super().build()
        a = 1 / (1 + self.par["beta"])
        one = 1 + 0 * a
        self.bodies = [
            Body(self.par["mu"], self.hip),
            Body(one, self.hip * a),
            Body(one, self.hip + self.down * (1 - a)),
        ]


class Garcia(Newton):
    """The published equations of the simplest walker, J. Biomech. Eng. 120 (1998) 281-288.

    The swing leg hangs on a hip that takes no notice of it.
    """

    def build(self):
        self.par["beta"] = 0 * self.t
        super().build()

    def mass_matrix(self):
        """Row theta is the hip's law, row phi the swing foot's for a unit of its mass."""
        return {"M": self.by_rows(lambda p: transposed(p.jacobian) @ p.jacobian)}

    def bias_forces(self):
        return {
            "h": self.by_rows(lambda p: times(transposed(p.jacobian), p.acceleration)),
            "v_gravity": -self.by_rows(lambda p: times(transposed(p.jacobian), self.gravity)),
        }

    def by_rows(self, term):
        return np.stack([term(self.hip)[:, 0], term(self.foot)[:, 1]], axis=1)

    def state_derivative(self):
        theta, phi = self.q.T
        tilt, rate = theta - self.par["slope"], self.v[:, 0]
        ddtheta = self.xp.sin(tilt)
        ddphi = ddtheta + rate**2 * self.xp.sin(phi) - self.xp.cos(tilt) * self.xp.sin(phi)
        return {"dq": self.v, "dv": np.stack([ddtheta, ddphi], axis=-1)}

    def impact_map(self):
        """Published for ``phi = 2 theta``, where both feet are on the ground.

        The hip keeps its angular momentum about the new foot; of the old foot's velocity, which was zero, the
        part across its leg stays zero, since a leg without mass pulls along itself only.
        """
        along = self.xp.cos(self.q[:, 1])
        dtheta = along * self.v[:, 0]
        return {
            "q_plus": self.swapped(self.q),
            "v_plus": np.stack([dtheta, (1 - along) * dtheta], axis=-1),
        }

    def impact_impulse(self):
        """What it changes is the momentum of the hip, which then turns about the new foot."""
        after = self.impact_map()
        turning = self.leg(after["q_plus"][:, 0], after["v_plus"][:, 0], -1, {0: 1})
        return {"Lambda": times(turning.jacobian, after["v_plus"]) - self.velocity(self.hip)}

    def section_state(self):
        theta, dtheta = self.values["z"].T
        v = [dtheta, (1 - self.xp.cos(2 * theta)) * dtheta]
        return {"q": np.stack([theta, 2 * theta], axis=-1), "v": np.stack(v, axis=-1)}


class Wheel(Newton):
    """A hub on spokes, which turns with them; its angle leans ahead."""

    sense = -1

    def build(self):
        self.between = 2 * self.xp.pi / self.par["spokes"]
        theta, w = self.q[:, 0], self.v[:, 0]
        self.hip = self.leg(-theta, -w, -1, {0: -1})
        self.foot = self.hip + self.leg(self.between - theta, -w, 1, {0: -1})
        self.behind = self.hip + self.leg(-self.between - theta, -w, 1, {0: -1})
        one = 1 + 0 * self.t
        self.bodies = [Body(one, self.hip, one / self.par["lambda2"] - 1, np.stack([one], axis=-1))]

    def touchdown_condition(self):
        theta, w = self.q[:, 0], self.v[:, 0]
        h = self.xp.cos(self.between / 2) - self.xp.cos(theta)
        return {"h": h, "dh": self.xp.sin(theta) * w, "side": -theta}

    def swapped(self, vector):
        return vector

    def impact_map(self):
        return {**super().impact_map(), "q_plus": self.q - self.between[:, None]}

    def before_touchdown(self):
        return {"q_minus": self.q + self.between[:, None]}

    def step_length(self):
        """From the foot of the spoke behind to the stance foot."""
        return {"length": -self.behind.position[:, 0], "rise": -self.behind.position[:, 1]}

    def lines(self):
        return {"stance_spokes": [self.rest, self.hip, self.foot], "spoke_behind": [self.hip, self.behind]}

    def section_state(self):
        theta, dtheta = self.values["z"].T
        return {"q": theta[:, None], "v": dtheta[:, None]}


WALKERS = {
    "wobbling": Wobbling, "compass": Newton, "simplest_walker": Garcia, "goswami_compass": Goswami,
    "rimless_wheel": Wheel,
}  # fmt: skip


def by_hand(name, values, xp=np):
    """The hand-written walker at these states."""
    return WALKERS[name](name, values, xp)
