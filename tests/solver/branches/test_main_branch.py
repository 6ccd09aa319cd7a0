"""Which cycles stable walking leads to without a fold."""

import numpy as np

from stridemap.solver.branches.main_branch import fixed_point_index, on_main_branch
from stridemap.solver.cycles.orbits import Orbits
from stridemap.solver.model.loading import load


def sheet(k, period, multiplier, stable=False, **others):
    """Made-up cycles over `k`: real multipliers, of which the first is given and the others are 0."""
    model, n = load("wobbling"), len(k)
    values = {**model.preset, **others, "k": k, "period": period, "stable": stable, "status": "converged"}
    values |= dict.fromkeys(model.section, 0.0)
    for i in range(len(model.section)):
        values |= {f"multiplier_{i}_re": multiplier if i == 0 else 0.0, f"multiplier_{i}_im": 0.0}
    return Orbits.from_columns(model, {name: np.broadcast_to(value, n) for name, value in values.items()})


def joined(*sheets):
    return Orbits.concatenate(sheets[0].model, sheets)


K = np.arange(1.0, 11.0)


def test_the_index_is_the_sign_of_the_determinant():
    pair = np.array([[0.5 + 0.5j, 0.5 - 0.5j], [2.0, 0.5], [-2.0, 0.5], [2.0, 3.0], [1.0, 0.5], [np.nan, 0]])
    matrices = [np.diag(row) for row in pair[1:5].real]
    expected = [1.0, *(np.sign(np.linalg.det(np.eye(2) - matrix)) for matrix in matrices)]
    assert fixed_point_index(pair)[:5].tolist() == expected == [1.0, -1.0, 1.0, 1.0, 0.0]
    assert np.isnan(fixed_point_index(pair)[5])


def test_the_main_branch_is_what_stable_cycles_lead_to_without_a_fold():
    lower = sheet(K, 1.0 + 0.001 * K, 0.9, stable=True)
    flipped = sheet(K + 10, 1.011 + 0.001 * K, -1.5)  # the same sheet, after a flip
    upper = sheet(K + 10, 1.2 - 0.001 * K, 1.5)  # beyond a fold
    apart = sheet(K + 5, 2.0 - 0.01 * K, -1.5)  # as good an index, but no stable cycle
    orbits = joined(lower, flipped, upper, apart)
    assert fixed_point_index(orbits.multipliers).tolist() == [1.0] * 20 + [-1.0] * 10 + [1.0] * 10
    assert on_main_branch(orbits, "k").tolist() == [True] * 20 + [False] * 20
    # The order of the cycles does not matter.
    mixed = np.random.default_rng(1).permutation(40)
    np.testing.assert_array_equal(on_main_branch(orbits.take(mixed), "k"), mixed < 20)


def test_lines_are_apart():
    stable, other = sheet(K, 1.0, 0.9, stable=True), sheet(K, 1.0, -1.5, alpha=0.5)
    assert on_main_branch(joined(other, stable), "k").tolist() == [False] * 10 + [True] * 10
    # Along alpha, each spring has a line of two cycles, one of them stable.
    assert on_main_branch(joined(other, stable), "alpha").all()


def test_a_sheet_ends_where_the_period_jumps():
    below, above = sheet(K, 1.0, 0.9, stable=True), sheet(K + 10, 1.15, -1.5)
    assert on_main_branch(joined(below, above), "k").tolist() == [True] * 10 + [False] * 10


def test_cycles_of_a_walker(line):
    """What is beyond the folds is not on it, nor is group C, whose stable cycles are at stiffer springs."""
    main, index = on_main_branch(line.orbits, "k"), fixed_point_index(line.orbits.multipliers)
    assert main[line.orbits.stable].all()
    assert not main[index < 0].any()
    assert not main[line.orbits.group == "C"].any()
    assert main[(line.orbits.group == "B") & (index > 0)].all()
    assert (index < 0).any() and (line.orbits.group == "C").any()


def test_no_cycles():
    assert on_main_branch(Orbits.empty(load("wobbling")), "k").shape == (0,)
