"""Where branches that are being followed have got to."""

from collections.abc import Sequence
from dataclasses import dataclass, fields
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Index = NDArray[np.int64]
Mask = NDArray[np.bool_]


class Points(NamedTuple):
    """Points of branches: their numbers, whether they are ahead of the beginning, points, and tangents."""

    branch: Index
    ahead: Mask
    x: Array
    tangent: Array

    @classmethod
    def concatenate(cls, parts: Sequence["Points"]) -> "Points":
        """All of some, in order."""
        return cls(*map(np.concatenate, zip(*parts, strict=True)))


@dataclass(frozen=True)
class Heads:
    """The foremost points of branches, one row each; a branch that is followed both ways may have two.

    Parameters
    ----------
    branch : ndarray of int, shape (n,)
    ahead : ndarray of bool, shape (n,)
        Whether this is the way ahead, or the one back.
    x, tangent : ndarray, shape (n, nz + 2)
        The point, and the unit tangent that points onwards.
    bend : ndarray, shape (n, nz + 2)
        Change of the tangent per length in the last arclength step.
    ds : ndarray, shape (n,)
        The next arclength step; 0 where the branch ends.
    idle : ndarray, shape (n,)
        Length since the last gait.
    steps : ndarray of int, shape (n,)
        Arclength steps so far.
    """

    branch: Index
    ahead: Mask
    x: Array
    tangent: Array
    bend: Array
    ds: Array
    idle: Array
    steps: Index

    @classmethod
    def beginning(cls, branch: Index, ahead: bool, x: Array, tangent: Array, ds: Array) -> "Heads":
        """Branches at their beginnings."""
        none = np.zeros(len(x))
        return cls(
            branch, np.full(len(x), ahead), x, tangent, np.zeros_like(x), ds, none, none.astype(np.int64)
        )

    @classmethod
    def concatenate(cls, parts: Sequence["Heads"]) -> "Heads":
        """All of some, in order."""
        return cls(*(np.concatenate([getattr(p, column.name) for p in parts]) for column in fields(cls)))

    def __len__(self) -> int:
        return len(self.branch)

    def take(self, index: NDArray[Any]) -> "Heads":
        """Some of them."""
        return Heads(*(getattr(self, column.name)[index] for column in fields(self)))

    @property
    def points(self) -> Points:
        """What is kept of where they are."""
        return Points(self.branch, self.ahead, self.x, self.tangent)
