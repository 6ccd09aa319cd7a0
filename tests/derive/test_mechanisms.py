"""Rolling feet, dampers, latches, clocks and several motors: Newton's law on the declared positions.

Positions are taken from the declaration, and everything else from Newton and d'Alembert: accelerations of the
bodies are second differences of their positions along the motion, at 50 digits. There is no Lagrangian.
"""

import mpmath
import numpy as np
import pytest
import sympy as sp

from stridemap import motion
from stridemap.derive import STANCE_FOOT
from stridemap.solver.model.loading import load
from tests.oracles.walkers import cycles, derived, walker

MP = mpmath.mp
STEP = MP.mpf("1e-15")
NAMES = ("damped", "rolling", "two_motors", "latched")


@pytest.fixture(autouse=True)
def fifty_digits():
    with MP.workdps(50):
        yield


def at_rest_in(w, point):
    """A point with the stance foot where the declaration holds it."""
    return sp.Matrix(point).subs(dict(zip(STANCE_FOOT, w.stance, strict=True)))


class Declared:
    """The declared positions as functions of 50-digit coordinates."""

    def __init__(self, name, params):
        self.w = w = walker(name)
        self.model = derived(name)
        self.values = {a.symbol: sp.Rational(str(params.get(a.name, a.default))) for a in w.parameters}
        self.p = np.array([float(self.values[a.symbol]) for a in w.parameters])
        q, v = list(w.q), list(w.v)
        self.bodies = [self._function(q, at_rest_in(w, b.position)) for b in w.bodies]
        self.masses = [MP.mpf(sp.sympify(b.mass).subs(self.values).evalf(50)) for b in w.bodies]
        self.gravity = MP.matrix([MP.mpf(g) for g in w.gravity.subs(self.values).evalf(50)])
        self.potential = self._function(q, sp.Matrix([sum(w.potentials.values(), sp.S.Zero)]))
        self.damping = self._function([*q, *v], sp.Matrix([w.dissipation]).jacobian(v).T)
        time = sp.Symbol("t", real=True)
        torques = [w.torques.get(c, sp.S.Zero) for c in w.coordinates]
        self.torques = self._function([time, *q, *v], sp.Matrix(torques))

    def _function(self, arguments, matrix):
        return sp.lambdify(arguments, matrix.subs(self.values), "mpmath")

    def velocity(self, body, q, v):
        ahead, behind = (body(*[a + s * STEP * b for a, b in zip(q, v, strict=True)]) for s in (1, -1))
        return (ahead - behind) / (2 * STEP)

    def acceleration(self, body, q, v, a):
        def place(t):
            return body(*[x + t * y + t * t * z / 2 for x, y, z in zip(q, v, a, strict=True)])

        return (place(STEP) - 2 * place(0) + place(-STEP)) / STEP**2

    def derivative(self, function, q, j):
        ahead, behind = ([x + s * STEP * (i == j) for i, x in enumerate(q)] for s in (1, -1))
        return (function(*ahead) - function(*behind)) / (2 * STEP)


def states(model, count=40):
    rng = np.random.default_rng(3)
    n = len(model.coordinates)
    return rng.uniform(-0.4, 0.4, (count, n)), rng.uniform(-1, 1, (count, n)), rng.uniform(0, 2, count)


def exact(values):
    return [MP.mpf(float(x)) for x in values]


@pytest.mark.parametrize("name", NAMES)
def test_equation_of_motion_and_ground_force(name):
    declared = Declared(name, {})
    model, p = declared.model, declared.p
    for q, v, t in zip(*states(model), strict=True):
        a = model.evaluate("state_derivative", t=t, q=q, v=v, p=p)["dv"]
        force = model.evaluate("ground_force", t=t, q=q, v=v, p=p)["force"]
        q_, v_, a_ = exact(q), exact(v), exact(a)
        pushes = [
            m * (declared.acceleration(body, q_, v_, a_) - declared.gravity)
            for m, body in zip(declared.masses, declared.bodies, strict=True)
        ]
        total = sum(pushes[1:], pushes[0])
        assert np.abs([float(total[i]) - force[i] for i in range(2)]).max() < 1e-12
        torques, damping = declared.torques(float(t), *q_, *v_), declared.damping(*q_, *v_)
        for j in range(len(q)):
            virtual = sum(
                (push.T * declared.derivative(body, q_, j))[0]
                for push, body in zip(pushes, declared.bodies, strict=True)
            )
            rest = virtual + declared.derivative(declared.potential, q_, j)[0] + damping[j] - torques[j]
            assert abs(rest) < 1e-12


def test_rolling_impact_keeps_the_angular_momenta():
    # Of the whole about the new contact, where the ground pushes; and of the leg behind about the hip.
    declared = Declared("rolling", {"radius": 0.3})
    w, model, p = declared.w, declared.model, declared.p
    renamed = {"hip": "hip", "stance foot": "swing foot", "swing foot": "stance foot"}
    place = {b.name: f for b, f in zip(w.bodies, declared.bodies, strict=True)}
    mass = {b.name: m for b, m in zip(w.bodies, declared.masses, strict=True)}
    stance_x = sp.lambdify(list(w.q), w.stance[0].subs(declared.values), "mpmath")

    def moment(arm, velocity):
        return arm[0] * velocity[1] - arm[1] * velocity[0]

    for angle, v in zip(np.linspace(-0.3, -0.05, 9), states(model, 9)[1], strict=True):
        q = np.array([angle, 2 * angle])
        after = model.evaluate("impact_map", q=q, v=v, p=p)
        q_, v_ = exact(q), exact(v)
        q2, v2 = exact(after["q_plus"]), exact(after["v_plus"])
        contact = MP.matrix([stance_x(*q2), 0])
        hip, whole, behind = place["hip"](*q2), MP.mpf(0), MP.mpf(0)
        for old, new in renamed.items():
            arm = place[new](*q2)
            change = declared.velocity(place[new], q2, v2) - declared.velocity(place[old], q_, v_)
            whole += mass[old] * moment(arm - contact, change)
            if old == "stance foot":
                behind += mass[old] * moment(arm - hip, change)
        assert abs(whole) < 1e-14
        assert abs(behind) < 1e-14
        # The new foot rolls: its lowest point is at rest, and its centre moves with the leg.
        assert np.isfinite(after["v_plus"]).all()


def test_feet_as_long_as_the_leg_lose_nothing():
    # T. McGeer's synthetic wheel (Int. J. Robotics Research 9 (1990) 62-82): arcs of the leg's length roll
    # on without an impact.
    model = derived("rolling")
    p = model.point({"radius": 1 - 1e-9, "beta": 1e-9, "Kp": 0, "Kd": 0})
    q, v = np.array([-0.2, -0.4]), np.array([-0.5, 0.0])
    after = model.evaluate("impact_map", q=q, v=v, p=p)
    before = model.evaluate("kinetic_energy", q=q, v=v, p=p)["kinetic"]
    then = model.evaluate("kinetic_energy", q=after["q_plus"], v=after["v_plus"], p=p)["kinetic"]
    assert before > 0.1
    assert then == pytest.approx(before, rel=1e-7)


@pytest.mark.usefixtures("uncompiled")
@pytest.mark.parametrize(
    ("name", "params"),
    [("damped", {"k": 6.0, "zeta": 0.3}), ("rolling", {"radius": 0.3}), ("two_motors", {"k": 7.0})],
)
def test_energy_is_balanced(name, params):
    # What the motors give is what dampers take and the impact loses.
    model, w = derived(name), walker(name)
    values = {a.symbol: params.get(a.name, a.default) for a in w.parameters}
    power = sp.lambdify([*w.q, *w.v], (2 * w.dissipation).subs(values), "numpy")
    found = [o for o in cycles(model, **params) if o.min_vertical_force > 0]
    assert found
    for orbit in found:
        seen, p = motion(orbit, 2001), model.point(orbit.params)
        kinetic = [
            model.evaluate("kinetic_energy", q=seen.q[i], v=seen.v[i], p=p)["kinetic"] for i in (-1, 0)
        ]
        taken = np.broadcast_to(power(*seen.q.T, *seen.v.T), seen.t.shape)
        h = seen.t[1]
        lost = h / 3 * (taken[0] + 4 * taken[1:-1:2].sum() + 2 * taken[2:-1:2].sum() + taken[-1])
        assert orbit.work_net == pytest.approx(lost + kinetic[0] - kinetic[1], abs=1e-10)
        assert orbit.work >= abs(orbit.work_net)
        one_by_one = seen.torque * np.stack([seen.coordinate("d" + c) for c in model.actuated], axis=-1)
        total = np.trapezoid(np.abs(one_by_one).sum(axis=-1), seen.t)
        assert orbit.work == pytest.approx(total, rel=1e-5)


def test_a_clock_that_is_not_reset_sets_the_pace():
    (orbit,) = cycles(derived("locked"), omega=5.0)
    assert orbit.stable
    assert orbit.period == pytest.approx(2 * np.pi / 5.0, abs=1e-11)
    assert 0 <= orbit.state["phase"] < 2 * np.pi
    section = np.array([[*orbit.state.values()]] * 3)
    section[:, -1] = [-1e-9, 2 * np.pi - 1e-9, 7.0]  # rounding at the seam makes no second cycle
    wrapped = derived("locked").wrapped(section)[:, -1]
    assert wrapped == pytest.approx([-1e-9, -1e-9, 7.0 - 2 * np.pi], abs=1e-12)
    assert len(orbit.multipliers) == 4
    assert min(abs(o.period - orbit.period) for o in cycles(load("compass"), omega=5.0)) > 1e-3
