"""Cycles followed to other values of a parameter: where they get, and where they end."""

import numpy as np

from stridemap.solver.branches import following
from stridemap.solver.branches.following import MAX_CHANGE, follow_parameter
from stridemap.solver.branches.main_branch import fixed_point_index
from stridemap.solver.cycles.orbits import Orbits
from stridemap.solver.cycles.search import continued


def test_a_cycle_that_was_removed_is_found_again(solver, line):
    k = line.orbits.params[:, 0]
    removed, kept = line.orbits.take(k == 8.5), line.orbits.take(k != 8.5)
    starts = kept.take(np.isin(kept.params[:, 0], (8.0, 9.0)))
    paths = follow_parameter(solver, starts, "k", np.full(len(starts), 8.5))
    assert len(removed) == 1 and len(starts) == 2
    for path in paths:
        assert path.reached
        assert path.orbits.params[-1, 0] == 8.5
        np.testing.assert_allclose(path.orbits.u[-1], removed.u[0], rtol=0, atol=1e-10)


def test_other_parameters_can_be_followed(solver, find):
    starts, there = find(k=8.0, alpha=0.25), find(k=8.0, alpha=0.3)
    (path,) = follow_parameter(solver, starts, "alpha", np.array([0.3]))
    assert path.reached
    np.testing.assert_allclose(path.orbits.u[-1], there.u[0], rtol=0, atol=1e-10)
    assert np.unique(np.delete(path.orbits.params, 1, axis=1), axis=0).shape[0] == 1


def test_branches_end_at_a_fold_where_they_meet(solver, find):
    both = find(k=6.0)
    paths = follow_parameter(solver, both, "k", np.full(2, 5.5))
    assert fixed_point_index(both.multipliers).tolist() == [-1, 1]
    assert not any(path.reached for path in paths)
    one, other = (path.orbits for path in paths)
    assert np.abs(one.u[-1] - other.u[-1]).max() < 0.02
    assert abs(one.params[-1, 0] - other.params[-1, 0]) < 1e-4
    for start, path in zip(both, paths, strict=True):
        steps = np.diff([start.section_point, *path.orbits.u], axis=0)
        assert np.abs(steps).max() < MAX_CHANGE
        assert len(set(fixed_point_index(path.orbits.multipliers))) == 1
        # At a fold a multiplier is 1.
        before, after = (
            np.abs(np.array(one) - 1).min() for one in (start.multipliers, path.orbits[-1].multipliers)
        )
        assert after < before / 4


def test_the_other_cycle_beside_a_fold_is_not_a_step_along_the_branch(solver, find, monkeypatch):
    """Even where Newton's method goes astray and always ends at the other one, which is not far."""
    both = find(k=5.961, starts=128)
    assert fixed_point_index(both.multipliers).tolist() == [-1, 1]
    assert np.abs(both.scaled[0] - both.scaled[1]).max() < 0.8 * MAX_CHANGE

    def astray(solver, points, guesses, options):
        return continued(solver, points, np.repeat(both.u[:1], len(points), axis=0), options)

    monkeypatch.setattr(following, "continued", astray)
    (other,) = follow_parameter(solver, both.take([1]), "k", np.array([5.9612]))
    assert (other.reached, len(other.orbits)) == (False, 0)
    (own,) = follow_parameter(solver, both.take([0]), "k", np.array([5.9612]))
    assert own.reached


def test_branches_do_not_depend_on_each_other(solver, line):
    starts = line.orbits.take(np.isin(line.orbits.params[:, 0], (6.0, 9.0)))
    target = starts.params[:, 0] - 0.2
    together = follow_parameter(solver, starts, "k", target)
    assert {path.reached for path in together} == {True, False}
    for i, path in enumerate(together):
        (alone,) = follow_parameter(solver, starts.take([i]), "k", target[[i]])
        assert alone.reached == path.reached
        np.testing.assert_array_equal(alone.orbits.u, path.orbits.u)
        np.testing.assert_array_equal(alone.orbits.params, path.orbits.params)


def test_no_cycles(solver):
    assert follow_parameter(solver, Orbits.empty(solver.model), "k", np.empty(0)) == []
