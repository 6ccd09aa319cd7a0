"""The map: where in the plane of two parameters limit cycles are, stable ones and others.

Its regions are bounded by the curves on which gaits are born, end and change their stability, as vectors.
"""

import numpy as np
import pandas as pd
from matplotlib.collections import PolyCollection
from matplotlib.colors import ListedColormap
from matplotlib.figure import Figure
from matplotlib.patches import Patch
from numpy.typing import NDArray

from stridemap.paper.drawings.material import SOLUTIONS, Material
from stridemap.paper.drawings.raster import extent, letters
from stridemap.paper.drawings.regions import Regions
from stridemap.paper.map_boundaries import NAMES
from stridemap.paper.points import PLANE
from stridemap.solver.branches.classes import classes_at
from stridemap.solver.branches.plane import NONE, STABLE, UNSTABLE, Plane
from stridemap.solver.cycles.orbits import Orbits
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.model.loading import load
from stridemap.views import style

HEIGHT = 66 * style.MM
Sides = tuple[float, float, float, float]
"""Left, right, bottom and top."""

COLOURS = {NONE: style.NONE, UNSTABLE: style.UNSTABLE, STABLE: style.STABLE}
SEAM = 0.1
"""Width in points by which a region reaches into its neighbours of the same class."""


def draw(material: Material) -> Figure:
    """The map of the paper: spring stiffness and mass ratio at one frequency."""
    plane, sides, regions, classes = mapped(material)
    figure = style.new_figure(style.COLUMN, HEIGHT)
    axes = figure.add_subplot()
    # What is too narrow to be a region of its own has the colour of its cell.
    axes.imshow(
        plane.classes, cmap=ListedColormap(list(COLOURS.values())), vmin=NONE, vmax=STABLE, origin="lower",
        extent=sides, aspect="auto",
    )  # fmt: skip
    for number, colour in COLOURS.items():
        look = {"facecolors": colour, "edgecolors": colour, "linewidths": SEAM}
        outlines = regions.polygons(classes, number)
        axes.add_collection(PolyCollection(outlines, gid=f"class-{number}", **look), autolim=False)
    for letter, k, alpha in letters(plane, HEIGHT / style.COLUMN):
        axes.annotate(
            letter, (k, alpha), ha="center", va="center", fontsize=10, fontweight="bold", bbox=_backed()
        )
    for letter, (_, k) in SOLUTIONS.items():
        axes.plot(
            k, PLANE["alpha"], "o", ms=4, mfc=style.WHITE, mec=style.BLACK, mew=0.9, gid=letter, clip_on=False
        )
        axes.annotate(
            letter, (k, PLANE["alpha"]), (3.5, -3.5), textcoords="offset points", ha="left", va="top",
            fontstyle="italic", bbox=_backed(),
        )  # fmt: skip
    axes.set(xlabel="spring stiffness $k$  [$Mg/L$]", ylabel=r"mass ratio $\alpha$  [–]")
    axes.set(xlim=sides[:2], ylim=sides[2:])  # beyond, nothing was searched
    handles = [
        Patch(facecolor=colour, edgecolor=style.BLACK, linewidth=0.5, label=text)
        for colour, text in (
            (style.STABLE, "stable"), (style.UNSTABLE, "unstable only"), (style.NONE, "none found"),
        )
    ]  # fmt: skip
    figure.legend(handles=handles, loc="outside upper center", ncols=3, handlelength=1.2, columnspacing=1.2)
    axes.set_title(rf"$\omega = {PLANE['omega']:g}\,\sqrt{{g/L}}$", loc="right", fontsize=7)
    return figure


def _backed() -> dict:
    """A pale ground behind a letter, so that it can be read on every class."""
    return {"boxstyle": "round,pad=0.12", "facecolor": "white", "edgecolor": "none", "alpha": 0.85}


def mapped(material: Material) -> tuple[Plane, Sides, Regions, NDArray[np.int64]]:
    """The cells of the map, its sides, and the regions between its boundaries with their classes."""
    config = material.sweeps.configs["map"]
    model = load(config.model)
    orbits, solver = Orbits.from_columns(model, material.map), Solver.for_model(model)
    plane = Plane.of_orbits(orbits, NAMES, config.grid["k"], config.grid["alpha"])
    regions = Regions.between(gait_lines(material.boundaries), plane, sides := extent(plane))
    return (
        plane,
        sides,
        regions,
        regions.classes(plane, lambda x, y: classes_at(solver, plane, orbits, x, y)),
    )


def gait_lines(boundaries: pd.DataFrame) -> list[NDArray[np.float64]]:
    """The parts of boundaries on which cycles are gaits, each with a point more at either end, shape (m, 2).

    So a part that ends on another boundary reaches it.
    """
    lines = []
    for _, one in boundaries.groupby("boundary") if len(boundaries) else ():
        points, gait = one[list(NAMES)].to_numpy(), one["gait"].to_numpy(dtype=bool)
        gait = gait | np.append(gait[1:], False) | np.append(False, gait[:-1])
        edges = np.flatnonzero(np.diff(np.concatenate([[0], gait.astype(int), [0]])))
        lines += [points[i:j] for i, j in zip(edges[::2], edges[1::2], strict=True) if j - i > 1]
    return lines
