"""Measures of limit cycles against the event-driven simulator, SciPy quadrature and brute-force sampling."""

from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import brentq, minimize_scalar

from stridemap import units
from stridemap.quantities import MEASURED, QUANTITIES, SOLVED
from stridemap.solver.observables import measures
from stridemap.solver.observables.measures import MEASURES, group_letter
from stridemap.solver.walks.simulator import swing
from tests.oracles.reference import LIFTING, POINTS, orbits_at, parameters, point_name, section_point

SAMPLES = 6001


class Motion:
    """One step of an orbit as the simulator sees it, and functions of time along it."""

    def __init__(self, orbit):
        self.orbit, self.model, self.p = orbit, orbit.model, parameters(orbit)
        self.n = len(self.model.coordinates)
        self.swing = swing(self.model, self.p, section_point(orbit))
        self.t = np.linspace(0, self.swing.duration, SAMPLES)

    def evaluate(self, function, output, t):
        y = self.swing(t)
        values = {"t": t, "q": y[..., : self.n], "v": y[..., self.n :], "p": self.p}
        return self.model.evaluate(function, **values)[output]

    def power(self, t):
        return self.evaluate("controller_torque", "u", t)[..., 0] * self.swing(t)[..., self.n + 1]

    def d(self, t):
        return np.abs(self.evaluate("zmp", "d", t))

    def vertical_force(self, t):
        return self.evaluate("ground_force", "force", t)[..., 1]

    def friction(self, t):
        force = self.evaluate("ground_force", "force", t)
        return np.abs(force[..., 0] / force[..., 1])

    def excursion(self, t):
        return np.abs(self.swing(t)[..., self.model.coordinates.index("x")])

    def foot_height(self, t):
        return self.evaluate("swing_foot", "foot", t)[..., 1]

    def largest(self, f, sign=1):
        """The maximum of f (of -f for `sign` -1) over continuous time."""
        values = sign * f(self.t)
        best = np.argmax(values)
        bounds = self.t[max(best - 1, 0)], self.t[min(best + 1, SAMPLES - 1)]
        inside = minimize_scalar(
            lambda t: -sign * f(t), bounds=bounds, method="bounded", options={"xatol": 1e-10}
        )
        return max(-inside.fun, values[best])


QUICK = (0, 1, 10, POINTS.index(("wobbling", LIFTING)), len(POINTS) - 1)
"""Two typical points, one with falling zeros between nodes, one where the foot is pulled, one compass."""


@pytest.fixture(
    scope="module",
    params=[pytest.param(i, marks=[pytest.mark.quick] * (i in QUICK)) for i in range(len(POINTS))],
    ids=[point_name(p) for p in POINTS],
)
def motions(request):
    """The orbits at a point, simulated."""
    return [Motion(orbit) for orbit in orbits_at(request.param)]


def test_extremes_agree_with_brute_force(motions):
    for m in motions:
        assert m.swing.duration == pytest.approx(m.orbit.period, abs=1e-10)
        lowest = -m.largest(m.vertical_force, sign=-1)
        assert m.orbit.min_vertical_force == pytest.approx(lowest, abs=1e-8)
        if lowest > 0:
            assert m.orbit.d_max == pytest.approx(m.largest(m.d), abs=1e-8)
            assert m.orbit.cop_max == 0.0  # point feet without a motor at the ankle
            assert m.orbit.friction == pytest.approx(m.largest(m.friction), abs=1e-8)
        else:
            assert np.isnan(m.orbit.d_max)
            assert np.isnan(m.orbit.cop_max)
            assert np.isnan(m.orbit.friction)
        assert m.orbit.clearance == pytest.approx(-m.largest(m.foot_height, sign=-1), abs=1e-8)


def test_peaks_and_crossings_agree_with_brute_force(motions):
    for m in motions:
        y = m.swing(m.t)
        rate = y[:, m.n]
        assert m.orbit.peaks == np.count_nonzero((rate[1:-1] > rate[:-2]) & (rate[1:-1] > rate[2:]))
        if "x" in m.model.coordinates:
            x = y[:, m.model.coordinates.index("x")]
            assert m.orbit.x_zero_crossings == np.count_nonzero((x[1:] < 0) != (x[:-1] < 0))
        else:
            assert m.orbit.x_zero_crossings is None


def test_work_agrees_with_quadrature(motions):
    for m in motions:
        power = m.power(m.t)
        change = np.flatnonzero((power[1:] < 0) != (power[:-1] < 0))
        kinks = [brentq(m.power, m.t[i], m.t[i + 1], xtol=1e-14) for i in change]
        ends = [0.0, *kinks, m.swing.duration]
        pieces = [quad(m.power, a, b, epsabs=1e-11, epsrel=1e-11)[0] for a, b in pairwise(ends)]
        assert m.orbit.work == pytest.approx(sum(map(abs, pieces)), abs=1e-8)
        assert m.orbit.work_positive == pytest.approx(sum(x for x in pieces if x > 0), abs=1e-8)
        assert m.orbit.work_net == pytest.approx(sum(pieces), abs=1e-8)


def test_wobble_amplitude_agrees_with_the_simulator(motions):
    for m in motions:
        if "x" in m.model.coordinates:
            largest = m.largest(m.excursion)
            assert m.orbit.wobble_amplitude == pytest.approx(largest, abs=1e-9)
            assert m.orbit.wobble_amplitude >= max(abs(m.orbit.state["x"]), m.excursion(m.t).max() - 1e-10)
        else:
            assert m.orbit.wobble_amplitude is None


def test_touchdown_speed_agrees_with_the_simulators_path_of_the_foot(motions):
    """By one-sided differences of the foot's position, up to where the simulator found the touchdown."""
    for m in motions:
        end, size = m.swing.duration, 1e-4
        feet = [m.evaluate("swing_foot", "foot", end - i * size) for i in range(5)]
        weights = np.array([25, -48, 36, -16, 3]) / (12 * size)  # of fourth order
        velocity = sum(w * foot for w, foot in zip(weights, feet, strict=True))
        assert m.orbit.touchdown_speed == pytest.approx(np.hypot(*velocity), rel=1e-6, abs=1e-7)
        assert m.orbit.touchdown_speed > 0


def test_length_speed_and_cost_follow_from_their_definitions(motions):
    for m in motions:
        length = m.evaluate("swing_foot", "foot", m.swing.duration)[0]
        weight = 1 + 2 * m.orbit.params["beta"]
        assert m.orbit.step_length == pytest.approx(length, abs=1e-9)
        assert m.orbit.step_length == pytest.approx(2 * np.sin(m.orbit.state["theta1"]), abs=1e-12)
        assert m.orbit.speed == pytest.approx(length / m.swing.duration, abs=1e-9)
        assert m.orbit.cot == pytest.approx(m.orbit.work / (weight * length), rel=1e-7)
        assert m.orbit.cot_per_speed == pytest.approx(m.orbit.work / (weight * m.orbit.speed), rel=1e-12)


def test_energy_balances(motions):
    """What the hip puts in is what the impact takes away, and the posture comes back."""
    for m in motions:
        n = m.n
        start, end = m.swing(0.0), m.swing.end
        kinetic = [
            m.model.evaluate("kinetic_energy", q=y[:n], v=y[n:], p=m.p)["kinetic"] for y in (start, end)
        ]
        potential = [m.model.evaluate("potential_energy", q=y[:n], p=m.p)["potential"] for y in (start, end)]
        # On the cycle the energy just after the impact is the energy at the start.
        limit = 1e-10 * max(1.0, m.orbit.spectral_radius)
        assert m.orbit.work_net == pytest.approx(kinetic[1] - kinetic[0], abs=limit)
        assert kinetic[1] > kinetic[0]
        assert potential[1] == pytest.approx(potential[0], abs=1e-10)


def test_groups_count_the_oscillations_of_the_spring(motions):
    for m in motions:
        if m.model.name == "compass":
            assert m.orbit.group is None
        else:
            k, alpha = m.orbit.params["k"], m.orbit.params["alpha"]
            turns = np.sqrt(k / (alpha * (1 - alpha))) * m.orbit.period / (2 * np.pi)
            assert m.orbit.group == "ABCDEFGHIJKLMNOP"[int(turns)]


@pytest.mark.quick
def test_letters_go_on_after_z():
    letters = [group_letter(i) for i in (0, 1, 25, 26, 27, 51, 52, 701, 702)]
    assert letters == ["A", "B", "Z", "AA", "AB", "AZ", "BA", "ZZ", "AAA"]


@pytest.mark.quick
def test_every_quantity_has_one_function_and_a_kind():
    assert list(MEASURES) != []
    assert set(MEASURES) == set(MEASURED) == set(QUANTITIES) - set(SOLVED)
    for name, function in MEASURES.items():
        assert function.__name__ == name
        assert getattr(measures, name) is function
        assert function.__doc__
    assert len(set(MEASURES.values())) == len(MEASURES)
    kinds = getattr(units, "KINDS", None) or units.QUANTITIES
    for quantity in QUANTITIES.values():
        assert quantity.kind in kinds, quantity.name
        assert quantity.label and quantity.definition.endswith("."), quantity.name
        assert quantity.type in ("float", "int", "bool", "str")


def test_the_orbits_checked_are_many_and_differ():
    orbits = [orbit for i in range(len(POINTS)) for orbit in orbits_at(i)]
    assert len(orbits) >= 24
    assert {o.stable for o in orbits} == {True, False}
    assert {"A", "B", "C"} <= {o.group for o in orbits}
    assert len({o.peaks for o in orbits}) >= 4
    assert min(o.min_vertical_force for o in orbits) < 0
    assert len({o.wobble_amplitude for o in orbits}) >= 20
