"""SI units: formulas, dimensions, round trips, and a walker in metres and kilograms written by hand."""

import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

import stridemap
from stridemap.quantities import QUANTITIES
from stridemap.solver.model.loading import available
from stridemap.units import KINDS, MEASURE_KINDS, STANDARD_GRAVITY

InputError = stridemap.InputError
ROBOT = stridemap.Units(leg_length=0.8, mass=40.0, gravity=9.81)

robots = st.builds(
    stridemap.Units,
    leg_length=st.floats(1e-4, 50),
    mass=st.floats(1e-7, 1e4),
    gravity=st.floats(1e-2, 300),
)
values = st.floats(-1e9, 1e9).filter(lambda x: x == 0 or abs(x) > 1e-9)
names = st.sampled_from(sorted(KINDS))

# What the SI unit of a quantity is in kg, m and s: from the SI Brochure (BIPM, 9th edition, tables 2 to 4).
SI_BASE = {
    "1": (0, 0, 0), "rad": (0, 0, 0), "kg": (1, 0, 0), "m": (0, 1, 0), "s": (0, 0, 1), "rad/s": (0, 0, -1),
    "m/s": (0, 1, -1), "m/s^2": (0, 1, -2), "N": (1, 1, -2), "N s": (1, 1, -1), "N/m": (1, 0, -2),
    "N s/m": (1, 0, -1), "N m": (1, 2, -2), "N m/rad": (1, 2, -2), "N m s/rad": (1, 2, -1),
    "kg m^2": (1, 2, 0), "J": (1, 2, -2), "W": (1, 2, -3),
}  # fmt: skip


# -- the units -----------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", KINDS)
def test_every_quantity_has_the_dimension_of_its_si_unit(name):
    """Units of another size change the number of every quantity by the powers of its SI unit."""
    kilogram, metre, second = SI_BASE[KINDS[name][1]]
    one = stridemap.Units(leg_length=1, mass=1, gravity=1)
    # 1 m = 4 of the new unit of length, 1 s = 2 of the new unit of time: L is 4, g = 1 m/s^2 is 4/2^2 = 1.
    smaller = stridemap.Units(leg_length=4, mass=8, gravity=1)
    assert one.unit(name) == 1
    assert smaller.unit(name) == float(Fraction(8) ** kilogram * Fraction(4) ** metre * Fraction(2) ** second)
    faster = stridemap.Units(leg_length=1, mass=1, gravity=Fraction(1, 16).__float__())
    assert faster.unit(name) == float(Fraction(4) ** second)


@pytest.mark.parametrize(
    ("name", "unit"),
    [
        ("stiffness", 40 * 9.81 / 0.8),
        ("time", math.sqrt(0.8 / 9.81)),
        ("angular frequency", math.sqrt(9.81 / 0.8)),
        ("speed", math.sqrt(9.81 * 0.8)),
        ("torque", 40 * 9.81 * 0.8),
        ("rotational damping", 40 * 9.81 * 0.8 * math.sqrt(0.8 / 9.81)),
        ("force", 40 * 9.81),
        ("energy", 40 * 9.81 * 0.8),
        ("power", 40 * 9.81 * 0.8 / math.sqrt(0.8 / 9.81)),
        ("length", 0.8),
        ("mass", 40),
    ],
)
def test_formulas(name, unit):
    assert ROBOT.unit(name) == pytest.approx(unit, rel=1e-15)


@given(robots)
def test_units_belong_together(robot):
    """Laws of mechanics hold between the units, so they hold between converted numbers."""
    u = robot.unit
    for one, other in [
        (u("force"), u("mass") * u("acceleration")),
        (u("torque"), u("force") * u("length")),
        (u("energy"), u("mass") * u("speed") ** 2),
        (u("power"), u("force") * u("speed")),
        (u("impulse"), u("force") * u("time")),
        (u("speed"), u("length") / u("time")),
        (u("angular frequency"), 1 / u("time")),
        (u("stiffness"), u("mass") * u("angular frequency") ** 2),
        (u("damping"), u("stiffness") * u("time")),
        (u("rotational damping"), u("rotational stiffness") * u("time")),
        (u("torque"), u("moment of inertia") * u("angular frequency") ** 2),
    ]:
        assert one == pytest.approx(other, rel=2e-15)


@pytest.mark.parametrize("model", available())
def test_every_unit_of_a_model_can_be_converted(model):
    spec = stridemap.load(model).spec
    written = {entry.unit for argument in "tqvpz" for entry in spec.entries(argument)}
    assert written
    assert all(ROBOT.unit(unit) > 0 for unit in written)


def test_every_measured_quantity_is_of_a_known_kind():
    assert {quantity.kind for quantity in QUANTITIES.values()} <= set(KINDS)
    assert MEASURE_KINDS["work"] == "energy"
    assert "peaks" not in MEASURE_KINDS


@pytest.mark.parametrize(("old", "new"), [("QUANTITIES", "KINDS"), ("MEASURES", "MEASURE_KINDS")])
def test_former_names_say_what_they_are_called_now(old, new):
    with pytest.raises(InputError, match=f"stridemap.units.{old} is called stridemap.units.{new} now"):
        getattr(stridemap.units, old)
    with pytest.raises(AttributeError, match="has no attribute 'KIND'"):
        stridemap.units.KIND  # noqa: B018


# -- there and back ------------------------------------------------------------------------------------------


@given(robots, names, values)
def test_round_trip(robot, name, value):
    """Two roundings: at most one unit in the last place away."""
    for way in (
        lambda x: robot.from_si(robot.to_si(x, name), name),
        lambda x: robot.to_si(robot.from_si(x, name), name),
    ):
        back = way(value)
        assert isinstance(back, float)
        assert abs(back - value) <= math.ulp(value)


@given(st.floats(1e-4, 50), names, values, st.integers(-8, 8))
def test_round_trip_is_exact_where_the_unit_is_a_power_of_two(length, name, value, power):
    robot = stridemap.Units(leg_length=4, mass=2.0**power, gravity=1)
    assert robot.from_si(robot.to_si(value, name), name) == value


def test_arrays_and_numbers_of_any_kind():
    times = ROBOT.to_si([0, 1, 2], "time")
    assert times.tolist() == [ROBOT.to_si(t, "time") for t in (0, 1, 2)]
    assert ROBOT.from_si(times, "time") == pytest.approx([0, 1, 2])
    assert ROBOT.to_si(np.float32(2), "mass") == 80
    assert ROBOT.to_si(np.arange(6).reshape(2, 3), "length").shape == (2, 3)


def test_total_mass():
    robot = stridemap.Units.from_total_mass(0.8, 52, 0.15, 9.81)
    assert robot.mass == pytest.approx(40, rel=1e-15)
    total = float(stridemap.load("wobbling").total_mass(p=stridemap.load("wobbling").point({}))["mass"])
    assert robot.to_si(total, "mass") == pytest.approx(52, rel=1e-15)
    assert stridemap.Units.from_total_mass(0.8, 40, 0).mass == 40
    assert stridemap.Units(0.8, 40).gravity == STANDARD_GRAVITY == 9.80665


@given(robots)
def test_parameters_there_and_back(robot):
    model = stridemap.load("wobbling")
    si = robot.parameters_si("wobbling", model.preset)
    assert robot.parameters("wobbling", **si) == pytest.approx(model.preset, rel=1e-15)
    assert si["alpha"] == 0.25
    assert (si["S"], si["gamma"]) == (0.18, 0.18)


# -- refusals ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        ({"leg_length": 0.0}, r"leg_length = 0 m is outside .* give it in m"),
        ({"leg_length": -0.8}, "leg_length = -0.8 m is outside"),
        (
            {"leg_length": 800},
            r"leg_length = 800 m is outside the allowed range \(0.0001 to 50 m\); give it in m",
        ),
        ({"mass": 40_000}, "mass = 40000 kg is outside"),
        ({"mass": 0}, "mass = 0 kg is outside"),
        ({"mass": float("nan")}, "mass = nan is not a finite number"),
        ({"mass": float("inf")}, "mass = inf is not a finite number"),
        ({"mass": "40 kg"}, "mass = '40 kg' is not a number"),
        ({"mass": True}, "mass = True is not a number"),
        ({"mass": None}, "mass = None is not a number"),
        ({"gravity": -9.81}, "gravity = -9.81 m/s"),
        ({"gravity": 0}, "gravity = 0 m/s"),
    ],
)
def test_sizes_that_no_robot_has(arguments, sentence):
    with pytest.raises(InputError, match=sentence):
        stridemap.Units(**{"leg_length": 0.8, "mass": 40.0, **arguments})


@pytest.mark.parametrize(
    ("total", "beta", "sentence"),
    [
        (-1, 0.15, "total_mass = -1 kg is outside"),
        (52, -0.1, "beta = -0.1 is not allowed"),
        (52, float("nan"), "beta = nan is not a finite number"),
        ("52", 0.15, "total_mass = '52' is not a number"),
    ],
)
def test_bad_total_mass(total, beta, sentence):
    with pytest.raises(InputError, match=sentence):
        stridemap.Units.from_total_mass(0.8, total, beta)


@pytest.mark.parametrize(
    "unit",
    ["sprng", "", "N/m", "M g +", "M + g", "M g / K", "2 M", "M^x", "M**10", "sqrt(M, g)", "sqrt()", "M; L",
     "__import__('os')", "M.real", "(lambda: 1)()", "True", "1.0", 3, None, ["M"], "(" * 500, "\0"],
)  # fmt: skip
def test_what_is_no_unit(unit):
    with pytest.raises(InputError, match="is neither a quantity"):
        ROBOT.to_si(1.0, unit)


def test_a_misspelt_quantity_is_recognised():
    with pytest.raises(InputError, match="did you mean 'stiffness'"):
        ROBOT.from_si(2943, "stifness")


@pytest.mark.parametrize(
    "value", [float("nan"), float("inf"), "6", None, True, 1j, [1, float("nan")], ["6"], [[1], [1j]]]
)
@pytest.mark.parametrize("way", [ROBOT.to_si, ROBOT.from_si])
def test_what_is_no_number(way, value):
    with pytest.raises(InputError, match="stiffness"):
        way(value, "stiffness")


@pytest.mark.parametrize(
    ("way", "params", "sentence"),
    [
        (ROBOT.parameters, {"kk": 3.0}, "no parameter 'kk'"),
        (ROBOT.parameters, {"k": "3000 N/m"}, "k = '3000 N/m' is not a number"),
        (ROBOT.parameters, {"alpha": 1.5}, "alpha = 1.5 is outside"),
        (lambda model, **p: ROBOT.parameters_si(model, p), {"kk": 3.0}, "no parameter 'kk'"),
        (lambda model, **p: ROBOT.parameters_si(model, p), {"k": "6"}, "k = '6' is not a number"),
    ],
)
def test_bad_parameters(way, params, sentence):
    with pytest.raises(InputError, match=sentence):
        way("wobbling", **params)
    with pytest.raises(InputError, match="there is no model"):
        way("wobling", **params)


def test_a_record_is_frozen_and_a_value():
    with pytest.raises(AttributeError):
        ROBOT.mass = 50.0
    assert stridemap.Units(0.8, 40, 9.81) == ROBOT
    assert len({ROBOT, stridemap.Units(0.8, 40, 9.81)}) == 1


# -- a walker in metres, kilograms and seconds, by Newton's law ----------------------------------------------


class Robot:
    """The walker with a wobbling mass as somebody with a scale and a ruler writes it down.

    Point masses in kg, a leg in m, a spring in N/m, g in m/s^2. Positions are from the stance foot, which is
    given two coordinates of its own (the first two rows) for the impact.
    """

    def __init__(self, leg, hip, wobbler, foot, spring, Kp, Kd, omega, S, gamma, g):
        self.__dict__.update(locals())
        self.masses = np.array([foot, hip, wobbler, foot])

    def points(self, q, v):
        """Positions (4, 2), Jacobians (4, 2, 5) and accelerations at constant rates (4, 2)."""
        a, b, x = q[0], q[0] - q[1], q[2]
        da, db = v[0], v[0] - v[1]
        up = self.leg * np.array([-np.sin(a), np.cos(a)])
        d_up = self.leg * np.array([-np.cos(a), -np.sin(a)])
        down = self.leg * np.array([np.sin(b), -np.cos(b)])
        d_down = self.leg * np.array([np.cos(b), np.sin(b)])
        zero = np.zeros(2)
        where = np.array([zero, up, up + np.array([x, 0]), up + down])
        J = np.zeros((4, 2, 5))
        J[:, 0, 0] = J[:, 1, 1] = 1
        J[1:, :, 2] = d_up
        J[2, 0, 4] = 1
        J[3, :, 2] += d_down
        J[3, :, 3] = -d_down
        bend = np.array([zero, -up * da**2, -up * da**2, -up * da**2 - down * db**2])
        return where, J, bend

    def torque(self, t, q, v):
        target = self.gamma * (1 + np.cos(self.omega * t)) - self.S
        rate = -self.gamma * self.omega * np.sin(self.omega * t)
        return -self.Kp * (q[1] - target) - self.Kd * (v[1] - rate)

    def mass_matrix(self, J):
        return np.einsum("i,ika,ikb->ab", self.masses, J, J)

    def accelerations(self, t, q, v):
        """Angular and linear accelerations, and those of the four masses."""
        _, J, bend = self.points(q, v)
        pull = np.array([0, -self.g]) - bend
        force = np.einsum("i,ika,ik->a", self.masses, J, pull)[2:]
        force += [0, self.torque(t, q, v), -self.spring * q[2]]
        rates = np.linalg.solve(self.mass_matrix(J)[2:, 2:], force)
        return rates, np.einsum("ika,a->ik", J[:, :, 2:], rates) + bend

    def ground(self, t, q, v):
        """Ground force in N, and the distance from the zero moment point to the stance foot in m."""
        where, _, _ = self.points(q, v)
        _, a = self.accelerations(t, q, v)
        weight = a + np.array([0, self.g])
        share = self.masses / self.masses.sum()
        centre, acceleration = share @ where, share @ a
        zmp = centre[0] - acceleration[0] * centre[1] / (self.g + acceleration[1])
        return self.masses @ weight, -zmp

    def impact(self, q, v):
        """Rates after the swing foot stops and the legs swap names."""
        _, J, _ = self.points(q, v)
        M, foot = self.mass_matrix(J), J[3]
        system = np.block([[M, -foot.T], [foot, np.zeros((2, 2))]])
        after = np.linalg.solve(system, np.concatenate([M @ [0, 0, *v], [0, 0]]))[2:5]
        return np.array([after[0] - after[1], -after[1], after[2]])

    def step(self, q, v):
        """One step by SciPy's DOP853 with the touchdown as an event, and the work of the hip's motor."""

        def rate(t, y):
            power = self.torque(t, y[:3], y[3:6]) * y[4]
            return [*y[3:6], *self.accelerations(t, y[:3], y[3:6])[0], abs(power), max(power, 0), power]

        def touchdown(t, y):
            return y[1] - 2 * y[0] if t > 0.01 and y[0] < 0 else -1.0

        touchdown.terminal, touchdown.direction = True, 1
        done = solve_ivp(
            rate, (0, 5), [*q, *v, 0, 0, 0], "DOP853",
            events=touchdown, dense_output=True, rtol=1e-12, atol=1e-14, max_step=0.02,
        )  # fmt: skip
        period = done.t_events[0][0]
        t = np.linspace(0, period, 5001)
        return t, done.sol(t)[:6].T, period, done.y_events[0][0]


def test_a_robot_in_si_units_walks_the_converted_cycle():
    """A robot of 52 kg on Mars and a small one on Earth, integrated in SI units: all measures agree."""
    for units, k in [
        (stridemap.Units(leg_length=0.8, mass=40.0, gravity=3.72), 6.0),
        (stridemap.Units(leg_length=0.25, mass=1.7), 22.5),
    ]:
        orbits = stridemap.find_orbits("wobbling", k=k, alpha=0.25, omega=3)
        orbit = min(orbits, key=lambda o: o.spectral_radius)
        si = units.parameters_si("wobbling", orbit.params)
        hip, wobbler = 0.75 * units.mass, 0.25 * units.mass
        robot = Robot(
            units.leg_length, hip, wobbler, si["beta"], si["k"], si["Kp"], si["Kd"], si["omega"], si["S"],
            si["gamma"], units.gravity,
        )  # fmt: skip
        start = orbit.state
        q = np.array([start["theta1"], 2 * start["theta1"], units.to_si(start["x"], "length")])
        v = np.array([
            units.to_si(start["dtheta1"], "angular frequency"),
            units.to_si(start["dtheta2"], "angular frequency"),
            units.to_si(start["dx"], "speed"),
        ])  # fmt: skip
        t, y, period, end = robot.step(q, v)
        measured = units.measures(orbit)
        assert set(measured) == {name for name in QUANTITIES if isinstance(getattr(orbit, name, None), float)}
        assert period == pytest.approx(measured["period"], rel=1e-9)
        after = robot.impact(end[:3], end[3:6])
        assert after == pytest.approx(v, rel=1e-7, abs=1e-8)
        assert end[2] == pytest.approx(q[2], rel=1e-7)
        step_length = units.leg_length * (math.sin(end[0] - end[1]) - math.sin(end[0]))
        assert step_length == pytest.approx(measured["step_length"], rel=1e-9)
        assert step_length / period == pytest.approx(measured["speed"], rel=1e-9)
        for work, name in zip(end[6:], ("work", "work_positive", "work_net"), strict=True):
            assert work == pytest.approx(measured[name], rel=1e-6)
        weight = robot.masses.sum() * units.gravity
        assert end[6] / (weight * step_length) == pytest.approx(measured["cot"], rel=1e-6)
        assert end[6] / (weight * measured["speed"]) == pytest.approx(measured["cot_per_speed"], rel=1e-6)
        # Between 5,001 samples an extreme is missed by less than the square of their distance.
        ground = [robot.ground(at, z[:3], z[3:]) for at, z in zip(t, y, strict=True)]
        force, d = np.array([f for f, _ in ground]), np.array([d for _, d in ground])
        foot = min(robot.points(z[:3], z[3:])[0][3, 1] for z in y)
        for value, name in [
            (force[:, 1].min(), "min_vertical_force"),
            (np.abs(force[:, 0] / force[:, 1]).max(), "friction"),
            (np.abs(d).max(), "d_max"),
            (foot, "clearance"),
        ]:
            assert value == pytest.approx(measured[name], rel=1e-6, abs=1e-8), name
