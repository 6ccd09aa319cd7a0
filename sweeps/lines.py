"""Lines of a tile: its cells along the grid's longest axis, and the next cells beyond both ends."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from stridemap.sweeps.grid import Grid

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]


@dataclass(frozen=True)
class Lines:
    """Lines of the cells of a block of a grid.

    Parameters
    ----------
    grid : Grid
    first, last : int
        Places along the grid's longest axis of the lines' ends, which may be cells of other tiles.
    """

    grid: Grid
    first: int
    last: int

    @classmethod
    def of(cls, grid: Grid, cells: Ints) -> "Lines":
        """The lines of a block of cells."""
        places = grid.indices(cells)[:, grid.longest_axis]
        end = grid.shape[grid.longest_axis] - 1
        return cls(grid, max(int(places.min()) - 1, 0), min(int(places.max()) + 1, end))

    def __len__(self) -> int:
        """Number of cells of each line."""
        return self.last - self.first + 1

    @property
    def positions(self) -> Floats:
        """Of the cells of each line, from 0 to 1."""
        values = self.grid.axes[self.grid.longest_axis][self.first : self.last + 1]
        with np.errstate(invalid="ignore"):
            return np.asarray((values - values[0]) / (values[-1] - values[0]))

    def line_of(self, cells: Ints) -> Ints:
        """The line of each cell, by the number of its first cell."""
        return self.cell_at(cells, np.zeros(len(cells), dtype=np.int64))

    def place_of(self, cells: Ints) -> Ints:
        """The place of each cell on its line, from 0."""
        return self.grid.indices(cells)[:, self.grid.longest_axis] - self.first

    def cell_at(self, cells: Ints, places: Ints) -> Ints:
        """The cells at places on the lines of cells."""
        indices = self.grid.indices(cells)
        indices[:, self.grid.longest_axis] = self.first + places
        return self.grid.cells(indices)
