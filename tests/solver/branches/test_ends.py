"""Where gaits end along a branch, against the measures and an event-driven integrator."""

import itertools
from dataclasses import replace

import numpy as np
import pytest

import stridemap
from stridemap.solver.branches.conditions import GaitConditions, GaitEnd
from stridemap.solver.branches.ends import conditions_along, gait_ends
from stridemap.solver.cycles.search import find_all
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.kernels.catalogue import CYCLE_N_RK
from stridemap.solver.model.loading import load
from stridemap.solver.options import ContinuationOptions, SearchOptions
from stridemap.solver.walks.swing import swing


@pytest.mark.quick
def test_conditions_are_what_is_measured():
    solver = Solver.for_model(load("simplest_walker"))
    points = np.array([[0.004], [0.009], [0.014]])
    _, orbits = find_all(solver, points, SearchOptions(starts=64))
    assert len(orbits) == 6
    seen = GaitConditions(solver.kernels, 0.2).of_steps(96, orbits.u, orbits.params)
    assert set(seen) == set(GaitEnd) - {GaitEnd.PERIOD_LIMIT}
    np.testing.assert_allclose(seen[GaitEnd.CONTACT], orbits.min_vertical_force, rtol=0, atol=1e-10)
    np.testing.assert_allclose(seen[GaitEnd.FRICTION], 0.2 - orbits.friction, rtol=0, atol=1e-10)
    for name in (GaitEnd.GRAZING, GaitEnd.EARLY_TOUCHDOWN, GaitEnd.BACKWARD, GaitEnd.FALL):
        assert (seen[name] > 0).all(), name
    # The stance leg leans most at the ends of a step: back by theta, then ahead by as much.
    theta = orbits.u[:, 0]
    np.testing.assert_allclose(seen[GaitEnd.FALL], np.pi / 2 - theta, rtol=0, atol=1e-10)
    np.testing.assert_allclose(seen[GaitEnd.BACKWARD], theta, rtol=0, atol=1e-10)
    # The condition phi - 2 theta rises at the touchdown as an event-driven integrator sees it.
    ends = [swing(solver.model, p, u[:-1]).end for p, u in zip(orbits.params, orbits.u, strict=True)]
    rates = [dphi - 2 * dtheta for _, _, dtheta, dphi in ends]
    np.testing.assert_allclose(seen[GaitEnd.GRAZING], rates, rtol=0, atol=1e-9)
    without = GaitConditions(solver.kernels).of_steps(96, orbits.u, orbits.params)
    assert set(without) == set(GaitEnd) - {GaitEnd.FRICTION, GaitEnd.PERIOD_LIMIT}


@pytest.mark.quick
def test_a_cycle_of_several_steps_is_as_good_as_its_worst_step():
    """Two different steps, near those of the doubled gait at this slope."""
    solver = Solver.for_model(load("simplest_walker"))
    conditions, params = GaitConditions(solver.kernels, 0.3), np.array([[0.0165]])
    steps = np.array([[0.25054944845, -0.23949, 3.76779272], [0.23665687719, -0.2352, 4.02590285]])
    each = conditions.of_steps(96, steps, np.repeat(params, 2, axis=0))
    whole = conditions.of_cycles([96], steps.reshape(1, -1), params, 2)
    for name, values in each.items():
        assert whole[name] == values.min()
    assert np.ptp(each[GaitEnd.FRICTION]) > 1e-3


@pytest.mark.quick
def test_the_limit_of_friction_is_reached_where_the_branch_says():
    found = stridemap.branches("simplest_walker", "slope", (0.005, 0.015), seeds=1, friction_limit=0.2)
    ends = [point for point in found.special if point.type == "friction"]
    assert len(ends) == 2  # either gait ends once
    for end in ends:
        assert end.residual < 1e-11
        walk = stridemap.simulate("simplest_walker", end.state, steps=1, slope=end.value)
        path = walk.trajectory(end.period / 4000).to_frame()
        model = stridemap.load("simplest_walker")
        q, v = path[["theta", "phi"]].to_numpy(), path[["dtheta", "dphi"]].to_numpy()
        first = (path["step"] == path["step"].iloc[0]).to_numpy()
        p = np.array([end.value])
        force = model.evaluate("ground_force", t=0.0, q=q[first], v=v[first], p=p)["force"]
        assert np.abs(force[:, 0] / force[:, 1]).max() == pytest.approx(0.2, abs=1e-7)


@pytest.mark.quick
def test_where_a_gait_ends_it_begins_the_other_way():
    found = stridemap.branches("simplest_walker", "slope", (0.005, 0.015), seeds=1, friction_limit=0.2)
    conditions = GaitConditions(Solver.for_model(load("simplest_walker")).kernels, 0.2)
    for branch in found:
        back = [point.reversed() for point in reversed(branch.points)]
        values = conditions_along(branch.curve, back, conditions)
        ((_, begins),) = gait_ends(branch.curve, back, values, conditions, ContinuationOptions())
        ((_, ends),) = branch.ends
        assert begins.point.x == pytest.approx(ends.point.x, rel=0, abs=1e-10)


def test_an_end_is_one_at_the_finest_resolution_too():
    """At the resolution at which the branch is followed it is at 17.73935299, 2e-7 beside its place."""
    given = {"alpha": 0.25, "omega": 3.0}
    found = stridemap.branches("wobbling", "k", (17.4, 18.0), given, seeds=2)
    curve = found[0].curve
    conditions = GaitConditions(curve.chain.kernels)
    ends = [end for branch in found for _, end in branch.ends]
    assert len(ends) == 1
    x = ends[0].point.x
    assert np.abs(curve.linearised(x, 384)[1]).max() < 1e-12
    params = curve.equations.point(x[-1:])[None]
    assert abs(conditions.of_cycles([768], x[None, :-1], params, 1)[ends[0].type][0]) < 1e-12


class Counted:
    """Conditions that count for how many points they were asked."""

    def __init__(self, of_cycles):
        self.given, self.count = of_cycles, 0

    def of_cycles(self, n_rk, u, params, n_steps, names=None):
        self.count += len(u)
        return self.given(n_rk, u, params, n_steps, names)


def given_along(points, value):
    """A condition in the place of contact, as a function of the part of the way between two points."""
    begin, end = (point.x[-1] for point in points)

    def of_cycles(n_rk, u, params, n_steps, names):
        return {GaitEnd.CONTACT: np.array([value((one - begin) / (end - begin)) for one in params[:, -1]])}

    return Counted(of_cycles)


def test_an_end_takes_few_trials():
    """Bisection from a bracket of 0.05 to 1e-14 would take more than forty at each resolution."""
    found = stridemap.branches("simplest_walker", "slope", (0.005, 0.015), seeds=1, friction_limit=0.2)
    conditions = GaitConditions(Solver.for_model(load("simplest_walker")).kernels, 0.2)
    for branch in found:
        points = branch.points[:: len(branch.points) - 1]  # a long bracket
        values = conditions_along(branch.curve, points, conditions)
        counted = Counted(conditions.of_cycles)
        ((_, end),) = gait_ends(branch.curve, points, values, counted, ContinuationOptions())
        assert end.residual < 1e-11
        assert end.point.x == pytest.approx(branch.ends[0][1].point.x, rel=0, abs=1e-10)
        assert counted.count <= 20


def test_an_end_between_points_of_the_finest_resolution_is_exact():
    """There is no finer one at which a rough zero would be refined."""
    (branch, *_) = stridemap.branches("simplest_walker", "slope", (0.005, 0.015), seeds=1)
    points = [replace(point, n_rk=CYCLE_N_RK[-1]) for point in branch.points[:: len(branch.points) - 1]]
    steep = given_along(points, lambda share: 100 * np.expm1(3 * (0.3 - share)))
    values = {GaitEnd.CONTACT: 100 * np.expm1([0.9, -2.1])}
    begin, end = (point.x[-1] for point in points)
    ((_, found),) = gait_ends(branch.curve, points, values, steep, ContinuationOptions())
    assert found.residual < 1e-11
    assert (found.point.x[-1] - begin) / (end - begin) == pytest.approx(0.3, abs=1e-11)


def test_where_a_condition_jumps_secants_do_not_creep():
    """An early touchdown can vanish all at once: large on one side of the jump, nearly zero on the other."""
    (branch, *_) = stridemap.branches("simplest_walker", "slope", (0.005, 0.015), seeds=1)
    points = branch.points[:: len(branch.points) - 1]
    jumps = given_along(points, lambda share: 1.0 if share < 0.4 else 1e-5 * (0.6 - share))
    values = {GaitEnd.CONTACT: np.array([1.0, -1e-5])}
    list(gait_ends(branch.curve, points, values, jumps, ContinuationOptions()))
    assert 0 < jumps.count <= 15


@pytest.mark.parametrize("seed", range(7, 12))
def test_where_rounding_blurs_a_condition_by_more_than_its_limit_the_best_trial_counts(seed):
    """It is within what rounding leaves open; the last trial of the bisection need not be as good."""
    (branch, *_) = stridemap.branches("simplest_walker", "slope", (0.005, 0.015), seeds=1)
    points = branch.points[:: len(branch.points) - 1]
    begin, end = (point.x[-1] for point in points)
    rng = np.random.default_rng(seed)
    blurred = given_along(points, lambda share: 1e-3 * (0.5 - share) + rng.normal(0, 2e-11))
    values = {GaitEnd.CONTACT: np.array([5e-4, -5e-4])}
    ((_, found),) = gait_ends(branch.curve, points, values, blurred, ContinuationOptions())
    assert found.residual < 1e-11
    assert (found.point.x[-1] - begin) / (end - begin) == pytest.approx(0.5, abs=1e-7)


@pytest.mark.parametrize(("early", "kind"), [(0.4, GaitEnd.GRAZING), (0.35, GaitEnd.EARLY_TOUCHDOWN)])
def test_an_early_touchdown_that_appears_where_the_foot_grazes_is_not_searched_for(early, kind):
    """There it appears all at once; met before it is an end of its own."""
    (branch, *_) = stridemap.branches("simplest_walker", "slope", (0.005, 0.015), seeds=1)
    points = branch.points[:: len(branch.points) - 1]
    begin, end = (point.x[-1] for point in points)
    asked = []

    def of_cycles(n_rk, u, params, n_steps, names=None):
        asked.append(names)
        share = (params[:, -1] - begin) / (end - begin)
        jumps = np.where(share < 0.4, early - share + (early == 0.4), -1.0)
        return {GaitEnd.EARLY_TOUCHDOWN: jumps, GaitEnd.GRAZING: 0.4 - share}

    values = of_cycles(None, None, np.array([[begin], [end]]), 1)
    ((_, found),) = gait_ends(branch.curve, points, values, Counted(of_cycles), ContinuationOptions())
    assert found.type is kind
    assert (found.point.x[-1] - begin) / (end - begin) == pytest.approx(early, abs=1e-10)
    assert (asked.count([GaitEnd.EARLY_TOUCHDOWN]) == 1) == (kind is GaitEnd.GRAZING)


def test_where_rounding_blurs_a_condition_secants_stop():
    """Next to it a zero is not searched for again at the finest resolution, from the whole bracket."""
    (branch, *_) = stridemap.branches("simplest_walker", "slope", (0.005, 0.015), seeds=1)
    points = branch.points[:: len(branch.points) - 1]
    begin, end = (point.x[-1] for point in points)
    blur = itertools.cycle([4e-13, -3e-13, 5e-13])
    blurred = given_along(points, lambda share: 0.1 * (0.5 - share) + next(blur))
    values = {GaitEnd.CONTACT: np.array([0.05, -0.05])}
    ((_, found),) = gait_ends(branch.curve, points, values, blurred, ContinuationOptions())
    assert found.residual < 1e-12
    assert (found.point.x[-1] - begin) / (end - begin) == pytest.approx(0.5, abs=1e-10)
    assert blurred.count <= 20


@pytest.mark.parametrize(
    ("given", "k", "starts"),
    [
        ({"alpha": 0.25, "omega": 3.0}, (6.3, 6.6), 128),
        ({"alpha": 0.5, "omega": 3.5}, (1.32, 1.345), 512),
    ],
    ids=["from above", "from below"],
)
def test_a_gait_ends_where_the_foot_touches_down_early(given, k, starts):
    """On one side the integrator walks the cycle; on the other its foot is down before the step ends.

    It comes down to the ground there; or it does not come up any more before it swings on below the ground.
    """
    found = stridemap.branches("wobbling", "k", k, given, seeds=2, search={"starts": starts})
    (end,) = (point for point in found.special if point.type == "early_touchdown")
    assert end.residual < 1e-11
    points = found.to_frame().query(f"branch == {end.branch}").reset_index(drop=True)
    at = int((points.gait.astype(int).diff().abs() == 1).idxmax())
    model = stridemap.load("wobbling")
    for row in (points.iloc[at - 1], points.iloc[at]):
        state = {name: row[name] for name in model.section}
        walk = stridemap.simulate("wobbling", state, steps=1, params={**given, "k": row.k})
        if row.gait:
            assert walk.steps[0].period == pytest.approx(row.period, abs=1e-9)
        else:
            assert walk.steps[0].period < row.period - 1e-3


@pytest.mark.parametrize(("k", "alpha"), [(2.8, 0.2), (12.4, 0.2), (3.6, 0.31), (30.0, 0.4)])
def test_early_touchdowns_are_those_that_the_acceptance_sees(k, alpha):
    """The foot may pass the ground where that is no touchdown, and be lowest where it would be one."""
    solver = Solver.for_model(load("wobbling"))
    point = solver.model.point({"k": k, "alpha": alpha, "omega": 3.0})
    _, gaits = find_all(solver, point[None, :], SearchOptions(starts=256))
    assert len(gaits)
    late = gaits.search.discarded
    late = late.take(late.status == "later_touchdown")
    margins = [
        GaitConditions(solver.kernels).of_steps(192, one.u, one.params, [GaitEnd.EARLY_TOUCHDOWN])
        for one in (gaits, late)
        if len(one)
    ]
    assert (margins[0][GaitEnd.EARLY_TOUCHDOWN] > 0).all()
    assert all((margin[GaitEnd.EARLY_TOUCHDOWN] < 0).all() for margin in margins[1:])
