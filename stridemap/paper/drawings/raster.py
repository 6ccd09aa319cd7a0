"""Where a map lies on paper, and where the letters of its groups stand."""

import string

import numpy as np
from scipy.ndimage import distance_transform_edt, label

from stridemap.solver.branches.plane import Plane, middle_edges

SMALLEST = 0.004
"""Share of the map's area below which a patch of one group is not lettered."""

APART = 0.07
"""Least distance of two letters, as a part of the map's width."""


def extent(plane: Plane) -> tuple[float, float, float, float]:
    """Left, right, bottom and top of the cells, whose middles are the values; these are evenly spaced."""
    return (*middle_edges(plane.x), *middle_edges(plane.y))


def letters(plane: Plane, aspect: float) -> list[tuple[str, float, float]]:
    """The letter of each group with the position, in parameters, where its largest patch is widest.

    Parameters
    ----------
    plane : Plane
    aspect : float
        Height of the map on paper over its width.
    """
    out: list[tuple[str, float, float]] = []
    cell = aspect / len(plane.y), 1 / len(plane.x)
    rows, columns = np.indices(plane.groups.shape)
    sides = [(rows + 0.5) * cell[0], aspect - (rows + 0.5) * cell[0]]
    sides += [(columns + 0.5) * cell[1], 1 - (columns + 0.5) * cell[1]]
    free = np.min(sides, axis=0) > APART / 2
    for group in range(int(plane.groups.max()) + 1):
        patches, count = label(plane.groups == group)
        sizes = np.bincount(patches.ravel(), minlength=count + 1)[1:]
        if not count or sizes.max() < SMALLEST * plane.groups.size:
            continue
        patch = np.pad(patches == 1 + sizes.argmax(), 1)  # the map's own edge bounds a patch too
        room = distance_transform_edt(patch, sampling=cell)[1:-1, 1:-1]
        room = np.where(free, room, 0.0)
        if not room.any():
            continue
        row, column = np.unravel_index(room.argmax(), room.shape)
        free &= np.hypot((rows - row) * cell[0], (columns - column) * cell[1]) > APART
        out.append((string.ascii_uppercase[group], float(plane.x[column]), float(plane.y[row])))
    return out
