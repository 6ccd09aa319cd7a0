"""The two walkers stated a second time, by hand, and random states at which to compare with `generated/`.

Nothing here comes from `derive`: `Newton` holds positions, Jacobians and centripetal accelerations of the
point masses as one writes them down on paper, and adds up Newton's law over the masses. There is no
Lagrangian and no SymPy. It runs on arrays of floats and, for the truth, on arrays of 50-digit numbers.
"""

import os
import shutil
from functools import cache

import mpmath
import numpy as np
import pytest

from stridemap.solver.model import load

MODELS = ("wobbling", "compass")
COUNT = 1000

FIFTY = mpmath.mp.clone()  # a context of its own: other tests keep their precision
FIFTY.dps = 50


class MP:
    """A namespace like NumPy, for arrays of 50-digit numbers."""

    sin, cos, sqrt = (np.frompyfunc(f, 1, 1) for f in (FIFTY.sin, FIFTY.cos, FIFTY.sqrt))


exact = np.frompyfunc(FIFTY.mpf, 1, 1)
"""Floats as 50-digit numbers of the same value."""

RANGES = {
    "k": (0, 60), "alpha": (0.02, 0.98), "omega": (0.5, 6), "beta": (0.02, 2), "Kp": (0, 30), "Kd": (0, 3),
    "S": (-0.5, 0.5), "gamma": (-0.5, 0.5), "theta1": (-1.2, 1.2), "theta2": (-2.4, 2.4), "x": (-1, 1),
    "dtheta1": (-3, 3), "dtheta2": (-3, 3), "dx": (-3, 3),
}  # fmt: skip


def need(*commands):
    """The first of these commands that is on the path; without one the test is skipped, and fails in CI."""
    found = next((command for command in commands if shutil.which(command)), None)
    return found or lacking(f"there is no {' or '.join(commands)} on the path")


def lacking(reason):
    if os.environ.get("CI"):
        pytest.fail(f"{reason}, and CI must have it")
    pytest.skip(reason)


@cache
def states(name, count=COUNT, seed=7):
    """Random inputs of a model's functions: t (count,), and q, v, p, z with an axis more."""
    rng = np.random.default_rng(seed)
    model = load(name)

    def draw(names):
        return np.stack([rng.uniform(*RANGES[n], count) for n in names], axis=-1)

    return {
        "t": rng.uniform(0, 3, count),
        "q": draw(model.coordinates),
        "v": draw(["d" + c for c in model.coordinates]),
        "p": draw([a.name for a in model.parameters]),
        "z": draw(model.section),
    }


def on_section(name):
    """The random states with the swing foot on the ground, where impacts happen."""
    values = dict(states(name))
    values["q"] = values["q"].copy()
    values["q"][:, 1] = 2 * values["q"][:, 0]
    return values


def call(function, xp, values):
    """Call a namespace-neutral function on arrays; the results have the states on the first axis."""
    names = function.__code__.co_varnames[1 : function.__code__.co_argcount]
    result = function(xp, *[values[n] if n == "t" else list(values[n].T) for n in names])
    return {key: stacked(value, len(values["t"])) for key, value in result.items()}


def differences(function, values, output, which):
    """Derivative of `output` with respect to ``q`` or ``v`` by central differences at 50 digits.

    With steps of 1e-16 their error is about 1e-32.
    """
    columns = []
    for j in range(values[which].shape[1]):
        step = np.zeros(values[which].shape[1])
        step[j] = 1e-16
        moved = [{**values, which: values[which] + sign * step} for sign in (1, -1)]
        ahead, behind = (call(function, MP, m)[output] for m in moved)
        columns.append((ahead - behind) / FIFTY.mpf(2e-16))
    return np.stack(columns, axis=-1)


def stacked(value, count):
    if isinstance(value, list):
        return np.stack([stacked(v, count) for v in value], axis=1)
    return np.broadcast_to(np.asarray(value), (count,))


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


class Newton:
    """Every generated quantity, from Newton's law for the point masses.

    Methods are named as the generated functions and return a dict of outputs, as those do. Jacobians are
    missing: their truth are differences at 50 digits (`differences`).
    """

    def __init__(self, name, values, xp=np):
        self.name, self.values, self.xp = name, values, xp
        self.t, self.q, self.v = values["t"], values["q"], values["v"]
        self.n = self.q.shape[1]
        self.par = dict(zip([a.name for a in load(name).parameters], values["p"].T, strict=True))
        self.count = len(self.t)
        theta1, theta2 = self.q.T[:2]
        w1, w2 = self.v.T[:2]
        hip = self._leg(theta1, w1, -1, {0: 1})
        foot = self._leg(theta1 - theta2, w1 - w2, 1, {0: 1, 1: -1})
        self.foot = [a + b for a, b in zip(hip, foot, strict=True)]
        beta = self.par["beta"]
        rest = [0 * part for part in hip]
        self.masses = [(beta, rest), (beta, self.foot)]
        if name == "wobbling":
            alpha = self.par["alpha"]
            rail = [part.copy() for part in rest]
            rail[0][:, 0] = self.q[:, 2]
            rail[1][:, 0, 2] = 1
            wobbler = [a + b for a, b in zip(hip, rail, strict=True)]
            self.masses += [(1 - alpha, hip), (alpha, wobbler)]
        else:
            self.masses += [(1 + 0 * beta, hip)]

    def _leg(self, angle, rate, sign, jacobian):
        """The vector ``sign (sin angle, -cos angle)``: itself, Jacobian, acceleration at constant rates."""
        s, c = self.xp.sin(angle), self.xp.cos(angle)
        along = np.stack([s, -c], axis=-1)
        across = np.stack([c, s], axis=-1)
        columns = [sign * jacobian.get(j, 0) * across for j in range(self.n)]
        return [sign * along, np.stack(columns, axis=-1), -sign * along * (rate * rate)[:, None]]

    def _sum(self, term):
        """Sum of ``mass * term(point)`` over the masses."""
        parts = [(m, term(point)) for m, point in self.masses]
        return sum(m.reshape(-1, *[1] * (x.ndim - 1)) * x for m, x in parts)

    # -- swing phase -----------------------------------------------------------------------------------------

    def mass_matrix(self):
        return {"M": self._sum(lambda point: np.matmul(point[1].transpose(0, 2, 1), point[1]))}

    def bias_forces(self):
        up = np.array([0, 1])
        forces = {
            "h": self._sum(lambda point: times(point[1].transpose(0, 2, 1), point[2])),
            "v_gravity": self._sum(lambda point: times(point[1].transpose(0, 2, 1), up + 0 * point[2])),
        }
        if self.name == "wobbling":
            forces["v_spring"] = 0 * forces["h"]
            forces["v_spring"][:, 2] = self.par["k"] * self.q[:, 2]
        return forces

    def controller_torque(self):
        a = self.par
        phase = a["omega"] * self.t
        target = a["gamma"] * (1 + self.xp.cos(phase)) - a["S"]
        target_rate = -a["gamma"] * a["omega"] * self.xp.sin(phase)
        return {"u": -a["Kp"] * (self.q[:, 1] - target) - a["Kd"] * (self.v[:, 1] - target_rate)}

    def state_derivative(self):
        force = -sum(self.bias_forces().values())
        force[:, 1] = force[:, 1] + self.controller_torque()["u"]
        return {"dq": self.v, "dv": solve(self.mass_matrix()["M"], force)}

    # -- touchdown and impact --------------------------------------------------------------------------------

    def touchdown_condition(self):
        (theta1, theta2), (w1, w2) = self.q.T[:2], self.v.T[:2]
        return {"h": theta2 - 2 * theta1, "dh": w2 - 2 * w1, "side": theta1}

    def released(self):
        """The impact as it is stated: ``Me (v+ - v-) = J^T Lambda, J v+ = 0`` for all n + 4 unknowns."""
        stance = np.broadcast_to(np.eye(2, dtype=int), (self.count, 2, 2))
        size = self.n + 2
        jacobian = np.concatenate([stance, self.foot[1]], axis=-1)

        def floating(point):
            wide = np.concatenate([stance, point[1]], axis=-1)
            return np.matmul(wide.transpose(0, 2, 1), wide)

        inertia = self._sum(floating)
        matrix = np.zeros((self.count, size + 2, size + 2), dtype=inertia.dtype)
        matrix[:, :size, :size] = inertia
        matrix[:, :size, size:] = -jacobian.transpose(0, 2, 1)
        matrix[:, size:, :size] = jacobian
        before = np.concatenate([0 * self.v[:, :2], self.v], axis=-1)
        right = np.concatenate([times(inertia, before), 0 * before[:, :2]], axis=-1)
        solution = solve(matrix, right)
        return solution[:, 2:size], solution[:, size:]

    @staticmethod
    def _swapped(vector):
        """theta1 - theta2, -theta2 and the rest: the legs swap names."""
        return np.concatenate([vector[:, :1] - vector[:, 1:2], -vector[:, 1:2], vector[:, 2:]], axis=-1)

    def impact_map(self):
        return {"q_plus": self._swapped(self.q), "v_plus": self._swapped(self.released()[0])}

    def impact_impulse(self):
        return {"Lambda": self.released()[1]}

    # -- what is measured ------------------------------------------------------------------------------------

    def kinetic_energy(self):
        return {"kinetic": self._sum(lambda point: (times(point[1], self.v) ** 2).sum(axis=-1)) / 2}

    def potential_energy(self):
        spring = self.par["k"] * self.q[:, 2] ** 2 / 2 if self.name == "wobbling" else 0
        return {"potential": self._sum(lambda point: point[0][:, 1]) + spring}

    def total_mass(self):
        return {"mass": sum(m for m, _ in self.masses)}

    def centre_of_mass(self):
        mass = self.total_mass()["mass"][:, None]
        velocity = self._sum(lambda point: times(point[1], self.v))
        return {"com": self._sum(lambda point: point[0]) / mass, "dcom": velocity / mass}

    def ground_force(self):
        acceleration = self.state_derivative()["dv"]
        weight = np.array([0, 1])
        return {"force": self._sum(lambda point: times(point[1], acceleration) + point[2] + weight)}

    def zmp(self):
        x_g, y_g = self.centre_of_mass()["com"].T
        ddx_g, up = (self.ground_force()["force"] / self.total_mass()["mass"][:, None]).T
        point = x_g - ddx_g / up * y_g  # up is 1 + ddy_g
        return {"zmp": point, "d": -point}

    def swing_foot(self):
        return {"foot": self.foot[0], "dfoot": times(self.foot[1], self.v)}

    def drawing(self):
        feet, upper = self.masses[:2], self.masses[2:]
        bodies = [*upper, *feet]
        hip, lines = upper[0][1][0], {}
        lines["legs"] = np.stack([0 * hip, hip, self.foot[0]], axis=1)
        if self.name == "wobbling":
            lines["spring"] = np.stack([point[0] for _, point in upper], axis=1)
        masses = np.stack([m for m, _ in bodies], axis=-1)
        return {"positions": np.stack([p[0] for _, p in bodies], axis=1), "masses": masses, **lines}

    def spring_mode(self):
        k, alpha = self.par["k"], self.par["alpha"]
        return {"frequency": self.xp.sqrt(k / (alpha * (1 - alpha)))}

    def section_state(self):
        z = self.values["z"].T
        wobbling = self.name == "wobbling"
        q = [z[0], 2 * z[0], z[3]] if wobbling else [z[0], 2 * z[0]]
        v = [z[1], z[2], z[4]] if wobbling else [z[1], z[2]]
        return {"q": np.stack(q, axis=-1), "v": np.stack(v, axis=-1)}


class Rounded:
    """A float with a bound of its rounding error (running error analysis), over arrays of states.

    A generated function called with these gives, with every result, how far it may be from the truth.
    """

    UNIT = 2.0**-53

    def __init__(self, value, error=0.0):
        self.value, self.error = value, error

    @classmethod
    def _of(cls, x):
        return x if isinstance(x, cls) else cls(x)

    @classmethod
    def _rounded(cls, value, error):
        return cls(value, error + cls.UNIT * np.abs(value))

    def __add__(self, other):
        other = self._of(other)
        return self._rounded(self.value + other.value, self.error + other.error)

    def __sub__(self, other):
        return self + -self._of(other)

    def __rsub__(self, other):
        return -self + other

    def __neg__(self):
        return Rounded(-self.value, self.error)

    def __mul__(self, other):
        other = self._of(other)
        error = np.abs(self.value) * other.error + (np.abs(other.value) + other.error) * self.error
        return self._rounded(self.value * other.value, error)

    def __truediv__(self, other):
        other = self._of(other)
        value = self.value / other.value
        error = (self.error + np.abs(value) * other.error) / (np.abs(other.value) - other.error)
        return self._rounded(value, error)

    def __rtruediv__(self, other):
        return self._of(other) / self

    __radd__, __rmul__ = __add__, __mul__

    # NumPy's sine and cosine are good to 4 units in the last place.

    @classmethod
    def sin(cls, x):
        return cls(np.sin(x.value), x.error + 8 * cls.UNIT * np.abs(np.sin(x.value)))

    @classmethod
    def cos(cls, x):
        return cls(np.cos(x.value), x.error + 8 * cls.UNIT * np.abs(np.cos(x.value)))

    @classmethod
    def sqrt(cls, x):
        root = np.sqrt(x.value)
        return cls._rounded(root, x.error / root)


def error_bounds(function, values):
    """Bounds of the rounding errors of a generated function's results, shaped like these."""
    names = function.__code__.co_varnames[1 : function.__code__.co_argcount]
    arguments = [Rounded(values[n]) if n == "t" else [Rounded(x) for x in values[n].T] for n in names]

    def bound(value):
        if isinstance(value, list):
            return [bound(v) for v in value]
        return value.error + 0.0 if isinstance(value, Rounded) else 0.0

    return {k: stacked(bound(v), len(values["t"])) for k, v in function(Rounded, *arguments).items()}
