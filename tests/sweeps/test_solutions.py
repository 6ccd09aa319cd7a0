"""Solutions by cell, lines of tiles, and families of branches, each against a few lines of plain Python."""

import numpy as np
import pytest
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from stridemap.sweeps.connections import open_links
from stridemap.sweeps.families import families
from stridemap.sweeps.grid import Grid
from stridemap.sweeps.lines import Lines
from stridemap.sweeps.solutions import NONE, Links, Solutions

pytestmark = pytest.mark.quick


def test_the_same_solution_is_of_the_same_cell_and_near_in_every_entry():
    rng = np.random.default_rng(0)
    scale = np.array([1.0, 10.0])
    known = Solutions(rng.integers(0, 5, 40), rng.integers(0, 3, (40, 2)) * scale, np.arange(40))
    asked = Solutions(
        rng.integers(0, 6, 60),
        rng.integers(0, 4, (60, 2)) * scale + rng.choice([0, 0.5e-3, 2e-3], (60, 2)) * scale,
        np.full(60, NONE),
    )
    found = asked.same_as(known, 1e-3, scale)
    for cell, u, row in zip(asked.cell, asked.u, found, strict=True):
        same = [i for i in range(40) if known.cell[i] == cell and (abs(u - known.u[i]) <= 1e-3 * scale).all()]
        assert (row in same) if same else row == NONE
    assert (found != NONE).any() and (found == NONE).any()
    assert asked.same_as(Solutions.empty(2), 1.0, scale).tolist() == [NONE] * 60


def test_lines_reach_one_cell_beyond_a_tile():
    grid = Grid(("a", "k"), (np.array([1.0, 2.0]), np.array([0.0, 1.0, 2.0, 4.0, 8.0])))
    lines = Lines.of(grid, np.array([1, 2, 6, 7]))  # k = 1 and 2 at both a
    assert (lines.first, lines.last, len(lines)) == (0, 3, 4)
    np.testing.assert_array_equal(lines.positions, [0, 0.25, 0.5, 1])
    cells = np.array([2, 6, 7])
    assert lines.line_of(cells).tolist() == [0, 5, 5]
    assert lines.place_of(cells).tolist() == [2, 1, 2]
    assert lines.cell_at(cells, np.array([3, 0, 3])).tolist() == [3, 5, 8]
    whole = Lines.of(grid, np.arange(10))
    assert (whole.first, whole.last) == (0, 4)


def test_families_are_connected_and_numbered_as_they_appear():
    branch = np.array([70, 10, 30, 10, 50, 20])
    joins = np.array([[10, 40], [40, 50], [90, 91]])  # 10 and 50 by way of one without a cycle
    assert families(branch, joins).tolist() == [0, 1, 2, 1, 1, 3]
    assert families(np.array([1, 2, 3, 4]), np.array([[1, 3], [2, 4]])).tolist() == [0, 1, 0, 1]
    assert families(branch[:0], joins).tolist() == []
    assert families(branch, joins[:0]).tolist() == [0, 1, 2, 1, 3, 4]


def test_links_are_followed_where_they_decide_whether_two_families_are_one():
    branch, other = np.array([[1, 2], [3, 2], [2, 1], [1, 4], [5, 4], [2, 1], [4, 3]]).T
    cells = np.arange(len(branch))
    links = Links(cells, np.zeros((len(cells), 6)), branch, cells, other)
    joins = np.array([[5, 4]])  # so that the fifth decides nothing
    assert open_links(links, joins).tolist() == [0, 1, 3, 6]
    assert open_links(links, joins, attempts=2).tolist() == [0, 1, 2, 3, 6]
    # With 3 and 1 in one family, the second is about the same pair as the first.
    assert open_links(links, np.array([[5, 4], [3, 1]])).tolist() == [0, 3]
    assert open_links(links, np.array([[1, 2], [2, 3], [3, 4], [4, 5]])).tolist() == []
    assert open_links(links.take(cells[:0]), joins).tolist() == []


@pytest.mark.parametrize("seed", range(20))
def test_families_are_the_connected_components_that_scipy_finds(seed):
    rng = np.random.default_rng(seed)
    n = int(rng.integers(1, 60))
    joins = rng.integers(0, n, (int(rng.integers(0, 60)), 2))
    edges = coo_array((np.ones(len(joins), dtype=bool), (joins[:, 0], joins[:, 1])), shape=(n, n))
    _, wanted = connected_components(edges, directed=False)
    found = families(np.arange(n), joins)
    assert (found[:, None] == found).tolist() == (wanted[:, None] == wanted).tolist()
    chain = rng.permutation(n)
    assert set(families(np.arange(n), np.column_stack([chain[:-1], chain[1:]]))) == {0}
