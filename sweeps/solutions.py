"""Solutions in the cells of a grid, as arrays: which of them are one."""

from collections.abc import Sequence
from dataclasses import dataclass, fields
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

NONE = -1
"""In the place of a row or a branch where there is none."""

SAME_BRANCH = 0.05
"""Largest distance of a solution from where its branch passes the cell, in terms of the scales; what is
farther away is another solution."""

PARTS = 4
"""Into so many parts even a short branch is cut by those of its solutions that stand for it."""


@dataclass(frozen=True)
class Solutions:
    """Solutions with their cells and branches.

    Parameters
    ----------
    cell : ndarray of int, shape (n,)
    u : ndarray, shape (n, nz + 1)
        Section points and periods.
    branch : ndarray of int, shape (n,)
        Number of the branch; `NONE` where it is not known.
    """

    cell: Ints
    u: Floats
    branch: Ints

    @classmethod
    def empty(cls, width: int) -> Self:
        """No solutions in `width` unknowns."""
        u, numbers = np.empty((0, width)), np.empty(0, dtype=np.int64)
        columns: dict[str, Any] = {column.name: numbers for column in fields(cls)}
        return cls(**{**columns, "u": u})

    @classmethod
    def concatenate(cls, parts: Sequence[Self], width: int) -> Self:
        """All of some in `width` unknowns, in order."""
        every = [cls.empty(width), *parts]
        names = (column.name for column in fields(cls))
        return cls(*(np.concatenate([getattr(part, name) for part in every]) for name in names))

    def __len__(self) -> int:
        return len(self.cell)

    def take(self, index: NDArray[np.int64] | NDArray[np.bool_]) -> Self:
        """Some of them."""
        return type(self)(*(getattr(self, column.name)[index] for column in fields(self)))

    def some_of_each_branch(self, every: int) -> Self:
        """At most every so many in a row of one branch, nearer together on short ones; first and last too."""
        branch = self.branch
        begins = np.flatnonzero(np.append(True, branch[1:] != branch[:-1])[: len(branch)])
        length = np.diff(np.append(begins, len(branch)))
        place = np.arange(len(branch)) - np.repeat(begins, length)
        apart = np.repeat(np.clip(length // PARTS, 1, every), length)
        last = np.append(branch[1:] != branch[:-1], True)[: len(branch)]
        return self.take((place % apart == 0) | last)

    def same_as(self, other: "Solutions", tolerance: float, scale: Floats) -> Ints:
        """For each of them a row of `other` that is the same solution; `NONE` where there is none.

        Parameters
        ----------
        other : Solutions
        tolerance : float
            Largest difference of two that are one, in any entry and in terms of `scale`.
        scale : ndarray, shape (nz + 1,)
        """
        order = np.argsort(other.cell, kind="stable")
        cells = other.cell[order]
        row, last = np.searchsorted(cells, self.cell, "left"), np.searchsorted(cells, self.cell, "right")
        out = np.full(len(self), NONE)
        open_ = np.flatnonzero(row < last)
        while len(open_):
            candidate = order[row[open_]]
            near = (np.abs(self.u[open_] - other.u[candidate]) <= tolerance * scale).all(axis=1)
            out[open_[near]] = candidate[near]
            row[open_] += 1
            open_ = open_[~near & (row[open_] < last[open_])]
        return out


@dataclass(frozen=True)
class Guesses(Solutions):
    """Guesses of solutions in cells.

    Parameters
    ----------
    origin : ndarray of int, shape (n,)
        The cell in which u is a solution; the guess's own one for starts, and where a branch seems to pass.
    """

    origin: Ints


@dataclass(frozen=True)
class Links(Guesses):
    """Guesses from which a search has led to another branch, which may be the same one.

    Parameters
    ----------
    other : ndarray of int, shape (n,)
        That branch.
    """

    other: Ints
