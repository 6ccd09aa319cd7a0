"""What a search throws away is reported, and a steep torque loses no gait."""

import json

import numpy as np
import pytest
import sympy as sp

from stridemap.codegen import derive_model
from stridemap.derive import Parameter
from stridemap.derive.models.compass import THETA2
from stridemap.derive.models.goswami_compass import WALKER as COMPASS
from stridemap.errors import InputError
from stridemap.solver.api.points import find_orbits
from stridemap.solver.backends import chained
from stridemap.solver.cycles import solver as solver_module
from stridemap.solver.cycles.duplicates import grouped
from stridemap.solver.cycles.report import ENDS
from stridemap.solver.cycles.search import find_all, starts
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.cycles.status import Status
from stridemap.solver.kernels.catalogue import CYCLE_N_RK, FINE_N_RK
from stridemap.solver.kernels.step_map import BLOCK
from stridemap.solver.model.loading import load
from stridemap.solver.options import SearchOptions
from tests.oracles.reference import TWO_CYCLES
from tests.oracles.remembered import remembered

FC = Parameter("Fc", 0.002, "m g L", "dry friction at the hip", 0.0)
SHARP = Parameter("sharp", 100.0, "sqrt(L/g)", "sharpness of the sign function", 0.0)


@pytest.fixture(scope="module")
def friction():
    """The compass gait with dry friction at the hip."""
    walker = COMPASS.with_(
        name="coulomb_min",
        parameters=(*COMPASS.parameters, FC, SHARP),
        torques={THETA2: -FC.symbol * sp.tanh(SHARP.symbol * THETA2.rate)},
    )
    with remembered():
        return derive_model(walker)


# By an independent program (floating-base equations, event-driven DOP853 at 1e-12, Newton's method on the
# step map). Sharpness: state and period, multipliers.
KNOWN = {
    1000: ((0.265949807680, -0.347611335746, -0.214452874225, 2.266483263256), -0.0383746, 0.5990099),
    2000: ((0.265949815193, np.nan, np.nan, 2.266483299787), -0.0383738, 0.5990104),
}


@pytest.mark.parametrize("sharp", KNOWN)
def test_both_gaits_with_steep_friction(friction, sharp):
    orbits = find_orbits(friction, sharp=sharp)
    assert len(orbits) == 2
    assert orbits.status.tolist() == ["converged", "converged"]
    assert orbits[0].state["theta1"] == pytest.approx(0.2538, abs=1e-4)
    u, real, imaginary = KNOWN[sharp]
    there = np.isfinite(u)
    np.testing.assert_allclose(orbits.u[1][there], np.array(u)[there], rtol=0, atol=3e-11)
    assert orbits[1].multipliers[0] == pytest.approx(complex(real, imaginary), abs=1e-7)
    assert orbits[1].stable
    assert orbits.search.unresolved == 0


@pytest.mark.parametrize("sharp", [80, 120, 300, 500, 5000])
def test_no_sharpness_loses_a_gait(friction, sharp):
    orbits = find_orbits(friction, sharp=sharp)
    assert orbits.period == pytest.approx([1.8548262, 2.266483], abs=2e-5)
    assert (orbits.state_error < 1e-10).all()


def test_what_the_finest_resolution_does_not_resolve_is_reported(friction, monkeypatch):
    monkeypatch.setattr(solver_module, "LEVELS", CYCLE_N_RK)
    orbits = find_orbits(friction, sharp=5000)
    assert len(orbits) == 1
    assert orbits.search.unresolved > 0
    assert any("nearly closed" in warning for warning in orbits.search.warnings)
    lost = orbits.search.discarded
    near = lost[lost.status == Status.UNRESOLVED]
    assert (np.abs(near.u - [0.26595, -0.34761, -0.21445, 2.26648]).max(axis=1) < 0.02).any()


# -- steps of any number of RK steps -----------------------------------------------------------------------


@pytest.mark.quick
@pytest.mark.parametrize("n_rk", [24, 96])
def test_chained_steps_have_the_bits_of_compiled_ones(n_rk):
    solver = Solver.for_model(load("wobbling"))
    orbits = find_orbits("wobbling", TWO_CYCLES)
    kernels, u, p = solver.kernels, orbits.u, orbits.params
    jacobian, residual = kernels.jacobian(n_rk, u, p)
    by_columns, closing = chained.jacobian(kernels, n_rk, u, p)
    assert np.array_equal(by_columns.transpose(0, 2, 1), jacobian)
    assert np.array_equal(closing, residual)
    for one, other in zip(kernels.trace(n_rk, u, p), chained.trace(kernels, n_rk, u, p), strict=True):
        assert np.array_equal(one, other)


@pytest.mark.quick
def test_newton_on_chained_steps_ends_at_the_same_cycle():
    solver = Solver.for_model(load("wobbling"))
    orbits = find_orbits("wobbling", TWO_CYCLES)
    u, jacobian, residual = solver.kernels.limit_cycle(FINE_N_RK[0], orbits.u + 1e-4, orbits.params)
    assert np.abs(u - orbits.u).max() < 1e-9
    assert np.abs(residual).max() < 1e-13
    assert np.abs(jacobian - orbits.jacobian).max() < 1e-7
    assert all(n % BLOCK == 0 for n in FINE_N_RK)


# -- what a search says of itself ----------------------------------------------------------------------------


@pytest.mark.quick
def test_every_start_ends_somewhere():
    orbits = find_orbits("wobbling", TWO_CYCLES)
    search = orbits.search
    assert sum(search.ended.values()) == search.starts == 512
    assert search.ended["limit_cycle"] == search.reached.sum()
    assert len(search.reached) == len(orbits)
    assert search.settled
    assert search.warnings == []
    assert not search.discarded.found.any()
    assert set(search.ended) == set(ENDS)
    assert {s.value for s in Status if not s.found} < set(ENDS)
    plain = json.loads(json.dumps(search.to_dict(), allow_nan=False))
    assert len(plain["discarded"]) == len(search.discarded) > 0
    assert all(row["reason"] for row in plain["discarded"])
    assert orbits[:1].search is None


@pytest.mark.quick
def test_starts_are_added_while_a_cycle_was_reached_once():
    few = find_orbits("wobbling", TWO_CYCLES, options=SearchOptions(starts=1))
    bound = find_orbits("wobbling", TWO_CYCLES, options=SearchOptions(starts=2, max_starts=2))
    assert bound.search.starts == 2
    unsettled = find_orbits("wobbling", TWO_CYCLES, options=SearchOptions(starts=6, max_starts=6))
    assert few.search.starts <= 8
    more = find_orbits("wobbling", TWO_CYCLES, options=SearchOptions(starts=6, max_starts=512))
    assert 6 <= more.search.starts <= 512
    assert (unsettled.search.settled) == (unsettled.search.reached > 1).all()
    if not unsettled.search.settled:
        assert more.search.starts > 6
        assert "from one start of 6 only" in unsettled.search.warnings[0]


@pytest.mark.quick
def test_a_cycle_that_one_start_reached_is_a_reason_for_more():
    seen = set()
    for n in (2, 4, 6, 8, 12, 16, 24, 32):
        alone = find_orbits("simplest_walker", options=SearchOptions(starts=n, max_starts=n)).search
        once = bool((alone.reached == 1).any())
        assert alone.settled == (not once)
        more = find_orbits("simplest_walker", options=SearchOptions(starts=n, max_starts=512)).search
        assert (more.starts > n) == once
        seen.add(once)
    assert seen == {True, False}


@pytest.mark.quick
def test_batches_of_starts_are_one_sequence():
    """So that what is found does not depend on how many are made at once."""
    model = load("wobbling")
    whole = starts(model, SearchOptions(starts=96))
    parts = [starts(model, SearchOptions(starts=n), skip=skip) for n, skip in ((32, 0), (32, 32), (32, 64))]
    assert np.array_equal(np.concatenate(parts), whole)


def test_points_do_not_depend_on_each_other():
    solver = Solver.for_model(load("wobbling"))
    points = np.array([solver.model.point({"k": k}) for k in (6, 12, 30)])
    options = SearchOptions(starts=24)
    point, together = find_all(solver, points, options)
    for i in range(3):
        alone = find_all(solver, points[i : i + 1], options)[1]
        assert np.array_equal(together[point == i].u, alone.u)


@pytest.mark.quick
def test_groups_of_solutions():
    cell = np.array([0, 0, 1, 0, 1])
    u = np.array([[0.1, 1.0], [0.1 + 1e-8, 1.0], [0.1, 1.0], [0.5, 1.0], [0.1, 1.0 - 1e-8]])
    kept, group = grouped(cell, u, 1e-6)
    assert kept[group].tolist() == [0, 0, 4, 3, 4]


# -- where starts lie ----------------------------------------------------------------------------------------


@pytest.mark.quick
def test_the_search_box_can_be_given_and_widened():
    model = load("compass")
    box = SearchOptions(starts=256, search_box={"theta1": (0.3, 0.5)}, widen=2.0)
    made = starts(model, box)
    assert (made[:, 0] >= 0.3).all()
    assert (made[:, 0] <= 0.5).all()
    middle, half = model.spec.search_box["dtheta1"]
    assert half < np.abs(made[:, 1] - middle).max() <= 2 * half
    own, room = model.spec.search_box["theta1"], box.room_for(model)
    ends = min(own[0] - 8 * own[1], 0.4 - 0.8), max(own[0] + 8 * own[1], 0.4 + 0.8)
    assert room[0] == pytest.approx(ends)
    assert room[1] == pytest.approx([middle - 16 * half, middle + 16 * half])
    assert hash(box) == hash(SearchOptions(starts=256, search_box={"theta1": [0.3, 0.5]}, widen=2.0))
    with pytest.raises(InputError, match="search_box names 'theta', which is not an entry of the section"):
        starts(model, SearchOptions(search_box={"theta": (0, 1)}))
    for wrong in ({"theta1": (1, 0)}, {"theta1": 1}, {"theta1": (0, np.inf)}, 5):
        with pytest.raises(InputError, match="search_box"):
            SearchOptions(search_box=wrong)
    with pytest.raises(InputError, match="max_starts = 3 is not allowed"):
        SearchOptions(starts=4, max_starts=3)


def test_the_command_line_reports_the_search(run):
    words = ["orbit", "--model", "compass", "--search-box", "theta1=0.05:0.2", "--search", "widen=2"]
    status, _, err = run(*words)
    assert (status, err) == (0, "")
    status, _, err = run("orbit", "--k", "6", "--starts", "1", "--search", "max_starts=1")
    assert status == 0
    assert "1 starts ended: 1 in a limit cycle" in err
    assert "warning: 1 limit cycle reached from one start of 1 only" in err
    status, out, err = run(*words, "--json")
    assert (status, err) == (0, "")
    assert json.loads(out)["search"]["starts"] == 512
    status, _, err = run("orbit", "--search-box", "theta1=5")
    assert status == 2
    assert "write --search-box NAME=LOW:HIGH" in err
