"""Edges of ranges with stable cycles are where independent searches find them."""

import numpy as np
import pytest

from stridemap.solver.branches.edges import BISECTIONS, bisected
from stridemap.solver.cycles.gait import is_physical_gait
from stridemap.solver.cycles.orbits import Orbits


@pytest.fixture(scope="module")
def gaits(line):
    return line.orbits.take(is_physical_gait(line.orbits))


@pytest.fixture(scope="module")
def edges(solver, gaits, line):
    return bisected(solver, gaits, "k", line.k)


def test_stable_cycles_are_inside_and_none_outside(line, gaits, edges, find):
    assert edges.side.tolist() == [-1, 1]  # a fold below, a bifurcation above
    assert set(gaits.group[edges.row]) == {"B"}
    spacing = line.k[1] - line.k[0]
    for row, side, value in zip(edges.row, edges.side, edges.value, strict=True):
        inside = side * (value - gaits.params[row, 0])
        assert 0 < inside < spacing
        beyond = value + side * 2 * spacing / 2**BISECTIONS
        for k, expected in ((value, True), (beyond, False)):
            found = find(k=k, starts=256)
            assert (found.stable & (found.group == "B")).any() == expected


def test_the_row_is_the_last_stable_cycle_of_the_grid(line, gaits, edges):
    k = gaits.params[gaits.stable, 0]
    assert gaits.params[edges.row, 0].tolist() == [k.min(), k.max()]
    assert gaits.stable[edges.row].all()


def test_the_grids_own_ends_are_no_edges(solver, line, gaits):
    inner = (line.k >= 6.5) & (line.k <= 10.0)
    within = gaits.take(np.isin(gaits.params[:, 0], line.k[inner]))
    assert within.stable.all()
    assert len(bisected(solver, within, "k", line.k[inner]).row) == 0


def test_a_hole_in_the_range_has_two_edges(solver, line, gaits):
    """A cycle that was missed: both edges move through to the far end of its interval."""
    missed = gaits.take(gaits.params[:, 0] != 8.0)
    edges = bisected(solver, missed, "k", line.k)
    assert edges.side.tolist() == [-1, 1, -1, 1]
    np.testing.assert_allclose(edges.value[1:3], 8.0, atol=0.5 / 2**BISECTIONS)


def test_lines_and_groups_are_apart(solver, line, gaits, edges, find):
    """A second line changes nothing on the first, and comes before it where its parameters are smaller."""
    other = find(k=line.k, alpha=0.2)
    other = other.take(is_physical_gait(other))
    both = bisected(solver, Orbits.concatenate(solver.model, [gaits, other]), "k", line.k)
    second = both.row < len(gaits)
    np.testing.assert_array_equal(both.row[second], edges.row)
    np.testing.assert_array_equal(both.value[second], edges.value)
    assert (~second).any() and (np.diff(second.astype(int)) >= 0).all()


def test_no_stable_cycles(solver, line, gaits):
    for orbits in (Orbits.empty(solver.model), gaits.take(~gaits.stable)):
        edges = bisected(solver, orbits, "k", line.k)
        assert edges.row.shape == edges.side.shape == edges.value.shape == (0,)
