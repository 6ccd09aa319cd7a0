"""Limit cycles: the reference orbits, all cycles at a point, and how each failure is told."""

import copy
import dataclasses
import json
import math
import pickle

import casadi as ca
import numpy as np
import pytest

from stridemap.errors import InputError
from stridemap.solver.cycles.orbit import Orbit, Status
from stridemap.solver.cycles.search import SearchOptions, distinct, find_orbits, merge, offer
from stridemap.solver.kernels.step_map import StepMap
from stridemap.solver.model.loading import load
from stridemap.solver.walks.simulator import Outcome, swing, walk
from tests.oracles.reference import (
    POINTS,
    REFERENCE,
    TWO_CYCLES,
    TYPICAL,
    orbits_at,
    parameters,
    point_name,
    reference_name,
    section_point,
)


def find(name, **params):
    model = load(name)
    return find_orbits(model, model.point(params)[None])[0]


# -- what is found ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("entry", REFERENCE, ids=reference_name)
def test_reference_orbit_is_found(entry):
    found = find(entry["model"], **entry["params"])
    orbit = min(found, key=lambda o: abs(o.period - entry["period"]))
    assert orbit.period == pytest.approx(entry["period"], abs=1e-10)
    np.testing.assert_allclose(section_point(orbit), section_point(entry), rtol=0, atol=1e-10)
    expected = [complex(*pair) for pair in entry["multipliers"]]
    np.testing.assert_allclose(orbit.multipliers, expected, rtol=0, atol=1e-9)
    assert orbit.spectral_radius == pytest.approx(abs(expected[0]), abs=1e-9)
    assert orbit.stable == (abs(expected[0]) < 1)
    assert orbit.params == entry["params"]
    assert orbit.status is Status.CONVERGED
    assert orbit.residual < 1e-11
    assert orbit.integration_error < 1e-9


def test_both_cycles_of_one_point_are_found_in_order_of_period():
    expected = sorted(e["period"] for e in REFERENCE if TWO_CYCLES.items() <= e["params"].items())
    assert len(expected) == 2
    assert [o.period for o in find("wobbling", **TWO_CYCLES)] == pytest.approx(expected, abs=1e-10)


@pytest.mark.parametrize(
    ("params", "group", "peaks"), [*zip(TYPICAL, "ABC", (1, 2, 3), strict=True)], ids=["A", "B", "C"]
)
def test_typical_solution(params, group, peaks):
    (stable,) = [o for o in find("wobbling", **params) if o.stable]
    assert (stable.group, stable.peaks) == (group, peaks)


@pytest.mark.parametrize("index", range(len(POINTS)), ids=[point_name(p) for p in POINTS])
def test_orbits_are_distinct_ordered_and_one_multiplier_is_zero(index):
    orbits = orbits_at(index)
    assert all(np.diff([o.period for o in orbits]) > 0)
    for orbit in orbits:
        modulus = np.abs(orbit.multipliers)
        assert len(modulus) == len(load(orbit.model).section)
        assert all(np.diff(modulus) <= 0)
        assert modulus[-1] < 1e-12  # the swing foot's speed, lost at the impact
        assert modulus[-2] > 1e-9
        assert orbit.spectral_radius == modulus[0]
        assert orbit.stable == (modulus[0] < 1)


def test_search_is_reproducible_and_points_do_not_disturb_each_other():
    model = load("wobbling")
    points = np.array([model.point(p) for p in TYPICAL[:2]])
    together = find_orbits(model, points)
    assert together[0] == find_orbits(model, points[:1])[0]
    assert find_orbits(model, points) == together
    assert find_orbits(model, points[::-1]) == together[::-1]  # nor does the place in the batch matter


def test_no_points_have_no_orbits():
    model = load("wobbling")
    assert find_orbits(model, np.empty((0, len(model.parameters)))) == []
    assert offer(model, np.empty((0, len(model.parameters))), np.empty((0, len(model.section) + 1))) == []


@pytest.mark.parametrize(
    "options",
    [
        {"starts": 0},
        {"starts": 1_000_001},
        {"period_min": 0.0},
        {"period_min": 3.0, "period_max": 1.0},
        {"period_max": math.inf},
        {"period_min": math.nan},
    ],
)
def test_search_options_are_checked(options):
    with pytest.raises(InputError, match="not allowed"):
        SearchOptions(**options)


def test_rootfinder_prints_as_one_c_function():
    rootfinder = StepMap(load("wobbling")).rootfinder(12, 10, abstol=1e-12, abstol_step=1e-4)
    generator = ca.CodeGenerator("rootfinder.c")
    generator.add(rootfinder)
    text = generator.dump()
    assert "#error" not in text
    assert "casadi_newton(" in text
    kernels = load("wobbling").path("wobbling_kernels.c").read_text("utf-8")
    assert "#error" not in kernels


# -- failures are values ---------------------------------------------------------------------------------

GUESSES = {
    # Status: (k, alpha, omega), guess of section point and period; found by search, digits cut
    Status.CONVERGED: ((6, 0.25, 3), (0.0942, -0.1455, -0.0026, 0.0029, 0.152, 1.1837)),
    Status.INACCURATE: ((510, 0.05, 1.5), (0.08998, -0.120851, -0.001952, 6.9e-05, 0.007439, 2.247503)),
    Status.NOT_CONVERGED: ((6, 0.25, 3), (0.05, -0.62, 0.6, 0.05, -0.76, 1.69)),
    Status.NOT_A_STEP: ((6, 0.25, 3), (-0.077183, 0.325498, 0.00387, 0.000193, 0.007035, 0.484398)),
    Status.LATER_TOUCHDOWN: ((1, 0.75, 3.9), (0.08265, -0.22725, -0.0031, 0.00041, -0.19312, 2.62522)),
    Status.OUT_OF_RANGE: ((40, 0.25, 3), (0.095144, -0.106336, -0.001919, -4.6e-05, -0.003157, 3.276972)),
}


def offer_one(point, guess):
    model = load("wobbling")
    params = model.point(dict(zip(("k", "alpha", "omega"), point, strict=True)))
    (orbit,) = offer(model, params[None], np.array([guess]))
    return model, params, orbit


def test_every_status_has_a_guess_that_leads_to_it():
    assert set(GUESSES) == set(Status)


@pytest.mark.parametrize("status", Status)
def test_guess_leads_to_its_status(status):
    _, params, orbit = offer_one(*GUESSES[status])
    assert orbit.status is status
    assert list(orbit.params.values()) == params.tolist()
    if status.found:
        assert orbit.residual < 1e-11
        assert (orbit.integration_error < 1e-9) == (status is Status.CONVERGED)
    else:
        assert math.isnan(orbit.period)
        assert not orbit.stable
        assert orbit.state == {}


def test_solution_with_a_negative_period_is_not_taken():
    solution = (-0.097164, -0.371414, -0.006991, -0.009462, 0.01325, -0.536338)
    model, params, orbit = offer_one((6, 0.25, 3), solution)
    closing = np.array(StepMap(model).residual(24)(solution, params))
    assert np.abs(closing).max() < 1e-5  # it closes, backwards in time
    assert orbit.status is Status.NOT_CONVERGED


def test_simulator_confirms_that_the_touchdown_is_a_later_one():
    point, guess = GUESSES[Status.LATER_TOUCHDOWN]
    model = load("wobbling")
    params = model.point(dict(zip(("k", "alpha", "omega"), point, strict=True)))
    phase = swing(model, params, np.array(guess[:-1]))
    assert phase.outcome is Outcome.WALKED
    assert phase.duration < guess[-1] - 0.5


@pytest.mark.parametrize(
    ("point", "guess", "status"),
    [
        # The feet meet at mid-stance with the stance leg a hair before the vertical: no touchdown.
        ((5.7, 0.89, 3.2), (0.10458, -0.01347, -0.00029, 0.00025, 0.12988, 2.97201), Status.CONVERGED),
        # And a hair beyond it, rocking back: the first touchdown.
        (
            (4.799112957962385, 0.782076682068945, 3.330902093314011),
            (0.105769, -0.027448, -0.000612, 0.000547, 0.133838, 2.862442),
            Status.LATER_TOUCHDOWN,
        ),
    ],
)
def test_side_of_the_vertical_is_judged_where_the_feet_meet(point, guess, status):
    model, params, orbit = offer_one(point, guess)
    phase = swing(model, params, np.array(guess[:-1]))
    assert (abs(phase.duration - guess[-1]) < 1e-2) == (status is Status.CONVERGED)
    assert orbit.status is status


@pytest.mark.filterwarnings("error")
def test_wild_guesses_neither_warn_nor_fail():
    model = load("wobbling")
    rng = np.random.default_rng(3)
    guesses = rng.uniform(-3, 3, (300, 6)) * 10.0 ** rng.integers(-2, 4, (300, 6))
    guesses[:4] = [[np.nan] * 6, [np.inf] * 6, [0.0] * 6, [1e300] * 6]
    orbits = offer(model, np.tile(model.point({}), (len(guesses), 1)), guesses)
    assert len(orbits) == len(guesses)
    assert {o.status for o in orbits[:4]} <= {Status.NOT_CONVERGED, Status.NOT_A_STEP}


@pytest.mark.parametrize("omega", [1.5, 2.0])
def test_stiff_spring_is_integrated_finely_enough(omega):
    """k = 60 at alpha = 0.05: a dozen oscillations of the spring in a step."""
    orbits = find("wobbling", k=60.0, alpha=0.05, omega=omega)
    assert any(o.period > 2 for o in orbits)
    for orbit in orbits:
        assert orbit.status is Status.CONVERGED
        assert orbit.integration_error < 1e-9
        z = section_point(orbit)
        (step,) = walk(load("wobbling"), parameters(orbit), z, 1).steps
        # The closing error of the simulator is no larger than the error that the orbit admits.
        assert np.abs(section_point(step) - z).max() < 2 * orbit.integration_error + 1e-10
        assert step.period == pytest.approx(orbit.period, abs=1e-9)


# -- orbits as values ------------------------------------------------------------------------------------


def test_orbit_cannot_be_changed():
    (orbit, _) = find("wobbling", **TWO_CYCLES)
    with pytest.raises(dataclasses.FrozenInstanceError):
        orbit.period = 1.0
    with pytest.raises(TypeError):
        orbit.state["theta1"] = 1.0
    for change in (
        lambda d: d.update(k=1.0), lambda d: d.pop("k"), lambda d: d.clear(), lambda d: d.__ior__({"k": 1.0}),
        lambda d: d.setdefault("new", 1.0), lambda d: d.__delitem__("k"), lambda d: d.popitem(),
    ):  # fmt: skip
        with pytest.raises(TypeError, match="cannot be changed"):
            change(orbit.params)


def test_orbit_as_plain_dicts():
    (orbit, _) = find("wobbling", **TWO_CYCLES)
    plain = dataclasses.asdict(orbit)
    assert plain["params"] == dict(orbit.params)
    assert plain["state"] == dict(orbit.state)
    assert Orbit(**plain) == orbit
    assert dataclasses.replace(orbit, stable=False).state == orbit.state
    assert copy.deepcopy(orbit) == orbit
    assert json.loads(json.dumps(orbit.state)) == orbit.state


@pytest.mark.parametrize("status", [Status.CONVERGED, Status.NOT_CONVERGED])
def test_orbit_pickles(status):
    _, _, orbit = offer_one(*GUESSES[status])
    again = pickle.loads(pickle.dumps(orbit))
    assert repr(again) == repr(orbit)  # NaN is not equal to itself
    assert again.status is status
    assert (again == orbit) == status.found


@pytest.mark.parametrize("status", Status)
def test_orbit_is_json_without_nan(status):
    _, _, orbit = offer_one(*GUESSES[status])
    entry = json.loads(json.dumps(orbit.to_dict(), allow_nan=False))
    names = [f.name for f in dataclasses.fields(Orbit) if f.name not in ("model", "params")]
    assert list(entry) == names
    assert entry["status"] == status.value
    if status.found:
        assert entry["state"] == dict(orbit.state)
        assert [complex(*pair) for pair in entry["multipliers"]] == list(orbit.multipliers)
        assert None not in entry.values()
    else:
        assert entry["period"] is None


# -- duplicates ------------------------------------------------------------------------------------------


def make_orbit(period, x=0.0, status=Status.CONVERGED):
    if not status.found:
        return Orbit("wobbling", {}, status)
    return Orbit("wobbling", {}, status, {"theta1": 0.1, "x": x}, period)


def test_distinct_keeps_one_of_each_solution_of_a_cell():
    u = np.array([
        [0.2, 1.5], [0.1, 1.0], [0.1, 1.0 + 1e-7], [0.3, 1.0], [0.2, 1.5], [0.1, 1.0], [0.1, 1.0 + 2e-5],
    ])  # fmt: skip
    cell = np.array([0, 0, 0, 0, 1, 1, 0])
    kept_cell, kept = distinct(cell, u, tolerance=1e-5)
    assert kept_cell.tolist() == [0, 0, 0, 0, 1, 1]
    assert kept.tolist() == [[0.1, 1.0], [0.3, 1.0], [0.1, 1.0 + 2e-5], [0.2, 1.5], [0.1, 1.0], [0.2, 1.5]]


def test_distinct_agrees_with_comparing_all_pairs():
    rng = np.random.default_rng(0)
    u = rng.integers(0, 4, (300, 3)) + 1e-8 * rng.uniform(size=(300, 3))
    cell = rng.integers(0, 3, 300)
    kept_cell, kept = distinct(cell, u, tolerance=1e-5)
    expected = {(c, *np.round(row)) for c, row in zip(cell, u, strict=True)}
    assert len(kept) == len(expected)
    assert {(c, *np.round(row)) for c, row in zip(kept_cell, kept, strict=True)} == expected


def test_merge_drops_failures_and_duplicates_and_orders_by_period():
    orbits = [
        make_orbit(1.5), make_orbit(0, status=Status.NOT_A_STEP), make_orbit(1.0),
        make_orbit(1.0 + 5e-7, x=5e-7), make_orbit(1.0, x=5e-6), make_orbit(0, status=Status.NOT_CONVERGED),
        make_orbit(0.7), make_orbit(1.2, status=Status.INACCURATE),
    ]  # fmt: skip
    first, second, third = merge(3, [0, 0, 0, 0, 0, 0, 0, 2], orbits)
    assert [(o.period, o.state["x"]) for o in first] == [(0.7, 0.0), (1.0, 0.0), (1.0, 5e-6), (1.5, 0.0)]
    assert second == []
    assert third == orbits[-1:]


@pytest.mark.parametrize("seed", range(5))
def test_merge_orders_whatever_the_order_and_the_failures(seed):
    rng = np.random.default_rng(seed)
    orbits = [make_orbit(1 + 0.1 * i) for i in range(6)]
    orbits += [make_orbit(0, status=Status.NOT_CONVERGED) for _ in range(6)]
    shuffled = [orbits[i] for i in rng.permutation(len(orbits))]
    (merged,) = merge(1, [0] * len(orbits), shuffled)
    assert merged == orbits[:6]
