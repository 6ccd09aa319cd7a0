"""Branches of limit cycles: where they lead, past folds and not across to other branches."""

import numpy as np
import pytest

from stridemap.solver.branches.continuation import follow
from stridemap.solver.cycles.search import find_all
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.model.loading import load
from stridemap.solver.options import ContinuationOptions
from tests.oracles.reference import REFERENCE, TWO_CYCLES

RANGE = (0.3, 3.0)


def cycles_at(model, **params):
    """Section points with periods of every cycle at a point, and the point."""
    p = model.point(params)
    return find_all(Solver.for_model(model), p[None])[1].u, p


def followed(model, u, start, target):
    m = len(u)
    return follow(Solver.for_model(model), u, np.tile(start, (m, 1)), np.tile(target, (m, 1)), RANGE)


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
    ends = followed(model, u, p, q)
    assert ends.reached.any()
    for end in ends.u[ends.reached]:
        assert np.abs(there - converged(model, end, q)).max(axis=1).min() < 1e-9


@pytest.mark.quick
def test_fold_leads_to_the_other_cycle_of_the_pair():
    """Both cycles of the reference file at one point: towards a softer spring they meet in a fold."""
    model = load("wobbling")
    both = [e for e in REFERENCE if TWO_CYCLES.items() <= e["params"].items()]
    u = np.array([[*e["state"].values(), e["period"]] for e in both])
    p = model.point(TWO_CYCLES)
    ends = followed(model, u, p, model.point({**TWO_CYCLES, "k": 3.0}))
    assert ends.branch.tolist() == [0, 1]
    assert not ends.reached.any()
    for end, other in zip(ends.u, u[::-1], strict=True):
        np.testing.assert_allclose(converged(model, end, p), other, rtol=0, atol=1e-10)


def test_following_back_returns():
    model = load("wobbling")
    u, p = cycles_at(model, k=22.5)
    q = model.point({"k": 23.5})
    there = followed(model, u, p, q)
    assert there.reached.all() and len(there.branch) == len(u)
    ends = followed(model, np.array([converged(model, end, q) for end in there.u]), q, p)
    assert ends.reached.all()
    for end, start in zip(ends.u, u, strict=True):
        np.testing.assert_allclose(converged(model, end, p), start, rtol=0, atol=1e-10)


def test_branches_do_not_depend_on_each_other():
    model = load("wobbling")
    u, p = cycles_at(model, k=22.5)
    targets = np.array([model.point({"k": k, "omega": w}) for k in (19.5, 23.5) for w in (2.6, 3.0)])
    at, to = np.repeat(np.arange(len(u)), 4), np.tile(np.arange(4), len(u))
    together = follow(Solver.for_model(model), u[at], np.tile(p, (len(at), 1)), targets[to], RANGE)
    assert len(together.branch) > 4
    for row, (i, j) in enumerate(zip(at, to, strict=True)):
        alone = follow(Solver.for_model(model), u[[i]], p[None], targets[[j]], RANGE)
        here = together.branch == row
        np.testing.assert_array_equal(alone.u, together.u[here])
        np.testing.assert_array_equal(alone.reached, together.reached[here])


def test_options_bound_the_steps():
    model = load("wobbling")
    u, p = cycles_at(model, k=22.5)
    rows = Solver.for_model(model), u, np.tile(p, (len(u), 1)), np.tile(model.point({"k": 23.5}), (len(u), 1))
    assert follow(*rows, RANGE).reached.all()
    # In one step of a tenth of the whole distance no branch gets to its end.
    assert len(follow(*rows, RANGE, ContinuationOptions(ds_max=0.1, max_steps=1)).branch) == 0
    fine = follow(*rows, RANGE, ContinuationOptions(ds_max=0.1, max_steps=200))
    for end, other in zip(fine.u, follow(*rows, RANGE).u, strict=True):
        q = model.point({"k": 23.5})
        np.testing.assert_allclose(converged(model, end, q), converged(model, other, q), rtol=0, atol=1e-10)


def test_hopeless_branches_end_nowhere():
    model = load("wobbling")
    u, p = cycles_at(model, k=6.0)
    q = model.point({"k": 6.5})
    bad = np.array([np.full(6, np.nan), np.full(6, np.inf), np.full(6, 1e200)])
    ends = followed(model, np.concatenate([bad, u]), p, q)
    assert ends.branch.min() == len(bad)
    assert len(followed(model, bad, p, q).branch) == 0
    assert len(followed(model, u[:0], p, q).branch) == 0
    # A branch that leaves the range of periods is given up.
    period = u[0, -1]
    solver, rows = Solver.for_model(model), (p[None], model.point({"k": 3.0})[None])
    assert len(follow(solver, u[:1], *rows, (period - 1e-4, period + 1e-4)).branch) == 0
