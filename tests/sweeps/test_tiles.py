"""One tile of a sweep from guesses that are known: which branches are followed, and where to."""

from dataclasses import dataclass, field, replace

import numpy as np
import pytest

from stridemap.solver.backends.lanes import Lanes
from stridemap.solver.branches import continuation
from stridemap.solver.cycles.search import find_all
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.cycles.status import Status
from stridemap.solver.model.loading import load
from stridemap.solver.model.scales import Scales
from stridemap.solver.options import (
    IN_SWEEPS,
    IN_SWEEPS_OF_CYCLES,
    AcceptanceOptions,
    ContinuationOptions,
    SearchOptions,
)
from stridemap.sweeps import connections, tiles
from stridemap.sweeps.connections import connect
from stridemap.sweeps.families import families
from stridemap.sweeps.grid import Grid
from stridemap.sweeps.solutions import NONE, Guesses, Solutions
from stridemap.sweeps.tasks import Task
from stridemap.sweeps.tiles import BESIDE, work
from tests.oracles.kernels import needs_compiler
from tests.oracles.reference import GUESSES, LIFTING

pytestmark = [needs_compiler, pytest.mark.quick]


@dataclass(frozen=True)
class Line:
    """Cells of the wobbling walker along k, of which a tile has some; no starts are made."""

    k: tuple[float, ...]
    params: dict[str, float]
    period_range: tuple[float, float] = (0.3, 3.0)
    continuation: ContinuationOptions = field(default_factory=lambda: IN_SWEEPS)

    def result(self, incoming, cells=None):
        """What a tile finds from guesses (cell, cycle)."""
        model = load("wobbling")
        fixed = {n: v for n, v in {**model.preset, **self.params}.items() if n != "k"}
        low, high = self.period_range
        task = Task(
            model=model,
            grid=Grid(("k",), (np.array(self.k),)),
            params=fixed,
            search=SearchOptions(starts=1, period_min=low, period_max=high),
            acceptance=AcceptanceOptions(),
            continuation=self.continuation,
            backend=Lanes(),
            round=1,
            tile=0,
            cells=np.arange(len(self.k)) if cells is None else np.array(cells),
            seeds=np.array([], dtype=np.int64),
            incoming=Guesses(
                np.array([cell for cell, _ in incoming]),
                np.array([u for _, u in incoming]),
                np.full(len(incoming), NONE),
                np.array([cell for cell, _ in incoming]),
            ),
            known=Solutions.empty(6),
            seen=Solutions.empty(6),
        )
        return work(task)

    def cycles(self, k):
        """All limit cycles at one value of k, by a search of its own; unknowns by period."""
        model = load("wobbling")
        point = model.point({**self.params, "k": k})[None]
        return find_all(Solver.for_model(model), point, SearchOptions(starts=128))[1]


def connected(task, found):
    """Pairs of branches that are one once the links of a result are followed."""
    links = found.links
    seen = Solutions.concatenate([task.seen, found.seen], links.u.shape[1])
    incoming = Guesses(links.cell, links.u, links.branch, links.origin)
    followed = connect(replace(task, round=9, incoming=incoming, seen=seen))
    assert not followed.failures
    return np.concatenate([found.joins, followed.joins])


def test_a_branch_is_followed_along_its_line():
    line = Line((8.0, 8.5, 9.0, 9.5), {})
    start = line.cycles(8.5).u[0]
    rows = line.result([(1, start)]).orbits
    assert rows["cell"].tolist() == [0, 1, 2, 3]
    for k, period in zip(line.k, rows["period"].tolist(), strict=True):
        assert np.abs(line.cycles(k).period - period).min() < 1e-10


def test_what_leads_into_other_tiles_is_handed_on():
    line = Line((8.0, 8.5, 9.0, 9.5), {})
    found = line.result([(1, line.cycles(8.5).u[0])], cells=[0, 1])
    assert found.orbits["cell"].tolist() == [0, 1]
    assert found.outgoing.cell.tolist() == [2]
    assert found.outgoing.branch.tolist() == [found.orbits["branch"][1]]
    (u,) = found.outgoing.u
    assert np.abs(line.cycles(9.0).u - u).max(axis=1).min() < 1e-2  # a guess


def test_a_branch_is_followed_through_cells_in_which_it_is_not_a_gait():
    """At k = 1.4 the foot is down before the end of the step, at 1.5 it is a gait."""
    point, _ = GUESSES[Status.LATER_TOUCHDOWN]
    line = Line((1.3, 1.4, 1.5), dict(zip(("alpha", "omega"), point[1:], strict=True)))
    near = np.array([0.0813196831, -0.3064211610, -0.0040437340, 0.0015141253, -0.3212197710, 2.62971018])
    found = line.result([(0, near)])
    assert found.discarded[0, Status.LATER_TOUCHDOWN.value] == 1
    assert found.discarded[1, Status.LATER_TOUCHDOWN.value] == 1
    assert found.orbits["cell"].tolist() == [2]
    (period,) = found.orbits["period"].tolist()
    assert np.abs(line.cycles(1.5).period - period).min() < 1e-10


def test_a_branch_is_followed_as_long_as_it_is_a_gait_however_little_patience_there_is(monkeypatch):
    monkeypatch.setattr(continuation, "PATIENCE", 0.1)
    k = tuple(np.linspace(20.5, 25.0, 10))
    line = Line(k, {}, continuation=replace(IN_SWEEPS, ds=0.02, ds_max=0.02))
    assert line.result([(5, line.cycles(k[5]).u[0])]).orbits["cell"].tolist()[-1] == 9


def test_a_foot_that_is_pulled_a_little_does_not_end_a_branch():
    """It needs a pull of 0.6 of the weight; the neighbour has no other guess."""
    line = Line((LIFTING["k"], LIFTING["k"] + 0.02), {n: v for n, v in LIFTING.items() if n != "k"})
    u = np.array([0.0230059121, -1.4194402303, -0.0015022749, 0.0774067137, -7.4529883501, 0.6799971970])
    found = line.result([(0, u)])
    assert found.orbits["cell"].tolist() == [0, 1]
    pulls = -found.orbits["min_vertical_force"] / (1 + 2 * LIFTING["beta"])
    assert ((pulls > 0.5) & (pulls < 0.7)).all()


@pytest.mark.parametrize(("first", "second"), [(22.5, 23.0), (23.0, 22.5)])
@pytest.mark.parametrize("end", ["short", "long"])
def test_a_branch_is_followed_that_is_a_little_outside_the_range_of_periods(first, second, end):
    """By 1 in 10: it does not count there, but it is a guess for where it comes back."""
    line = Line((22.5, 23.0), {})
    outside, inside = line.cycles(first), line.cycles(second)
    u, period = outside.u[0], outside.period[0]
    there = inside.period[np.abs(inside.period - period).argmin()]
    limits = (1.1 * period, 9.0) if end == "short" else (0.1, period / 1.1)
    found = Line(line.k, {}, limits).result([(line.k.index(first), u)])
    assert len(found.orbits["cell"]) == 0
    assert set(found.seen.cell.tolist()) == {0, 1}
    assert np.abs(found.seen.u[:, -1] - there).min() < 1e-5
    # Where the range ends between the two, the one inside counts.
    between = 0.5 * (period + there)
    limits = (between, 9.0) if there > period else (0.1, between)
    found = Line(line.k, {}, limits).result([(line.k.index(first), u)])
    assert set(found.orbits["cell"].tolist()) == {line.k.index(second)}
    assert np.abs(found.orbits["period"] - there).min() < 1e-10
    # By half is too far.
    limits = (1.5 * period, 9.0) if end == "short" else (0.1, period / 1.5)
    assert len(Line(line.k, {}, limits).result([(line.k.index(first), u)]).seen) == 0


def test_two_cycles_next_to_a_fold_are_one_branch():
    """They are 0.05 apart; on each side of where they were met one goes on."""
    line = Line((5.95, 5.965, 5.98), {})
    one, other = line.cycles(5.965).u
    apart = np.abs((one - other) / Scales.of(load("wobbling")).unknowns).max()
    assert 1e-2 < apart < 0.1
    for begun in ([(1, one)], [(1, other)], [(1, one), (1, other)]):
        found = line.result(begun)
        cells = found.orbits["cell"]
        periods = found.orbits["period"]
        for cell, k in enumerate(line.k):
            np.testing.assert_allclose(np.sort(periods[cells == cell]), line.cycles(k).period, atol=1e-9)
        assert set(families(found.orbits["branch"], found.joins)) == {0}


def test_from_a_branch_the_cells_beside_it_are_tried():
    """Along alpha, which has fewer values than k; in another tile by a guess, and with the same branch."""
    model = load("wobbling")
    axes = (np.array([22.0, 22.5, 23.0]), np.array([0.24, 0.25]))
    fixed = {n: v for n, v in model.preset.items() if n not in ("k", "alpha")}
    start = Line((22.5,), {"alpha": 0.25}).cycles(22.5).u[0]
    results = []
    for cells in (np.arange(6), np.array([1, 3, 5])):
        task = Task(
            model, Grid(("k", "alpha"), axes), fixed, SearchOptions(starts=1, period_min=0.3, period_max=3.0),
            AcceptanceOptions(), IN_SWEEPS, Lanes(), round=1, tile=3, cells=cells,
            seeds=np.array([], dtype=np.int64),
            incoming=Guesses(np.array([3]), start[None], np.array([NONE]), np.array([3])),
            known=Solutions.empty(6), seen=Solutions.empty(6),
        )  # fmt: skip
        results.append(work(task))
        if len(results) == 1:
            joins = connected(task, results[0])
    whole, part = results
    assert whole.orbits["cell"].tolist() == [0, 1, 2, 3, 4, 5]
    assert set(families(whole.orbits["branch"], joins)) == {0}
    assert part.orbits["cell"].tolist() == [1, 3, 5]
    assert set(part.outgoing.cell.tolist()) <= {0, 2, 4}
    assert len(part.outgoing) > 0
    assert set(part.outgoing.branch.tolist()) <= set(part.seen.branch.tolist())


def beside_a_known_cycle(continuation=IN_SWEEPS, **more):
    """A task with a cycle that is known at alpha = 0.25, and a guess for it from the one at 0.24."""
    model = load("wobbling")
    axes = (np.array([22.0, 22.5, 23.0]), np.array([0.24, 0.25]))
    fixed = {n: v for n, v in model.preset.items() if n not in ("k", "alpha")}
    there, here = (Line((22.5,), {"alpha": alpha}).cycles(22.5).u[:1] for alpha in axes[1])
    assert 1e-4 < np.abs((there - here) / Scales.of(model).unknowns).max() < BESIDE
    seen = Solutions(np.array([3]), here, np.array([5]))
    return Task(
        model, Grid(("k", "alpha"), axes), fixed, SearchOptions(starts=1, period_min=0.3, period_max=3.0),
        AcceptanceOptions(), continuation, Lanes(), round=2, tile=0, cells=np.array([1, 3, 5]),
        seeds=np.array([], dtype=np.int64),
        incoming=Guesses(np.array([3]), there, np.array([10**12]), np.array([2])),
        known=seen, seen=seen, **more,
    )  # fmt: skip


def test_no_search_begins_beside_a_known_cycle_and_yet_the_branches_are_one(monkeypatch):
    monkeypatch.setattr(Solver, "quick_search", refuse)
    task = beside_a_known_cycle()
    found = work(task)
    assert not found.failures
    assert not len(found.orbits["cell"])
    assert not len(found.joins)
    assert found.links.origin.tolist() == [2]
    assert connected(task, found).tolist() == [[10**12, 5]]


def test_a_link_that_cannot_be_followed_is_a_failure_of_its_cell_alone(monkeypatch):
    task = beside_a_known_cycle()
    one = work(task).links
    follow = connections.follow

    def odd(solver, u, *args, **kwargs):
        if (u[:, -1] > 100).any():
            raise ArithmeticError("odd")
        return follow(solver, u, *args, **kwargs)

    monkeypatch.setattr(connections, "follow", odd)
    both = Guesses(
        np.append(one.cell, 1), np.concatenate([one.u, np.full((1, 6), 999.0)]),
        np.append(one.branch, 10**13), np.append(one.origin, 0),
    )  # fmt: skip
    found = connect(replace(task, incoming=both))
    assert found.failures == {1: "ArithmeticError: odd"}
    assert found.joins.tolist() == [[10**12, 5]]


def test_a_branch_that_turns_back_on_the_way_to_the_next_cell_does_not_join_what_is_there():
    """From omega = 3.5 it turns at 3.4479; steps as long as the way came to a cycle at 3.0 all the same."""
    model = load("wobbling")
    solver, fixed = Solver.for_model(model), {**model.preset, "k": 48.5, "alpha": 0.15}
    here, there = (
        solver.polished(np.array([guess]), model.point({**fixed, "omega": omega})[None])[0]
        for omega, guess in (
            (3.5, [0.0957279563, -0.11139562, -0.00203539487, -0.000114391204, -0.0100791512, 2.8418366]),
            (3.0, [0.0956744072, -0.103831352, -0.00190506689, 0.000147257168, 0.0152833862, 3.27227241]),
        )
    )
    ends = (model.point({**fixed, "omega": omega})[None] for omega in (3.5, 3.0))
    short = replace(IN_SWEEPS, ds=5e-4, ds_max=5e-3)
    curve = continuation.follow(solver, here, np.zeros(1), *ends, (0.2, 3.45), short, upwards=True).x
    assert curve[-1, -1] == 0.0
    assert curve[:, -1].max() == pytest.approx((3.5 - 3.4479) / 0.5, abs=1e-3)
    fixed.pop("omega"), fixed.pop("k")
    task = Task(
        model, Grid(("k", "omega"), (np.array([48.5]), np.array([3.0, 3.5]))), fixed,
        SearchOptions(starts=1, period_min=0.3, period_max=3.0), AcceptanceOptions(), IN_SWEEPS, Lanes(),
        round=2, tile=0, cells=np.array([0]), seeds=np.array([], dtype=np.int64),
        incoming=Guesses(np.array([0]), here, np.array([7]), np.array([1])),
        known=Solutions.empty(6),
        seen=Solutions(np.array([0, 1]), np.vstack([there, here]), np.array([5, 7])),
    )  # fmt: skip
    found = connect(task)
    assert not found.failures
    assert not len(found.joins)


def refuse(*args, **kwargs):
    """In the place of what must not be called."""
    raise AssertionError("called")


def test_families_are_one_only_where_following_leads_from_one_to_the_other():
    """From another cycle at alpha = 0.24 a search at 0.33 ends on the branch of the first."""
    model = load("wobbling")
    axes = (np.array([13.99, 14.0, 14.01]), np.array([0.24, 0.33]))
    solver, fixed = Solver.for_model(model), {**model.preset, "omega": 3.0}
    cycles = Line((14.0,), {"alpha": 0.24, "omega": 3.0}).cycles(14.0).u[[0, 2]]
    # In steps so small that Newton's method stays on their branches they come to two cycles.
    ends, farthest = cycles.copy(), np.zeros(2)
    for alpha in np.linspace(0.24, 0.33, 501)[1:]:
        ends, moved = solver.polished(
            ends, np.tile(model.point({**fixed, "k": 14.0, "alpha": alpha}), (2, 1))
        )
        farthest = np.maximum(farthest, moved)
    assert (farthest < 1e-2).all()
    searched, _ = solver.search(cycles, np.tile(model.point({**fixed, "k": 14.0, "alpha": 0.33}), (2, 1)))
    scale = Scales.of(model).unknowns
    assert (np.abs((searched - ends[0]) / scale) < 1e-2).all()
    assert np.abs((searched - ends[1]) / scale).max() > 0.1

    task = Task(
        model, Grid(("k", "alpha"), axes), {n: v for n, v in fixed.items() if n not in ("k", "alpha")},
        SearchOptions(starts=1, period_min=0.3, period_max=3.0), AcceptanceOptions(), ContinuationOptions(),
        Lanes(), round=1, tile=0, cells=np.array([1, 3, 5]), seeds=np.array([], dtype=np.int64),
        incoming=Guesses(np.array([3, 3]), cycles, np.array([10**12, 10**13]), np.array([2, 2])),
        known=Solutions.empty(6), seen=Solutions.empty(6),
    )  # fmt: skip
    found = work(task)
    here = found.seen.branch[np.abs((found.seen.u - ends[0]) / scale).max(axis=1).argmin()]
    first, second, own = families(np.array([10**12, 10**13, here]), connected(task, found))
    assert first == own
    assert second != own


def test_long_arclength_steps_are_long_from_cell_to_cell_as_well():
    """A shortest step above the first one that is taken there is no failure of the cell."""
    task = beside_a_known_cycle(continuation=replace(IN_SWEEPS, ds_min=0.5, ds=0.5, ds_max=0.5))
    found = work(task)
    assert not found.failures
    assert connected(task, found).tolist() == [[10**12, 5]]


def test_a_fold_just_beyond_a_cell_does_not_hide_its_two_cycles(monkeypatch):
    """At k = 42.5 the stable gait and another one are 0.0013 from the fold in which they meet."""
    k = tuple(np.linspace(0.5, 60.0, 120))
    line = Line(k, {"alpha": 0.95, "omega": 3.0}, continuation=IN_SWEEPS_OF_CYCLES)
    start = line.cycles(43.0).u[0]
    for beyond, found in ((0.0, 1), (tiles.BEYOND, 3)):
        monkeypatch.setattr(tiles, "BEYOND", beyond)
        result = line.result([(k.index(43.0), start)])
        # Of which branch they are is known when they were followed.
        assert (result.seen.branch != NONE).all() and (result.joins != NONE).all()
        rows = result.orbits
        here = rows["cell"] == k.index(42.5)
        assert np.count_nonzero(here) == found
    (stable,) = rows["period"][here][rows["stable"][here]]
    assert np.abs(line.cycles(42.5).period - stable).min() < 1e-10


def test_a_cycle_is_not_lost_that_is_far_from_where_its_branch_seems_to_pass(monkeypatch):
    """Near folds that nearly meet the way from a branch to its solution in a cell may be long."""
    line = Line((49.5, 50.0, 50.5, 51.0), {"alpha": 0.15, "omega": 2.0})
    start = line.cycles(51.0).u[-1]
    periods = line.cycles(50.5).period
    for same_branch in (tiles.SAME_BRANCH, 1e-12):
        monkeypatch.setattr(tiles, "SAME_BRANCH", same_branch)
        rows = line.result([(3, start)]).orbits
        here = rows["period"][rows["cell"] == 2]
        assert len(here)
        for period in here:
            assert np.abs(periods - period).min() < 1e-10


def test_a_gait_is_found_from_one_beside_it_to_which_only_its_tangent_leads(monkeypatch):
    """From alpha = 0.9125 to 0.925 at the softest spring."""
    model = load("wobbling")
    axes = (np.array([0.5, 0.55, 0.6]), np.array([0.9125, 0.925]))
    fixed = {n: v for n, v in model.preset.items() if n not in ("k", "alpha")}
    start = Line((0.5,), {"alpha": 0.9125}).cycles(0.5).u[:1]
    task = Task(
        model, Grid(("k", "alpha"), axes), fixed, SearchOptions(starts=1, period_min=0.3, period_max=3.0),
        AcceptanceOptions(), IN_SWEEPS, Lanes(), round=1, tile=0, cells=np.array([1]),
        seeds=np.array([], dtype=np.int64),
        incoming=Guesses(np.array([1]), start, np.array([NONE]), np.array([0])),
        known=Solutions.empty(6), seen=Solutions.empty(6),
    )  # fmt: skip
    (period,) = work(task).orbits["period"]
    assert np.abs(Line((0.5,), {"alpha": 0.925}).cycles(0.5).period - period).min() < 1e-10
    monkeypatch.setattr(Solver, "predicted", lambda solver, u, params, target: u)
    assert not len(work(task).orbits["period"])


def test_a_search_from_another_cell_begins_where_the_tangent_leads_and_is_short(monkeypatch):
    begun = []
    search = Solver.quick_search

    def recorded(solver, u, p, steps):
        begun.append((u, steps))
        return search(solver, u, p, steps)

    monkeypatch.setattr(Solver, "quick_search", recorded)
    task = replace(beside_a_known_cycle(), known=Solutions.empty(6), seen=Solutions.empty(6))
    found = work(task)
    assert len(found.orbits["cell"])
    ((first, steps),) = [(u, steps) for u, steps in begun[:2] if len(u)]
    assert steps == tiles.NEWTON_STEPS_ACROSS < 10
    assert first.shape == task.incoming.u.shape == (1, 6)
    off = np.abs(first - task.incoming.u).max()
    assert 0.01 < off < 0.5
    # The families are joined.
    assert 10**12 in found.links.branch
