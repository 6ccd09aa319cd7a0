"""Branches of limit cycles: where they lead, past folds and not across to other branches."""

from dataclasses import replace

import numpy as np
import pytest

from stridemap.solver.branches import continuation
from stridemap.solver.branches.arcs import Lines
from stridemap.solver.branches.continuation import Followed, Known, follow
from stridemap.solver.cycles.search import find_all
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.model.loading import load
from stridemap.solver.model.scales import Scales
from stridemap.solver.options import IN_SWEEPS, IN_SWEEPS_OF_CYCLES
from tests.oracles.reference import REFERENCE, TWO_CYCLES

RANGE = (0.3, 3.0)
ENDS = np.array([0.0, 1.0])


def cycles_at(model, **params):
    """Section points with periods of every cycle at a point, and the point."""
    p = model.point(params)
    return find_all(Solver.for_model(model), p[None])[1].u, p


def followed(model, u, start, target, options=None, s=0.0, **more):
    """Branches from cycles at one position of one line."""
    m = len(u)
    ends = (np.tile(start, (m, 1)), np.tile(target, (m, 1)))
    return follow(Solver.for_model(model), u, np.full(m, s), *ends, RANGE, options, **more)


def at_target(crossings):
    """What reaches the end of the line."""
    return crossings.u[crossings.position == 1]


def converged(model, u, p):
    """The cycle that Newton's method makes of a guess."""
    solver = Solver.for_model(model)
    near, _ = solver.search(u[None], p[None])
    orbits = solver.converge(near, p[None], RANGE)
    assert orbits.found.all()
    return orbits.u[0]


@pytest.mark.parametrize(
    ("name", "start", "target"),
    [
        ("wobbling", {"k": 0.5}, {"k": 0.6}),
        ("wobbling", {"k": 8.0, "omega": 2.5}, {"k": 5.0, "omega": 2.5}),
        ("wobbling", {"k": 12.0, "alpha": 0.5}, {"k": 13.0, "alpha": 0.48, "omega": 2.9}),
        ("compass", {"omega": 3.0}, {"omega": 2.5}),
    ],
)
def test_branch_reaches_a_cycle_of_the_target(name, start, target):
    model = load(name)
    u, p = cycles_at(model, **start)
    there, q = cycles_at(model, **target)
    ends = at_target(followed(model, u, p, q).crossings(ENDS))
    assert len(ends)
    for end in ends:
        assert np.abs(there - converged(model, end, q)).max(axis=1).min() < 1e-9


@pytest.mark.quick
def test_fold_leads_to_the_other_cycle_of_the_pair():
    """Both cycles of the reference file at one point: towards a softer spring they meet in a fold."""
    model = load("wobbling")
    both = [e for e in REFERENCE if TWO_CYCLES.items() <= e["params"].items()]
    u = np.array([[*e["state"].values(), e["period"]] for e in both])
    p = model.point(TWO_CYCLES)
    for one, other in ((0, 1), (1, 0)):
        ends = followed(model, u[[one]], p, model.point({**TWO_CYCLES, "k": 3.0})).crossings(ENDS)
        assert ends.position.tolist() == [0]
        np.testing.assert_allclose(converged(model, ends.u[0], p), u[other], rtol=0, atol=1e-10)


def test_what_a_branch_passes_on_its_way_is_the_cycle_there():
    """At each of twenty springs, and on both sides of where it begins."""
    model = load("wobbling")
    k = np.linspace(20.0, 25.0, 21)
    middle = k[10]
    u, _ = cycles_at(model, k=middle)
    found = followed(model, u, model.point({"k": k[0]}), model.point({"k": k[-1]}), s=0.5)
    passed = found.crossings(np.linspace(0, 1, 21))
    scale = Scales.of(model).unknowns
    for branch, begin in enumerate(u):
        here = passed.branch == branch
        for position, guess in zip(passed.position[here], passed.u[here], strict=True):
            cycle = converged(model, guess, model.point({"k": k[position]}))
            assert np.abs((cycle - guess) / scale).max() < 1e-3
            assert np.abs((cycle - begin) / scale).max() > 3e-3  # they differ by more from one another
    # A fold lies between the springs of positions 6 and 7, and the line ends at 20.
    assert len(u) == 2
    assert set(passed.position.tolist()) == set(range(7, 21))


def test_following_back_returns():
    model = load("wobbling")
    u, p = cycles_at(model, k=22.5)
    q = model.point({"k": 23.5})
    there = at_target(followed(model, u, p, q).crossings(ENDS))
    assert len(there) == len(u)
    ends = at_target(
        followed(model, np.array([converged(model, end, q) for end in there]), q, p).crossings(ENDS)
    )
    for end, start in zip(ends, u, strict=True):
        np.testing.assert_allclose(converged(model, end, p), start, rtol=0, atol=1e-10)


def test_where_branches_are_given_up_does_not_depend_on_other_lines():
    """Each line is as it is alone: when its way back begins, and when gaits are looked for."""
    model = load("wobbling")
    solver = Solver.for_model(model)
    alphas = np.repeat(np.linspace(0.2, 0.5, 5), 4)
    springs = np.tile([4.0, 9.0, 14.0, 19.0], 5)
    points = np.array([model.point({"k": k, "alpha": a}) for k, a in zip(springs, alphas, strict=True)])
    at, cycles = find_all(solver, points)
    k = model.spec.names.index("k")
    start, target = points[at].copy(), points[at].copy()
    start[:, k], target[:, k] = 0.5, 60.0
    s = (points[at][:, k] - 0.5) / 59.5

    def run(rows):
        return follow(
            solver, cycles.u[rows], s[rows], start[rows], target[rows], RANGE,
            may_be_gaits=lambda u, params: np.zeros(len(u), dtype=bool),
        )  # fmt: skip

    together = run(np.arange(len(at)))
    lengths = []
    for alpha in np.unique(alphas):
        rows = np.flatnonzero(alphas[at] == alpha)
        alone = run(rows)
        mine = np.isin(together.branch, rows)
        lengths.append(mine.sum())
        np.testing.assert_array_equal(rows[alone.branch], together.branch[mine])
        np.testing.assert_array_equal(alone.ahead, together.ahead[mine])
        np.testing.assert_array_equal(alone.x, together.x[mine])
    assert len(set(lengths)) > 1
    assert (~together.ahead).sum() > 100


def test_branches_on_different_lines_do_not_depend_on_each_other():
    model = load("wobbling")
    u, p = cycles_at(model, k=22.5)
    targets = np.array([model.point({"k": k, "omega": w}) for k in (19.5, 23.5) for w in (2.6, 3.0)])
    m = len(targets)
    together = follow(Solver.for_model(model), u[[0] * m], np.zeros(m), np.tile(p, (m, 1)), targets, RANGE)
    for row in range(m):
        alone = followed(model, u[:1], p, targets[row])
        here = together.branch == row
        assert here.sum() > 4
        np.testing.assert_array_equal(alone.x, together.x[here])
        np.testing.assert_array_equal(alone.tangent, together.tangent[here])


def test_a_branch_ends_where_another_one_begins_that_it_leads_to():
    """Both cycles of the pair are on one curve through the fold: together they are followed once."""
    model = load("wobbling")
    both = [e for e in REFERENCE if TWO_CYCLES.items() <= e["params"].items()]
    u = np.array([[*e["state"].values(), e["period"]] for e in both])
    line = [model.point({**TWO_CYCLES, "k": k}) for k in (3.0, TWO_CYCLES["k"] + 1.0)]
    s = (TWO_CYCLES["k"] - 3.0) / (TWO_CYCLES["k"] - 2.0)
    alone = [len(followed(model, u[[i]], *line, s=s).x) for i in (0, 1)]
    together = followed(model, u, *line, s=s)
    assert len(together.x) < 0.75 * sum(alone)
    # One of them goes around the fold to where the other begins, which goes on from there.
    sides = [
        np.count_nonzero((together.branch == i) & (together.ahead == ahead))
        for i in (0, 1)
        for ahead in (False, True)
    ]
    assert sorted(sides)[0] <= 1 < sorted(sides)[1]
    # All springs are passed as often as by one of them alone.
    positions = np.linspace(0, 1, 41)
    one = followed(model, u[[0]], *line, s=s).crossings(positions)
    both_ = together.crossings(positions)
    for position in range(41):
        assert (both_.position == position).any() == (one.position == position).any()
    # A cycle that is known ends it as well.
    known = Known(u[[1]], np.array([s]), np.array([0]))
    assert len(followed(model, u[[0]], *line, s=s, known=known).x) < alone[0]


def test_a_branch_without_gaits_ends_when_patience_does(monkeypatch):
    model = load("wobbling")
    u, p = cycles_at(model, k=22.5)
    q = model.point({"k": 30.5})
    short = replace(IN_SWEEPS, ds=0.02, ds_max=0.02)
    whole = followed(model, u[:1], p, q, short)
    monkeypatch.setattr(continuation, "PATIENCE", 0.1)
    none = followed(
        model, u[:1], p, q, short,
        may_be_gaits=lambda u, params: np.zeros(len(u), dtype=bool),
    )  # fmt: skip
    all_ = followed(
        model, u[:1], p, q, short,
        may_be_gaits=lambda u, params: np.ones(len(u), dtype=bool),
    )  # fmt: skip
    assert len(none.x) < len(whole.x)
    np.testing.assert_array_equal(all_.x, whole.x)


@pytest.mark.parametrize(
    ("params", "u"),
    [
        (
            {"k": 27.0, "alpha": 0.175, "omega": 3.5},
            [0.0882372883, -0.1821493378, -0.00282901, 2.20928e-05, 0.0047700203, 1.0802338664],
        ),
        (
            {"k": 3.0, "alpha": 0.2, "omega": 2.0},
            [0.091476799, -0.1299768153, -0.0021692324, 0.000966037, 0.0517305023, 1.7089565070],
        ),
    ],
)
def test_steps_as_long_as_in_sweeps_do_not_stray_to_a_curve_beside(params, u):
    """Along a whole line of the default sweep, steps of at most 0.02 pass the same cycles."""
    model, positions = load("wobbling"), np.linspace(0, 1, 120)
    solver, at = Solver.for_model(model), (params["k"] - 0.5) / 59.5
    start, target = (model.point({**params, "k": k}) for k in (0.5, 60.0))
    short = replace(IN_SWEEPS, ds=0.002, ds_max=0.02, max_steps=5000, easy_tangent_cosine=0.995)
    cycles = []
    for options in (short, replace(IN_SWEEPS_OF_CYCLES, max_steps=1000)):
        passed = followed(model, np.array([u]), start, target, options, at, upwards=True).crossings(positions)
        there = start + positions[passed.position, None] * (target - start)
        solved, moved = solver.polished(passed.u, there)
        assert (moved < 0.05).all()
        order = np.lexsort((solved[:, -1], passed.position))
        cycles.append(np.column_stack([passed.position, solved])[order])
    assert len(cycles[0]) > 15
    np.testing.assert_allclose(cycles[1], cycles[0], rtol=0, atol=1e-4)


def test_options_bound_the_steps():
    model = load("wobbling")
    u, p = cycles_at(model, k=22.5)
    q = model.point({"k": 23.5})
    ends = at_target(followed(model, u, p, q).crossings(ENDS))
    assert len(ends) == len(u)
    # In one step of a tenth of the whole distance no branch gets to its end.
    short = replace(IN_SWEEPS, ds=0.1, ds_max=0.1, max_steps=1)
    assert not len(at_target(followed(model, u, p, q, short).crossings(ENDS)))
    fine = at_target(followed(model, u, p, q, replace(IN_SWEEPS, ds=0.02, ds_max=0.02)).crossings(ENDS))
    for end, other in zip(fine, ends, strict=True):
        np.testing.assert_allclose(converged(model, end, q), converged(model, other, q), rtol=0, atol=1e-10)


def test_hopeless_branches_end_nowhere():
    model = load("wobbling")
    u, p = cycles_at(model, k=6.0)
    q = model.point({"k": 6.5})
    bad = np.array([np.full(6, np.nan), np.full(6, np.inf), np.full(6, 1e200)])
    ends = followed(model, np.concatenate([bad, u]), p, q).crossings(ENDS)
    assert ends.branch.min() == len(bad)
    assert not len(followed(model, bad, p, q).crossings(ENDS).u)
    assert not len(followed(model, u[:0], p, q).crossings(ENDS).u)
    # A branch that leaves the range of periods is given up.
    period = u[0, -1]
    solver, rows = Solver.for_model(model), (p[None], model.point({"k": 3.0})[None])
    narrow = follow(solver, u[:1], np.zeros(1), *rows, (period - 1e-4, period + 1e-4))
    assert len(narrow.x) < 5


def test_beyond_a_fold_a_branch_is_looked_for_on_both_sides_of_it():
    """A parabola that turns back at s = 0.5, at what it would be for a fold a little farther on."""
    u = np.array([-0.3, -0.05, 0.1, 0.3])
    tangent = np.column_stack([np.ones(4), -2 * u])
    tangent /= np.linalg.norm(tangent, axis=1)[:, None]
    curve = Followed(
        np.ones(2),
        np.zeros(4, dtype=np.int64),
        np.ones(4, dtype=bool),
        np.column_stack([u, 0.5 - u**2]),
        tangent,
    )
    positions = np.array([0.0, 0.46, 0.504, 1.0])
    passed = curve.crossings(positions)
    np.testing.assert_allclose(passed.u[:, 0], [-0.2, 0.2], atol=1e-3)
    assert passed.position.tolist() == [1, 1]
    passed = curve.crossings(positions, beyond=0.005)
    np.testing.assert_allclose(passed.u[:, 0], [-0.2, -np.sqrt(0.004), np.sqrt(0.004), 0.2], atol=4e-3)
    assert passed.position.tolist() == [1, 2, 2, 1]
    assert curve.crossings(positions, beyond=0.003).position.tolist() == [1, 1]
    other = Followed(
        np.ones(2), curve.branch, curve.ahead, np.column_stack([u, 0.5 + u**2]), tangent * [1.0, -1.0]
    )
    assert other.crossings(np.array([0.496, 0.54]), beyond=0.005).position.tolist() == [1, 0, 0, 1]


@pytest.mark.parametrize(("k", "low", "high"), [(22.7, 0.5, 60.0), (22.7, 22.5, 23.0), (8.2, 8.0, 8.5)])
def test_the_derivative_along_a_line_is_exact(k, low, high):
    """It is that of the kernel with two directions, however short the line."""
    model = load("wobbling")
    u, _ = cycles_at(model, k=k)
    start, target = (np.tile(model.point({"k": end}), (len(u), 1)) for end in (low, high))
    solver = Solver.for_model(model)
    lines = Lines(solver, start, target)
    s = np.full((len(u), 1), (k - low) / (high - low))
    at = np.arange(len(u))
    matrix, _ = lines.system(at, np.hstack([u, s]), np.full(len(u), 96))
    along = np.hstack([np.zeros_like(u), target - start])
    exact = solver.kernels.directional(96, u, lines.point(at, s), along, along).along_a
    error = np.abs(matrix[:, :-1, -1] - exact).max(axis=1) / np.abs(exact).max(axis=1)
    assert (error < 1e-12).all(), error
