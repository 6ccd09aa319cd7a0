"""The map: where in the plane of two parameters limit cycles are, stable ones and others."""

from matplotlib.colors import ListedColormap
from matplotlib.figure import Figure
from matplotlib.patches import Patch

from stridemap.paper.drawings.material import SOLUTIONS, Material
from stridemap.paper.drawings.raster import extent, letters
from stridemap.paper.points import PLANE
from stridemap.solver.branches.plane import NONE, STABLE, Plane
from stridemap.solver.branches.refinement import refined
from stridemap.solver.cycles.orbits import Orbits
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.model.loading import load
from stridemap.views import style

HEIGHT = 66 * style.MM
TIMES = 2
"""Number of times that the cells along the edges are halved."""


def draw(material: Material) -> Figure:
    """The map of the paper: spring stiffness and mass ratio at one frequency."""
    config = material.sweeps.configs["map"]
    grid, model = config.grid, load(config.model)
    orbits = Orbits.from_columns(model, material.map)
    coarse = Plane.of_orbits(orbits, ("k", "alpha"), grid["k"], grid["alpha"])
    plane = refined(Solver.for_model(model), coarse, orbits, TIMES)
    sides = extent(plane)
    figure = style.new_figure(style.COLUMN, HEIGHT)
    axes = figure.add_subplot()
    colours = ListedColormap([style.NONE, style.UNSTABLE, style.STABLE])
    axes.imshow(
        plane.classes, cmap=colours, vmin=NONE, vmax=STABLE, origin="lower", extent=sides, aspect="auto"
    )
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
