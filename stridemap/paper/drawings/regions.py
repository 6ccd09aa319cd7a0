"""The regions into which curves cut a map, their classes, and their outlines as polygons.

The map is cut at many heights. Between two curves that are neighbours at one height and again at the next
lies one region; where curves cross, end or turn back, regions begin and end. A region is of the class that
its cells are of, or, where it is so narrow that it holds none, of the class that is computed there.
"""

import itertools
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.branches.plane import Plane

Array = NDArray[np.float64]
Index = NDArray[np.int64]

HEIGHTS = 600
"""Heights at which the map is cut, at least."""

HALVINGS = 7
"""How often the distance of two heights is halved between which curves cross, begin or end."""

UNKNOWN = -1
"""Class of a region that is too narrow to be seen and holds no cell."""

NARROWEST = 2e-4
"""Width of such a region, as a part of the map's."""

SHARE = 0.1
"""Part of the cells of a region that must be of a class for the region to be of it."""

FLAT = 1e-5
"""How far a point may lie beside a line to be left out, as a part of the width of what is drawn."""

LEFT, RIGHT = -1, -2
"""In the place of a curve: the sides of the map."""


@dataclass(frozen=True)
class Cut:
    """What a map is cut into at one height.

    Parameters
    ----------
    y : float
        The height.
    x : ndarray, shape (n + 1,)
        Where the curves cross it, ascending, between the left and the right side.
    curve : ndarray of int, shape (n + 1,)
        Their numbers.
    region : ndarray of int, shape (n,)
        The region between each and the next.
    """

    y: float
    x: Array
    curve: Index
    region: Index


@dataclass(frozen=True)
class Regions:
    """The regions of a map.

    Parameters
    ----------
    cuts : list of Cut
        By height.
    count : int
        Number of regions.
    """

    cuts: list[Cut]
    count: int

    @classmethod
    def between(cls, lines: list[Array], plane: Plane, sides: tuple[float, float, float, float]) -> "Regions":
        """The regions between curves.

        Parameters
        ----------
        lines : list of ndarray, shape (m, 2)
        plane : Plane
            Its rows are among the heights.
        sides : (float, float, float, float)
            Left, right, bottom and top of the map.
        """
        left, right, bottom, top = sides
        rising = [piece for line in lines for piece in _rising(line)]
        heights = _heights(rising, plane.y, bottom, top)
        for _ in range(HALVINGS):
            rows = _crossed(rising, heights, left, right)
            changed = [
                i for i in range(len(rows) - 1) if not np.array_equal(rows[i].curve, rows[i + 1].curve)
            ]
            heights = np.unique(np.append(heights, [(heights[i] + heights[i + 1]) / 2 for i in changed]))
        cuts, known, count = [], {}, 0
        for y, row in zip(heights.tolist(), _crossed(rising, heights, left, right), strict=True):
            curve, now = row.curve, {}
            for pair in zip(curve[:-1].tolist(), curve[1:].tolist(), strict=True):
                if pair not in known:
                    known[pair], count = count, count + 1
                now[pair] = known[pair]
            region = np.array(list(now.values()), dtype=np.int64)
            cuts.append(Cut(y, row.x, curve, region))
            known = now
        return cls(cuts, count)

    def of_cells(self, plane: Plane) -> Index:
        """The region in which the middle of each cell lies, shape (rows, columns)."""
        return np.array(
            [cut.region[np.searchsorted(cut.x, plane.x) - 1] for cut in self._at(plane.y)], dtype=np.int64
        )

    def classes(self, plane: Plane, elsewhere: Callable[[Array, Array], Index]) -> Index:
        """The class of every region, shape (count,): the highest that a tenth of its cells are of.

        A search may miss a gait, and then the class of a cell is too low; it does not make one up.

        Parameters
        ----------
        plane : Plane
        elsewhere : callable
            Takes points, as x and y, of regions without a cell; returns their classes.
        """
        region = self.of_cells(plane)
        votes = np.zeros((self.count, 3), dtype=np.int64)
        np.add.at(votes, (region.ravel(), plane.classes.ravel()), 1)
        enough = (votes > 0) & (votes >= SHARE * votes.sum(axis=1, keepdims=True))
        out = np.where(votes.any(axis=1), 2 - enough[:, ::-1].argmax(axis=1), UNKNOWN)
        x, y, width = self._widest
        asked = np.flatnonzero((out == UNKNOWN) & (width > NARROWEST))
        if len(asked):
            out[asked] = elsewhere(x[asked], y[asked])
        return out

    def on_the_other_side(self, plane: Plane, classes: Index) -> Index:
        """Row and column of the cells that are not of the class of their region, shape (m, 2)."""
        region = classes[self.of_cells(plane)]
        return np.argwhere((region != plane.classes) & (region != UNKNOWN))

    @cached_property
    def _widest(self) -> tuple[Array, Array, Array]:
        """Where each region is widest: the middle in x, y, and the width as a part of the map's."""
        best = np.zeros((3, self.count))
        for cut in self.cuts:
            width = np.diff(cut.x)
            wider = width > best[2, cut.region]
            at = cut.region[wider]
            best[:, at] = (cut.x[:-1] + width / 2)[wider], np.full(len(at), cut.y), width[wider]
        best[2] /= self.cuts[0].x[-1] - self.cuts[0].x[0]
        return best[0], best[1], best[2]

    def _at(self, y: Array) -> list[Cut]:
        """The cuts at some of their heights."""
        heights = np.array([cut.y for cut in self.cuts])
        return [self.cuts[i] for i in np.searchsorted(heights, y)]

    def polygons(self, classes: Index, wanted: int) -> list[Array]:
        """Outlines of all regions of one class, neighbours in one piece, shape (m, 2) each."""
        done: list[Array] = []
        open_: dict[tuple[int, int], list[tuple[float, float, float]]] = {}
        for cut in self.cuts:
            now = {}
            for first, last in _runs(classes[cut.region] == wanted):
                sides = int(cut.curve[first]), int(cut.curve[last])
                spans = open_.pop(sides, [])
                spans.append((cut.y, float(cut.x[first]), float(cut.x[last])))
                now[sides] = spans
            done += [_outline(spans) for spans in open_.values() if len(spans) > 1]
            open_ = now
        return done + [_outline(spans) for spans in open_.values() if len(spans) > 1]


def _rising(line: Array) -> list[Array]:
    """Pieces of a line on which y rises or falls throughout, each from its lowest point upwards."""
    up = np.sign(np.diff(line[:, 1]))
    turns = np.flatnonzero(up[1:] != up[:-1]) + 1
    ends: list[int] = [0, *turns.tolist(), len(line) - 1]
    pieces = [line[i : j + 1] for i, j in itertools.pairwise(ends) if j > i]
    pieces = [one for one in pieces if one[0, 1] != one[-1, 1]]
    return [one if one[-1, 1] > one[0, 1] else one[::-1] for one in pieces]


def _heights(pieces: list[Array], rows: Array, bottom: float, top: float) -> Array:
    """Where to cut: evenly, along the rows of cells, and just inside the ends of every piece."""
    just = 1e-7 * (top - bottom)
    ends = np.array([one[i, 1] + side * just for one in pieces for i in (0, -1) for side in (-1, 1)])
    even = np.linspace(bottom, top, HEIGHTS)
    heights = np.unique(np.concatenate([even, rows, ends]))
    return heights[(heights >= bottom) & (heights <= top)]


@dataclass(frozen=True)
class _Row:
    """Where curves cross one height, between the sides of the map, and their numbers, shape (n + 1,)."""

    x: Array
    curve: Index


def _crossed(pieces: list[Array], heights: Array, left: float, right: float) -> list[_Row]:
    """Where pieces cross each height."""
    levels, xs, numbers = [np.empty(0, dtype=np.int64)], [np.empty(0)], [np.empty(0, dtype=np.int64)]
    for which, piece in enumerate(pieces):
        first, last = np.searchsorted(heights, [piece[0, 1], piece[-1, 1]])
        at = np.arange(first, last)
        levels.append(at)
        xs.append(np.interp(heights[at], piece[:, 1], piece[:, 0]))
        numbers.append(np.full(len(at), which))
    level, x, number = np.concatenate(levels), np.concatenate(xs), np.concatenate(numbers)
    order = np.lexsort((x, level))
    order = order[(x[order] > left) & (x[order] < right)]
    ends = np.searchsorted(level[order], np.arange(len(heights) + 1))
    parts = [order[i:j] for i, j in itertools.pairwise(ends)]
    return [
        _Row(
            np.concatenate([[left], x[part], [right]]),
            np.concatenate([[LEFT], number[part], [RIGHT]]).astype(np.int64),
        )
        for part in parts
    ]


def _runs(inside: NDArray[np.bool_]) -> list[tuple[int, int]]:
    """First crossing and last crossing of each run of neighbouring parts that are inside."""
    change = np.diff(np.concatenate([[0], inside.astype(int), [0]]))
    first, last = np.flatnonzero(change > 0), np.flatnonzero(change < 0)
    return list(zip(first.tolist(), last.tolist(), strict=True))


def _outline(spans: list[tuple[float, float, float]]) -> Array:
    """The polygon of spans between a left and a right end, by height."""
    y, left, right = np.array(spans).T
    return np.vstack([_simplified(left, y), _simplified(right, y)[::-1]])


def _simplified(x: Array, y: Array) -> Array:
    """A side of a polygon without the points that lie on the line between others (Douglas and Peucker)."""
    kept = np.zeros(len(y), dtype=bool)
    kept[[0, -1]] = True
    parts = [(0, len(y) - 1)]
    tolerance = FLAT * max(float(np.ptp(x)), 1e-12)
    while parts:
        first, last = parts.pop()
        if last - first < 2:
            continue
        between = slice(first + 1, last)
        chord = x[first] + (x[last] - x[first]) * (y[between] - y[first]) / (y[last] - y[first])
        away = np.abs(x[between] - chord)
        worst = int(away.argmax())
        if away[worst] > tolerance:
            middle = first + 1 + worst
            kept[middle] = True
            parts += [(first, middle), (middle, last)]
    return np.column_stack([x[kept], y[kept]])
