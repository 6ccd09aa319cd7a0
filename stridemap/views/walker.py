"""A walker, drawn: legs, masses, springs, and the ground under it."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Circle
from numpy.typing import NDArray

from stridemap.spec import Mass
from stridemap.views import palette, style

Array = NDArray[np.float64]

RADIUS = 0.095
"""Radius of a disc for the mass of the whole walker, in heights of the walker."""
LEFT, RIGHT, HIP = palette.STANCE, palette.SWING, style.DARK
COILS = 5
ARC = 0.6
"""Half the angle of a round foot's arc."""


def draw_leg(axes: Axes, points: Array, colour: str) -> None:
    """One leg, a line through points of shape (n, 2)."""
    axes.plot(*points.T, color=colour, linewidth=3, solid_capstyle="round", zorder=2)


def leg_points(points: Array) -> tuple[Array, Array]:
    """Points of the stance leg and of the swing leg of a line whose role is ``legs``; the hip is in both."""
    half = len(points) // 2
    return points[: half + 1], points[half:]


def mass_colours(
    masses: Sequence[Mass], positions: Array, hip: Array | None, stance: str, swing: str
) -> list[str]:
    """Colours of the masses by their roles; a body at the hip, where the legs meet, has its own.

    Parameters
    ----------
    masses : sequence of Mass
    positions : ndarray, shape (n_masses, 2)
    hip : ndarray, shape (2,), or None
        Where the legs meet, if the walker has legs.
    stance, swing : str
        Colours of the two legs.
    """
    by_role = {"stance_foot": stance, "swing_foot": swing, "wobbling": palette.MASS, "body": palette.BODY}
    return [
        HIP if mass.role == "body" and hip is not None and np.allclose(position, hip) else by_role[mass.role]
        for mass, position in zip(masses, positions, strict=True)
    ]


def draw_masses(
    axes: Axes, names: Sequence[str], positions: Array, masses: Array, colours: Sequence[str]
) -> None:
    """Discs whose areas are as the masses, the lighter ones in front."""
    for i in np.argsort(-masses, kind="stable"):
        radius = RADIUS * np.sqrt(masses[i])
        disc = Circle(tuple(positions[i]), radius, facecolor=colours[i], edgecolor=style.WHITE, linewidth=0.6)
        axes.add_patch(disc)
        disc.set(zorder=4, gid=names[i])


def spring_line(points: Array, width: float) -> Array:
    """A zigzag between the first and the last of some points, shape (2 COILS + 2, 2)."""
    begin, extent = points[0], points[-1] - points[0]
    length = float(np.hypot(*extent))
    along = np.concatenate([[0.0], (np.arange(2 * COILS) + 0.5) / (2 * COILS), [1.0]])
    aside = np.concatenate([[0.0], np.resize([1.0, -1.0], 2 * COILS), [0.0]]) * width
    normal = np.array([-extent[1], extent[0]]) / length if length else np.zeros(2)
    return begin + along[:, None] * extent + aside[:, None] * normal


def draw_spring(axes: Axes, points: Array, width: float = 0.03, **line: Any) -> None:
    """A spring as a zigzag."""
    look = {"color": palette.SPRING, "linewidth": 0.8, "zorder": 5, **line}
    axes.plot(*spring_line(points, width).T, **look)


def draw_arc(axes: Axes, centre: Array, radius: float, up: Array, colour: str) -> None:
    """A round foot: the arc at the end of a leg that leads from its centre into the direction `up`."""
    angle = float(np.arctan2(-up[1], -up[0]))
    along = angle + np.linspace(-ARC, ARC, 41)
    points = centre + radius * np.column_stack([np.cos(along), np.sin(along)])
    axes.plot(*points.T, color=colour, linewidth=3, solid_capstyle="round", zorder=2, gid="foot")
    spoke = centre + np.outer([0.0, radius], -up / np.hypot(*up))
    axes.plot(*spoke.T, color=colour, linewidth=3, solid_capstyle="round", zorder=2)


def draw_ground(
    axes: Axes, left: float, right: float, spacing: float, step: float = 1.0, rise: float = 0.0
) -> None:
    """The ground through the origin with hatches at multiples of `spacing`; stairs where each step rises."""
    if rise:
        stairs = np.arange(np.floor(left / step) - 1, np.ceil(right / step) + 2)
        x = np.column_stack([step * (stairs - 0.5), step * (stairs + 0.5)]).ravel()
        axes.plot(x, np.repeat(rise * stairs, 2), color=style.BLACK, linewidth=1, zorder=1, gid="stairs")
    else:
        axes.plot([left, right], [0, 0], color=style.BLACK, linewidth=1, zorder=1)
    at = spacing * np.arange(np.ceil(left / spacing), np.floor(right / spacing) + 1)
    level = rise * np.floor(at / step + 0.5)
    ends = np.full_like(at, np.nan)
    x = np.column_stack([at, at - 0.03, ends]).ravel()
    y = np.column_stack([level, level - 0.04, ends]).ravel()
    axes.plot(x, y, color=style.GREY, linewidth=0.8, zorder=1)
