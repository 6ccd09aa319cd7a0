"""A map made finer along its edges: cells are halved where neighbours differ, and only there.

What lies between cells of one class is taken to be of that class. Elsewhere all cycles of the cells around
are offered, and what is found decides. When it differs from a neighbour that was taken as given, that one is
computed too, and so on, so that an edge always runs between cells that were computed.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from stridemap.paper.drawings.raster import NO_GROUP, Raster, class_of, group_number
from stridemap.solver.branches.main_branch import walks
from stridemap.solver.cycles.search import SearchOptions, distinct, merge, section_point
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.model.model import Model
from stridemap.sweeps.grid import Grid

Floats = NDArray[np.float64]
Mask = NDArray[np.bool_]

AROUND = [(i, j) for i in (-1, 0, 1) for j in (-1, 0, 1) if (i, j) != (0, 0)]


@dataclass
class _Plane:
    """Cells of a plane, row by row: what they are, which of them are computed, and the cycles of these."""

    raster: Raster
    known: Mask
    cycles: dict[tuple[int, int], list[Floats]] = field(default_factory=dict)


def refined(
    model: Model, fixed: Mapping[str, float], coarse: Raster, orbits: pd.DataFrame, times: int
) -> Raster:
    """Halve the cells of a map along its edges.

    Parameters
    ----------
    model : Model
    fixed : mapping of str to float
        Every parameter that is not of the plane.
    coarse : Raster
    orbits : pandas.DataFrame
        The cycles that it was made from.
    times : int
        How often.
    """
    plane = _Plane(coarse, np.ones_like(coarse.classes, dtype=bool))
    at = coarse.place(orbits)
    cycles = orbits[[*model.section, "period"]].to_numpy()
    for row, column, u in zip(*at, cycles, strict=True):
        plane.cycles.setdefault((int(row), int(column)), []).append(u)
    for _ in range(times):
        plane = _halved(plane)
        wanted = ~plane.known & _differs(plane.raster.classes, np.ones_like(plane.known))
        while wanted.any():
            _compute(model, fixed, plane, wanted)
            wanted = ~plane.known & _differs(plane.raster.classes, plane.known)
    return plane.raster


def _halved(plane: _Plane) -> _Plane:
    """Twice as many cells along each side, the new ones as the cell before them."""
    old = plane.raster
    shape = 2 * len(old.y) - 1, 2 * len(old.x) - 1
    rows, columns = (np.arange(n) // 2 for n in shape)
    classes, groups = (a[np.ix_(rows, columns)] for a in (old.classes, old.groups))
    known = np.zeros(shape, dtype=bool)
    known[::2, ::2] = plane.known
    x, y = (np.interp(np.arange(n), np.arange(0, n, 2), v) for n, v in ((shape[1], old.x), (shape[0], old.y)))
    cycles = {(2 * row, 2 * column): us for (row, column), us in plane.cycles.items()}
    return _Plane(Raster(old.names, x, y, classes, groups), known, cycles)


def _differs(classes: NDArray[np.int64], among: Mask) -> Mask:
    """Which cells have, among some, a neighbour of another class."""
    padded = np.pad(classes, 1, mode="edge")
    counted = np.pad(among, 1)
    out = np.zeros(classes.shape, dtype=bool)
    rows, columns = classes.shape
    for i, j in AROUND:
        there = np.s_[1 + i : 1 + i + rows, 1 + j : 1 + j + columns]
        out |= counted[there] & (padded[there] != classes)
    return out


def _compute(model: Model, fixed: Mapping[str, float], plane: _Plane, wanted: Mask) -> None:
    """Compute cells from the cycles around them."""
    cells = np.argwhere(wanted)
    guesses = [
        (n, u)
        for n, (row, column) in enumerate(cells.tolist())
        for i, j in AROUND
        for u in plane.cycles.get((row + i, column + j), ())
    ]
    raster = plane.raster
    grid = Grid(raster.names[::-1], (raster.y, raster.x))
    points = grid.points(model, fixed, grid.cells(cells))
    found = _orbits(model, points, np.array([n for n, _ in guesses], dtype=np.int64), [u for _, u in guesses])
    for (row, column), orbits in zip(cells.tolist(), found, strict=True):
        gaits = [orbit for orbit in orbits if walks(orbit)]
        plane.known[row, column] = True
        raster.classes[row, column] = class_of(gaits)
        raster.groups[row, column] = NO_GROUP
        if gaits:
            best = min(gaits, key=lambda orbit: orbit.spectral_radius)
            raster.groups[row, column] = group_number(best.group)
            plane.cycles[row, column] = [np.array(section_point(orbit)) for orbit in gaits]


def _orbits(model: Model, points: Floats, cell: NDArray[np.int64], guesses: list[Floats]) -> list[list]:
    """Limit cycles of each of n points, from guesses for some of them."""
    if not guesses:
        return [[] for _ in points]
    solver = Solver.of(model)
    u, closed = solver.search(np.array(guesses), points[cell])
    cell, u = distinct(cell[closed], u[closed])
    return merge(len(points), cell, solver.complete(u, points[cell], SearchOptions().of(model).period_range))
