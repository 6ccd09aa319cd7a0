"""The cells of a plane of two parameters, classified by the limit cycles found in them."""

import string
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import pandas as pd
from numpy.typing import NDArray
from scipy.ndimage import distance_transform_edt, label

Ints = NDArray[np.int64]

NONE, UNSTABLE, STABLE = 0, 1, 2
"""Classes of a cell: no cycle, no stable one, a stable one."""

NO_GROUP = -1
SMALLEST = 0.004
"""Share of the map's area below which a patch of one group is not lettered."""


@dataclass(frozen=True)
class Raster:
    """Classes and groups of the cells of a plane.

    Parameters
    ----------
    names : (str, str)
        The two parameters.
    x, y : ndarray, shapes (n,) and (m,)
        Their values, ascending and evenly spaced.
    classes : ndarray of int, shape (m, n)
        `NONE`, `UNSTABLE` or `STABLE`.
    groups : ndarray of int, shape (m, n)
        Group of the cell's most stable cycle, 0 for A; `NO_GROUP` where there is no cycle, or no group.
    """

    names: tuple[str, str]
    x: NDArray[np.float64]
    y: NDArray[np.float64]
    classes: Ints
    groups: Ints

    @property
    def extent(self) -> tuple[float, float, float, float]:
        """Left, right, bottom and top of the cells, whose middles are the values."""
        (left, right), (bottom, top) = (
            (v[0] - (v[1] - v[0]) / 2, v[-1] + (v[-1] - v[-2]) / 2) for v in (self.x, self.y)
        )
        return float(left), float(right), float(bottom), float(top)

    def place(self, orbits: pd.DataFrame) -> tuple[Ints, Ints]:
        """Row and column of the cell of each of some cycles of the sweep."""
        x, y = self.names
        return np.searchsorted(self.y, orbits[y]), np.searchsorted(self.x, orbits[x])


def rastered(orbits: pd.DataFrame, x: str, xs: Sequence[float], y: str, ys: Sequence[float]) -> Raster:
    """Classify the cells of the plane of parameters `x` and `y` by the limit cycles found in them."""
    shape = len(ys), len(xs)
    out = Raster((x, y), np.array(xs), np.array(ys), np.full(shape, NONE), np.full(shape, NO_GROUP))
    rows = orbits.sort_values("spectral_radius", ascending=False)  # a cell's most stable cycle comes last
    at = out.place(rows)
    out.classes[at] = np.where(rows["stable"], STABLE, UNSTABLE)
    out.groups[at] = [group_number(group) for group in rows["group"]]
    return out


def class_of(gaits: Sequence[Any]) -> int:
    """Class of a cell with some limit cycles."""
    if not gaits:
        return NONE
    return STABLE if any(orbit.stable for orbit in gaits) else UNSTABLE


def group_number(group: str | None) -> int:
    """0 for A, 1 for B; `NO_GROUP` for none, and beyond Z."""
    return string.ascii_uppercase.index(group) if group and len(group) == 1 else NO_GROUP


def letters(of: Raster, aspect: float) -> list[tuple[str, float, float]]:
    """The letter of each group with the position, in parameters, where its largest patch is widest.

    Parameters
    ----------
    of : Raster
    aspect : float
        Height of the map on paper over its width.
    """
    out = []
    cell = aspect / len(of.y), 1 / len(of.x)
    for group in range(int(of.groups.max()) + 1):
        patches, count = label(of.groups == group)
        sizes = np.bincount(patches.ravel(), minlength=count + 1)[1:]
        if not count or sizes.max() < SMALLEST * of.groups.size:
            continue
        patch = np.pad(patches == 1 + sizes.argmax(), 1)  # the map's own edge bounds a patch too
        room = distance_transform_edt(patch, sampling=cell)[1:-1, 1:-1]
        row, column = np.unravel_index(room.argmax(), room.shape)
        out.append((string.ascii_uppercase[group], float(of.x[column]), float(of.y[row])))
    return out
