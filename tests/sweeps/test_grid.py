"""The grid of a sweep: numbering of cells, neighbours, tiles, subgrid and parameter points."""

import itertools
import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from stridemap.solver.model.loading import load
from stridemap.sweeps.config import parse_config
from stridemap.sweeps.grid import Grid, tile_size, tiles

pytestmark = pytest.mark.quick

AXES = st.lists(
    st.lists(st.floats(-1e6, 1e6), min_size=1, max_size=5, unique=True).map(sorted), min_size=1, max_size=3
)


def make_grid(axes):
    return Grid(tuple(f"p{i}" for i in range(len(axes))), tuple(np.array(axis) for axis in axes))


@settings(deadline=None)
@given(AXES)
def test_cells_number_the_product_in_c_order(axes):
    grid = make_grid(axes)
    assert grid.shape == tuple(map(len, axes))
    every = list(itertools.product(*map(range, grid.shape)))
    assert grid.n_cells == len(every)
    np.testing.assert_array_equal(grid.indices(np.arange(grid.n_cells)), every)
    np.testing.assert_array_equal(grid.cells(every), np.arange(grid.n_cells))


@settings(deadline=None)
@given(AXES)
def test_cells_beside_are_one_step_along_one_axis_that_is_not_the_longest(axes):
    grid = make_grid(axes)
    row, neighbour = grid.beside(np.arange(grid.n_cells))
    indices = grid.indices(np.arange(grid.n_cells))
    apart = np.abs(indices[:, None, :] - indices[None, :, :])
    wanted = np.argwhere((apart.sum(axis=-1) == 1) & (apart[..., grid.longest_axis] == 0))
    assert sorted(zip(row.tolist(), neighbour.tolist(), strict=True)) == sorted(map(tuple, wanted.tolist()))


def test_cells_beside_keep_the_order_asked_for():
    grid = make_grid([[0, 1, 2], [0, 1, 2, 3], [0, 1]])
    assert grid.longest_axis == 1
    row, neighbour = grid.beside([10, 0])
    assert row.tolist() == [0, 0, 0, 1, 1]
    assert neighbour.tolist() == [2, 18, 11, 8, 1]
    assert [part.tolist() for part in grid.beside([])] == [[], []]


@settings(deadline=None)
@given(AXES, st.integers(1, 40))
def test_tiles_are_contiguous_blocks_that_cover_the_grid_once(axes, target):
    grid = make_grid(axes)
    cut = tiles(grid, target)
    assert sorted(np.concatenate(list(cut)).tolist()) == list(range(grid.n_cells))
    for number, cells in enumerate(cut):
        assert 1 <= len(cells) <= target
        assert (np.diff(cells) > 0).all()
        indices = grid.indices(cells)
        extent = np.ptp(indices, axis=0) + 1
        assert math.prod(extent.tolist()) == len(cells)  # a block without holes
        assert (cut.tile_of(cells) == number).all()
    with pytest.raises(IndexError, match=str(len(cut))):
        cut[len(cut)]


def test_tiles_are_no_smaller_than_needed():
    grid = make_grid([range(120), range(18), range(4)])
    sizes = [len(cells) for cells in tiles(grid, 256)]
    assert min(sizes) > 64
    assert tiles(grid, 256).counts == (1, 18, 2)  # whole lines along the longest axis
    assert tiles(grid, 60).counts == (2, 18, 4)  # as long as one of them is small enough
    assert len(tiles(grid, grid.n_cells)) == 1
    with pytest.raises(ValueError, match="0"):
        tiles(grid, 0)


@pytest.mark.parametrize(
    ("shape", "cut"),
    [
        ((60,), 4),
        ((24,), 4),
        ((8,), 2),
        ((3,), 1),
        ((16, 3), 3),  # whole lines
        ((3, 16), 3),
        ((6, 5, 2), 5),
        ((120, 18, 4), 4),  # the paper's map
        ((1000, 100), 32),
    ],
)
def test_small_grids_have_tiles_for_several_workers(shape, cut):
    grid = make_grid([range(n) for n in shape])
    assert len(tiles(grid, tile_size(grid))) == cut


def test_subgrid_has_every_stride_and_both_ends():
    grid = make_grid([range(6), range(4)])
    assert grid.subgrid({"p0": 2, "p1": 3}).tolist() == [0, 3, 8, 11, 16, 19, 20, 23]
    assert grid.subgrid({"p0": 9}).tolist() == [0, 1, 2, 3, 20, 21, 22, 23]
    assert grid.subgrid({}).tolist() == grid.subgrid({"p1": 1}).tolist() == list(range(24))
    for strides in ({"p0": 0}, {"q": 2}):
        with pytest.raises(ValueError, match="strides"):
            grid.subgrid(strides)


def test_points_are_in_the_models_order():
    resolved = parse_config(
        {
            "model": "wobbling",
            "params": {"beta": 0.2},
            "grid": {"omega": [2, 3], "k": [1, 5], "S": [0.1, 0.2]},
        }
    )
    grid = Grid.from_mapping(resolved.grid)
    assert grid.names == ("k", "omega", "S")
    model = load("wobbling")
    points = grid.points(model, resolved.params)
    assert points.shape == (8, 9)
    for cell, (k, omega, amplitude) in enumerate(itertools.product([1, 5], [2, 3], [0.1, 0.2])):
        expected = model.point({"k": k, "omega": omega, "S": amplitude, "beta": 0.2})
        np.testing.assert_array_equal(points[cell], expected)
    np.testing.assert_array_equal(grid.points(model, resolved.params, [6, 1]), points[[6, 1]])


def test_points_need_every_parameter_once():
    model = load("wobbling")
    resolved = parse_config({"model": "wobbling", "grid": {"k": [1, 2]}})
    grid = Grid.from_mapping(resolved.grid)
    lacking = {name: value for name, value in resolved.params.items() if name != "beta"}
    for fixed in (lacking, {**resolved.params, "k": 1.0}, {**resolved.params, "mass": 1.0}):
        with pytest.raises(ValueError, match="parameters"):
            grid.points(model, fixed)


def test_grid_refuses_bad_axes_and_cannot_be_changed():
    for names, axes in [((), ()), (("a",), ([1], [2])), (("a", "a"), ([1], [2]))]:
        with pytest.raises(ValueError, match="name"):
            Grid(names, axes)
    for axis in ([], [2, 1], [1, 1], [[1]], [math.nan, 1]):
        with pytest.raises(ValueError, match="ascending"):
            Grid(("a",), (axis,))
    values = np.array([1.0, 2.0])
    grid = Grid(("a",), (values,))
    values[0] = 9
    assert grid.axes[0][0] == 1
    with pytest.raises(ValueError, match="read-only"):
        grid.axes[0][0] = 9
    for cells in ([2], [-1]):
        with pytest.raises(ValueError, match=r"out of bounds|invalid entry"):
            grid.indices(cells)
