"""A walker, drawn: legs, masses, springs, and the ground under it."""

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Circle
from numpy.typing import NDArray

from stridemap.views import style

Array = NDArray[np.float64]

RADIUS = 0.095
"""Radius of a disc of the whole walker's mass, in its heights; areas are as masses."""
LEFT, RIGHT = style.DARK, style.SKY
MASS_COLOURS = {"hip": style.DARK, "wobbling mass": style.VERMILION}
COILS = 5


def draw_leg(axes: Axes, points: Array, colour: str) -> None:
    """One leg, a line through points of shape (n, 2)."""
    axes.plot(*points.T, color=colour, linewidth=3, solid_capstyle="round", zorder=2)


def draw_masses(axes: Axes, names: list[str], positions: Array, masses: Array, feet: dict[str, str]) -> None:
    """Discs of the area of their mass, the lighter ones in front; `feet` gives the colours of the feet."""
    for i in np.argsort(-masses, kind="stable"):
        colour = feet.get(names[i]) or MASS_COLOURS.get(names[i], style.PURPLE)
        radius = RADIUS * np.sqrt(masses[i])
        disc = Circle(tuple(positions[i]), radius, facecolor=colour, edgecolor=style.WHITE, linewidth=0.6)
        axes.add_patch(disc)
        disc.set(zorder=4, gid=names[i])


def spring_line(points: Array, width: float) -> Array:
    """A zigzag between the first and the last of some points, shape (2 COILS + 2, 2)."""
    begin, way = points[0], points[-1] - points[0]
    length = float(np.hypot(*way))
    along = np.concatenate([[0.0], (np.arange(2 * COILS) + 0.5) / (2 * COILS), [1.0]])
    aside = np.concatenate([[0.0], np.resize([1.0, -1.0], 2 * COILS), [0.0]]) * width
    normal = np.array([-way[1], way[0]]) / length if length else np.zeros(2)
    return begin + along[:, None] * way + aside[:, None] * normal


def draw_spring(axes: Axes, points: Array, width: float = 0.03, **line: Any) -> None:
    """A spring as a zigzag."""
    look = {"color": style.BLACK, "linewidth": 0.8, "zorder": 5, **line}
    axes.plot(*spring_line(points, width).T, **look)


def draw_ground(axes: Axes, left: float, right: float, spacing: float) -> None:
    """The ground through the origin with hatches at multiples of `spacing`."""
    axes.plot([left, right], [0, 0], color=style.BLACK, linewidth=1, zorder=1)
    at = spacing * np.arange(np.ceil(left / spacing), np.floor(right / spacing) + 1)
    ends = np.full_like(at, np.nan)
    x = np.column_stack([at, at - 0.03, ends]).ravel()
    y = np.column_stack([0 * at, 0 * at - 0.04, ends]).ravel()
    axes.plot(x, y, color=style.GREY, linewidth=0.8, zorder=1)
