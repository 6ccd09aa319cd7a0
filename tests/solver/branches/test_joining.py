"""Branches hold every cycle once, go around folds and not across gaps, and find again what was left out."""

import numpy as np
import pytest

from stridemap.solver.branches.following import MAX_CHANGE
from stridemap.solver.branches.joining import BETWEEN, FOLD_DISTANCE, branches
from stridemap.solver.branches.main_branch import fixed_point_index
from stridemap.solver.cycles.orbits import Orbits


@pytest.fixture(scope="module")
def joined(solver, line):
    return branches(solver, line.orbits, "k", line.k)


def test_every_cycle_is_on_one_branch(line, joined):
    rows = np.concatenate([branch.row[branch.on_grid] for branch in joined])
    assert sorted(rows.tolist()) == list(range(len(line.orbits)))
    for branch in joined:
        np.testing.assert_array_equal(
            branch.orbits.u[branch.on_grid], line.orbits.u[branch.row[branch.on_grid]]
        )
        between = branch.orbits.params[~branch.on_grid, 0]
        assert (branch.row[~branch.on_grid] == BETWEEN).all()
        assert not np.isin(between, line.k).any()


def test_branches_do_not_cross_a_gap(joined):
    assert [set(branch.orbits.group) for branch in joined] == [{"A"}, {"B"}, {"C"}]
    assert [len(branch.orbits) > 1 for branch in joined] == [True] * 3


def test_a_branch_changes_its_index_where_it_turns_back(joined):
    turns = 0
    for branch in joined:
        index, k = fixed_point_index(branch.orbits.multipliers), branch.orbits.params[:, 0]
        changes = np.flatnonzero(index[1:] != index[:-1])
        turns += len(changes)
        for i in changes:
            assert np.abs(branch.orbits.u[i + 1] - branch.orbits.u[i]).max() < FOLD_DISTANCE
            inner, outer = k[max(0, i - 5)], k[i + 6]
            assert (k[i] - inner) * (k[i + 1] - outer) > 0
        assert np.abs(np.diff(branch.orbits.u, axis=0)).max() < MAX_CHANGE
    assert turns >= 2


def test_a_removed_cycle_is_found_again(solver, line):
    """From both sides of its value, where two branches end, as no search found a cycle there."""
    k = line.orbits.params[:, 0]
    kept, removed = line.orbits.take((k >= 7) & (k <= 9) & (k != 8)), line.orbits.take(k == 8)
    values = line.k[(line.k >= 7) & (line.k <= 9)]
    below, above = branches(solver, kept, "k", values)
    for branch, end in ((below, -1), (above, 0)):
        assert branch.orbits.params[end, 0] == 8.0
        assert branch.row[end] == BETWEEN
        np.testing.assert_allclose(branch.orbits.u[end], removed.u[0], rtol=0, atol=1e-10)
    # At values that were never searched, a branch goes on.
    (one,) = branches(solver, kept, "k", values[values != 8.0])
    np.testing.assert_array_equal(one.row[one.on_grid], np.arange(4))


def test_branches_are_ordered_by_where_they_begin(joined):
    begins = [(branch.orbits.params[0, 0], branch.orbits.period[0]) for branch in joined]
    assert begins == sorted(begins)


def test_no_cycles(solver, line):
    assert branches(solver, Orbits.empty(solver.model), "k", line.k) == []


def test_a_cycle_at_another_value_is_refused(solver, line):
    with pytest.raises(ValueError, match="values of k that are not among the 17 given"):
        branches(solver, line.orbits, "k", line.k[1:])
