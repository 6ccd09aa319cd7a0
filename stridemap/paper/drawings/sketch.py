"""The model, sketched from its own geometry, with the symbols of its coordinates and parameters."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Arc, Circle
from numpy.typing import NDArray

from stridemap.paper.drawings.material import Material
from stridemap.solver.model.loading import load
from stridemap.views import style, walker

Array = NDArray[np.float64]

THETA1, THETA2, X = 0.3, 0.85, 0.42
"""Coordinates of the pose; much larger than in a gait, so that they can be seen."""
RADII = {"body": 0.07, "wobbling": 0.055, "stance_foot": 0.035, "swing_foot": 0.035}
"""Radii of the discs by the roles of the masses, of which the model has one each; the body is the hip."""
ARROW = {"arrowstyle": "<|-|>,head_width=0.15,head_length=0.35", "color": style.BLACK, "linewidth": 0.7}


def draw(material: Material | None = None) -> Figure:
    """The wobbling model: legs, hip, feet, wobbling mass on its spring, coordinates and masses."""
    model = load("wobbling")
    drawn = model.evaluate("drawing", q=np.array([THETA1, THETA2, X]), p=model.point({"alpha": 0.45}))
    (legs,) = (line.name for line in model.spec.lines if line.role == "legs")
    positions: dict[str, Array] = {
        mass.role: at for mass, at in zip(model.spec.masses, drawn["positions"], strict=True)
    }
    figure = style.new_figure(style.COLUMN, 72 * style.MM)
    axes = figure.add_subplot()
    axes.set(xlim=(-1.05, 0.62), ylim=(-0.2, 1.3))
    axes.set_aspect("equal")
    axes.axis("off")
    walker.draw_ground(axes, -1.0, 0.55, 0.06)
    stance_leg, swing_leg = walker.leg_points(drawn[legs])
    walker.draw_leg(axes, swing_leg, walker.RIGHT)
    walker.draw_leg(axes, stance_leg, walker.LEFT)
    colours = walker.mass_colours(
        model.spec.masses, drawn["positions"], swing_leg[0], walker.LEFT, walker.RIGHT
    )
    for (role, position), colour in zip(positions.items(), colours, strict=True):
        look = {"facecolor": colour, "edgecolor": style.WHITE, "linewidth": 0.6, "zorder": 4}
        axes.add_patch(Circle(tuple(position), RADII[role], **look))
    _draw_wobbling(axes, positions["body"], positions["wobbling"])
    _draw_angles(axes, positions["stance_foot"], positions["body"])
    _draw_names(axes, positions)
    return figure


def _draw_wobbling(axes: Axes, hip: Array, mass: Array) -> None:
    """Rail, spring, and the distance of the wobbling mass ahead of the hip."""
    axes.plot([hip[0], mass[0] + 0.2], [hip[1] - 0.075] * 2, color=style.GREY, linewidth=1.2, zorder=1)
    ends = np.array([hip + np.array([0.07, 0]), mass - np.array([0.055, 0])])
    walker.draw_spring(axes, ends, linewidth=1.0)
    x, y = ends.mean(axis=0)
    axes.text(x, y + 0.045, "$k$", ha="center", va="bottom")
    above = 0.2
    for x, y in (hip, mass):
        axes.plot([x, x], [y + 0.08, y + above + 0.03], color=style.BLACK, linewidth=0.5)
    tips = [(x, y + above) for x, y in (hip, mass)]
    axes.annotate(
        "",
        *tips,
        arrowprops={
            **ARROW,
            "arrowstyle": "<|-,head_width=0.15,head_length=0.35",
            "shrinkA": 0,
            "shrinkB": 0,
        },
    )
    axes.text((hip[0] + mass[0]) / 2, hip[1] + above + 0.015, "$x$", ha="center", va="bottom")


def _draw_angles(axes: Axes, foot: Array, hip: Array) -> None:
    """Both angles, each between the two lines that it is measured from and to."""
    thin = {"color": style.BLACK, "linewidth": 0.6, "linestyle": (0, (4, 2))}
    axes.plot([foot[0]] * 2, [foot[1], foot[1] + 0.75], **thin)
    up = 90.0
    _arc(axes, foot, 0.6, up, up + np.degrees(THETA1), r"$\theta_1$")
    down = 270 + np.degrees(THETA1)  # the stance leg, from the hip
    _arc(axes, hip, 0.42, down - np.degrees(THETA2), down, r"$\theta_2$")


def _arc(axes: Axes, centre: Array, radius: float, first: float, last: float, text: str) -> None:
    axes.add_patch(
        Arc(tuple(centre), 2 * radius, 2 * radius, theta1=first, theta2=last, linewidth=0.8, zorder=3)
    )
    middle = np.radians((first + last) / 2)
    position = centre + (radius + 0.07) * np.array([np.cos(middle), np.sin(middle)])
    axes.text(*position, text, ha="center", va="center")


def _draw_names(axes: Axes, positions: dict[str, Array]) -> None:
    hip, mass, foot, swing = (positions[role] for role in RADII)
    axes.text(*(hip + np.array([-0.09, 0.03])), r"$m_1=(1-\alpha)M$", ha="right", va="center")
    axes.text(*(mass + np.array([0.03, -0.11])), r"$m_3=\alpha M$", ha="center", va="top")
    axes.text(*(foot + np.array([0.06, 0.03])), r"$m_2=\beta M$", ha="left", va="bottom")
    axes.text(*(swing + np.array([-0.05, 0.0])), "$m_2$", ha="right", va="center")
    axes.text(*((foot + hip) / 2 + [0.07, -0.12]), "$L$", ha="left", va="center")
    axes.annotate(
        "walking", (0.5, 1.22), (0.1, 1.22), va="center", fontsize=7,
        arrowprops={
            "arrowstyle": "-|>,head_width=0.15,head_length=0.35", "linewidth": 0.8, "color": style.BLACK,
        },
    )  # fmt: skip
