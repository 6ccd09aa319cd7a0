"""Which values of a sweep's grid a page shows: a part of it, and of a large one every so many."""

import itertools
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from stridemap.errors import InputError

Ints = NDArray[np.int64]
Floats = NDArray[np.float64]

MOST_CYCLES = 100_000
"""Limit cycles of a page that is not thinned out: it stays below 20 MB, and a press below 60 ms."""

LOST = 20.0
"""What leaving out a value that should be kept costs, in squares of the logarithm of a stride: more than a
stride of 80."""

FEW_VALUES = 3
"""An axis of so few values is not thinned out, as long as others can be."""

MOST_CHOICES = 20_000
"""Combinations of strides that are looked at."""


@dataclass(frozen=True)
class Thinned:
    """The values of each axis that are shown.

    Parameters
    ----------
    axes : mapping of str to ndarray
        All values of each axis of the grid, in the order in which cells are numbered.
    places : mapping of str to ndarray of int
        Which of them are shown, ascending.
    strides : mapping of str to int
        Of which every n-th was taken; 1 where all of the part that was chosen are shown.
    ends : mapping of str to tuple of two floats
        Between which values those axes are shown of which a part was chosen.
    full : mapping of str to tuple of two floats
        A part of the grid that would be shown in full.
    """

    axes: Mapping[str, Floats]
    places: Mapping[str, Ints]
    strides: Mapping[str, int]
    ends: Mapping[str, tuple[float, float]]
    full: Mapping[str, tuple[float, float]]

    @property
    def thin(self) -> bool:
        """Whether values were left out between others."""
        return any(stride > 1 for stride in self.strides.values())

    @property
    def whole(self) -> bool:
        """Whether all of the grid is shown."""
        return all(len(self.places[name]) == len(values) for name, values in self.axes.items())

    @property
    def grid(self) -> dict[str, list[float]]:
        """The values that are shown, by axis."""
        return {name: values[self.places[name]].tolist() for name, values in self.axes.items()}

    @property
    def cells(self) -> Ints:
        """The numbers of the cells that are shown, ascending."""
        mesh = np.meshgrid(*self.places.values(), indexing="ij")
        shape = tuple(len(values) for values in self.axes.values())
        return np.ravel_multi_index(tuple(one.ravel() for one in mesh), shape)


def thinned(
    axes: Mapping[str, Floats],
    cycles: Ints,
    part: Mapping[str, tuple[float, float]],
    most: int = MOST_CYCLES,
    kept: Mapping[str, Sequence[float]] | None = None,
) -> Thinned:
    """Choose the values of a grid that are shown, so that there are no more limit cycles than a page bears.

    Of each axis every n-th value is taken. Strides are chosen that are as equal as can be, and that leave the
    values in that should be kept.

    Parameters
    ----------
    axes : mapping of str to ndarray
        The axes of the grid, in the order in which cells are numbered.
    cycles : ndarray of int, shape (n_cells,)
        How many limit cycles each cell has.
    part : mapping of str to tuple of two floats
        Lowest and highest value of axes of which a part is shown.
    most : int
        Limit cycles at most.
    kept : mapping of str to sequence of float, optional
        Values of axes that should be shown.

    Raises
    ------
    InputError
        When a part is not one of the grid.
    """
    within = {name: _within(name, values, part.get(name)) for name, values in axes.items()}
    if unknown := [name for name in part if name not in axes]:
        raise InputError(
            f"a part of {unknown[0]} cannot be shown: the axes of the grid are {', '.join(axes)}"
        )
    counts = cycles.reshape([len(values) for values in axes.values()])
    anchors = {name: _places_of(values, (kept or {}).get(name, ())) for name, values in axes.items()}
    ends = _ends_of(axes, within, {})
    full = _full(axes, within, counts, most)
    for strides in _by_cost(within, anchors, counts, most):
        places = {
            name: _every(within[name], stride, anchors[name])
            for name, stride in zip(axes, strides, strict=True)
        }
        if 0 < counts[np.ix_(*places.values())].sum() <= most:
            return Thinned(axes, places, dict(zip(axes, strides, strict=True)), ends, full)
    # Single cells have more than that: one is shown.
    fullest = np.unravel_index(counts[np.ix_(*within.values())].argmax(), [len(p) for p in within.values()])
    first = {name: within[name][[at]] for name, at in zip(axes, fullest, strict=True)}
    return Thinned(axes, first, {name: len(places) for name, places in within.items()}, ends, full)


def _full(
    axes: Mapping[str, Floats], within: Mapping[str, Ints], counts: Ints, most: int
) -> dict[str, tuple[float, float]]:
    """A part that has no more than so many cycles: the first values of the longest axis, and so on."""
    part, out = dict(within), {}
    for name in sorted(within, key=lambda one: -len(within[one])):
        if counts[np.ix_(*part.values())].sum() <= most:
            break
        across = tuple(i for i, other in enumerate(axes) if other != name)
        so_far = np.cumsum(counts[np.ix_(*part.values())].sum(axis=across))
        part[name] = part[name][: max(1, int(np.searchsorted(so_far, most, "right")))]
        out[name] = (float(axes[name][part[name][0]]), float(axes[name][part[name][-1]]))
    return {**_ends_of(axes, within, out), **out}


def _ends_of(
    axes: Mapping[str, Floats], within: Mapping[str, Ints], but: Mapping[str, object]
) -> dict[str, tuple[float, float]]:
    """Between which values those axes are of which a part was chosen, save some."""
    return {
        name: (float(axes[name][places[0]]), float(axes[name][places[-1]]))
        for name, places in within.items()
        if len(places) < len(axes[name]) and name not in but
    }


def _within(name: str, values: Floats, ends: tuple[float, float] | None) -> Ints:
    """The places of those values of an axis that lie between two."""
    if ends is None:
        return np.arange(len(values))
    low, high = ends
    tolerance = 1e-9 * np.abs(values).max(initial=0.0)
    found = np.flatnonzero((values >= low - tolerance) & (values <= high + tolerance))
    if not len(found):
        near = values[np.abs(values - (low + high) / 2).argmin()]
        raise InputError(
            f"no value of {name} on the grid is between {low:g} and {high:g}; its values go from "
            f"{values[0]:g} to {values[-1]:g}, and the nearest is {near:g}"
        )
    return found


def _places_of(values: Floats, kept: Sequence[float]) -> Ints:
    """Where on an axis some values are, as far as they are on it."""
    near = [i for one in kept for i in np.flatnonzero(np.isclose(values, one, rtol=1e-9, atol=0))]
    return np.array(sorted(near), dtype=np.int64)


def _every(within: Ints, stride: int, anchors: Ints) -> Ints:
    """Every n-th place, so that as many of some as can be are among them."""
    inside = np.intersect1d(within, anchors) - within[0]
    offset = int(np.bincount(inside % stride, minlength=stride).argmax()) if len(inside) else 0
    return within[offset::stride]


def _by_cost(
    within: Mapping[str, Ints], anchors: Mapping[str, Ints], counts: Ints, most: int
) -> Iterator[tuple[int, ...]]:
    """Strides of all axes that may leave few enough cycles, the best first."""
    if counts[np.ix_(*within.values())].sum() <= most:
        yield (1,) * len(within)
        return
    choices = [_choices(places, anchors[name]) for name, places in within.items()]
    while math.prod(map(len, choices)) > MOST_CHOICES:
        longest = max(choices, key=len)
        longest[:] = [longest[0], *longest[1:-1:2], longest[-1]] if len(longest) > 3 else [longest[-1]]
    shown = counts[np.ix_(*within.values())]
    # Twice as many as an even spread would allow are certainly too many.
    cells = 2 * most * shown.size / shown.sum()
    priced = []
    for chosen in itertools.product(*choices):
        if (size := math.prod(one.values for one in chosen)) <= cells:
            cost = sum(one.cost for one in chosen) - 1e-3 * math.log(size)
            priced.append((cost, tuple(one.stride for one in chosen)))
    yield from (strides for _, strides in sorted(priced))


@dataclass(frozen=True)
class _Choice:
    """A stride along one axis.

    Parameters
    ----------
    stride, values : int
        Of which every n-th value is taken, and how many values that leaves.
    cost : float
    """

    stride: int
    values: int
    cost: float


def _choices(places: Ints, anchors: Ints) -> list[_Choice]:
    """Strides that leave different numbers of values on an axis, from 1."""
    inside, found = np.intersect1d(places, anchors), []
    for stride in _strides(len(places)):
        left = _every(places, stride, anchors)
        lost = len(inside) - len(np.intersect1d(left, inside))
        few = 100.0 * (stride > 1 and len(places) <= FEW_VALUES)
        found.append(_Choice(stride, len(left), math.log(stride) ** 2 + LOST * lost + few))
    return found


def _strides(size: int) -> list[int]:
    """Strides that leave different numbers of values on an axis."""
    found = {math.ceil(size / stride): stride for stride in range(size, 0, -1)}
    return sorted(found.values())
