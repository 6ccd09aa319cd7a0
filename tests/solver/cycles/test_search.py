"""All cycles at a point: the reference orbits, their order, and duplicates merged."""

import numpy as np
import pytest

from stridemap.solver.api.points import find_orbits
from stridemap.solver.cycles.duplicates import distinct, first_of_each
from stridemap.solver.cycles.orbits import Orbits
from stridemap.solver.cycles.search import continued, find_all, merged
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.cycles.status import Status
from stridemap.solver.model.loading import load
from tests.oracles.reference import (
    POINTS,
    REFERENCE,
    TWO_CYCLES,
    TYPICAL,
    orbits_at,
    point_name,
    reference_name,
    section_point,
)

pytestmark = pytest.mark.quick

# -- what is found ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("entry", REFERENCE, ids=reference_name)
def test_reference_orbit_is_found(entry):
    found = find_orbits(entry["model"], entry["params"])
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
    assert find_orbits("wobbling", TWO_CYCLES).period.tolist() == pytest.approx(expected, abs=1e-10)


@pytest.mark.parametrize(
    ("params", "group", "peaks"), [*zip(TYPICAL, "ABC", (1, 2, 3), strict=True)], ids=["A", "B", "C"]
)
def test_typical_solution(params, group, peaks):
    (stable,) = [o for o in find_orbits("wobbling", params) if o.stable]
    assert (stable.group, stable.peaks) == (group, peaks)


@pytest.mark.parametrize("index", range(len(POINTS)), ids=[point_name(p) for p in POINTS])
def test_orbits_are_distinct_ordered_and_one_multiplier_is_zero(index):
    orbits = orbits_at(index)
    assert all(np.diff([o.period for o in orbits]) > 0)
    for orbit in orbits:
        modulus = np.abs(orbit.multipliers)
        assert len(modulus) == len(orbit.model.section)
        assert all(np.diff(modulus) <= 0)
        assert modulus[-1] < 1e-12  # the swing foot's speed, lost at the impact
        assert modulus[-2] > 1e-9
        assert orbit.spectral_radius == modulus[0]
        assert orbit.stable == (modulus[0] < 1)


def by_point(model, points):
    """The orbits of each point."""
    at, orbits = find_all(Solver.for_model(model), points)
    assert (np.diff(at) >= 0).all()
    return [list(orbits[at == i]) for i in range(len(points))]


def test_search_is_reproducible_and_points_do_not_disturb_each_other():
    model = load("wobbling")
    points = np.array([model.point(p) for p in TYPICAL[:2]])
    together = by_point(model, points)
    assert all(together)
    assert together[0] == by_point(model, points[:1])[0]
    assert by_point(model, points) == together
    assert by_point(model, points[::-1]) == together[::-1]  # nor does the place in the batch matter


def test_no_points_have_no_orbits():
    model = load("wobbling")
    solver, none = Solver.for_model(model), np.empty((0, len(model.parameters)))
    at, orbits = find_all(solver, none)
    assert (at.tolist(), len(orbits)) == ([], 0)
    assert len(continued(solver, none, np.empty((0, len(model.section) + 1)))) == 0


# -- duplicates ------------------------------------------------------------------------------------------


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


def some_orbits(rows):
    """Orbits of the compass walker from (period, x, status), x the first entry of the section point."""
    model = load("compass")
    columns = {name: np.full(len(rows), value) for name, value in model.preset.items()}
    columns |= {name: np.zeros(len(rows)) for name in model.section}
    columns["period"], columns["theta1"], columns["status"] = zip(*rows, strict=True)
    return Orbits.from_columns(model, columns)


def shown(orbits):
    return list(zip(orbits.period.tolist(), orbits.u[:, 0].tolist(), strict=True))


def test_merge_drops_failures_and_duplicates_and_orders_by_cell_and_period():
    good = Status.CONVERGED
    orbits = some_orbits([
        (1.5, 0.0, good), (0.5, 0.0, Status.NOT_A_STEP), (1.0, 0.0, good), (1.0 + 5e-7, 5e-7, good),
        (1.0, 5e-6, good), (np.nan, 0.0, Status.NOT_CONVERGED), (0.7, 0.0, good),
        (1.2, 0.0, Status.INACCURATE),
    ])  # fmt: skip
    cells, kept = merged(np.array([0, 0, 0, 0, 0, 0, 0, 2]), orbits)
    assert cells.tolist() == [0, 0, 0, 0, 2]
    assert shown(kept) == [(0.7, 0.0), (1.0, 0.0), (1.0, 5e-6), (1.5, 0.0), (1.2, 0.0)]
    assert kept.status.tolist() == [good] * 4 + [Status.INACCURATE]


@pytest.mark.parametrize("seed", range(5))
def test_merge_orders_whatever_the_order_and_the_failures(seed):
    rows = [(1 + 0.1 * i, 0.0, Status.CONVERGED) for i in range(6)] + [(1.0, 0.0, Status.NOT_CONVERGED)] * 6
    order = np.random.default_rng(seed).permutation(len(rows))
    cells, kept = merged(np.zeros(len(rows), dtype=np.int64), some_orbits(rows).take(order))
    assert cells.tolist() == [0] * 6
    assert kept.period.tolist() == [period for period, *_ in rows[:6]]


def greedy(cell, u, tolerance):
    """The rows that two plain loops keep: ordered, and each one compared with all that were kept."""
    kept = []
    for i in sorted(range(len(u)), key=lambda i: (cell[i], u[i][-1], *u[i][:-1], i)):
        if not any(cell[i] == cell[j] and max(abs(u[i] - u[j])) <= tolerance for j in kept):
            kept.append(i)
    return kept


@pytest.mark.parametrize("seed", range(40))
def test_first_of_each_is_what_plain_loops_keep(seed):
    """With many ties in every entry, chains of neighbours that agree pairwise only, and equal rows."""
    rng = np.random.default_rng(seed)
    n, width = int(rng.integers(0, 90)), int(rng.integers(1, 4))
    u = rng.integers(0, 6, (n, width)) * 0.7e-6 + rng.integers(0, 2, (n, width))
    cell = rng.integers(0, 4, n)
    if seed % 2:
        u[rng.integers(0, max(n, 1), n // 3)] = u[rng.integers(0, max(n, 1), n // 3)] if n else 0
    assert first_of_each(cell, u, 1e-6).tolist() == greedy(cell, u, 1e-6)


def test_chains_exist_in_which_agreeing_is_not_transitive():
    u = np.array([[0.0], [0.7e-6], [1.4e-6], [2.1e-6]])
    assert first_of_each(np.zeros(4, dtype=np.int64), u, 1e-6).tolist() == [0, 2]
