"""Smallest values between the points of a grid: not above the grid's, and not above those around them."""

import numpy as np
import pytest

from stridemap.solver.branches.main_branch import on_main_branch
from stridemap.solver.branches.minima import POINTS_PER_SIDE, REFINEMENTS, minima
from stridemap.solver.cycles.gait import is_physical_gait
from stridemap.solver.cycles.orbits import Orbits

MEASURES = ("spectral_radius", "cot")


@pytest.fixture(scope="module")
def gaits(line):
    return line.orbits.take(is_physical_gait(line.orbits))


@pytest.fixture(scope="module")
def found(solver, gaits, line):
    return minima(solver, gaits, on_main_branch(gaits, "k"), "k", line.k, MEASURES)


@pytest.mark.parametrize("measure", MEASURES)
def test_fresh_searches_around_a_minimum_find_nothing_smaller(measure, line, gaits, found, find):
    stable = found.orbits.stable
    amount, k = found.orbits.measures[measure][stable], found.orbits.params[stable, 0]
    on_grid = gaits.measures[measure][gaits.stable]
    least = amount.min()
    assert least < on_grid.min()
    at = k[amount.argmin()]
    spacing = (line.k[1] - line.k[0]) / POINTS_PER_SIDE**REFINEMENTS
    around = find(k=at + np.array([-0.02, -10 * spacing, 0.0, 10 * spacing, 0.02]), starts=96)
    around = around.take(is_physical_gait(around) & around.stable & (around.group == "B"))
    assert len(around) >= 2
    assert around.measures[measure].min() > least - 1e-5
    assert np.abs(around.measures[measure][around.params[:, 0] == at] - least).min() < 1e-9


def test_minima_are_cycles_of_the_kind_that_they_began_with(gaits, line, found):
    orbits = found.orbits
    assert is_physical_gait(orbits).all()
    assert ((orbits.params[:, 0] >= line.k[0]) & (orbits.params[:, 0] <= line.k[-1])).all()
    main = on_main_branch(gaits, "k")
    assert set(orbits.group) == set(gaits.group[main])
    assert set(orbits.group[orbits.stable]) == set(gaits.group[gaits.stable]) == {"B"}
    assert found.on_main_branch.all() and found.on_main_branch.shape == (len(orbits),)
    assert len(np.unique(np.column_stack([orbits.params, orbits.period]), axis=0)) == len(orbits)


def test_without_stable_cycles_the_main_branch_counts(solver, gaits, line):
    group_a = gaits.take(gaits.group == "A")
    none = minima(solver, group_a, np.zeros(len(group_a), dtype=bool), "k", line.k, MEASURES)
    assert len(none.orbits) == len(none.on_main_branch) == 0
    some = minima(solver, group_a, np.ones(len(group_a), dtype=bool), "k", line.k, ("spectral_radius",))
    assert some.orbits.spectral_radius.min() <= group_a.spectral_radius.min()
    assert some.on_main_branch.all() and set(some.orbits.group) == {"A"}


def test_one_value_has_nothing_between(solver, gaits, line):
    at = gaits.take(gaits.params[:, 0] == 8.0)
    found = minima(solver, at, at.stable, "k", np.array([8.0]), MEASURES)
    assert len(found.orbits) == 0


def test_no_cycles(solver, line):
    nothing = Orbits.empty(solver.model)
    found = minima(solver, nothing, np.empty(0, dtype=bool), "k", line.k, MEASURES)
    assert len(found.orbits) == len(found.on_main_branch) == 0
