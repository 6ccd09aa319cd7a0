"""The grid of a sweep: numbering of its cells, neighbours, tiles and subgrid.

A cell is one point of the product of the axes. Cells are numbered from 0 in C order: the last axis
runs fastest. Everything here depends on the grid alone, never on the number of workers.
"""

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stridemap.solver.model.model import Model

Ints = NDArray[np.int64]
Floats = NDArray[np.float64]

SHARE, SMALLEST_TILE, LARGEST_TILE = 0.3, 4, 4320
"""Largest share of a grid that a tile has, and the cells of the smallest and the largest tile. Branches are
followed fastest where many are followed at a time; each worker needs a tile."""

SMALL_GRID = 256
"""Cells below which lines are cut only where there is nothing else to cut: what a branch costs to hand on is
much in tiles so small."""


@dataclass(frozen=True, eq=False)
class Grid:
    """A product of axes of parameter values.

    Parameters
    ----------
    names : tuple of str
        The parameter of each axis.
    axes : tuple of ndarray
        The values along each axis, shape(n,), strictly ascending so that cells next to each other in
        number are neighbours in value. Copied and made read-only.

    Raises
    ------
    ValueError
        If there is no axis, or names and axes do not match, or an axis is empty or not ascending.
    """

    names: tuple[str, ...]
    axes: tuple[Floats, ...]

    def __post_init__(self) -> None:
        axes = tuple(np.array(axis, dtype=np.float64) for axis in self.axes)
        if not axes or len(set(self.names)) != len(axes) or len(self.names) != len(axes):
            raise ValueError(f"a grid needs one name for each of its axes, not {self.names} for {len(axes)}")
        for name, axis in zip(self.names, axes, strict=True):
            if axis.ndim != 1 or not axis.size or not (np.diff(axis) > 0).all():
                raise ValueError(f"the values of {name} must be a strictly ascending list, not {axis}")
            axis.setflags(write=False)
        object.__setattr__(self, "names", tuple(self.names))
        object.__setattr__(self, "axes", axes)

    @classmethod
    def from_mapping(cls, grid: Mapping[str, ArrayLike]) -> "Grid":
        """Return the grid of a mapping from parameter to values, such as ``SweepConfig.grid``."""
        return cls(tuple(grid), tuple(np.asarray(values, dtype=np.float64) for values in grid.values()))

    @property
    def shape(self) -> tuple[int, ...]:
        """Number of values along each axis."""
        return tuple(len(axis) for axis in self.axes)

    @property
    def n_cells(self) -> int:
        """Number of cells."""
        return math.prod(self.shape)

    @property
    def longest_axis(self) -> int:
        """Number of the axis with the most values, along which branches are followed."""
        return self.shape.index(max(self.shape))

    def indices(self, cells: ArrayLike) -> Ints:
        """Return the index along each axis, shape(n, n_axes), of `cells`, shape(n,).

        Raises
        ------
        ValueError
            If a cell is not in the grid.
        """
        return np.stack(np.unravel_index(np.asarray(cells, dtype=np.int64), self.shape), axis=-1)

    def cells(self, indices: ArrayLike) -> Ints:
        """Return the cells, shape(n,), at `indices` along the axes, shape(n, n_axes).

        Raises
        ------
        ValueError
            If an index is not in the grid.
        """
        columns = np.moveaxis(np.asarray(indices, dtype=np.int64), -1, 0)
        return np.asarray(np.ravel_multi_index(tuple(columns), self.shape), dtype=np.int64)

    def points(self, model: Model, fixed: Mapping[str, float], cells: ArrayLike | None = None) -> Floats:
        """Return parameter points, shape(n, n_parameters), in the model's order of parameters.

        Parameters
        ----------
        model : Model
            Gives the order of the parameters.
        fixed : mapping of str to float
            The value of every parameter that is not on an axis, such as ``SweepConfig.params``.
        cells : array_like of int, shape(n,), optional
            The cells; all of them by default.

        Raises
        ------
        ValueError
            If axes and `fixed` together are not exactly the model's parameters.
        """
        parameters = list(model.spec.names)
        if sorted([*self.names, *fixed]) != sorted(parameters):
            raise ValueError(f"{self.names} and {tuple(fixed)} together must be the parameters {parameters}")
        indices = self.indices(np.arange(self.n_cells) if cells is None else cells)
        points = np.empty((len(indices), len(parameters)))
        for column, name in enumerate(parameters):
            if name in fixed:
                points[:, column] = fixed[name]
            else:
                axis = self.names.index(name)
                points[:, column] = self.axes[axis][indices[:, axis]]
        return points

    def beside(self, cells: ArrayLike) -> tuple[Ints, Ints]:
        """The neighbours of cells, one step away along one axis that is not the longest.

        Returns
        -------
        row : ndarray of int, shape (m,)
            Number of the cell among those given, ascending; for one cell by axis, the smaller one first.
        neighbour : ndarray of int, shape (m,)
        """
        cells = np.asarray(cells, dtype=np.int64)
        indices = self.indices(cells)
        across = np.array(self.shape)
        across[self.longest_axis] = 1
        strides = np.array([math.prod(self.shape[axis + 1 :]) for axis in range(len(self.shape))])
        # The last two dimensions are the axes and the two directions along each.
        neighbours = cells[:, None, None] + strides[:, None] * np.array([-1, 1])
        inside = np.stack([indices > 0, indices < across - 1], axis=-1) & (across > 1)[:, None]
        return np.nonzero(inside)[0], neighbours[inside]

    def subgrid(self, strides: Mapping[str, int]) -> Ints:
        """Return the cells, ascending, of every `strides`-th value along each axis and of its last.

        Parameters
        ----------
        strides : mapping of str to int
            Stride along each axis, 1 for an axis not named. Both ends of every axis always belong.

        Raises
        ------
        ValueError
            If a stride is less than 1 or names no axis.
        """
        if not set(strides) <= set(self.names) or any(stride < 1 for stride in strides.values()):
            raise ValueError(f"strides must be at least 1 along axes of {self.names}, not {dict(strides)}")
        chosen = [
            np.unique(np.append(np.arange(0, size, strides.get(name, 1)), size - 1))
            for name, size in zip(self.names, self.shape, strict=True)
        ]
        return _block(chosen, self)


@dataclass(frozen=True, eq=False)
class Tiles:
    """A grid cut into contiguous blocks; item `i` is the ascending cells of tile `i`. Made by `tiles`.

    Attributes
    ----------
    grid : Grid
        The grid.
    counts : tuple of int
        Number of blocks along each axis.
    """

    grid: Grid
    counts: tuple[int, ...]

    @cached_property
    def _edges(self) -> list[Ints]:
        """First index of each block along each axis, and the end; blocks of an axis differ by at most one."""
        return [
            np.arange(count + 1) * size // count
            for size, count in zip(self.grid.shape, self.counts, strict=True)
        ]

    def __len__(self) -> int:
        return math.prod(self.counts)

    def __getitem__(self, tile: int) -> Ints:
        if not 0 <= tile < len(self):
            raise IndexError(f"tile {tile} is not among the {len(self)} tiles")
        blocks = np.unravel_index(tile, self.counts)
        ranges = [
            np.arange(*edges[block : block + 2]) for block, edges in zip(blocks, self._edges, strict=True)
        ]
        return _block(ranges, self.grid)

    def __iter__(self) -> Iterator[Ints]:
        return (self[tile] for tile in range(len(self)))

    def tile_of(self, cells: ArrayLike) -> Ints:
        """Return the tile of each of `cells`, shape(n,)."""
        columns = np.moveaxis(self.grid.indices(cells), -1, 0)
        blocks = [
            np.searchsorted(edges, column, side="right") - 1
            for edges, column in zip(self._edges, columns, strict=True)
        ]
        return np.asarray(np.ravel_multi_index(tuple(blocks), self.counts), dtype=np.int64)


def tile_size(grid: Grid) -> int:
    """Cells of a tile at most, so that several workers have one and each has many branches to follow.

    It depends on the grid alone: how a grid is cut shows in which cycles are found, and workers must not.
    """
    size = max(int(SHARE * grid.n_cells), SMALLEST_TILE)
    if grid.n_cells < SMALL_GRID and grid.n_cells > max(grid.shape):
        size = max(size, max(grid.shape))
    return min(size, LARGEST_TILE)


def tiles(grid: Grid, target_cells: int = 256) -> Tiles:
    """Cut `grid` into contiguous blocks of at most `target_cells` cells.

    Blocks have whole lines along the longest axis as long as one line is small enough, so that a branch is
    followed in one piece. The longest of the other sides is halved first.

    Raises
    ------
    ValueError
        If `target_cells` is less than 1.
    """
    if target_cells < 1:
        raise ValueError(f"target_cells must be at least 1, not {target_cells}")
    counts = [1] * len(grid.shape)
    while True:
        sides = [-(-size // count) for size, count in zip(grid.shape, counts, strict=True)]
        if math.prod(sides) <= target_cells:
            return Tiles(grid, tuple(counts))
        others = [0 if axis == grid.longest_axis else side for axis, side in enumerate(sides)]
        axis = others.index(max(others)) if max(others) > 1 else grid.longest_axis
        counts[axis] = min(2 * counts[axis], grid.shape[axis])


def _block(ranges: list[Ints], grid: Grid) -> Ints:
    """Return the cells, ascending, of the product of ascending indices along each axis."""
    mesh = np.meshgrid(*ranges, indexing="ij")
    return grid.cells(np.stack([part.ravel() for part in mesh], axis=-1))
